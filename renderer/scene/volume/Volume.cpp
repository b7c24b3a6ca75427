// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Volume.h"

#include "scene/basics/Error.h"
#include "scene/volume/ValidVoxels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <cmath>
#include <initializer_list>

namespace limn {
namespace {

using Words = std::initializer_list<const char*>;

// A word that hints begins so, or is it where it is short: "ct" must not be found in "sector".
bool isAny(const std::string& word, const Words& words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view known) {
    return known.size() > 4 ? word.starts_with(known) : word == known;
  });
}

void readWord(const std::string& word, ScanHints& hints) {
  using BodyPart = ScanHints::BodyPart;
  using Weighting = ScanHints::Weighting;
  if (isAny(word, {"ct", "cta", "ctpa", "ccta", "hrct"}))
    hints.modality = "CT";
  if (isAny(word, {"mr", "mri", "mra", "mrv", "tof", "mprage", "flair", "spgr"}))
    hints.modality = "MR";
  if (isAny(word, {"pt", "pet", "suv"}))
    hints.modality = "PT";
  if (isAny(word, {"cta", "ctpa", "ccta", "mra", "mrv", "tof", "angio", "angiography", "avm", "vessel",
                   "aneurysm"}))
    hints.isAngiography = true;
  if (isAny(word, {"head", "brain", "skull", "cranium", "cerebr", "neuro"}))
    hints.bodyPart = BodyPart::head;
  if (isAny(word, {"chest", "thorax", "lung", "lungs", "hrct"}))
    hints.bodyPart = BodyPart::chest;
  if (isAny(word, {"abdomen", "abdominal", "liver", "pelvis"}))
    hints.bodyPart = BodyPart::abdomen;
  if (isAny(word, {"t1", "t1w", "mprage", "spgr"}))
    hints.weighting = Weighting::t1;
  if (isAny(word, {"t2", "t2w", "flair"}))
    hints.weighting = Weighting::t2;
  if (isAny(word, {"pd", "pdw"}))
    hints.weighting = Weighting::pd;
}

// Differences, sums and gradients of scalars must be numbers, too.
constexpr double largestScalar = 1e300;

// Of scalars, from those of stored values.
ValueRange rangeOf(const ValidVoxels& voxels, const Rescale& rescale) {
  const double a = rescale.slope * voxels.smallest + rescale.intercept;
  const double b = rescale.slope * voxels.largest + rescale.intercept;
  const ValueRange range = rescale.slope >= 0.0 ? ValueRange{a, b} : ValueRange{b, a};
  if (!(range.lowest >= -largestScalar && range.highest <= largestScalar))
    throw Error(Error::Kind::input,
                Message::tr("The volume's values are not finite or beyond 1e300 after rescaling; its slope, "
                            "its intercept or its voxels are damaged."));
  return range;
}

void requireUsableGrid(const Grid& grid, std::size_t voxels) {
  for (int axis = 0; axis < 3; ++axis) {
    if (grid.dims[axis] < 1)
      throw Error(Error::Kind::input, Message::tr("The volume has no voxels along one axis."));
    if (!(grid.spacingMm[axis] > 0.0) || !std::isfinite(grid.spacingMm[axis]))
      throw Error(
          Error::Kind::input,
          Message::tr("The volume's voxel spacing is not a positive number; give it with --spacing X,Y,Z."));
  }
  const auto expected = static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z;
  if (expected != voxels)
    throw Error(Error::Kind::input, Message::tr("The volume has %1 voxels where its dimensions ask for %2; "
                                                "the file is truncated or its header is wrong.")
                                        .arg(voxels, expected));
}

} // namespace

ScanHints withHintsOf(ScanHints hints, std::string_view text) {
  std::string word;
  const auto end = [&] {
    readWord(word, hints);
    word.clear();
  };
  for (const char letter : text)
    if (std::isalnum(static_cast<unsigned char>(letter)))
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    else
      end();
  end();
  return hints;
}

ScanHints::Weighting weightingBy(double repetitionMs, double echoMs) {
  if (repetitionMs < 1000.0)
    return echoMs < 40.0 ? ScanHints::Weighting::t1 : ScanHints::Weighting::unknown;
  if (repetitionMs < 1800.0)
    return ScanHints::Weighting::unknown;
  return echoMs < 40.0 ? ScanHints::Weighting::pd : ScanHints::Weighting::t2;
}

Volume::Volume(Grid grid, VoxelArray stored, Rescale rescale, std::optional<PaddingRange> padding,
               VolumeInfo info, const Effort& effort, std::shared_ptr<Room> room)
    : m_grid(grid), m_rescale(rescale), m_info(std::move(info)), m_room(std::move(room)) {
  requireUsableGrid(m_grid, std::visit([](const auto& voxels) { return voxels.size(); }, stored));
  ValidVoxels valid = sanitise(stored, m_rescale, padding, effort, m_room);
  m_stored = std::make_shared<const VoxelArray>(std::move(stored));
  m_range = rangeOf(valid, m_rescale);
  m_invalidVoxels = valid.invalidVoxels;
  m_invalid = std::move(valid.invalid);
  m_counts = std::move(valid.counts);
}

Volume Volume::placed(const Grid& grid, VolumeInfo info) const {
  assert(grid.dims == m_grid.dims);
  Volume other = *this;
  other.m_grid = grid;
  other.m_info = std::move(info);
  return other;
}

std::size_t Volume::voxelCount() const {
  return std::visit([](const auto& voxels) { return voxels.size(); }, *m_stored);
}

double Volume::value(const glm::ivec3& index) const {
  const std::size_t offset = voxelOffset(m_grid.dims, index.x, index.y, index.z);
  return std::visit(
      [&](const auto& voxels) {
        return m_rescale.slope * static_cast<double>(voxels[offset]) + m_rescale.intercept;
      },
      *m_stored);
}

std::string voxelTypeName(const VoxelArray& stored) {
  static constexpr const char* names[] = {"uint8",  "int8",  "uint16",  "int16",
                                          "uint32", "int32", "float32", "float64"};
  return names[stored.index()];
}

double valueAt(const Volume& volume, const glm::dvec3& index) {
  const glm::dvec3 last = glm::dvec3(volume.grid().dims - 1);
  const glm::dvec3 p = glm::clamp(index, glm::dvec3(0.0), last);
  const glm::ivec3 low = glm::ivec3(glm::floor(p));
  const glm::ivec3 high = glm::min(low + 1, volume.grid().dims - 1);
  const glm::dvec3 w = p - glm::dvec3(low);
  const auto alongX = [&](int j, int k) {
    return glm::mix(volume.value({low.x, j, k}), volume.value({high.x, j, k}), w.x);
  };
  const auto alongY = [&](int k) { return glm::mix(alongX(low.y, k), alongX(high.y, k), w.y); };
  return glm::mix(alongY(low.z), alongY(high.z), w.z);
}

} // namespace limn
