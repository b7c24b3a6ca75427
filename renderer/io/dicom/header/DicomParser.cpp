// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomParser.h"

#include "io/dicom/header/DicomTags.h"
#include "scene/basics/Error.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <new>
#include <streambuf>
#include <string_view>
#include <vector>

namespace limn {
namespace {

constexpr std::uint64_t mostBytes = std::uint64_t{1} << 30;
constexpr int rawDeflate = -15;

// The state of zlib, given back also where opening fails.
struct Inflater {
  z_stream zlib{};
  Inflater() {
    if (inflateInit2(&zlib, rawDeflate) != Z_OK)
      throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&zlib); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
};

// Holds a window of what the deflated bytes behind `m_start` mean.
class InflatingBuffer : public std::streambuf {
public:
  InflatingBuffer(std::unique_ptr<std::istream> in, std::string file)
      : m_in(std::move(in)), m_file(std::move(file)), m_start(m_in->tellg()), m_input(1 << 16),
        m_window(1 << 18) {
    while (fill())
      if (m_begin + m_held > mostBytes)
        throw Error(
            Error::Kind::input,
            Message::tr(
                "The deflated DICOM file %1 inflates to more than 1 GiB; decompress it with another tool.")
                .arg(m_file));
    m_length = m_begin + m_held;
    restart();
  }

protected:
  int_type underflow() override { return fill() ? traits_type::to_int_type(*gptr()) : traits_type::eof(); }

  pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode) override {
    const auto here = static_cast<off_type>(m_begin) + (gptr() - eback());
    const off_type base = from == std::ios::beg   ? 0
                          : from == std::ios::cur ? here
                                                  : static_cast<off_type>(m_length);
    return seekpos(base + offset, std::ios::in);
  }

  pos_type seekpos(pos_type target, std::ios::openmode) override {
    const off_type offset = target;
    if (offset < 0 || static_cast<std::uint64_t>(offset) > m_length)
      return pos_type(off_type(-1));
    const auto place = static_cast<std::uint64_t>(offset);
    if (place < m_begin)
      restart();
    while (place > m_begin + m_held)
      if (!fill())
        return pos_type(off_type(-1));
    setg(eback(), eback() + (place - m_begin), egptr());
    return target;
  }

private:
  void restart() {
    m_in->clear();
    m_in->seekg(m_start);
    inflateReset(&m_zlib);
    m_zlib.avail_in = 0;
    m_isEnded = false;
    m_begin = m_held = 0;
    setg(m_window.data(), m_window.data(), m_window.data());
  }

  // Puts the bytes that follow into the window; false behind the last.
  bool fill() {
    m_begin += m_held;
    m_held = 0;
    m_zlib.next_out = reinterpret_cast<Bytef*>(m_window.data());
    m_zlib.avail_out = static_cast<uInt>(m_window.size());
    while (m_zlib.avail_out > 0 && !m_isEnded)
      inflateSome();
    m_held = m_window.size() - m_zlib.avail_out;
    setg(m_window.data(), m_window.data(), m_window.data() + m_held);
    return m_held > 0;
  }

  void inflateSome() {
    if (m_zlib.avail_in == 0) {
      m_in->read(m_input.data(), static_cast<std::streamsize>(m_input.size()));
      m_zlib.next_in = reinterpret_cast<Bytef*>(m_input.data());
      m_zlib.avail_in = static_cast<uInt>(m_in->gcount());
    }
    const int status = ::inflate(&m_zlib, Z_NO_FLUSH);
    // A buffer error is the end of the input before the end of the data: what uses it checks its lengths.
    m_isEnded = status != Z_OK;
    if (m_isEnded && status != Z_STREAM_END && status != Z_BUF_ERROR)
      throw Error(
          Error::Kind::input,
          Message::tr("The deflated DICOM file %1 is damaged: its data cannot be inflated; copy it again.")
              .arg(m_file));
  }

  std::unique_ptr<std::istream> m_in;
  std::string m_file;
  std::streampos m_start;
  std::vector<char> m_input;
  std::vector<char> m_window;
  Inflater m_inflater;
  z_stream& m_zlib = m_inflater.zlib;
  std::uint64_t m_begin = 0; // of the window, in the inflated bytes
  std::uint64_t m_held = 0;  // bytes in the window
  std::uint64_t m_length = 0;
  bool m_isEnded = false;
};

// A stream that owns its buffer.
class InflatingStream : public std::istream {
public:
  InflatingStream(std::unique_ptr<std::istream> packed, const std::string& file)
      : std::istream(nullptr), m_buffer(std::move(packed), file) {
    rdbuf(&m_buffer);
  }

private:
  InflatingBuffer m_buffer;
};

constexpr std::uint32_t undefinedLength = 0xFFFFFFFF;
constexpr DicomTag itemStart = 0xFFFEE000;
constexpr DicomTag itemEnd = 0xFFFEE00D;
constexpr DicomTag sequenceEnd = 0xFFFEE0DD;
constexpr std::uint64_t longestKeptValue = 1u << 20;
constexpr int deepestNesting = 32;
constexpr std::uint64_t mostKept = 64u << 20;    // bytes of all values, each with its place in memory
constexpr std::uint64_t mostElements = 1u << 22; // of a file, kept or not
constexpr std::uint64_t placeOfValue = 64;

struct ElementHeader {
  DicomTag tag = 0;
  std::string vr; // empty where implicit
  std::uint32_t length = 0;
};

struct Encoding {
  bool isExplicit = true;
  bool bigEndian = false;
};

bool isVr(std::string_view vr) {
  static constexpr auto known = std::to_array<std::string_view>(
      {"AE", "AS", "AT", "CS", "DA", "DS", "DT", "FL", "FD", "IS", "LO", "LT", "OB", "OD", "OF", "OL", "OV",
       "OW", "PN", "SH", "SL", "SQ", "SS", "ST", "SV", "TM", "UC", "UI", "UL", "UN", "UR", "US", "UT", "UV"});
  return std::find(known.begin(), known.end(), vr) != known.end();
}

bool hasLongLength(std::string_view vr) {
  static constexpr auto names = std::to_array<std::string_view>(
      {"OB", "OD", "OF", "OL", "OV", "OW", "SQ", "SV", "UC", "UN", "UR", "UT", "UV"});
  return std::find(names.begin(), names.end(), vr) != names.end();
}

// Reads a stream forward and never beyond its end.
class Parser {
public:
  Parser(std::istream& in, std::string file) : m_in(in), m_file(std::move(file)) {
    m_in.seekg(0, std::ios::end);
    m_end = static_cast<std::uint64_t>(std::max<std::streamoff>(m_in.tellg(), 0));
    moveTo(0);
  }

  std::uint64_t position() const { return m_position; }
  std::uint64_t end() const { return m_end; }
  void moveTo(std::uint64_t position) { m_position = position; }

  [[noreturn]] void fail(const Message& why) const {
    throw Error(
        Error::Kind::input,
        Message::tr(
            "The DICOM header of %1 %2: the file is damaged or cut off; copy it again from its source.")
            .arg(m_file, why));
  }

  std::string bytes(std::uint64_t count) {
    if (count > m_end - m_position)
      fail(Message::tr("names a value longer than the file"));
    if (count > m_window.size()) {
      std::string value(count, '\0');
      load(value.data(), count);
      m_position += count;
      return value;
    }
    if (m_position < m_windowStart || m_position + count > m_windowStart + m_held) {
      m_windowStart = m_position;
      m_held = std::min<std::uint64_t>(m_window.size(), m_end - m_position);
      load(m_window.data(), m_held);
    }
    std::string value = m_window.substr(m_position - m_windowStart, count);
    m_position += count;
    return value;
  }

  void skip(std::uint64_t count) {
    if (count > m_end - m_position)
      fail(Message::tr("names a value longer than the file"));
    moveTo(m_position + count);
  }

  std::uint32_t number(int count, bool bigEndian) {
    const std::string value = bytes(static_cast<std::uint64_t>(count));
    std::uint32_t result = 0;
    for (int i = 0; i < count; ++i)
      result = result << 8 | static_cast<unsigned char>(value[bigEndian ? i : count - 1 - i]);
    return result;
  }

  ElementHeader element(const Encoding& encoding) {
    if (++m_elements > mostElements)
      fail(Message::tr("holds more than any header"));
    ElementHeader header;
    header.tag = number(2, encoding.bigEndian) << 16;
    header.tag |= number(2, encoding.bigEndian);
    const bool isDelimiter = (header.tag >> 16) == 0xFFFE;
    if (!encoding.isExplicit || isDelimiter) {
      header.length = number(4, encoding.bigEndian);
      return header;
    }
    header.vr = bytes(2);
    // An unknown VR of two capitals has the short form; anything else is no VR at all.
    if (hasLongLength(header.vr)) {
      skip(2);
      header.length = number(4, encoding.bigEndian);
    } else {
      header.length = number(2, encoding.bigEndian);
    }
    return header;
  }

  // Reads elements up to `last`, the end of an item, or the pixels; those only at the top.
  DicomDataset dataset(const Encoding& encoding, std::uint64_t last, int depth,
                       std::optional<DicomPixelLocation>* pixels) {
    DicomDataset result;
    result.bigEndian = encoding.bigEndian;
    if (depth > deepestNesting)
      fail(Message::tr("nests sequences too deeply"));
    while (m_position + 8 <= last) {
      const ElementHeader header = element(encoding);
      if (header.tag == itemEnd)
        return result;
      if (pixels && tag::isPixels(header.tag)) {
        *pixels = located(header, encoding);
        return result;
      }
      readValue(header, encoding, depth, result);
    }
    if (m_position < last)
      skip(last - m_position);
    return result;
  }

private:
  // Reads from the stream at the position.
  void load(char* to, std::uint64_t count) {
    m_in.clear();
    m_in.seekg(static_cast<std::streamoff>(m_position));
    if (count > 0 && !m_in.read(to, static_cast<std::streamsize>(count)))
      fail(Message::tr("cannot be read to its end"));
  }

  DicomPixelLocation located(const ElementHeader& header, const Encoding& encoding) const {
    DicomPixelLocation location;
    location.offset = m_position;
    location.length = header.length;
    location.isEncapsulated = header.length == undefinedLength;
    location.isFloatingPoint = header.tag != tag::pixelData;
    location.isWordSwapped = encoding.bigEndian && header.vr != "OB";
    location.streamLength = m_end;
    return location;
  }

  void readValue(const ElementHeader& header, const Encoding& encoding, int depth, DicomDataset& into) {
    const bool isKept = tag::isKept(header.tag);
    const bool isUndefined = header.length == undefinedLength;
    if (isUndefined && (header.vr == "OB" || header.vr == "OW")) {
      skipFragments(encoding); // the compressed pixels of an icon
    } else if (isUndefined || (isKept && (header.vr == "SQ" || tag::isSequence(header.tag)))) {
      // A sequence of unknown VR is implicit inside (PS3.5, 6.2.2 note on UN).
      const Encoding inside = header.vr == "UN" ? Encoding{false, false} : encoding;
      auto items = sequence(header.length, inside, depth, isKept);
      if (isKept)
        into.elements[header.tag].items = std::move(items);
    } else if (!isKept || header.length > longestKeptValue) {
      skip(header.length);
    } else {
      keep(header.length);
      into.elements[header.tag].bytes = bytes(header.length);
    }
  }

  // No header in use comes near this; one that does would fill the memory.
  void keep(std::uint64_t count) {
    m_kept += count + placeOfValue;
    if (m_kept > mostKept)
      fail(Message::tr("holds more than any header"));
  }

  void skipFragments(const Encoding& encoding) {
    while (m_position + 8 <= m_end) {
      const ElementHeader header = element(encoding);
      if (header.tag == sequenceEnd)
        return;
      if (header.tag != itemStart)
        fail(Message::tr("has a broken fragment"));
      skip(header.length);
    }
  }

  // The items of a sequence; read and dropped where it is not kept.
  std::vector<DicomDataset> sequence(std::uint32_t length, const Encoding& encoding, int depth, bool isKept) {
    std::vector<DicomDataset> items;
    if (length != undefinedLength && length > m_end - m_position)
      fail(Message::tr("names a sequence longer than the file"));
    const std::uint64_t last = length == undefinedLength ? m_end : m_position + length;
    while (m_position + 8 <= last) {
      const ElementHeader header = element(encoding);
      if (header.tag == sequenceEnd)
        return items;
      if (header.tag != itemStart)
        fail(Message::tr("has a sequence with a broken item"));
      if (header.length != undefinedLength && header.length > last - m_position)
        fail(Message::tr("has an item longer than its sequence"));
      const std::uint64_t itemLast = header.length == undefinedLength ? last : m_position + header.length;
      DicomDataset item = dataset(encoding, itemLast, depth + 1, nullptr);
      if (!isKept)
        continue;
      keep(sizeof item);
      items.push_back(std::move(item));
    }
    return items;
  }

  std::istream& m_in;
  std::string m_file;
  std::uint64_t m_position = 0;
  std::uint64_t m_end = 0;
  std::uint64_t m_kept = 0;
  std::uint64_t m_elements = 0;
  std::string m_window = std::string(1 << 13, '\0'); // of the stream, for the many short reads
  std::uint64_t m_windowStart = 0;
  std::uint64_t m_held = 0;
};

// Looks at the first element of the data set, since some files are not in the syntax they declare.
Encoding sniffed(Parser& parser, const std::string& transferSyntax) {
  Encoding encoding;
  const std::uint64_t start = parser.position();
  if (start + 8 > parser.end())
    return encoding;
  const std::string first = parser.bytes(6);
  parser.moveTo(start);
  const bool zeroLowByte = first[0] == '\0' && first[1] != '\0';
  encoding.bigEndian = transferSyntax == "1.2.840.10008.1.2.2" || (transferSyntax.empty() && zeroLowByte);
  encoding.isExplicit = isVr(std::string_view(first).substr(4, 2));
  return encoding;
}

// Whether three sound elements of group 0002 or 0008 follow.
bool startsSoundly(Parser& parser, std::uint64_t start) {
  try {
    parser.moveTo(start);
    const Encoding encoding = sniffed(parser, "");
    DicomTag previous = 0;
    for (int i = 0; i < 3; ++i) {
      const ElementHeader header = parser.element(encoding);
      const auto group = header.tag >> 16;
      if (header.tag <= previous || (group != 2 && group != 8) || header.length % 2 != 0 ||
          (encoding.isExplicit && !isVr(header.vr)))
        return false;
      previous = header.tag;
      parser.skip(header.length);
    }
    return true;
  } catch (const Error&) {
    return false;
  }
}

// Finds the first element: behind the preamble, or at once. A file stripped of group 0002 may keep the byte
// that padded its last value.
std::optional<std::uint64_t> startOfElements(Parser& parser) {
  if (parser.end() >= 132) {
    parser.moveTo(128);
    if (parser.bytes(4) == "DICM")
      return 132;
  }
  for (const std::uint64_t start : {0, 1})
    if (startsSoundly(parser, start))
      return start;
  return std::nullopt;
}

// Reads group 0002, which is always explicit and little-endian.
DicomDataset metaInformation(Parser& parser) {
  DicomDataset meta;
  while (parser.position() + 8 <= parser.end()) {
    const std::uint64_t start = parser.position();
    const ElementHeader header = parser.element({});
    if (header.tag >> 16 != 2) {
      parser.moveTo(start);
      break;
    }
    if (tag::isKept(header.tag) && header.length <= longestKeptValue)
      meta.elements[header.tag].bytes = parser.bytes(header.length);
    else
      parser.skip(header.length);
  }
  return meta;
}

// The rest of a stream inflated (raw deflate, transfer syntax 1.2.840.10008.1.2.1.99), as a stream that can
// be sought and knows its length. It inflates as it is read, so it takes no more memory however much is
// packed; moving back starts anew. A stream that ends early gives what could be inflated. Throws Error
// (input) naming `file` where the bytes are not deflated data or inflate to more than 1 GiB.
std::unique_ptr<std::istream> inflated(std::unique_ptr<std::istream> in, const std::string& file) {
  return std::make_unique<InflatingStream>(std::move(in), file);
}

} // namespace

std::optional<DicomFile> parseIfDicom(const std::filesystem::path& path) {
  auto in = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*in)
    return std::nullopt;
  Parser parser(*in, path.string());
  std::optional<std::uint64_t> start;
  try {
    start = startOfElements(parser);
  } catch (const Error&) { // shorter than it says, as some files of the system are
  }
  if (!start)
    return std::nullopt;
  DicomFile file;
  parser.moveTo(*start);
  const DicomDataset meta = metaInformation(parser);
  file.transferSyntax = textOf(meta, tag::transferSyntax);
  if (textOf(meta, tag::mediaStorageClass) == "1.2.840.10008.1.3.10") {
    file.dataset = meta; // a DICOMDIR: an index, whose many records nobody needs
    return file;
  }
  if (file.transferSyntax == "1.2.840.10008.1.2.1.99") {
    file.deflatedFrom = parser.position();
    in->clear();
    in->seekg(static_cast<std::streamoff>(file.deflatedFrom));
    const auto plain = inflated(std::move(in), path.string());
    Parser unpacked(*plain, path.string());
    file.dataset = unpacked.dataset(sniffed(unpacked, ""), unpacked.end(), 0, &file.pixels);
  } else {
    file.dataset = parser.dataset(sniffed(parser, file.transferSyntax), parser.end(), 0, &file.pixels);
  }
  file.dataset.elements.insert(meta.elements.begin(), meta.elements.end());
  return file;
}

DicomFile parseDicom(const std::filesystem::path& path) {
  if (auto file = parseIfDicom(path))
    return std::move(*file);
  openDicomStream(path, 0); // says so where it cannot be read
  throw Error(Error::Kind::input,
              Message::tr("The file %1 does not start as DICOM does; if it was an image, it is damaged or "
                          "cut off, so copy it again from its source.")
                  .arg(path.string()));
}

std::unique_ptr<std::istream> openDicomStream(const std::filesystem::path& path, std::uint64_t deflatedFrom) {
  auto in = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*in)
    throw Error(Error::Kind::input,
                Message::tr("The file %1 cannot be opened; check that it exists and that you may read it.")
                    .arg(path.string()));
  if (deflatedFrom == 0)
    return in;
  in->seekg(static_cast<std::streamoff>(deflatedFrom));
  return inflated(std::move(in), path.string());
}

} // namespace limn
