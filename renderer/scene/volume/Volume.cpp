// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Volume.h"

#include "scene/volume/VolumePart.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>
#include <type_traits>

namespace limn {
namespace {

// Differences, sums and gradients of scalars must be numbers, too.
constexpr double largestScalar = 1e300;

/// What sanitising found.
struct ValidVoxels {
  double smallest = 0.0; ///< stored values of the valid voxels
  double largest = 0.0;
  std::size_t invalidVoxels = 0;
  VoxelMask invalid;   ///< empty where all are valid
  StoredCounts counts; ///< of the valid
};

// Of scalars, from the extremes of stored values.
ValueRange rangeOf(double smallest, double largest, const Rescale& rescale) {
  const double a = rescale.slope * smallest + rescale.intercept;
  const double b = rescale.slope * largest + rescale.intercept;
  const ValueRange range = rescale.slope >= 0.0 ? ValueRange{a, b} : ValueRange{b, a};
  if (!(range.lowest >= -largestScalar && range.highest <= largestScalar))
    throw Error(Error::Kind::input,
                Message::tr("The volume's values are not finite or beyond 1e300 after rescaling; its slope, "
                            "its intercept or its voxels are damaged."));
  return range;
}

void requireValid(std::size_t invalid, std::size_t voxels) {
  if (invalid == voxels)
    throw Error(Error::Kind::input,
                Message::tr("The volume holds no valid voxel: every value is NaN, infinite or declared "
                            "padding; check that the right series was chosen."));
}

std::size_t voxelsIn(const glm::ivec3& dims) {
  return static_cast<std::size_t>(dims.x) * dims.y * dims.z;
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
  const std::size_t expected = voxelsIn(grid.dims);
  if (expected != voxels)
    throw Error(Error::Kind::input, Message::tr("The volume has %1 voxels where its dimensions ask for %2; "
                                                "the file is truncated or its header is wrong.")
                                        .arg(voxels, expected));
}

// Pieces of voxels begin at whole words of a mask.
static_assert(voxelsPerPiece % 64 == 0);

int piecesOf(std::size_t voxels) {
  return static_cast<int>((voxels + voxelsPerPiece - 1) / voxelsPerPiece);
}

template <class T>
std::span<T> pieceOf(std::span<T> stored, int piece) {
  const std::size_t first = static_cast<std::size_t>(piece) * voxelsPerPiece;
  return stored.subspan(first, std::min<std::size_t>(voxelsPerPiece, stored.size() - first));
}

template <class T>
bool isInvalid(T stored, const std::optional<PaddingRange>& padding) {
  if constexpr (std::is_floating_point_v<T>)
    if (!std::isfinite(stored))
      return true;
  return padding && stored >= padding->first && stored <= padding->last;
}

template <class T>
struct Extremes {
  T smallest = std::numeric_limits<T>::max();
  T largest = std::numeric_limits<T>::lowest();
  std::size_t invalid = 0;
};

template <class T>
Extremes<T> extremesOf(std::span<const T> stored, const std::optional<PaddingRange>& padding,
                       const Effort& effort) {
  Extremes<T> all;
  std::mutex mutex;
  forEachPiece(piecesOf(stored.size()), effort, [&](int piece) {
    Extremes<T> own;
    for (const T voxel : pieceOf(stored, piece))
      if (isInvalid(voxel, padding)) {
        ++own.invalid;
      } else {
        own.smallest = std::min(own.smallest, voxel);
        own.largest = std::max(own.largest, voxel);
      }
    const std::lock_guard lock(mutex);
    all.smallest = std::min(all.smallest, own.smallest);
    all.largest = std::max(all.largest, own.largest);
    all.invalid += own.invalid;
  });
  return all;
}

// How often each value of an 8- or 16-bit type occurs, from the lowest that the type has.
template <class T>
std::vector<std::uint64_t> countsOfAll(std::span<const T> stored, const Effort& effort) {
  constexpr std::size_t values = std::size_t{1} << (8 * sizeof(T));
  // Neighbours are often equal, and no count waits for the one before it.
  constexpr std::size_t tables = 4;
  // Counts of fewer pieces do not overflow.
  constexpr int mostPieces = 1 << 14;
  std::vector<std::uint64_t> all(values, 0);
  std::mutex mutex;
  shareOut(piecesOf(stored.size()), effort, [&](Pieces& pieces) {
    for (int piece = pieces.next(); piece >= 0;) {
      std::vector<std::array<std::uint32_t, tables>> own(values);
      for (int n = 0; piece >= 0 && n < mostPieces; ++n, piece = pieces.next()) {
        const std::span<const T> voxels = pieceOf(stored, piece);
        for (std::size_t i = 0; i < voxels.size(); ++i)
          ++own[static_cast<std::size_t>(int{voxels[i]} - int{std::numeric_limits<T>::lowest()})][i % tables];
      }
      const std::lock_guard lock(mutex);
      for (std::size_t i = 0; i < values; ++i)
        for (const std::uint32_t count : own[i])
          all[i] += count;
    }
  });
  return all;
}

// What the counts tell of the valid voxels, whose counts remain.
template <class T>
Extremes<T> extremesOf(std::vector<std::uint64_t> counts, const std::optional<PaddingRange>& padding,
                       StoredCounts& valid) {
  constexpr int lowest = std::is_signed_v<T> ? -(1 << (8 * sizeof(T) - 1)) : 0;
  Extremes<T> all;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto value = static_cast<T>(static_cast<int>(i) + lowest);
    if (isInvalid(value, padding)) {
      all.invalid += counts[i];
      counts[i] = 0;
    } else if (counts[i] > 0) {
      all.smallest = std::min(all.smallest, value);
      all.largest = std::max(all.largest, value);
    }
  }
  if (all.smallest <= all.largest) {
    const int first = all.smallest - lowest;
    valid.first = lowest + first;
    valid.counts.assign(counts.begin() + first, counts.begin() + (all.largest - lowest) + 1);
  }
  return all;
}

template <class T>
VoxelMask replaceInvalid(std::span<T> stored, const std::optional<PaddingRange>& padding, T replacement,
                         const Effort& effort, const std::shared_ptr<Room>& room) {
  VoxelMask mask(stored.size(), room);
  forEachPiece(piecesOf(stored.size()), effort, [&](int piece) {
    const std::span<T> voxels = pieceOf(stored, piece);
    for (std::size_t first = 0; first < voxels.size(); first += 64) {
      std::uint64_t flags = 0;
      for (std::size_t i = first; i < std::min(first + 64, voxels.size()); ++i)
        if (isInvalid(voxels[i], padding)) {
          flags |= std::uint64_t{1} << (i - first);
          voxels[i] = replacement;
        }
      mask.word((static_cast<std::size_t>(piece) * voxelsPerPiece + first) / 64) = flags;
    }
  });
  return mask;
}

/// Finds the valid voxels, and replaces NaN, ±Inf and padding by the smallest valid stored value, or by the
/// largest where the rescale falls. One pass; a second where voxels are invalid. Throws Error (input) where
/// no voxel is valid; Cancelled. Where voxels cannot be changed in their place, the copy lies in `room`, and
/// so does the mask.
template <class T>
ValidVoxels sanitised(StoredVoxels<T>& stored, const Rescale& rescale,
                      const std::optional<PaddingRange>& padding, const Effort& effort,
                      const std::shared_ptr<Room>& room) {
  ValidVoxels result;
  Extremes<T> extremes;
  const std::span<const T> found(stored.data(), stored.size());
  if constexpr (sizeof(T) <= 2)
    extremes = extremesOf<T>(countsOfAll(found, effort), padding, result.counts);
  else
    extremes = extremesOf(found, padding, effort);
  requireValid(extremes.invalid, stored.size());
  result.smallest = static_cast<double>(extremes.smallest);
  result.largest = static_cast<double>(extremes.largest);
  result.invalidVoxels = extremes.invalid;
  if (extremes.invalid > 0)
    result.invalid =
        replaceInvalid(stored.writable(room), padding,
                       rescale.slope >= 0.0 ? extremes.smallest : extremes.largest, effort, room);
  return result;
}

} // namespace

Volume::Volume(Grid grid, VoxelArray stored, Rescale rescale, std::optional<PaddingRange> padding,
               VolumeInfo info, const Effort& effort, std::shared_ptr<Room> room)
    : m_grid(grid), m_rescale(rescale), m_info(std::move(info)), m_room(std::move(room)) {
  requireUsableGrid(m_grid, std::visit([](const auto& voxels) { return voxels.size(); }, stored));
  ValidVoxels valid =
      std::visit([&](auto& voxels) { return sanitised(voxels, m_rescale, padding, effort, m_room); }, stored);
  m_stored = std::make_shared<const VoxelArray>(std::move(stored));
  m_range = rangeOf(valid.smallest, valid.largest, m_rescale);
  m_invalidVoxels = valid.invalidVoxels;
  m_invalid = std::move(valid.invalid);
  m_counts = std::move(valid.counts);
}

Volume::Volume(Grid grid, VoxelArray stored, Rescale rescale, VolumeInfo info, const VoxelFacts& facts,
               std::shared_ptr<const VolumePart> part, const Effort& effort, std::shared_ptr<Room> room)
    : m_grid(grid), m_rescale(rescale), m_info(std::move(info)), m_room(std::move(room)),
      m_part(std::move(part)) {
  const auto voxels = std::visit([](const auto& array) { return array.size(); }, stored);
  requireUsableGrid(partOf(m_grid, m_part->box), voxels);
  requireValid(facts.invalid, voxelsIn(m_grid.dims));
  m_range = rangeOf(facts.smallest, facts.largest, m_rescale);
  m_invalidVoxels = facts.invalid;
  m_counts = facts.counts;
  if (m_invalidVoxels > 0)
    std::visit(
        [&]<class T>(StoredVoxels<T>& array) {
          const auto replacement = static_cast<T>(m_rescale.slope >= 0.0 ? facts.smallest : facts.largest);
          m_invalid = replaceInvalid(array.writable(m_room), m_part->padding, replacement, effort, m_room);
        },
        stored);
  m_stored = std::make_shared<const VoxelArray>(std::move(stored));
}

Volume Volume::held() const {
  Volume held = *this;
  if (m_part) {
    held.m_grid = partOf(m_grid, m_part->box);
    held.m_part = nullptr;
  }
  return held;
}

Volume Volume::placed(const Grid& grid, VolumeInfo info) const {
  assert(grid.dims == m_grid.dims);
  Volume other = *this;
  other.m_grid = grid;
  other.m_info = std::move(info);
  return other;
}

Volume Volume::withScalars(VoxelArray stored, Rescale rescale) const {
  assert(std::visit([](const auto& voxels) { return voxels.size(); }, stored) == voxelCount() && !m_part);
  Volume other = *this;
  other.m_stored = std::make_shared<const VoxelArray>(std::move(stored));
  other.m_rescale = rescale;
  other.m_counts = {};
  return other;
}

std::size_t Volume::voxelCount() const {
  return voxelsIn(m_grid.dims);
}

double Volume::value(const glm::ivec3& index) const {
  assert(!m_part);
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
