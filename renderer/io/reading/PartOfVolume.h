// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/PartWanted.h"
#include "io/reading/ReadOptions.h"

namespace limn {

/// What one of several processes has read of a volume.
struct PartRead {
  Grid grid; ///< of all of it
  VoxelArray stored;
  Rescale rescale;
  std::optional<PaddingRange> padding;
  VolumeInfo info;
  std::shared_ptr<Room> room;
  VoxelBox held; ///< the voxels `stored`
  VoxelBox own;  ///< within them; of all processes each voxel is one's own
  bool isInSlices = false;
  bool bitsIgnored = false; ///< beyond those of a value, in what was read
};

/// The sentence for a volume of which every process must read all before it can keep its part.
inline const Message notInParts = Message::tr(
    "The volume is compressed or text, which can only be read from its start: every process reads all of it "
    "and keeps its part.");

/// The same for one that is straightened.
inline const Message notStraightInParts =
    Message::tr("The slices are straightened, for which every process reads and keeps all of them.");

/// The sentence for bits that no value has.
inline const Message bitsIgnoredWarning =
    Message::tr("Some pixels have bits set beyond those that hold the value; these bits were ignored.");

/// The volume of which this process holds a part: `options.part` joins what all found. `read` reads the same
/// again by other options. Throws Error, Cancelled.
std::shared_ptr<const Volume>
volumeOfPart(PartRead part, const ReadOptions& options,
             const std::function<std::shared_ptr<const Volume>(const ReadOptions&)>& read,
             const Effort& effort);

} // namespace limn
