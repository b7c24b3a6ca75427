// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/VolumePart.h"

#include "scene/volume/RowPieces.h"

#include <cmath>
#include <mutex>
#include <type_traits>

namespace limn {
namespace {

template <class T>
bool isValid(T voxel, const std::optional<PaddingRange>& padding) {
  if constexpr (std::is_floating_point_v<T>)
    if (!std::isfinite(voxel))
      return false;
  return !padding || voxel < padding->first || voxel > padding->last;
}

// Of counts of the values from `first` on those of padding are taken for invalid.
void leaveOut(const std::optional<PaddingRange>& padding, VoxelFacts& facts) {
  for (std::size_t i = 0; padding && i < facts.counts.counts.size(); ++i)
    if (!isValid(facts.counts.first + static_cast<int>(i), padding)) {
      facts.invalid += facts.counts.counts[i];
      facts.counts.counts[i] = 0;
    }
}

// Calls `worker(eachRow)` on several threads; `eachRow(function)` calls `function(offset)` with the place in
// the held array of the first voxel of each of its rows.
template <class Worker>
void shareOutRows(const VoxelBox& held, const VoxelBox& of, const Effort& effort, const Worker& worker) {
  if (isEmpty(of))
    return;
  const glm::ivec3 dims = held.upper - held.lower;
  const VoxelBox box = movedInto(of, held);
  const RowPieces rows(box.upper - box.lower);
  shareOut(rows.pieces(), effort, [&](Pieces& pieces) {
    worker([&](const auto& function) {
      for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
        rows.forEachRow(piece, [&](int j, int k) {
          function(voxelOffset(dims, box.lower.x, box.lower.y + j, box.lower.z + k));
        });
    });
  });
}

template <class T>
VoxelFacts factsOf(const StoredVoxels<T>& stored, const VoxelBox& held, const VoxelBox& of,
                   const Effort& effort, const std::optional<PaddingRange>& padding) {
  constexpr bool isCounted = sizeof(T) <= 2;
  constexpr int lowest = isCounted ? static_cast<int>(std::numeric_limits<T>::lowest()) : 0;
  const int width = of.upper.x - of.lower.x;
  VoxelFacts all;
  std::mutex mutex;
  shareOutRows(held, of, effort, [&](const auto& eachRow) {
    VoxelFacts own;
    if constexpr (isCounted) {
      own.counts.first = lowest;
      own.counts.counts.assign(std::size_t{1} << (8 * sizeof(T)), 0);
      eachRow([&](std::size_t first) {
        for (int i = 0; i < width; ++i)
          ++own.counts.counts[static_cast<std::size_t>(int{stored[first + i]} - lowest)];
      });
    } else {
      T smallest = std::numeric_limits<T>::max();
      T largest = std::numeric_limits<T>::lowest();
      bool isAny = false;
      eachRow([&](std::size_t first) {
        for (int i = 0; i < width; ++i)
          if (const T voxel = stored[first + i]; isValid(voxel, padding)) {
            smallest = std::min(smallest, voxel);
            largest = std::max(largest, voxel);
            isAny = true;
          } else {
            ++own.invalid;
          }
      });
      if (isAny) {
        own.smallest = static_cast<double>(smallest);
        own.largest = static_cast<double>(largest);
      }
    }
    const std::lock_guard lock(mutex);
    all = joined(all, own);
  });
  // Of all values of a type only those from the smallest to the largest are told of.
  leaveOut(padding, all);
  std::vector<std::uint64_t>& counts = all.counts.counts;
  const auto isAny = [](std::uint64_t count) { return count > 0; };
  const auto first = std::find_if(counts.begin(), counts.end(), isAny);
  const auto last = std::find_if(counts.rbegin(), counts.rend(), isAny);
  if (first == counts.end()) {
    all.counts = {};
    return all;
  }
  counts.erase(last.base(), counts.end());
  all.counts.first += static_cast<int>(first - counts.begin());
  counts.erase(counts.begin(), first);
  all.smallest = all.counts.first;
  all.largest = all.counts.first + static_cast<double>(counts.size()) - 1.0;
  return all;
}

} // namespace

bool VoxelFacts::operator==(const VoxelFacts& other) const {
  return smallest == other.smallest && largest == other.largest && invalid == other.invalid &&
         counts.first == other.counts.first && counts.counts == other.counts.counts &&
         bitsIgnored == other.bitsIgnored;
}

VoxelFacts factsOf(const VoxelArray& stored, const VoxelBox& held, const VoxelBox& of, const Effort& effort,
                   const std::optional<PaddingRange>& padding) {
  return std::visit([&](const auto& voxels) { return factsOf(voxels, held, of, effort, padding); }, stored);
}

VoxelFacts joined(const VoxelFacts& a, const VoxelFacts& b) {
  VoxelFacts both{std::min(a.smallest, b.smallest), std::max(a.largest, b.largest), a.invalid + b.invalid,
                  StoredCounts{}, a.bitsIgnored || b.bitsIgnored};
  if (a.counts.counts.empty() || b.counts.counts.empty()) {
    both.counts = a.counts.counts.empty() ? b.counts : a.counts;
    return both;
  }
  const auto endOf = [](const StoredCounts& counts) {
    return counts.first + static_cast<int>(counts.counts.size());
  };
  both.counts.first = std::min(a.counts.first, b.counts.first);
  both.counts.counts.assign(
      static_cast<std::size_t>(std::max(endOf(a.counts), endOf(b.counts)) - both.counts.first), 0);
  for (const StoredCounts* part : {&a.counts, &b.counts})
    for (std::size_t i = 0; i < part->counts.size(); ++i)
      both.counts.counts[static_cast<std::size_t>(part->first - both.counts.first) + i] += part->counts[i];
  return both;
}

BinCounts countsIn(const Volume& volume, const VoxelBox& of, int mostBins, const Effort& effort) {
  const Histogram empty = binsOf(volume, mostBins);
  const HistogramBins bins(empty);
  const Rescale rescale = volume.rescale();
  const VoxelBox held = volume.part() ? volume.part()->box : allVoxels(volume.grid());
  const VoxelMask& invalid = volume.invalidMask();
  const int width = of.upper.x - of.lower.x;
  BinCounts all{empty.counts};
  std::mutex mutex;
  const auto count = [&](const auto& stored) {
    shareOutRows(held, of, effort, [&](const auto& eachRow) {
      BinCounts own{empty.counts};
      eachRow([&](std::size_t first) {
        for (std::size_t n = first; n < first + static_cast<std::size_t>(width); ++n)
          if (invalid.empty() || !invalid[n])
            ++own.counts[bins.of(rescale.slope * static_cast<double>(stored[n]) + rescale.intercept)];
      });
      const std::lock_guard lock(mutex);
      all = joined(all, own);
    });
  };
  std::visit(count, volume.stored());
  return all;
}

BinCounts joined(const BinCounts& a, const BinCounts& b) {
  BinCounts both = a;
  std::transform(a.counts.begin(), a.counts.end(), b.counts.begin(), both.counts.begin(), std::plus<>());
  return both;
}

std::shared_ptr<const Volume> reread(const Volume& volume, const VoxelBox& box) {
  // Somebody may have placed it otherwise since.
  return std::make_shared<const Volume>(volume.part()->reread(box)->placed(volume.grid(), volume.info()));
}

std::shared_ptr<const Volume> wholeOf(const std::shared_ptr<const Volume>& volume) {
  return volume->part() ? reread(*volume, allVoxels(volume->grid())) : volume;
}

VoxelArray cutOut(const VoxelArray& all, const glm::ivec3& dims, const VoxelBox& box,
                  const std::shared_ptr<Room>& room) {
  const auto cut = [&]<class T>(const StoredVoxels<T>& stored) -> VoxelArray {
    const glm::ivec3 size = box.upper - box.lower;
    RoomVector<T> voxels(static_cast<std::size_t>(size.x) * size.y * size.z, room);
    T* to = voxels.data();
    for (int z = box.lower.z; z < box.upper.z; ++z)
      for (int y = box.lower.y; y < box.upper.y; ++y)
        to = std::copy_n(stored.data() + voxelOffset(dims, box.lower.x, y, z), size.x, to);
    return StoredVoxels<T>(std::move(voxels));
  };
  return std::visit(cut, all);
}

} // namespace limn
