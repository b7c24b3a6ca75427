// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/pixels/DicomPixelReader.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace limn {
namespace {

std::uint32_t number(const std::vector<unsigned char>& bytes, std::size_t at) {
  return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 | std::uint32_t{bytes[at + 3]} << 24;
}

constexpr std::uint32_t fragmentStart = 0xE000FFFE; // as read little-endian, group first
constexpr std::uint32_t fragmentsEnd = 0xE0DDFFFE;

void swapBytes(std::vector<unsigned char>& bytes, std::size_t width) {
  for (std::size_t i = 0; i + width <= bytes.size(); i += width)
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                 bytes.begin() + static_cast<std::ptrdiff_t>(i + width));
}

// Puts the samples of a pixel together where each has its own plane.
std::vector<unsigned char> interleaved(const std::vector<unsigned char>& planes, std::size_t samples,
                                       std::size_t width) {
  const std::size_t pixels = planes.size() / (samples * width);
  std::vector<unsigned char> result(planes.size());
  for (std::size_t sample = 0; sample < samples; ++sample)
    for (std::size_t i = 0; i < pixels; ++i)
      std::copy_n(planes.begin() + static_cast<std::ptrdiff_t>((sample * pixels + i) * width), width,
                  result.begin() + static_cast<std::ptrdiff_t>((i * samples + sample) * width));
  return result;
}

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

DicomPixelReader::DicomPixelReader(const DicomHeader& header)
    : m_header(&header), m_stream(openDicomStream(header.path, header.deflatedFrom)) {
  if (header.pixels->isEncapsulated)
    findFragments();
}

void DicomPixelReader::fail(const Message& why) const {
  throw Error(Error::Kind::input, Message::tr("The pixels of the DICOM file %1 %2; the file is damaged or "
                                              "cut off, so copy it again from its source.")
                                      .arg(m_header->path.string(), why));
}

std::vector<unsigned char> DicomPixelReader::bytesAt(std::uint64_t offset, std::uint64_t length) {
  const std::uint64_t end = m_header->pixels->streamLength;
  if (offset > end || length > end - offset)
    fail(Message::tr("end early"));
  std::vector<unsigned char> bytes(length);
  m_stream->clear();
  m_stream->seekg(static_cast<std::streamoff>(offset));
  if (!m_stream->read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(length)))
    fail(Message::tr("end early"));
  return bytes;
}

// Lists the fragments behind the offset table (PS3.5, A.4).
void DicomPixelReader::findFragments() {
  std::vector<Fragment> fragments;
  std::vector<std::uint32_t> offsets;
  std::uint64_t at = m_header->pixels->offset;
  bool isTable = true;
  while (true) {
    const std::vector<unsigned char> item = bytesAt(at, 8);
    if (number(item, 0) == fragmentsEnd)
      break;
    if (number(item, 0) != fragmentStart)
      fail(Message::tr("have a broken fragment"));
    const Fragment fragment{at + 8, number(item, 4)};
    if (isTable) {
      const std::vector<unsigned char> table = bytesAt(fragment.offset, fragment.length);
      for (std::size_t i = 0; i + 4 <= table.size(); i += 4)
        offsets.push_back(number(table, i));
    } else {
      fragments.push_back(fragment);
    }
    isTable = false;
    at = fragment.offset + fragment.length;
    // Some writers leave out the end mark; the length of the file is as good.
    if (at == m_header->pixels->streamLength)
      break;
  }
  assignFragments(fragments, offsets);
}

bool DicomPixelReader::startsFrame(const Fragment& fragment) {
  if (fragment.length < 4)
    return false;
  const std::vector<unsigned char> start = bytesAt(fragment.offset, 4);
  return start[0] == 0xFF &&
         ((start[1] == 0xD8 && start[2] == 0xFF) || (start[1] == 0x4F && start[2] == 0xFF));
}

// One frame may be cut into several fragments: the offset table tells, else the marks that open a picture.
void DicomPixelReader::assignFragments(const std::vector<Fragment>& fragments,
                                       const std::vector<std::uint32_t>& offsets) {
  const std::size_t frames = m_header->frames.size();
  if (fragments.size() < frames)
    fail(Message::tr("hold %1 compressed pieces for %2 frames").arg(fragments.size(), frames));
  const bool useTable = offsets.size() == frames;
  const std::unordered_set<std::uint64_t> starts(offsets.begin(), offsets.end());
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const std::uint64_t offset = fragments[i].offset - 8 - (fragments.front().offset - 8);
    const bool isFirst = i == 0 || fragments.size() == frames ||
                         (frames > 1 && (useTable ? starts.contains(offset) : startsFrame(fragments[i])));
    if (isFirst)
      m_frames.emplace_back();
    m_frames.back().push_back(fragments[i]);
  }
  if (m_frames.size() != frames)
    fail(Message::tr("hold %1 pictures for %2 frames").arg(m_frames.size(), frames));
}

std::vector<unsigned char> DicomPixelReader::uncompressed(int index) {
  const DicomPixelFormat& format = m_header->format;
  const std::uint64_t size = frameBytes(*m_header);
  const std::size_t width = static_cast<std::size_t>(format.bitsAllocated / 8);
  std::uint64_t offset = m_header->pixels->offset + size * static_cast<std::uint64_t>(index);
  const bool swapsPairs = m_header->pixels->isWordSwapped && width == 1;
  // A frame of an odd number of swapped bytes starts or ends within a pair.
  const std::uint64_t lead = swapsPairs ? (offset - m_header->pixels->offset) % 2 : 0;
  const std::uint64_t tail = swapsPairs ? (lead + size) % 2 : 0;
  std::vector<unsigned char> bytes = bytesAt(offset - lead, size + lead + tail);
  if (m_header->pixels->isWordSwapped || (m_header->transferSyntax == "1.2.840.10008.1.2.2" && width > 1))
    swapBytes(bytes, std::max<std::size_t>(width, 2));
  bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(lead));
  bytes.resize(size);
  if (format.isPlanar && format.samples > 1)
    bytes = interleaved(bytes, static_cast<std::size_t>(format.samples), width);
  return bytes;
}

DicomRawFrame DicomPixelReader::frame(int index) {
  if (!m_header->pixels->isEncapsulated)
    return {uncompressed(index), m_header->format.photometric};
  DicomCodestream stream;
  for (const Fragment& fragment : m_frames[static_cast<std::size_t>(index)]) {
    const std::vector<unsigned char> bytes = bytesAt(fragment.offset, fragment.length);
    stream.insert(stream.end(), bytes.begin(), bytes.end());
  }
  return decoded(*m_header, stream);
}

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
