// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Histogram.h"

#include <functional>
#include <limits>
#include <tuple>

namespace limn {

struct Scene;
struct VisibleVoxels;

/// What is known of some voxels as they are stored: what makes a volume's range.
struct VoxelFacts {
  double smallest = std::numeric_limits<double>::infinity(); ///< of the valid; of none the largest is less
  double largest = -std::numeric_limits<double>::infinity();
  std::uint64_t invalid = 0; ///< NaN, ±Inf and declared padding
  StoredCounts counts;       ///< of the valid, of types of 8 and 16 bits
  bool bitsIgnored = false;  ///< whoever read them ignored bits beyond those of a value

  bool operator==(const VoxelFacts& other) const;
  auto fields() { return std::tie(smallest, largest, invalid, counts.first, counts.counts, bitsIgnored); }
};

/// Of the voxels `of`, in the array of the voxels of `held`, within which they lie; `of` may be empty. Stored
/// values of `padding` are none. Throws Cancelled.
VoxelFacts factsOf(const VoxelArray& stored, const VoxelBox& held, const VoxelBox& of,
                   const Effort& effort = {}, const std::optional<PaddingRange>& padding = {});

/// Of the voxels of both, which share none. In any order and grouping the same.
VoxelFacts joined(const VoxelFacts& a, const VoxelFacts& b);

/// Counts of voxels in the bins of binsOf, which a histogram of all is joined from.
struct BinCounts {
  std::vector<std::uint64_t> counts;
  auto fields() { return std::tie(counts); }
};

/// Of the valid voxels `of` that a volume holds. Throws Cancelled.
BinCounts countsIn(const Volume& volume, const VoxelBox& of, int mostBins, const Effort& effort = {});
BinCounts joined(const BinCounts& a, const BinCounts& b);

/// What one of several processes holds of a volume of which none holds all.
struct VolumePart {
  VoxelBox box; ///< the voxels held
  VoxelBox own; ///< those that no other process counts as its own, within the box; may be empty

  /// The same volume with another box held; with all voxels one like any other. Throws Error, Cancelled.
  std::function<std::shared_ptr<const Volume>(const VoxelBox& box)> reread;

  /// What only all processes together know. Absent with processes that are asked and do not ask.
  std::function<BinCounts(const Volume&, int mostBins)> binCounts;
  std::function<VisibleVoxels(const Scene&, int unitVoxels)> visible; ///< see visibleWithin

  std::optional<PaddingRange> padding = {}; ///< stored values that are declared to be no voxels
  bool isInSlices = false; ///< what is read of it comes slice by slice, so parts are best of whole ones
};

inline VoxelBox allVoxels(const Grid& grid) {
  return {glm::ivec3(0), grid.dims};
}

/// Whether all of `inner` lies in `outer`.
inline bool contains(const VoxelBox& outer, const VoxelBox& inner) {
  return glm::all(glm::lessThanEqual(outer.lower, inner.lower)) &&
         glm::all(glm::lessThanEqual(inner.upper, outer.upper));
}

inline bool isEmpty(const VoxelBox& box) {
  return glm::any(glm::lessThanEqual(box.upper, box.lower));
}

/// A box of a volume seen from the first voxel of another.
inline VoxelBox movedInto(const VoxelBox& box, const VoxelBox& held) {
  return {box.lower - held.lower, box.upper - held.lower};
}

/// A volume of which a part is held, read once more with another box held. Throws as VolumePart::reread.
std::shared_ptr<const Volume> reread(const Volume& volume, const VoxelBox& box);

/// The volume with all of its voxels: read once more where a part is held, for work that parts cannot share.
std::shared_ptr<const Volume> wholeOf(const std::shared_ptr<const Volume>& volume);

/// The voxels of a part, copied out of an array of all; in `room`, or in memory where there is none.
VoxelArray cutOut(const VoxelArray& all, const glm::ivec3& dims, const VoxelBox& box,
                  const std::shared_ptr<Room>& room = {});

} // namespace limn
