// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/nifti/NiftiFile.h"

#include "io/formats/voxels/AxisGrid.h"
#include "io/formats/voxels/Voxels.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr double mostNiftiVolumes = 1e9;
constexpr double farthestOffset = 1 << 30; // of the voxels: behind it no header ends

struct Sample {
  int datatype; ///< its number in the header
  VoxelType type;
  int components = 1;
};

constexpr Sample sampleTypes[] = {
    {2, VoxelType::uint8},    {4, VoxelType::int16},     {8, VoxelType::int32},
    {16, VoxelType::float32}, {64, VoxelType::float64},  {128, VoxelType::uint8, 3},
    {256, VoxelType::int8},   {512, VoxelType::uint16},  {768, VoxelType::uint32},
    {1024, VoxelType::int64}, {1280, VoxelType::uint64}, {2304, VoxelType::uint8, 4}};

const Sample& sampleOf(const fs::path& file, int datatype) {
  const auto found = std::ranges::find(sampleTypes, datatype, &Sample::datatype);
  if (found == std::end(sampleTypes))
    failReading(
        file,
        Message::tr("its voxels are of NIfTI type %1 (binary, complex or 128-bit numbers are not supported)")
            .arg(datatype),
        Message::tr("convert it to integers or floats first"));
  return *found;
}

// The other half of a pair: the same name with the other ending, compressed or not.
fs::path partner(const fs::path& path, const std::string& ending) {
  fs::path stem = path;
  if (stem.extension() == ".gz")
    stem.replace_extension();
  stem.replace_extension();
  for (const std::string& end : {ending, ending + ".gz"}) {
    fs::path candidate = stem;
    candidate += end;
    std::error_code problem;
    if (fs::is_regular_file(candidate, problem))
      return candidate;
  }
  failReading(path, Message::tr("its other half %1%2 is missing").arg(stem.string()).arg(ending),
              Message::tr("copy both files of the pair into one folder"));
}

bool isVoxelFile(const fs::path& path) {
  const fs::path name = path.extension() == ".gz" ? path.stem() : path.filename();
  return name.extension() == ".img";
}

NiftiHeader headerOf(const fs::path& file) {
  const std::string bytes = firstBytes(file, niftiHeaderBytes);
  if (const auto header = parseNiftiHeader(bytes))
    return *header;
  if (isAnalyzeHeader(bytes))
    failReading(file, Message::tr("it is an Analyze 7.5 file, which does not say which side is left"),
                Message::tr("convert it to NIfTI (.nii) first"));
  failReading(file, Message::tr("its NIfTI header is cut off or damaged"), copyAgain);
}

glm::ivec3 dimsOf(const fs::path& file, const NiftiHeader& header) {
  if (!(header.dim[0] >= 2.0 && header.dim[0] <= 7.0))
    failReading(file, Message::tr("its header does not give 2 to 7 dimensions"), copyAgain);
  glm::ivec3 dims(1);
  for (int axis = 0; axis < 3 && axis < header.dim[0]; ++axis)
    dims[axis] = dimension(file, header.dim[static_cast<std::size_t>(axis) + 1]);
  return dims;
}

// How many volumes the file says it holds.
std::uint64_t volumesOf(const fs::path& file, const NiftiHeader& header) {
  double volumes = 1.0;
  for (std::size_t i = 4; i <= 7 && static_cast<double>(i) <= header.dim[0]; ++i)
    volumes *= std::max(header.dim[i], 1.0);
  if (volumes > mostNiftiVolumes)
    failReading(file, Message::tr("its header gives more volumes than any file holds"), copyAgain);
  return static_cast<std::uint64_t>(volumes);
}

// The type of a voxel stands in the header twice.
void requireOneType(const fs::path& file, const NiftiHeader& header, const Sample& sample) {
  const auto bits = static_cast<int>(8 * bytesPerVoxel(sample.type)) * sample.components;
  if (header.bitsPerVoxel != 0 && header.bitsPerVoxel != bits)
    failReading(file,
                Message::tr("its header contradicts itself: voxels of %1 bits, and of a type that has %2")
                    .arg(header.bitsPerVoxel)
                    .arg(bits),
                copyAgain);
}

ByteLocation locationOf(const fs::path& voxelFile, const NiftiHeader& header) {
  const double headerBytes = header.version == 1 ? 348.0 : 540.0;
  // Some writers leave the offset of a single file 0: the voxels follow the header and its four flag bytes.
  const double offset =
      header.singleFile && header.voxelOffset == 0.0 ? headerBytes + 4.0 : header.voxelOffset;
  const double least = header.singleFile ? headerBytes : 0.0;
  if (!(offset >= least) || offset > farthestOffset || offset != std::floor(offset))
    failReading(voxelFile, Message::tr("its header places the voxels at an impossible offset"), copyAgain);
  ByteLocation location;
  location.file = voxelFile;
  location.encoding = isGzip(voxelFile) ? Encoding::deflated : Encoding::raw;
  location.skip = static_cast<std::uint64_t>(offset);
  return location;
}

// Writers that do not scale leave slope and intercept 0, or NaN.
Rescale rescaleOf(const NiftiHeader& header, int components, std::vector<Message>& warnings) {
  const bool isAbsent = header.slope == 0.0 || (std::isnan(header.slope) && std::isnan(header.intercept));
  if (components > 1 || isAbsent)
    return {};
  if (std::isfinite(header.slope) && std::isfinite(header.intercept))
    return {header.slope, header.intercept};
  warnings.emplace_back(
      Message::tr("The file's scaling is damaged: the values are those stored, in no known unit."));
  return {};
}

} // namespace

bool isNifti(std::string_view bytes) {
  return parseNiftiHeader(bytes) || isAnalyzeHeader(bytes);
}

VolumeParts readNifti(const fs::path& path, const MemoryBudget& budget, const Progress& progress) {
  const fs::path headerFile = isVoxelFile(path) ? partner(path, ".hdr") : path;
  const NiftiHeader header = headerOf(headerFile);
  const fs::path voxelFile = header.singleFile   ? headerFile
                             : isVoxelFile(path) ? path
                                                 : partner(path, ".img");
  const glm::ivec3 dims = dimsOf(headerFile, header);
  const Sample sample = sampleOf(headerFile, header.datatype);
  const NiftiPlacement placement = placementOf(header);

  VolumeParts parts;
  parts.grid = gridFromAxes(headerFile, dims, placement.stepsMm, placement.originMm);
  parts.info.format = "NIfTI-" + std::to_string(header.version);
  parts.info.orientationKnown = placement.orientationKnown;
  parts.info.spacingKnown = placement.spacingKnown;
  parts.info.warnings = placement.warnings;
  requireOneType(headerFile, header, sample);

  VoxelLayout layout;
  layout.type = sample.type;
  layout.bigEndian = header.bigEndian;
  layout.components = sample.components;
  layout.count = voxelCount(headerFile, dims);
  layout.volumes = volumesOf(headerFile, header);
  noteLayout(layout, parts.info.warnings);
  parts.rescale = rescaleOf(header, sample.components, parts.info.warnings);
  readVoxels(locationOf(voxelFile, header), layout, budget, progress, parts);
  return parts;
}

} // namespace limn
