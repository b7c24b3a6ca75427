// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/PartOfVolume.h"

namespace limn {
namespace {

// The options by which the same volume is read with another box held, or all of it. What is known of all
// voxels stays, so no other process is asked.
ReadOptions optionsFor(const VoxelBox& box, const Grid& grid, const VoxelFacts& facts,
                       const ReadOptions& options) {
  ReadOptions again = options;
  again.part.reset();
  if (contains(box, allVoxels(grid)))
    return again;
  PartWanted other = *options.part;
  other.share = [box](const Grid&, bool) { return PartWanted::Share{box, box}; };
  other.joined = [facts](const VoxelFacts&) { return facts; };
  again.part = std::make_shared<const PartWanted>(std::move(other));
  return again;
}

} // namespace

std::shared_ptr<const Volume>
volumeOfPart(PartRead part, const ReadOptions& options,
             const std::function<std::shared_ptr<const Volume>(const ReadOptions&)>& read,
             const Effort& effort) {
  const PartWanted& wanted = *options.part;
  VoxelFacts found = factsOf(part.stored, part.held, part.own, effort, part.padding);
  found.bitsIgnored = part.bitsIgnored;
  const VoxelFacts facts = wanted.joined(found);
  if (facts.bitsIgnored)
    part.info.warnings.emplace_back(bitsIgnoredWarning);
  const auto reread = [read, options, facts, grid = part.grid](const VoxelBox& box) {
    return read(optionsFor(box, grid, facts, options));
  };
  auto known = std::make_shared<const VolumePart>(VolumePart{part.held, part.own, reread, wanted.binCounts,
                                                             wanted.visible, part.padding, part.isInSlices});
  return std::make_shared<const Volume>(part.grid, std::move(part.stored), part.rescale, std::move(part.info),
                                        facts, std::move(known), effort, std::move(part.room));
}

} // namespace limn
