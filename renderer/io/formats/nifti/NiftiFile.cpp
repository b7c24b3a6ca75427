// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/nifti/NiftiFile.h"

#include "io/formats/voxels/AxisGrid.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace limn {
namespace {

// Bytes that hold either version's header.
constexpr std::size_t niftiHeaderBytes = 540;

// The fields of a NIfTI-1 or NIfTI-2 header that place and decode its voxels, as stored (RAS, file units).
// Source: nifti1.h and nifti2.h of the NIfTI Data Format Working Group.
struct NiftiHeader {
  int version = 1;
  bool bigEndian = false;
  bool singleFile = true; // voxels in this file, else in an .img file
  std::array<double, 8> dim{};
  std::array<double, 8> pixdim{};
  int bitsPerVoxel = 0; // 0 where the writer left it out
  int datatype = 0;
  double voxelOffset = 0.0;
  double slope = 0.0;
  double intercept = 0.0;
  int units = 0;
  int qformCode = 0;
  int sformCode = 0;
  glm::dvec3 quaternion{0.0}; // b, c, d
  glm::dvec3 quaternionOffset{0.0};
  std::array<glm::dvec4, 3> sformRows{};
};

// Where a NIfTI header places its voxels, in LPS and mm.
struct NiftiPlacement {
  glm::dmat3 stepsMm{1.0}; // columns: one voxel along each axis
  glm::dvec3 originMm{0.0};
  bool orientationKnown = true;
  bool spacingKnown = true;
  std::vector<Message> warnings;
};

// An affine map from voxel index to mm.
struct Affine {
  glm::dmat3 steps{1.0};
  glm::dvec3 origin{0.0};
};

// Millimetres per unit of length; files that name no unit mean millimetres.
double millimetresPerUnit(int units) {
  switch (units & 7) {
  case 1:
    return 1000.0;
  case 3:
    return 0.001;
  default:
    return 1.0;
  }
}

Affine sformOf(const NiftiHeader& header) {
  const auto& rows = header.sformRows;
  Affine affine;
  for (int axis = 0; axis < 3; ++axis)
    affine.steps[axis] = {rows[0][axis], rows[1][axis], rows[2][axis]};
  affine.origin = {rows[0].w, rows[1].w, rows[2].w};
  return affine;
}

// The rotation of the quaternion (a, b, c, d), a ≥ 0 left out, times the voxel size; a negative pixdim[0]
// turns the third axis round (nifti1.h, "METHOD 2").
Affine qformOf(const NiftiHeader& header) {
  glm::dvec3 v = header.quaternion;
  const double rest = 1.0 - glm::dot(v, v);
  const double a = rest > 1e-7 ? std::sqrt(rest) : 0.0;
  if (a == 0.0)
    v /= glm::length(v);
  const double b = v.x, c = v.y, d = v.z;
  Affine affine;
  affine.steps[0] = {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
  affine.steps[1] = {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)};
  affine.steps[2] = {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c};
  affine.steps[2] *= header.pixdim[0] < 0.0 ? -1.0 : 1.0;
  for (int axis = 0; axis < 3; ++axis)
    affine.steps[axis] *= std::abs(header.pixdim[static_cast<std::size_t>(axis) + 1]);
  affine.origin = header.quaternionOffset;
  return affine;
}

bool isValid(int code, const Affine& affine) {
  return code > 0 && isUsable(affine.steps) && std::isfinite(glm::length(affine.origin));
}

// Whether the quaternion is one of unit length, but for the rounding of float32.
bool isRotation(const NiftiHeader& header) {
  return glm::dot(header.quaternion, header.quaternion) <= 1.0 + 1e-4;
}

// The largest distance between the places of one corner of the volume in two maps.
double largestCornerDistance(const Affine& a, const Affine& b, const NiftiHeader& header) {
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 index(0.0);
    for (int axis = 0; axis < 3; ++axis)
      index[axis] =
          (corner >> axis & 1) ? std::max(header.dim[static_cast<std::size_t>(axis) + 1] - 1.0, 0.0) : 0.0;
    largest = std::max(largest, glm::distance(a.steps * index + a.origin, b.steps * index + b.origin));
  }
  return largest;
}

NiftiPlacement placed(const Affine& affine, double millimetres) {
  NiftiPlacement placement;
  placement.stepsMm = rasToLps(affine.steps) * millimetres;
  placement.originMm = rasToLps(affine.origin) * millimetres;
  return placement;
}

NiftiPlacement spacingOnly(const NiftiHeader& header, double millimetres) {
  NiftiPlacement placement;
  placement.orientationKnown = false;
  for (int axis = 0; axis < 3; ++axis) {
    const double spacing = std::abs(header.pixdim[static_cast<std::size_t>(axis) + 1]) * millimetres;
    const bool isGiven = spacing > 0.0 && std::isfinite(spacing);
    placement.spacingKnown = placement.spacingKnown && isGiven;
    placement.stepsMm[axis] *= isGiven ? spacing : 1.0;
  }
  return placement;
}

using namespace std::string_view_literals;

constexpr std::int32_t size1 = 348;
constexpr std::int32_t size2 = 540;

// Reads numbers at byte offsets in either byte order.
class Fields {
public:
  Fields(std::string_view bytes, bool bigEndian)
      : m_bytes(bytes), m_swap(bigEndian != (std::endian::native == std::endian::big)) {}

  template <class T>
  T at(std::size_t offset) const {
    std::array<char, sizeof(T)> raw{};
    std::copy_n(m_bytes.data() + offset, sizeof(T), raw.data());
    if (m_swap)
      std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
  }

  template <class T>
  double number(std::size_t offset) const {
    return static_cast<double>(at<T>(offset));
  }

  template <class T>
  glm::dvec3 triple(std::size_t offset) const {
    return {number<T>(offset), number<T>(offset + sizeof(T)), number<T>(offset + 2 * sizeof(T))};
  }

private:
  std::string_view m_bytes;
  bool m_swap;
};

template <class Length, class Real>
void readArrays(NiftiHeader& header, const Fields& fields, std::size_t dim, std::size_t pixdim,
                std::size_t rows) {
  for (std::size_t i = 0; i < 8; ++i) {
    header.dim[i] = fields.number<Length>(dim + i * sizeof(Length));
    header.pixdim[i] = fields.number<Real>(pixdim + i * sizeof(Real));
  }
  for (std::size_t row = 0; row < 3; ++row) {
    const std::size_t start = rows + row * 4 * sizeof(Real);
    header.sformRows[row] = {fields.triple<Real>(start), fields.number<Real>(start + 3 * sizeof(Real))};
  }
}

NiftiHeader parse1(std::string_view bytes, bool bigEndian) {
  const Fields fields(bytes, bigEndian);
  NiftiHeader header;
  header.version = 1;
  header.bigEndian = bigEndian;
  header.singleFile = bytes.substr(344, 4) == "n+1\0"sv;
  readArrays<std::int16_t, float>(header, fields, 40, 76, 280);
  header.datatype = fields.at<std::int16_t>(70);
  header.bitsPerVoxel = fields.at<std::int16_t>(72);
  header.voxelOffset = fields.number<float>(108);
  header.slope = fields.number<float>(112);
  header.intercept = fields.number<float>(116);
  header.units = fields.at<std::uint8_t>(123);
  header.qformCode = fields.at<std::int16_t>(252);
  header.sformCode = fields.at<std::int16_t>(254);
  header.quaternion = fields.triple<float>(256);
  header.quaternionOffset = fields.triple<float>(268);
  return header;
}

NiftiHeader parse2(std::string_view bytes, bool bigEndian) {
  const Fields fields(bytes, bigEndian);
  NiftiHeader header;
  header.version = 2;
  header.bigEndian = bigEndian;
  header.singleFile = bytes.substr(4, 4) == "n+2\0"sv;
  readArrays<std::int64_t, double>(header, fields, 16, 104, 400);
  header.datatype = fields.at<std::int16_t>(12);
  header.bitsPerVoxel = fields.at<std::int16_t>(14);
  header.voxelOffset = fields.number<std::int64_t>(168);
  header.slope = fields.at<double>(176);
  header.intercept = fields.at<double>(184);
  header.units = fields.at<std::int32_t>(500);
  header.qformCode = fields.at<std::int32_t>(344);
  header.sformCode = fields.at<std::int32_t>(348);
  header.quaternion = fields.triple<double>(352);
  header.quaternionOffset = fields.triple<double>(376);
  return header;
}

bool startsWithSize(std::string_view bytes, std::int32_t size, bool bigEndian) {
  return bytes.size() >= static_cast<std::size_t>(size) &&
         Fields(bytes, bigEndian).at<std::int32_t>(0) == size;
}

namespace fs = std::filesystem;

constexpr double mostNiftiVolumes = 1e9;
constexpr double farthestOffset = 1 << 30; // of the voxels: behind it no header ends
constexpr double mostExtensionBytes = 1 << 24;

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
  failReading(path, Message::tr("its other half %1%2 is missing").arg(stem.string(), ending),
              Message::tr("copy both files of the pair into one folder"));
}

bool isVoxelFile(const fs::path& path) {
  const fs::path name = path.extension() == ".gz" ? path.stem() : path.filename();
  return name.extension() == ".img";
}

// Reads a header of either version and byte order; nothing where the bytes are no NIfTI header.
std::optional<NiftiHeader> parseNiftiHeader(std::string_view bytes) {
  for (const bool bigEndian : {false, true}) {
    if (startsWithSize(bytes, size1, bigEndian)) {
      const std::string_view magic = bytes.substr(344, 4);
      if (magic == "n+1\0"sv || magic == "ni1\0"sv)
        return parse1(bytes, bigEndian);
    }
    if (startsWithSize(bytes, size2, bigEndian)) {
      const std::string_view magic = bytes.substr(4, 4);
      if (magic == "n+2\0"sv || magic == "ni2\0"sv)
        return parse2(bytes, bigEndian);
    }
  }
  return std::nullopt;
}

// Whether the bytes are an Analyze 7.5 header: NIfTI-1's size without its magic word.
bool isAnalyzeHeader(std::string_view bytes) {
  return (startsWithSize(bytes, size1, false) || startsWithSize(bytes, size1, true)) &&
         !parseNiftiHeader(bytes);
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
                    .arg(header.bitsPerVoxel, bits),
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

// Decides the placement from the header alone: a valid sform (code > 0), else the qform (code > 0), else
// only the spacing. Units become millimetres.
NiftiPlacement placementOf(const NiftiHeader& header) {
  const double millimetres = millimetresPerUnit(header.units);
  const Affine sform = sformOf(header);
  const Affine qform = qformOf(header);
  const bool qformIsValid = isRotation(header) && isValid(header.qformCode, qform);
  if (isValid(header.sformCode, sform)) {
    NiftiPlacement placement = placed(sform, millimetres);
    const double apart = largestCornerDistance(sform, qform, header) * millimetres;
    if (qformIsValid && apart > 0.5 * glm::length(placement.stepsMm[0]))
      placement.warnings.push_back(
          Message::tr("The file's two placements (sform, qform) differ by up to %1 mm; the sform is used.")
              .arg(Message::fixed(apart, 1)));
    return placement;
  }
  NiftiPlacement placement = qformIsValid ? placed(qform, millimetres) : spacingOnly(header, millimetres);
  if (header.sformCode > 0)
    placement.warnings.emplace_back(Message::tr("The file's placement (sform) is damaged and was left out."));
  if (header.qformCode > 0 && !qformIsValid)
    placement.warnings.emplace_back(Message::tr("The file's placement (qform) is damaged and was left out."));
  return placement;
}

} // namespace

bool isNifti(std::string_view bytes) {
  return parseNiftiHeader(bytes) || isAnalyzeHeader(bytes);
}

VolumeParts readNifti(const fs::path& path, const VoxelKeeping& keeping, const Progress& progress) {
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
  readVoxels(locationOf(voxelFile, header), layout, keeping, progress, parts);
  return parts;
}

std::vector<std::string> niftiExtensions(const fs::path& path) {
  const std::optional<NiftiHeader> header = parseNiftiHeader(firstBytes(path, niftiHeaderBytes));
  const std::size_t flags = !header || header->version == 1 ? size1 : size2;
  if (!header || !header->singleFile || !(header->voxelOffset > static_cast<double>(flags + 4)))
    return {};
  const std::string bytes =
      firstBytes(path, static_cast<std::size_t>(std::min(header->voxelOffset, mostExtensionBytes)));
  std::vector<std::string> extensions;
  if (bytes.size() < flags + 4 || bytes[flags] == 0)
    return extensions;
  // Each begins with its size, these eight bytes included, and its code.
  const Fields fields(bytes, header->bigEndian);
  for (std::size_t at = flags + 4; at + 8 <= bytes.size();) {
    const auto size = fields.at<std::int32_t>(at);
    if (size < 8 || static_cast<std::size_t>(size) > bytes.size() - at)
      break;
    extensions.push_back(bytes.substr(at + 8, static_cast<std::size_t>(size) - 8));
    at += static_cast<std::size_t>(size);
  }
  return extensions;
}

} // namespace limn
