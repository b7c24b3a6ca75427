// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/metaimage/MetaImageFile.h"

#include "io/formats/voxels/AxisGrid.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <cmath>
#include <initializer_list>
#include <map>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestHeader = 1 << 20;

struct Header {
  std::map<std::string, std::string> fields; // by lower-case name
  std::uint64_t end = 0;                     // where the voxels of an attached file start

  // The value of the first of several names for one thing; empty where none is there.
  std::string field(std::initializer_list<const char*> names) const {
    for (const char* name : names)
      if (const auto found = fields.find(name); found != fields.end())
        return found->second;
    return {};
  }

  bool isTrue(std::initializer_list<const char*> names) const {
    const std::string value = lowerCase(field(names));
    return value == "true" || value == "t" || value == "1";
  }
};

// Reads lines up to ElementDataFile, which is the last.
Header parseHeader(std::string_view text) {
  Header header;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = std::min(end + 1, text.size());
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos)
      continue;
    const std::string name = lowerCase(trimmed(line.substr(0, equals)));
    header.fields[name] = trimmed(line.substr(equals + 1));
    if (name == "elementdatafile")
      break;
  }
  header.end = at;
  return header;
}

VoxelType typeOfElement(const fs::path& file, const std::string& name) {
  using enum VoxelType;
  static const std::map<std::string, VoxelType> types = {
      {"MET_CHAR", int8},       {"MET_UCHAR", uint8},       {"MET_SHORT", int16},   {"MET_USHORT", uint16},
      {"MET_INT", int32},       {"MET_UINT", uint32},       {"MET_LONG", int32},    {"MET_ULONG", uint32},
      {"MET_LONG_LONG", int64}, {"MET_ULONG_LONG", uint64}, {"MET_FLOAT", float32}, {"MET_DOUBLE", float64}};
  return typeNamed(file, name, types);
}

// The numbers of a field, at least `least` of them; empty where it is absent.
std::vector<double> listOf(const fs::path& file, const Header& header,
                           std::initializer_list<const char*> names, std::size_t least) {
  std::vector<double> values = numbers(file, header.field(names));
  if (!values.empty() && values.size() < least)
    failReading(file, Message::tr("its header's field %1 has too few numbers").arg(*names.begin()),
                copyAgain);
  return values;
}

struct Shape {
  std::size_t dimensions = 3;
  glm::ivec3 dims{1};
  double volumes = 1.0;
};

Shape shapeOf(const fs::path& file, const Header& header) {
  Shape shape;
  const double dimensions = number(file, header.field({"ndims"}));
  if (dimensions != 2.0 && dimensions != 3.0 && dimensions != 4.0)
    failReading(file, Message::tr("it does not have 2 to 4 dimensions"),
                Message::tr("save one volume of it"));
  shape.dimensions = static_cast<std::size_t>(dimensions);
  const std::vector<double> sizes = listOf(file, header, {"dimsize"}, shape.dimensions);
  if (sizes.empty())
    failReading(file, Message::tr("its header has no DimSize"), copyAgain);
  for (std::size_t axis = 0; axis < std::min<std::size_t>(3, shape.dimensions); ++axis)
    shape.dims[static_cast<int>(axis)] = dimension(file, sizes[axis]);
  if (shape.dimensions == 4)
    shape.volumes = dimension(file, sizes[3]);
  return shape;
}

// Places the volume: row i of the TransformMatrix is the direction of axis i.
void place(const fs::path& file, const Header& header, const Shape& shape, VolumeParts& parts) {
  const std::size_t n = shape.dimensions;
  const auto spatial = static_cast<int>(std::min<std::size_t>(n, 3));
  const auto matrix = listOf(file, header, {"transformmatrix", "rotation", "orientation"}, n * n);
  const auto offset = listOf(file, header, {"offset", "position", "origin"}, n);
  const auto spacing = listOf(file, header, {"elementspacing", "elementsize"}, n);
  parts.info.spacingKnown = !spacing.empty();
  parts.info.orientationKnown =
      !matrix.empty() && header.field({"anatomicalorientation"}).find('?') == std::string::npos;
  glm::dmat3 steps(1.0);
  glm::dvec3 origin(0.0);
  for (int axis = 0; axis < spatial; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    for (int row = 0; row < spatial && !matrix.empty(); ++row)
      steps[axis][row] = matrix[a * n + static_cast<std::size_t>(row)];
    steps[axis] *= spacing.empty() ? 1.0 : std::abs(spacing[a]);
    origin[axis] = offset.empty() ? 0.0 : offset[a];
  }
  parts.grid = gridFromAxes(file, shape.dims, steps, origin);
}

Rescale rescaleOf(const fs::path& file, const Header& header) {
  Rescale rescale;
  if (const auto slope = listOf(file, header, {"elementtointensityfunctionslope"}, 1);
      !slope.empty() && slope[0] != 0.0)
    rescale.slope = slope[0];
  if (const auto offset = listOf(file, header, {"elementtointensityfunctionoffset"}, 1); !offset.empty())
    rescale.intercept = offset[0];
  return rescale;
}

ByteLocation locationOf(const fs::path& path, const Header& header, std::uint64_t bytes) {
  const std::string name = header.field({"elementdatafile"});
  if (name.empty())
    failReading(path, Message::tr("its header names no ElementDataFile"), copyAgain);
  const bool isLocal = name == "LOCAL" || name == "Local" || name == "local";
  ByteLocation location;
  location.file = isLocal ? path : detachedFile(path, name);
  location.offset = isLocal ? header.end : 0;
  location.encoding = header.isTrue({"compresseddata"}) ? Encoding::deflated : Encoding::raw;
  const std::string skip = header.field({"headersize"});
  const double headerSize = skip.empty() ? 0.0 : number(path, skip);
  if (headerSize > 0.0 && headerSize < 1e12 && headerSize == std::floor(headerSize)) {
    location.offset += static_cast<std::uint64_t>(headerSize);
  } else if (headerSize == -1.0 && location.encoding == Encoding::raw) {
    moveToLast(bytes, location);
  } else if (headerSize != 0.0) {
    failReading(path, Message::tr("its header's HeaderSize is not supported"),
                Message::tr("save it as one .mha file"));
  }
  return location;
}

VoxelLayout layoutOf(const fs::path& path, const Header& header, const glm::ivec3& dims) {
  VoxelLayout layout;
  layout.type = typeOfElement(path, header.field({"elementtype"}));
  layout.bigEndian = header.isTrue({"binarydatabyteordermsb", "elementbyteordermsb"});
  layout.components = componentCount(path, header.field({"elementnumberofchannels"}));
  layout.count = voxelCount(path, dims);
  return layout;
}

} // namespace

bool isMetaImage(std::string_view bytes) {
  const Header header = parseHeader(bytes);
  const bool startsAsText = bytes.starts_with("ObjectType") || bytes.starts_with("NDims") ||
                            bytes.starts_with("Comment") || bytes.starts_with("ID");
  return startsAsText && !header.field({"ndims"}).empty() && !header.field({"dimsize"}).empty();
}

VolumeParts readMetaImage(const fs::path& path, const VoxelKeeping& keeping, const Progress& progress) {
  const Header header = parseHeader(firstBytes(path, longestHeader));
  const Shape shape = shapeOf(path, header);
  VoxelLayout layout = layoutOf(path, header, shape.dims);
  layout.volumes = static_cast<std::uint64_t>(shape.volumes);

  VolumeParts parts;
  parts.info.format = "MetaImage";
  place(path, header, shape, parts);
  parts.rescale = rescaleOf(path, header);
  noteLayout(layout, parts.info.warnings);

  // At most 2⁴⁵ bytes, 2³¹ times: their product counts as too many where it overflows.
  const bool isCountable = layout.volumes <= (std::uint64_t{1} << 60) / bytesOf(layout);
  const std::uint64_t allBytes = isCountable ? bytesOf(layout) * layout.volumes : ~std::uint64_t{0};
  const ByteLocation location = locationOf(path, header, allBytes);
  const std::string binary = header.field({"binarydata"});
  const bool isText = !binary.empty() && !header.isTrue({"binarydata"});
  if (isText && location.encoding != Encoding::raw)
    failReading(path, Message::tr("it holds compressed text"),
                Message::tr("save it uncompressed or as binary data"));
  if (isText)
    readTextVoxels(location, layout, keeping, progress, parts);
  else
    readVoxels(location, layout, keeping, progress, parts);
  return parts;
}

} // namespace limn
