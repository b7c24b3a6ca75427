// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/nrrd/NrrdFile.h"

#include "io/formats/voxels/AxisGrid.h"
#include "io/formats/voxels/Bytes.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <vector>

namespace limn {
namespace {

// The axes of a NRRD file sorted by what they mean, and where they put the volume (LPS, mm).
struct NrrdAxes {
  int components = 1;        // length of a colour axis before the spatial axes
  glm::ivec3 dims{1};        // the spatial axes
  std::uint64_t volumes = 1; // product of the axes after them
  glm::dmat3 stepsMm{1.0};
  glm::dvec3 originMm{0.0};
  bool orientationKnown = true;
  bool spacingKnown = true;
};

namespace fs = std::filesystem;

constexpr std::uint64_t mostNrrdVolumes = std::uint64_t{1} << 40;

// One axis as the header gives it.
struct Axis {
  int size = 1;
  std::string kind;                   // empty where not given
  std::optional<glm::dvec3> stepFile; // space direction, in the file's space and unit
  bool hasNoDirection = false;        // "none" among given directions
  double spacing = std::nan("");
};

// The text inside the double quotes of a list such as "mm" "mm" "mm".
std::vector<std::string> quoted(const std::string& text) {
  std::vector<std::string> result;
  std::size_t at = 0;
  while ((at = text.find('"', at)) != std::string::npos) {
    const std::size_t end = text.find('"', at + 1);
    if (end == std::string::npos)
      break;
    result.push_back(text.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return result;
}

double millimetresPer(const std::string& unit) {
  if (unit == "m" || unit == "meter" || unit == "meters")
    return 1000.0;
  if (unit == "cm")
    return 10.0;
  if (unit == "um" || unit == "µm" || unit == "micron" || unit == "microns")
    return 0.001;
  if (unit == "nm")
    return 1e-6;
  return 1.0;
}

// The vectors of a list such as (1,0,0) none (0,0,2); `none` gives nothing.
std::vector<std::optional<glm::dvec3>> vectors(const fs::path& file, const std::string& text) {
  std::vector<std::optional<glm::dvec3>> result;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t", at)) != std::string::npos) {
    if (text.compare(at, 4, "none") == 0) {
      result.emplace_back();
      at += 4;
      continue;
    }
    const std::size_t end = text.find(')', at);
    if (text[at] != '(' || end == std::string::npos)
      failReading(file, Message::tr("its header has a damaged list of vectors"), copyAgain);
    std::string inside = text.substr(at + 1, end - at - 1);
    for (char& c : inside)
      if (c == ',')
        c = ' ';
    const std::vector<double> parts = numbers(file, inside);
    if (parts.size() < 2 || parts.size() > 3)
      failReading(file, Message::tr("its space does not have two or three dimensions"),
                  Message::tr("convert it to a 3-D volume first"));
    result.emplace_back(glm::dvec3(parts[0], parts[1], parts.size() == 3 ? parts[2] : 0.0));
    at = end + 1;
  }
  return result;
}

void requireCount(const fs::path& file, const char* field, std::size_t count, std::size_t dimension) {
  if (count != 0 && count != dimension)
    failReading(file, Message::tr("its header's field \"%1\" does not fit its dimension").arg(field),
                copyAgain);
}

std::vector<Axis> axesOf(const fs::path& file, const NrrdHeader& header) {
  const std::vector<double> sizes = numbers(file, header.field("sizes"));
  const auto directions = vectors(file, header.field("space directions"));
  const std::vector<double> spacings = numbers(file, header.field("spacings"));
  const std::vector<std::string> kinds = words(header.field("kinds"));
  if (sizes.empty() || static_cast<double>(sizes.size()) != number(file, header.field("dimension")))
    failReading(file, Message::tr("its header's dimension and sizes do not agree"), copyAgain);
  requireCount(file, "space directions", directions.size(), sizes.size());
  requireCount(file, "spacings", spacings.size(), sizes.size());
  requireCount(file, "kinds", kinds.size(), sizes.size());
  std::vector<Axis> axes(sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    axes[i].size = dimension(file, sizes[i]);
    axes[i].kind = kinds.empty() ? std::string() : lowerCase(kinds[i]);
    if (!directions.empty()) {
      axes[i].stepFile = directions[i];
      axes[i].hasNoDirection = !directions[i];
    }
    if (!spacings.empty())
      axes[i].spacing = std::abs(spacings[i]);
  }
  return axes;
}

bool isSpatial(const Axis& axis) {
  if (axis.hasNoDirection)
    return false;
  const std::string& kind = axis.kind;
  return kind.empty() || kind == "domain" || kind == "space" || kind == "???";
}

bool isColor(const Axis& axis) {
  const std::string& kind = axis.kind;
  const bool saysNothing = kind.empty() || kind == "none" || kind == "???";
  return kind.ends_with("-color") || (saysNothing && (axis.size == 3 || axis.size == 4)) || axis.size == 1;
}

// The change from the file's space to LPS; nothing where the space is not the patient's.
std::optional<glm::dvec3> signsToLps(const std::string& space) {
  const std::string name = space.ends_with("-time") ? space.substr(0, space.size() - 5) : space;
  if (name == "left-posterior-superior" || name == "lps" || name == "lpst")
    return glm::dvec3(1.0);
  if (name == "right-anterior-superior" || name == "ras" || name == "rast")
    return glm::dvec3(-1.0, -1.0, 1.0);
  if (name == "left-anterior-superior" || name == "las" || name == "last")
    return glm::dvec3(1.0, -1.0, 1.0);
  return std::nullopt;
}

// Places the spatial axes by their directions in a space.
void placeInSpace(const fs::path& file, const NrrdHeader& header, const std::vector<Axis>& spatial,
                  NrrdAxes& result) {
  const auto signs = signsToLps(lowerCase(header.field("space")));
  result.orientationKnown = signs.has_value();
  const auto units = quoted(header.field("space units"));
  const double millimetres = units.empty() ? 1.0 : millimetresPer(units.front());
  const glm::dvec3 factor = signs.value_or(glm::dvec3(1.0)) * millimetres;
  for (std::size_t i = 0; i < spatial.size(); ++i)
    result.stepsMm[static_cast<int>(i)] = *spatial[i].stepFile * factor;
  if (spatial.size() == 2)
    result.stepsMm[2] = glm::normalize(glm::cross(result.stepsMm[0], result.stepsMm[1]));
  const auto origin = vectors(file, header.field("space origin"));
  if (!origin.empty() && origin.front())
    result.originMm = *origin.front() * factor;
}

// Gives the spatial axes their spacings only.
void placeBySpacing(const NrrdHeader& header, const std::vector<Axis>& spatial, NrrdAxes& result) {
  result.orientationKnown = false;
  const auto units = quoted(header.field("units"));
  const double millimetres = units.empty() ? 1.0 : millimetresPer(units.back());
  for (std::size_t i = 0; i < spatial.size(); ++i) {
    const double spacing = spatial[i].spacing * millimetres;
    const bool isGiven = spacing > 0.0 && std::isfinite(spacing);
    result.spacingKnown = result.spacingKnown && isGiven;
    result.stepsMm[static_cast<int>(i)] *= isGiven ? spacing : 1.0;
  }
}

// Names that mean one field.
std::string canonicalName(const std::string& name) {
  if (name == "datafile")
    return "data file";
  if (name == "lineskip")
    return "line skip";
  if (name == "byteskip")
    return "byte skip";
  return name;
}

constexpr std::uint64_t mostBytes = std::uint64_t{1} << 60;
constexpr double farthestSkip = 1 << 30; // of bytes before the voxels: no header in use is longer

VoxelType typeOf(const fs::path& file, const NrrdHeader& header) {
  using enum VoxelType;
  // The format gives each type several names.
  static const std::pair<VoxelType, std::string> types[] = {
      {int8, "|signed char|int8|int8_t|"},
      {uint8, "|uchar|unsigned char|uint8|uint8_t|"},
      {int16, "|short|short int|signed short|signed short int|int16|int16_t|"},
      {uint16, "|ushort|unsigned short|unsigned short int|uint16|uint16_t|"},
      {int32, "|int|signed int|int32|int32_t|"},
      {uint32, "|uint|unsigned int|uint32|uint32_t|"},
      {int64, "|longlong|long long|long long int|signed long long|signed long long int|int64|int64_t|"},
      {uint64, "|ulonglong|unsigned long long|unsigned long long int|uint64|uint64_t|"},
      {float32, "|float|"},
      {float64, "|double|"},
  };
  const std::string name = lowerCase(header.field("type"));
  for (const auto& [type, names] : types)
    if (names.find("|" + name + "|") != std::string::npos)
      return type;
  return typeNamed(file, name, {});
}

bool isBigEndian(const fs::path& file, const NrrdHeader& header, VoxelType type, bool isText) {
  const std::string endian = lowerCase(header.field("endian"));
  if (endian != "big" && endian != "little" && bytesPerVoxel(type) > 1 && !isText)
    failReading(file, Message::tr("its header does not name the byte order"),
                Message::tr("add \"endian: little\" or \"endian: big\""));
  return endian == "big";
}

double fieldNumber(const fs::path& file, const NrrdHeader& header, const std::string& name) {
  const std::string text = header.field(name);
  return text.empty() ? 0.0 : number(file, text);
}

// Moves the location behind the first `lines` lines.
void skipLines(ByteLocation& location, double lines) {
  std::ifstream stream(location.file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(location.offset));
  for (double line = 0.0; line < lines && stream; ++line)
    stream.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  if (!stream)
    failReading(location.file, Message::tr("it ends before its voxels start"), copyAgain);
  location.offset = static_cast<std::uint64_t>(stream.tellg());
}

ByteLocation locationOf(const fs::path& path, const NrrdHeader& header, Encoding encoding,
                        std::uint64_t bytes) {
  ByteLocation location;
  location.encoding = encoding;
  const std::string name = header.field("data file");
  location.file = name.empty() ? path : detachedFile(path, name);
  location.offset = name.empty() ? header.end : 0;
  if (const double lines = fieldNumber(path, header, "line skip"); lines > 0.0)
    skipLines(location, lines);
  const double skip = fieldNumber(path, header, "byte skip");
  if (skip == -1.0 && encoding == Encoding::raw) {
    moveToLast(bytes, location);
  } else if (skip >= 0.0 && skip < farthestSkip && skip == std::floor(skip)) {
    location.skip = static_cast<std::uint64_t>(skip);
  } else {
    failReading(path, Message::tr("its header's byte skip is not supported"),
                Message::tr("save it as one .nrrd file"));
  }
  return location;
}

// Sorts and places the axes. Throws Error where they are not those of one scalar or colour volume.
NrrdAxes nrrdAxes(const fs::path& file, const NrrdHeader& header) {
  const std::vector<Axis> axes = axesOf(file, header);
  NrrdAxes result;
  std::vector<Axis> spatial;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const bool volumeIsFull = spatial.size() == 3;
    // Without kinds and directions only three axes are beyond doubt.
    const bool doubtful =
        axes.size() > 3 && axes[i].kind.empty() && !axes[i].stepFile && !axes[i].hasNoDirection;
    if (doubtful)
      failReading(file, Message::tr("its header does not say which of its axes are spatial"),
                  Message::tr("add the field \"kinds\" to the header or save one volume"));
    if (isSpatial(axes[i]) && !volumeIsFull) {
      spatial.push_back(axes[i]);
    } else if (spatial.empty() && i == 0 && isColor(axes[i])) {
      result.components = axes[i].size;
    } else if (volumeIsFull) {
      const auto size = static_cast<std::uint64_t>(axes[i].size);
      if (result.volumes > mostNrrdVolumes / size)
        failReading(file, Message::tr("its header gives more volumes than any file holds"), copyAgain);
      result.volumes *= size;
    } else {
      failReading(file,
                  Message::tr("its axis %1 holds %2 values per voxel (%3), and a volume needs one")
                      .arg(i + 1, axes[i].size,
                           axes[i].kind.empty() ? Message::tr("no kind") : Message(axes[i].kind)),
                  Message::tr("save one component or one time step as a volume of its own"));
    }
  }
  if (spatial.size() < 2 || result.components > 4)
    failReading(file, Message::tr("its axes are not those of one volume"),
                Message::tr("save one scalar volume"));
  for (std::size_t i = 0; i < spatial.size(); ++i)
    result.dims[static_cast<int>(i)] = spatial[i].size;
  if (spatial.front().stepFile)
    placeInSpace(file, header, spatial, result);
  else
    placeBySpacing(header, spatial, result);
  return result;
}

} // namespace

std::string NrrdHeader::field(const std::string& name) const {
  const auto found = fields.find(name);
  return found == fields.end() ? std::string() : found->second;
}

bool isNrrd(std::string_view bytes) {
  return bytes.starts_with("NRRD000");
}

NrrdHeader readNrrdHeader(const std::filesystem::path& file) {
  const std::string text = firstBytes(file, 1 << 20);
  NrrdHeader header;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = text.find('\n', at);
    const std::string_view line = trimmed(std::string_view(text).substr(at, end - at));
    at = end == std::string::npos ? text.size() : end + 1;
    if (line.empty()) {
      header.end = at;
      return header;
    }
    const std::size_t colon = line.find(": ");
    const std::size_t equals = line.find(":=");
    if (line.starts_with('#') || isNrrd(line))
      continue;
    if (equals < colon) {
      header.keys[std::string(line.substr(0, equals))] = line.substr(equals + 2);
      continue;
    }
    if (colon == std::string_view::npos)
      continue;
    const std::string name = canonicalName(lowerCase(trimmed(line.substr(0, colon))));
    header.fields[name] = trimmed(line.substr(colon + 1));
    // A list of data files goes on to the end of the header.
    if (name == "data file" && header.fields[name].starts_with("LIST"))
      break;
  }
  header.end = text.size();
  if (header.field("data file").empty())
    failReading(file, Message::tr("its NRRD header has no end"), copyAgain);
  return header;
}

VolumeParts readNrrd(const fs::path& path, const VoxelKeeping& keeping, const Progress& progress) {
  const NrrdHeader header = readNrrdHeader(path);
  const NrrdAxes axes = nrrdAxes(path, header);
  const std::string encoding = lowerCase(header.field("encoding"));
  const bool isText = encoding == "txt" || encoding == "text" || encoding == "ascii";
  const bool isGzipped = encoding == "gz" || encoding == "gzip";
  if (!isText && !isGzipped && encoding != "raw")
    failReading(path, Message::tr("its encoding \"%1\" is not supported").arg(header.field("encoding")),
                Message::tr("save it with the encoding raw or gzip"));

  VolumeParts parts;
  parts.grid = gridFromAxes(path, axes.dims, axes.stepsMm, axes.originMm);
  parts.info.format = "NRRD";
  parts.info.orientationKnown = axes.orientationKnown;
  parts.info.spacingKnown = axes.spacingKnown;
  VoxelLayout layout;
  layout.type = typeOf(path, header);
  layout.bigEndian = isBigEndian(path, header, layout.type, isText);
  layout.components = axes.components;
  layout.count = voxelCount(path, axes.dims);
  layout.volumes = axes.volumes;
  noteLayout(layout, parts.info.warnings);
  if (axes.volumes > mostBytes / bytesOf(layout))
    failReading(path, Message::tr("its header gives more volumes than any file holds"), copyAgain);
  const std::uint64_t allBytes = bytesOf(layout) * axes.volumes;
  const ByteLocation location =
      locationOf(path, header, isGzipped ? Encoding::deflated : Encoding::raw, allBytes);
  if (isText)
    readTextVoxels(location, layout, keeping, progress, parts);
  else
    readVoxels(location, layout, keeping, progress, parts);
  return parts;
}

} // namespace limn
