// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/pixels/DicomUnpack.h"

#include <cmath>

namespace limn {
namespace {

// Cuts the stored bits out of an allocated word.
class Word {
public:
  explicit Word(const DicomHeader& header)
      : m_padding(header.padding), m_shift(header.format.highBit + 1 - header.format.bitsStored),
        m_mask((std::int64_t{1} << header.format.bitsStored) - 1),
        m_wordSign(signOf(header.format, header.format.bitsAllocated)),
        m_storedSign(signOf(header.format, header.format.bitsStored)) {}

  std::int64_t value(std::int64_t word, DicomUnpackNotes& notes) const {
    const std::int64_t whole = withSign(word, m_wordSign);
    const std::int64_t bits = (word >> m_shift) & m_mask;
    const std::int64_t stored = withSign(bits, m_storedSign);
    if (stored == whole)
      return stored;
    const auto number = static_cast<double>(whole);
    if (m_padding && number >= m_padding->first && number <= m_padding->last)
      return whole;
    // A negative number without its sign repeated above the stored bits loses nothing.
    if (word >> m_shift != bits)
      notes.ignoredBits = true;
    return stored;
  }

private:
  // The bit that holds the sign of so many; 0 where there is none.
  static std::int64_t signOf(const DicomPixelFormat& format, int bits) {
    return format.isSigned ? std::int64_t{1} << (bits - 1) : 0;
  }

  static std::int64_t withSign(std::int64_t bits, std::int64_t sign) { return (bits ^ sign) - sign; }

  const std::optional<PaddingRange>& m_padding;
  int m_shift;
  std::int64_t m_mask;
  std::int64_t m_wordSign;
  std::int64_t m_storedSign;
};

template <class Raw>
Raw wordAt(const unsigned char* bytes, std::size_t index) {
  Raw word = 0;
  for (std::size_t i = 0; i < sizeof(Raw); ++i)
    word = static_cast<Raw>(word |
                            static_cast<Raw>(static_cast<Raw>(bytes[index * sizeof(Raw) + i]) << (8 * i)));
  return word;
}

// The luminance of a colour pixel (ITU-R BT.601 weights, as the Y of DICOM's YBR).
double luminance(double red, double green, double blue, bool isYbr) {
  return isYbr ? red : std::round(0.299 * red + 0.587 * green + 0.114 * blue);
}

template <class Raw, class T>
void unpackWords(const DicomHeader& header, const DicomRawFrame& raw, T* out, DicomUnpackNotes& notes) {
  const Word word(header);
  const auto pixels = static_cast<std::size_t>(header.columns) * static_cast<std::size_t>(header.rows);
  const bool isYbr = raw.photometric.rfind("YBR_FULL", 0) == 0;
  const bool isPalette = header.format.photometric == "PALETTE COLOR";
  const auto at = [&](std::size_t index) { return word.value(wordAt<Raw>(raw.bytes.data(), index), notes); };
  const auto numberAt = [&](std::size_t index) { return static_cast<double>(at(index)); };
  for (std::size_t i = 0; i < pixels; ++i) {
    if (header.format.samples == 3)
      out[i] = static_cast<T>(luminance(numberAt(3 * i), numberAt(3 * i + 1), numberAt(3 * i + 2), isYbr));
    else if (isPalette)
      out[i] = static_cast<T>(header.palette->valueOf(numberAt(i)));
    else
      out[i] = static_cast<T>(at(i));
  }
}

} // namespace

template <class T>
void unpackFrame(const DicomHeader& header, const DicomRawFrame& raw, T* out, DicomUnpackNotes& notes) {
  if (header.format.bitsAllocated == 8)
    unpackWords<std::uint8_t>(header, raw, out, notes);
  else if (header.format.bitsAllocated == 16)
    unpackWords<std::uint16_t>(header, raw, out, notes);
  else
    unpackWords<std::uint32_t>(header, raw, out, notes);
}

template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::uint8_t*, DicomUnpackNotes&);
template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::int8_t*, DicomUnpackNotes&);
template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::uint16_t*, DicomUnpackNotes&);
template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::int16_t*, DicomUnpackNotes&);
template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::uint32_t*, DicomUnpackNotes&);
template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::int32_t*, DicomUnpackNotes&);
template void unpackFrame(const DicomHeader&, const DicomRawFrame&, double*, DicomUnpackNotes&);

} // namespace limn
