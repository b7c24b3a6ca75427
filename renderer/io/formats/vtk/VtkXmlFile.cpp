// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/vtk/VtkXmlFile.h"

#include "io/formats/voxels/AxisGrid.h"
#include "io/formats/voxels/Bytes.h"
#include "io/formats/voxels/Voxels.h"
#include "io/formats/vtk/VtkXmlArray.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <pugixml.hpp>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace limn {
namespace {

// The elements of a VTK XML file without the values between them, which may be long: where text stood, its
// place in the file stands instead, as two numbers (offset and length).
struct VtkXmlText {
  std::string xml;            ///< up to the appended bytes, which are no XML, or to the end
  std::uint64_t appended = 0; ///< where the appended bytes start; 0 where there are none
  bool appendedIsBase64 = false;
};

// Reads the elements of a file. Throws Error where they are no XML or longer than any in use.
VtkXmlText readVtkXmlText(const std::filesystem::path& file);

// A run of bytes of a file.
struct VtkXmlRun {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

// The bytes of a run.
ByteReader bytesOfRun(const std::filesystem::path& file, const VtkXmlRun& run);

namespace fs = std::filesystem;

constexpr std::size_t longestXml = 16 << 20;
constexpr std::string_view appendedTag = "<AppendedData";

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

VtkXmlText readVtkXmlText(const fs::path& file) {
  return Scanner(file).scanned();
}

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

ByteReader bytesOfRun(const fs::path& file, const VtkXmlRun& run) {
  const ByteReader bytes = openBytes({file, run.offset}, run.length);
  return [bytes, left = run.length](unsigned char* to, std::size_t count) mutable {
    const std::size_t got = bytes(to, static_cast<std::size_t>(std::min<std::uint64_t>(count, left)));
    left -= got;
    return got;
  };
}

namespace fs = std::filesystem;

// The elements of the file, and where its appended bytes start.
struct Document {
  pugi::xml_document xml;
  VtkXmlText text;

  pugi::xml_node root() const { return xml.child("VTKFile"); }
  pugi::xml_node image() const { return root().child("ImageData"); }
};

Document parse(const fs::path& file) {
  Document document;
  document.text = readVtkXmlText(file);
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
               const VoxelLayout& layout, const MemoryBudget& budget, const Progress& progress,
               VolumeParts& parts) {
  const std::string format = array.attribute("format").as_string("ascii");
  if (format == "ascii") {
    readTextVoxels(file, codedBytes(file, document, array, 2 * layout.count - 1), layout, budget, progress,
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
    if (mapVoxels(location, layout, budget, parts))
      return;
  }
  readVoxels(file, reader, layout, budget, progress, encoding.isCompressed ? 0 : layout.count, parts);
}

} // namespace

bool isVtkXml(std::string_view bytes) {
  return bytes.find("<VTKFile") != std::string_view::npos && trimmed(bytes).starts_with('<');
}

VolumeParts readVtkXml(const fs::path& path, const MemoryBudget& budget, const Progress& progress) {
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
  readArray(path, document, array, layout, budget, progress, parts);
  return parts;
}

} // namespace limn
