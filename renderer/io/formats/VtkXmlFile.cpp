// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/VtkXmlFile.h"

#include "io/formats/AxisGrid.h"
#include "io/formats/HeaderText.h"
#include "io/formats/ReadError.h"
#include "io/formats/Voxels.h"
#include "io/formats/VtkXmlArray.h"

#include <pugixml.hpp>

#include <map>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view appendedTag = "<AppendedData";

// The elements of the file, and where its appended bytes start.
struct Document {
  pugi::xml_document xml;
  std::uint64_t appended = 0; // 0: there are none
  bool appendedIsBase64 = false;

  pugi::xml_node root() const { return xml.child("VTKFile"); }
  pugi::xml_node image() const { return root().child("ImageData"); }
};

// Reads up to the appended bytes, which are no XML, or to the end.
std::string textOf(const fs::path& file) {
  constexpr std::size_t step = 1 << 20;
  const ByteReader bytes = openBytes({file}, 1);
  std::string text;
  std::size_t got = step;
  std::size_t found = std::string::npos;
  while (got == step && found == std::string::npos) {
    const std::size_t before = text.size();
    text.resize(before + step);
    got = bytes(reinterpret_cast<unsigned char*>(text.data() + before), step);
    text.resize(before + got);
    found = text.find(appendedTag, before > appendedTag.size() ? before - appendedTag.size() : 0);
  }
  return text;
}

Document parse(const fs::path& file) {
  const std::string text = textOf(file);
  const std::size_t tag = std::min(text.find(appendedTag), text.size());
  Document document;
  // With appended bytes the text is cut before its last elements close; the tree up to there is kept.
  const pugi::xml_parse_result result = document.xml.load_buffer(text.data(), tag);
  const std::string type = document.root().attribute("type").as_string();
  if (type != "ImageData")
    failReading(file, "it holds VTK data of the type \"" + type + "\", not image data",
                "export the volume as image data (.vti)");
  if (tag == text.size() && !result)
    failReading(file, "its text is cut off or damaged", copyAgain);
  if (tag == text.size())
    return document;
  const std::size_t tagEnd = text.find('>', tag);
  const std::size_t mark = tagEnd == std::string::npos ? tagEnd : text.find('_', tagEnd);
  if (mark == std::string::npos)
    failReading(file, "its appended data are missing", copyAgain);
  document.appended = mark + 1;
  document.appendedIsBase64 = text.substr(tag, tagEnd - tag).find("\"raw\"") == std::string::npos;
  return document;
}

std::vector<double> listOf(const fs::path& file, const pugi::xml_node& node, const char* name,
                           std::size_t count) {
  const std::vector<double> values = numbers(file, node.attribute(name).as_string());
  if (!values.empty() && values.size() != count)
    failReading(file, std::string("its attribute ") + name + " has the wrong number of numbers", copyAgain);
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
    failReading(file, "its header has no WholeExtent", copyAgain);
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
    failReading(file, "it does not hold exactly one piece", "save it as one piece");
  if (numbers(file, piece.attribute("Extent").as_string()) != listOf(file, image, "WholeExtent", 6))
    failReading(file, "its piece does not fill its extent", copyAgain);
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
  static const std::map<std::string, VoxelType> types = {
      {"UInt8", VoxelType::uint8},     {"Int8", VoxelType::int8},     {"UInt16", VoxelType::uint16},
      {"Int16", VoxelType::int16},     {"UInt32", VoxelType::uint32}, {"Int32", VoxelType::int32},
      {"UInt64", VoxelType::uint64},   {"Int64", VoxelType::int64},   {"Float32", VoxelType::float32},
      {"Float64", VoxelType::float64},
  };
  const std::string name = array.attribute("type").as_string();
  const auto type = types.find(name);
  if (type == types.end())
    failReading(file, "its values are of the type \"" + name + "\", which is not supported",
                "convert it to integers or floats first");
  VoxelLayout layout;
  layout.type = type->second;
  layout.bigEndian = std::string(document.root().attribute("byte_order").as_string()) == "BigEndian";
  layout.components = array.attribute("NumberOfComponents").as_int(1);
  if (layout.components != 1 && layout.components != 3 && layout.components != 4)
    failReading(file,
                "it holds " + std::to_string(layout.components) + " values per voxel, and a volume needs one",
                "save one component as a volume of its own");
  layout.count = voxelCount(file, dims);
  return layout;
}

VtkXmlEncoding encodingOf(const fs::path& file, const Document& document) {
  const std::string compressor = document.root().attribute("compressor").as_string();
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    failReading(file, "its compression " + compressor + " is not supported",
                "save it with ZLib or uncompressed");
  VtkXmlEncoding encoding;
  encoding.bigEndian = std::string(document.root().attribute("byte_order").as_string()) == "BigEndian";
  encoding.bytesPerLength =
      std::string(document.root().attribute("header_type").as_string()) == "UInt64" ? 8 : 4;
  encoding.isCompressed = !compressor.empty();
  return encoding;
}

VoxelArray voxelsOf(const fs::path& file, const Document& document, const pugi::xml_node& array,
                    const VoxelLayout& layout, const Progress& progress) {
  const std::string format = array.attribute("format").as_string("ascii");
  if (format == "ascii")
    return parseTextVoxels(file, array.text().as_string(), layout, progress);
  const VtkXmlEncoding encoding = encodingOf(file, document);
  const std::uint64_t bytes = bytesOf(layout);
  if (format == "binary")
    return readVoxels(file, arrayBytes(file, base64Units(file, array.text().as_string()), encoding, bytes),
                      layout, progress);
  if (format != "appended" || document.appended == 0)
    failReading(file, "its array of values is missing", copyAgain);
  const std::uint64_t first = document.appended + array.attribute("offset").as_ullong();
  if (!document.appendedIsBase64)
    return readVoxels(file, arrayBytes(file, plainUnits(file, first), encoding, bytes), layout, progress);
  const std::uint64_t size = fs::file_size(file);
  const std::string text = plainUnits(file, first)(size > first ? size - first : 0);
  return readVoxels(file, arrayBytes(file, base64Units(file, text), encoding, bytes), layout, progress);
}

} // namespace

bool isVtkXml(std::string_view bytes) {
  return bytes.find("<VTKFile") != std::string_view::npos && trimmed(bytes).starts_with('<');
}

VolumeParts readVtkXml(const fs::path& path, const Progress& progress) {
  const Document document = parse(path);
  const Points points = pointsOf(path, document.image());
  const pugi::xml_node piece = pieceOf(path, document.image());
  const pugi::xml_node ofPoints = arrayIn(piece.child("PointData"));
  const pugi::xml_node array = ofPoints ? ofPoints : arrayIn(piece.child("CellData"));
  if (!array)
    failReading(path, "it holds no array of values", "export the volume with its scalars");

  VolumeParts parts;
  parts.info.format = "VTI";
  parts.info.orientationKnown = false;
  parts.info.spacingKnown = points.spacingKnown;
  // Values of cells sit half a step behind the points.
  const glm::ivec3 dims = ofPoints ? points.dims : glm::max(points.dims - 1, glm::ivec3(1));
  const glm::dvec3 shift = ofPoints ? glm::dvec3(0.0) : glm::dvec3(0.5);
  parts.grid = gridFromAxes(path, dims, points.stepsMm, points.firstMm + points.stepsMm * shift);
  const VoxelLayout layout = layoutOf(path, document, array, dims);
  if (layout.components > 1)
    parts.info.warnings.emplace_back(colorWarning);
  parts.stored = voxelsOf(path, document, array, layout, progress);
  return parts;
}

} // namespace limn
