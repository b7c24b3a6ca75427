// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/vtk/VtkLegacyFile.h"

#include "io/formats/voxels/AxisGrid.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <map>

namespace limn {
namespace {

namespace fs = std::filesystem;

// A header of five to a dozen lines; a long title or other words may precede the voxels.
constexpr std::size_t longestLegacyHeader = 1 << 16;

struct LegacyHeader {
  bool isText = false;
  bool isCellData = false;
  std::map<std::string, std::vector<std::string>> lines; // by upper-case first word, the words after it
  std::uint64_t end = 0;                                 // where the voxels start

  // The numbers behind a word, three of them; `otherwise` where the word is absent.
  glm::dvec3 triple(const fs::path& file, const std::string& word, const glm::dvec3& otherwise) const {
    const auto found = lines.find(word);
    if (found == lines.end())
      return otherwise;
    if (found->second.size() < 3)
      failReading(file, Message::tr("its header's line %1 has too few numbers").arg(word), copyAgain);
    return {number(file, found->second[0]), number(file, found->second[1]), number(file, found->second[2])};
  }
};

std::string upperCase(std::string text) {
  for (char& c : text)
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

// Takes the next line off the text; false at its end.
bool takeLine(std::string_view text, std::size_t& at, std::string_view& line) {
  const std::size_t end = text.find('\n', at);
  if (end == std::string_view::npos)
    return false;
  line = trimmed(text.substr(at, end - at));
  at = end + 1;
  return true;
}

// Reads lines up to the voxels of the first SCALARS (behind an optional LOOKUP_TABLE) or COLOR_SCALARS.
LegacyHeader parseHeader(const fs::path& file, std::string_view text) {
  LegacyHeader header;
  std::size_t at = 0;
  std::string_view line;
  for (int title = 0; title < 2; ++title)
    takeLine(text, at, line);
  while (takeLine(text, at, line)) {
    std::vector<std::string> parts = words(line);
    if (parts.empty())
      continue;
    const std::string word = upperCase(parts.front());
    parts.erase(parts.begin());
    header.isText = header.isText || word == "ASCII";
    header.isCellData = header.isCellData || word == "CELL_DATA";
    header.lines[word] = parts;
    if (word == "FIELD" || word == "VECTORS" || word == "TENSORS")
      break;
    if (word != "SCALARS")
      continue;
    header.end = at;
    if (takeLine(text, at, line) && line.starts_with("LOOKUP_TABLE"))
      header.end = at;
    return header;
  }
  failReading(file, Message::tr("its header names no SCALARS among its first lines"),
              Message::tr("export it as structured points with scalars"));
}

VoxelType typeOfScalars(const fs::path& file, const std::string& name) {
  using enum VoxelType;
  static const std::map<std::string, VoxelType> types = {
      {"unsigned_char", uint8}, {"char", int8},     {"unsigned_short", uint16}, {"short", int16},
      {"unsigned_int", uint32}, {"int", int32},     {"vtktypeuint64", uint64},  {"vtktypeint64", int64},
      {"float", float32},       {"double", float64}};
  return typeNamed(file, lowerCase(name), types);
}

VoxelLayout layoutOf(const fs::path& file, const LegacyHeader& header, const glm::ivec3& dims) {
  const std::vector<std::string>& scalars = header.lines.at("SCALARS");
  if (scalars.size() < 2)
    failReading(file, Message::tr("its header's line SCALARS is cut off"), copyAgain);
  VoxelLayout layout;
  layout.type = typeOfScalars(file, scalars[1]);
  layout.bigEndian = true;
  layout.endsFile = false; // further arrays may follow
  layout.components = componentCount(file, scalars.size() > 2 ? scalars[2] : "");
  layout.count = voxelCount(file, dims);
  return layout;
}

// The number behind POINT_DATA or CELL_DATA says the size of the volume a second time.
void requireOneSize(const fs::path& file, const LegacyHeader& header, std::uint64_t voxels) {
  const std::string word = header.isCellData ? "CELL_DATA" : "POINT_DATA";
  const auto found = header.lines.find(word);
  const bool isGiven = found != header.lines.end() && !found->second.empty();
  if (isGiven && number(file, found->second.front()) != static_cast<double>(voxels))
    failReading(file,
                Message::tr("its header contradicts itself: %1 %2 where DIMENSIONS make %3")
                    .arg(word, found->second.front(), voxels),
                copyAgain);
}

} // namespace

bool isVtkLegacy(std::string_view bytes) {
  return bytes.starts_with("# vtk DataFile");
}

VolumeParts readVtkLegacy(const fs::path& path, const VoxelKeeping& keeping, const Progress& progress) {
  const LegacyHeader header = parseHeader(path, firstBytes(path, longestLegacyHeader));
  const auto dataset = header.lines.find("DATASET");
  if (dataset == header.lines.end() || dataset->second.empty() ||
      upperCase(dataset->second.front()) != "STRUCTURED_POINTS")
    failReading(path, Message::tr("it holds no image data (STRUCTURED_POINTS)"),
                Message::tr("export the volume as image data (.vti)"));
  const glm::dvec3 points = header.triple(path, "DIMENSIONS", glm::dvec3(0.0));
  const glm::dvec3 spacing =
      header.triple(path, "SPACING", header.triple(path, "ASPECT_RATIO", glm::dvec3(0.0)));
  glm::dvec3 origin = header.triple(path, "ORIGIN", glm::dvec3(0.0));

  VolumeParts parts;
  parts.info.format = "VTK";
  parts.info.orientationKnown = false;
  parts.info.spacingKnown = spacing != glm::dvec3(0.0);
  const glm::dvec3 step = parts.info.spacingKnown ? spacing : glm::dvec3(1.0);
  glm::ivec3 dims(0);
  for (int axis = 0; axis < 3; ++axis)
    dims[axis] = dimension(path, header.isCellData ? std::max(points[axis] - 1.0, 1.0) : points[axis]);
  // Values of cells sit half a step behind the points.
  if (header.isCellData)
    origin += 0.5 * step;
  const glm::dmat3 steps({step.x, 0.0, 0.0}, {0.0, step.y, 0.0}, {0.0, 0.0, step.z});
  parts.grid = gridFromAxes(path, dims, steps, origin);

  const VoxelLayout layout = layoutOf(path, header, dims);
  requireOneSize(path, header, layout.count);
  noteLayout(layout, parts.info.warnings);
  ByteLocation location;
  location.file = path;
  location.offset = header.end;
  if (header.isText)
    readTextVoxels(location, layout, keeping, progress, parts);
  else
    readVoxels(location, layout, keeping, progress, parts);
  return parts;
}

} // namespace limn
