// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/vtk/VtkXmlFile.h"

#include "io/formats/voxels/AxisGrid.h"
#include "io/formats/voxels/Bytes.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <pugixml.hpp>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace limn {
namespace {

namespace fs = std::filesystem;

// How a VTK XML file writes its arrays in binary form.
struct VtkXmlEncoding {
  bool bigEndian = false;
  int bytesPerLength = 4; ///< of the lengths before the values
  bool isCompressed = false;
  bool isBase64 = false;
};

[[noreturn]] void failDamagedArray(const fs::path& file) {
  failReading(file, Message::tr("its array of values is damaged or cut off"), copyAgain);
}

// The six bits of a base64 letter; nothing where it is none.
std::optional<unsigned> bitsOf(unsigned char letter) {
  static constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t at = alphabet.find(static_cast<char>(letter));
  return at == std::string_view::npos ? std::nullopt : std::optional(static_cast<unsigned>(at));
}

// Decodes base64 letters as they are asked for, in groups of four.
class Base64 {
public:
  Base64(fs::path file, ByteReader letters) : m_file(std::move(file)), m_letters(std::move(letters)) {}

  std::size_t read(unsigned char* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count && (m_taken < m_held || takeGroup()))
      to[done++] = m_group[m_taken++];
    return done;
  }

private:
  // Decodes the next group; false at the end of the letters.
  bool takeGroup() {
    unsigned bits = 0;
    std::size_t letters = 0;
    for (int i = 0; i < 4; ++i) {
      const auto letter = nextLetter();
      if (!letter && i == 0)
        return false;
      const auto value = letter ? bitsOf(*letter) : std::nullopt;
      if (!letter || (!value && *letter != '='))
        failDamagedArray(m_file);
      bits = bits << 6 | value.value_or(0);
      letters += value ? 1 : 0;
    }
    m_taken = 0;
    m_held = letters * 6 / 8;
    if (m_held == 0)
      failDamagedArray(m_file);
    for (std::size_t i = 0; i < 3; ++i)
      m_group[i] = static_cast<unsigned char>(bits >> (16 - 8 * i) & 0xff);
    return true;
  }

  std::optional<unsigned char> nextLetter() {
    while (true) {
      if (m_at == m_filled) {
        m_filled = m_letters(m_buffer.data(), m_buffer.size());
        m_at = 0;
        if (m_filled == 0)
          return std::nullopt;
      }
      const unsigned char letter = m_buffer[m_at++];
      if (letter != '\n' && letter != '\r' && letter != ' ' && letter != '\t')
        return letter;
    }
  }

  fs::path m_file;
  ByteReader m_letters;
  std::array<unsigned char, 1 << 16> m_buffer{};
  std::size_t m_at = 0;
  std::size_t m_filled = 0;
  std::array<unsigned char, 3> m_group{};
  std::size_t m_taken = 0;
  std::size_t m_held = 0;
};

// The bytes behind the code. Each unit of base64 ends with a whole group, so one starts where another ends.
ByteReader decoded(const fs::path& file, const ByteReader& coded, const VtkXmlEncoding& encoding) {
  if (!encoding.isBase64)
    return coded;
  auto decoder = std::make_shared<Base64>(file, coded);
  return [decoder](unsigned char* to, std::size_t count) { return decoder->read(to, count); };
}

std::uint64_t takeLength(const fs::path& file, const ByteReader& bytes, const VtkXmlEncoding& encoding) {
  const auto width = static_cast<std::size_t>(encoding.bytesPerLength);
  std::array<unsigned char, 8> raw{};
  if (bytes(raw.data(), width) < width)
    failDamagedArray(file);
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < width; ++i)
    value = value << 8 | raw[encoding.bigEndian ? i : width - 1 - i];
  return value;
}

// The blocks of a compressed array: lengths before and after compression.
struct Blocks {
  std::vector<std::uint64_t> packed;
  std::uint64_t size = 0;
  std::uint64_t lastSize = 0; // 0: the last is as long as the others

  std::uint64_t sizeOf(std::size_t block) const {
    return block + 1 == packed.size() && lastSize > 0 ? lastSize : size;
  }
};

Blocks blocksOf(const fs::path& file, const ByteReader& bytes, const VtkXmlEncoding& encoding,
                std::uint64_t expected) {
  const std::uint64_t count = takeLength(file, bytes, encoding);
  Blocks blocks;
  blocks.size = takeLength(file, bytes, encoding);
  blocks.lastSize = takeLength(file, bytes, encoding);
  // All blocks but the last are as long as one, so their number follows from the sizes.
  if (blocks.size == 0 || blocks.size > expected || blocks.lastSize > blocks.size ||
      count != expected / blocks.size + (expected % blocks.size > 0 ? 1 : 0))
    failDamagedArray(file);
  for (std::uint64_t i = 0; i < count; ++i)
    blocks.packed.push_back(takeLength(file, bytes, encoding));
  if (blocks.sizeOf(count - 1) != expected - (count - 1) * blocks.size)
    failDamagedArray(file);
  return blocks;
}

// Inflates block after block as bytes are asked for.
class BlockReader {
public:
  BlockReader(fs::path file, Blocks blocks, ByteReader packed)
      : m_file(std::move(file)), m_blocks(std::move(blocks)), m_packed(std::move(packed)) {
    if (inflateInit(&m_zlib) != Z_OK)
      throw std::bad_alloc();
  }
  ~BlockReader() { inflateEnd(&m_zlib); }
  BlockReader(const BlockReader&) = delete;
  BlockReader& operator=(const BlockReader&) = delete;

  std::size_t read(unsigned char* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count && (m_plainLeft > 0 || startNext()))
      done += inflateSome(to + done, count - done);
    return done;
  }

private:
  bool startNext() {
    if (m_next == m_blocks.packed.size())
      return false;
    inflateReset(&m_zlib);
    m_zlib.avail_in = 0;
    m_packedLeft = m_blocks.packed[m_next];
    m_plainLeft = m_blocks.sizeOf(m_next);
    ++m_next;
    return true;
  }

  void refill() {
    if (m_zlib.avail_in > 0 || m_packedLeft == 0)
      return;
    const auto step = static_cast<std::size_t>(std::min<std::uint64_t>(m_input.size(), m_packedLeft));
    if (m_packed(m_input.data(), step) < step)
      failDamagedArray(m_file);
    m_packedLeft -= step;
    m_zlib.next_in = m_input.data();
    m_zlib.avail_in = static_cast<uInt>(step);
  }

  std::size_t inflateSome(unsigned char* to, std::size_t count) {
    refill();
    const auto room =
        static_cast<uInt>(std::min<std::uint64_t>({count, m_plainLeft, std::uint64_t{1} << 30}));
    m_zlib.next_out = to;
    m_zlib.avail_out = room;
    const int status = inflate(&m_zlib, Z_NO_FLUSH);
    const std::size_t got = room - m_zlib.avail_out;
    m_plainLeft -= got;
    if ((status != Z_OK && status != Z_STREAM_END) ||
        (got == 0 && m_zlib.avail_in == 0 && m_packedLeft == 0) ||
        (status == Z_STREAM_END && m_plainLeft > 0))
      failDamagedArray(m_file);
    if (m_plainLeft == 0)
      endBlock(status);
    return got;
  }

  // A block holds no more than its size: behind the last value the stream ends, with its check sum.
  void endBlock(int status) {
    unsigned char beyond = 0;
    while (status == Z_OK) {
      refill();
      m_zlib.next_out = &beyond;
      m_zlib.avail_out = 1;
      status = inflate(&m_zlib, Z_NO_FLUSH);
      if (m_zlib.avail_out == 0)
        failDamagedArray(m_file);
    }
    if (status != Z_STREAM_END || m_packedLeft > 0)
      failDamagedArray(m_file);
  }

  fs::path m_file;
  Blocks m_blocks;
  ByteReader m_packed;
  z_stream m_zlib{};
  std::array<unsigned char, 1 << 16> m_input{};
  std::size_t m_next = 0;
  std::uint64_t m_packedLeft = 0; // of the block under way, not yet given to zlib
  std::uint64_t m_plainLeft = 0;  // of the block under way, not yet handed out
};

// The values of an array of `expected` bytes out of its coded bytes, decoded as they are asked for. Throws
// Error, naming `file`, also later as it reads, where the lengths before the values do not fit or the bytes
// are damaged.
ByteReader arrayBytes(const fs::path& file, const ByteReader& coded, const VtkXmlEncoding& encoding,
                      std::uint64_t expected) {
  ByteReader bytes = decoded(file, coded, encoding);
  if (!encoding.isCompressed) {
    if (takeLength(file, bytes, encoding) != expected)
      failDamagedArray(file);
    return bytes;
  }
  Blocks blocks = blocksOf(file, bytes, encoding, expected);
  auto reader = std::make_shared<BlockReader>(file, std::move(blocks), bytes);
  return [reader](unsigned char* to, std::size_t count) { return reader->read(to, count); };
}

// The elements of a VTK XML file without the values between them, which may be long: where text stood, its
// place in the file stands instead, as two numbers (offset and length).
struct VtkXmlText {
  std::string xml;            ///< up to the appended bytes, which are no XML, or to the end
  std::uint64_t appended = 0; ///< where the appended bytes start; 0 where there are none
  bool appendedIsBase64 = false;
};

// A run of bytes of a file.
struct VtkXmlRun {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

namespace fs = std::filesystem;

constexpr std::size_t longestXml = 16 << 20;
constexpr std::string_view appendedTag = "<AppendedData";

// Reads the elements of a file. Throws Error where they are no XML or longer than any in use.
class Scanner {
public:
  explicit Scanner(const fs::path& file) : m_file(file), m_buffer(1 << 16) {
    m_stream.rdbuf()->pubsetbuf(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
    m_stream.open(file, std::ios::binary);
  }

  VtkXmlText scanned() {
    for (int c = take(); c != end; c = take()) {
      if (c != '<') {
        noteText(c);
        continue;
      }
      writePlace();
      const std::string tag = takeTag();
      if (tag.starts_with(appendedTag)) {
        findAppended(tag);
        return std::move(m_result);
      }
      m_result.xml += tag;
      if (m_result.xml.size() > longestXml)
        failDamaged();
    }
    writePlace();
    return std::move(m_result);
  }

private:
  static constexpr int end = std::char_traits<char>::eof();

  [[noreturn]] void failDamaged() const {
    failReading(m_file, Message::tr("its text is cut off or damaged"), copyAgain);
  }

  int take() {
    const int c = m_stream.rdbuf()->sbumpc();
    m_position += c == end ? 0 : 1;
    return c;
  }

  void noteText(int c) {
    const bool isBlank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
    if (isBlank && m_text.length == 0)
      return;
    if (m_text.length == 0)
      m_text.offset = m_position - 1;
    m_text.length = m_position - m_text.offset;
  }

  void writePlace() {
    if (m_text.length > 0)
      m_result.xml += std::to_string(m_text.offset) + " " + std::to_string(m_text.length);
    m_text = {};
  }

  // A tag, comment or declaration; what is quoted in a tag may hold a closing bracket.
  std::string takeTag() {
    std::string tag = "<";
    char quote = 0;
    while (true) {
      const int c = take();
      if (c == end || tag.size() > longestXml)
        failDamaged();
      tag += static_cast<char>(c);
      const bool isComment = tag.starts_with("<!--");
      if (!isComment && quote == 0 && (c == '"' || c == '\''))
        quote = static_cast<char>(c);
      else if (c == quote)
        quote = 0;
      else if (c == '>' && quote == 0 && (!isComment || (tag.size() >= 7 && tag.ends_with("-->"))))
        return tag;
    }
  }

  // The appended bytes start behind an underscore.
  void findAppended(const std::string& tag) {
    int c = take();
    while (c != end && c != '_')
      c = take();
    if (c == end)
      failReading(m_file, Message::tr("its appended data are missing"), copyAgain);
    m_result.appended = m_position;
    m_result.appendedIsBase64 = tag.find("\"raw\"") == std::string::npos;
  }

  fs::path m_file;
  std::vector<char> m_buffer; // outlives the stream that fills it
  std::ifstream m_stream;
  std::uint64_t m_position = 0;
  VtkXmlRun m_text;
  VtkXmlText m_result;
};

// The place that stands in an element instead of its text; empty where the element had none.
VtkXmlRun runOf(const std::string& placeText) {
  VtkXmlRun run;
  const char* const last = placeText.data() + placeText.size();
  const auto first = std::from_chars(placeText.data(), last, run.offset);
  if (first.ec != std::errc{} || first.ptr == last ||
      std::from_chars(first.ptr + 1, last, run.length).ec != std::errc{})
    return {};
  return run;
}

// The bytes of a run.
ByteReader bytesOfRun(const fs::path& file, const VtkXmlRun& run) {
  const ByteReader bytes = openBytes({file, run.offset}, run.length);
  return [bytes, left = run.length](unsigned char* to, std::size_t count) mutable {
    const std::size_t got = bytes(to, static_cast<std::size_t>(std::min<std::uint64_t>(count, left)));
    left -= got;
    return got;
  };
}

// The elements of the file, and where its appended bytes start.
struct Document {
  pugi::xml_document xml;
  VtkXmlText text;

  pugi::xml_node root() const { return xml.child("VTKFile"); }
  pugi::xml_node image() const { return root().child("ImageData"); }
};

Document parse(const fs::path& file) {
  Document document;
  document.text = Scanner(file).scanned();
  // With appended bytes the text is cut before its last elements close; the tree up to there is kept.
  const pugi::xml_parse_result result =
      document.xml.load_buffer(document.text.xml.data(), document.text.xml.size());
  const std::string type = document.root().attribute("type").as_string();
  if (type != "ImageData")
    failReading(file, Message::tr("it holds VTK data of the type \"%1\", not image data").arg(type),
                Message::tr("export the volume as image data (.vti)"));
  if (document.text.appended == 0 && !result)
    failReading(file, Message::tr("its text is cut off or damaged"), copyAgain);
  return document;
}

std::vector<double> listOf(const fs::path& file, const pugi::xml_node& node, const char* name,
                           std::size_t count) {
  std::vector<double> values = numbers(file, node.attribute(name).as_string());
  if (!values.empty() && values.size() != count)
    failReading(file, Message::tr("its attribute %1 has the wrong number of numbers").arg(name), copyAgain);
  return values;
}

// Where the points lie.
struct Points {
  glm::ivec3 dims{0};
  glm::dmat3 stepsMm{1.0};
  glm::dvec3 firstMm{0.0};
  bool spacingKnown = false;
};

Points pointsOf(const fs::path& file, const pugi::xml_node& image) {
  const std::vector<double> extent = listOf(file, image, "WholeExtent", 6);
  const std::vector<double> spacing = listOf(file, image, "Spacing", 3);
  const std::vector<double> origin = listOf(file, image, "Origin", 3);
  const std::vector<double> direction = listOf(file, image, "Direction", 9);
  if (extent.empty())
    failReading(file, Message::tr("its header has no WholeExtent"), copyAgain);
  Points points;
  points.spacingKnown = !spacing.empty();
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    points.dims[axis] = dimension(file, extent[2 * a + 1] - extent[2 * a] + 1.0);
    for (int row = 0; row < 3 && !direction.empty(); ++row)
      points.stepsMm[axis][row] = direction[static_cast<std::size_t>(row) * 3 + a];
    points.stepsMm[axis] *= spacing.empty() ? 1.0 : spacing[a];
    points.firstMm[axis] = origin.empty() ? 0.0 : origin[a];
  }
  points.firstMm += points.stepsMm * glm::dvec3(extent[0], extent[2], extent[4]);
  return points;
}

pugi::xml_node pieceOf(const fs::path& file, const pugi::xml_node& image) {
  const pugi::xml_node piece = image.child("Piece");
  if (!piece || piece.next_sibling("Piece"))
    failReading(file, Message::tr("it does not hold exactly one piece"), Message::tr("save it as one piece"));
  if (numbers(file, piece.attribute("Extent").as_string()) != listOf(file, image, "WholeExtent", 6))
    failReading(file, Message::tr("its piece does not fill its extent"), copyAgain);
  return piece;
}

// The active array of values, else the first.
pugi::xml_node arrayIn(const pugi::xml_node& data) {
  const std::string active = data.attribute("Scalars").as_string();
  const pugi::xml_node named = data.find_child_by_attribute("DataArray", "Name", active.c_str());
  return named ? named : data.child("DataArray");
}

VoxelLayout layoutOf(const fs::path& file, const Document& document, const pugi::xml_node& array,
                     const glm::ivec3& dims) {
  using enum VoxelType;
  static const std::map<std::string, VoxelType> types = {
      {"UInt8", uint8}, {"Int8", int8},     {"UInt16", uint16}, {"Int16", int16},     {"UInt32", uint32},
      {"Int32", int32}, {"UInt64", uint64}, {"Int64", int64},   {"Float32", float32}, {"Float64", float64}};
  VoxelLayout layout;
  layout.type = typeNamed(file, array.attribute("type").as_string(), types);
  layout.bigEndian = std::string(document.root().attribute("byte_order").as_string()) == "BigEndian";
  layout.components = componentCount(file, array.attribute("NumberOfComponents").as_string());
  layout.count = voxelCount(file, dims);
  return layout;
}

VtkXmlEncoding encodingOf(const fs::path& file, const Document& document) {
  const std::string compressor = document.root().attribute("compressor").as_string();
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    failReading(file, Message::tr("its compression %1 is not supported").arg(compressor),
                Message::tr("save it with ZLib or uncompressed"));
  VtkXmlEncoding encoding;
  encoding.bigEndian = std::string(document.root().attribute("byte_order").as_string()) == "BigEndian";
  encoding.bytesPerLength =
      std::string(document.root().attribute("header_type").as_string()) == "UInt64" ? 8 : 4;
  encoding.isCompressed = !compressor.empty();
  return encoding;
}

// Where the coded bytes of an array among the appended ones lie.
ByteLocation appendedAt(const fs::path& file, const Document& document, const pugi::xml_node& array) {
  if (document.text.appended == 0)
    failReading(file, Message::tr("its array of values is missing"), copyAgain);
  const double offset = number(file, array.attribute("offset").as_string());
  if (!(offset >= 0.0) || offset > static_cast<double>(fs::file_size(file)))
    failReading(file, Message::tr("its array of values lies behind the end of the file"), copyAgain);
  return {file, document.text.appended + static_cast<std::uint64_t>(offset)};
}

// The coded bytes of an array that stands in its element, or among the appended ones.
ByteReader codedBytes(const fs::path& file, const Document& document, const pugi::xml_node& array,
                      std::uint64_t least) {
  const std::string format = array.attribute("format").as_string("ascii");
  if (format == "appended")
    return openBytes(appendedAt(file, document, array), least);
  const VtkXmlRun run = runOf(array.text().as_string());
  if (run.length < least)
    failReading(file, Message::tr("its text is too short for the voxels that its header asks for"),
                copyAgain);
  return bytesOfRun(file, run);
}

void readArray(const fs::path& file, const Document& document, const pugi::xml_node& array,
               const VoxelLayout& layout, const VoxelKeeping& keeping, const Progress& progress,
               VolumeParts& parts) {
  const std::string format = array.attribute("format").as_string("ascii");
  if (format == "ascii") {
    readTextVoxels(file, codedBytes(file, document, array, 2 * layout.count - 1), layout, keeping, progress,
                   false, parts);
    return;
  }
  if (format != "binary" && format != "appended")
    failReading(file, Message::tr("its array of values is missing"), copyAgain);
  VtkXmlEncoding encoding = encodingOf(file, document);
  encoding.isBase64 = format == "binary" || document.text.appendedIsBase64;
  const std::uint64_t bytes = bytesOf(layout);
  const std::uint64_t least = encoding.isCompressed ? 1 : bytes;
  const ByteReader reader =
      arrayBytes(file, codedBytes(file, document, array, least), encoding, bytes); // checks the length
  if (!encoding.isBase64 && !encoding.isCompressed) {
    ByteLocation location = appendedAt(file, document, array);
    location.skip = static_cast<std::uint64_t>(encoding.bytesPerLength);
    if (readInPlace(location, layout, keeping, progress, parts))
      return;
  }
  readVoxels(file, reader, layout, keeping, progress, encoding.isCompressed ? 0 : layout.count, parts);
}

} // namespace

bool isVtkXml(std::string_view bytes) {
  return bytes.find("<VTKFile") != std::string_view::npos && trimmed(bytes).starts_with('<');
}

VolumeParts readVtkXml(const fs::path& path, const VoxelKeeping& keeping, const Progress& progress) {
  const Document document = parse(path);
  const Points points = pointsOf(path, document.image());
  const pugi::xml_node piece = pieceOf(path, document.image());
  const pugi::xml_node ofPoints = arrayIn(piece.child("PointData"));
  const pugi::xml_node array = ofPoints ? ofPoints : arrayIn(piece.child("CellData"));
  if (!array)
    failReading(path, Message::tr("it holds no array of values"),
                Message::tr("export the volume with its scalars"));

  VolumeParts parts;
  parts.info.format = "VTI";
  parts.info.orientationKnown = false;
  parts.info.spacingKnown = points.spacingKnown;
  // Values of cells sit half a step behind the points.
  const glm::ivec3 dims = ofPoints ? points.dims : glm::max(points.dims - 1, glm::ivec3(1));
  const glm::dvec3 shift = ofPoints ? glm::dvec3(0.0) : glm::dvec3(0.5);
  parts.grid = gridFromAxes(path, dims, points.stepsMm, points.firstMm + points.stepsMm * shift);
  const VoxelLayout layout = layoutOf(path, document, array, dims);
  noteLayout(layout, parts.info.warnings);
  readArray(path, document, array, layout, keeping, progress, parts);
  return parts;
}

} // namespace limn
