// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/nrrd/NrrdFile.h"

#include "io/formats/nrrd/NrrdHeader.h"
#include "io/formats/voxels/AxisGrid.h"
#include "io/formats/voxels/TextVoxels.h"
#include "io/formats/voxels/Voxels.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <cmath>
#include <fstream>
#include <limits>

namespace limn {
namespace {

namespace fs = std::filesystem;

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

} // namespace

VolumeParts readNrrd(const fs::path& path, const MemoryBudget& budget, const Progress& progress) {
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
    readTextVoxels(location, layout, budget, progress, parts);
  else
    readVoxels(location, layout, budget, progress, parts);
  return parts;
}

} // namespace limn
