// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/pixels/DicomUnpack.h"

#include <cmath>

namespace limn {
namespace {

// Cuts the stored bits out of an allocated word.
class Word {
public:
  explicit Word(const DicomHeader& header)
      : m_format(header.format), m_padding(header.padding),
        m_shift(header.format.highBit + 1 - header.format.bitsStored),
        m_mask((std::uint64_t{1} << header.format.bitsStored) - 1) {}

  double value(std::uint32_t word, DicomUnpackNotes& notes) const {
    const double whole = withSign(word, m_format.bitsAllocated);
    const std::uint64_t bits = (word >> m_shift) & m_mask;
    const double stored = withSign(bits, m_format.bitsStored);
    if (stored == whole)
      return stored;
    if (m_padding && whole >= m_padding->first && whole <= m_padding->last)
      return whole;
    // A negative number without its sign repeated above the stored bits loses nothing.
    if ((static_cast<std::uint64_t>(word) >> m_shift) != bits)
      notes.ignoredBits = true;
    return stored;
  }

private:
  double withSign(std::uint64_t bits, int count) const {
    const bool isNegative = m_format.isSigned && (bits >> (count - 1) & 1);
    return static_cast<double>(bits) - (isNegative ? std::ldexp(1.0, count) : 0.0);
  }

  const DicomPixelFormat& m_format;
  const std::optional<PaddingRange>& m_padding;
  int m_shift;
  std::uint64_t m_mask;
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
  for (std::size_t i = 0; i < pixels; ++i) {
    if (header.format.samples == 3)
      out[i] = static_cast<T>(luminance(at(3 * i), at(3 * i + 1), at(3 * i + 2), isYbr));
    else if (isPalette)
      out[i] = static_cast<T>(header.palette->valueOf(at(i)));
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
