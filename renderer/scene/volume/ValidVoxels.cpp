// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/ValidVoxels.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <span>
#include <type_traits>

namespace limn {
namespace {

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

template <class T>
ValidVoxels sanitisedAs(StoredVoxels<T>& stored, const Rescale& rescale,
                        const std::optional<PaddingRange>& padding, const Effort& effort,
                        const std::shared_ptr<Room>& room) {
  ValidVoxels result;
  Extremes<T> extremes;
  const std::span<const T> found(stored.data(), stored.size());
  if constexpr (sizeof(T) <= 2)
    extremes = extremesOf<T>(countsOfAll(found, effort), padding, result.counts);
  else
    extremes = extremesOf(found, padding, effort);
  if (extremes.invalid == stored.size())
    throw Error(Error::Kind::input,
                Message::tr("The volume holds no valid voxel: every value is NaN, infinite or declared "
                            "padding; check that the right series was chosen."));
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

ValidVoxels sanitise(VoxelArray& stored, const Rescale& rescale, const std::optional<PaddingRange>& padding,
                     const Effort& effort, const std::shared_ptr<Room>& room) {
  return std::visit([&](auto& voxels) { return sanitisedAs(voxels, rescale, padding, effort, room); },
                    stored);
}

} // namespace limn
