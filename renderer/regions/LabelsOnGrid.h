// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/Region.h"
#include "scene/volume/Volume.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// A volume whose values are labels as a label map on `grid`, which may be another: each voxel takes the
/// label that is nearest to its centre, and the background (0) outside. `described` are names and colours
/// by value, of which those matter that occur; others get a colour of their own and are called "Label 3", the
/// only one beside the background `alone` where that is not empty. Labels are listed by their value, the
/// background first. Throws Error (input) where a value is no whole number or where there are more than 65535
/// labels; Cancelled.
std::shared_ptr<const LabelMap> labelsOnGrid(const Volume& labels, const std::vector<Label>& described,
                                             const Grid& grid, const Effort& effort = {},
                                             const std::string& alone = {});

/// Whether a volume is the mask of one structure: beside 0 it has one value, above 0, or none.
bool isMask(const Volume& volume);

/// Masks that become one label map on a grid. They are added one after the other, so that beside the map one
/// mask lies in memory; a voxel belongs to the last that has it.
class MasksOnGrid {
public:
  /// At most `most` masks come, < 65536. The map lies in `room`, in memory where there is none.
  MasksOnGrid(const Grid& grid, std::size_t most, std::shared_ptr<Room> room);

  /// A mask (isMask) as a label; nearest voxel by nearest voxel where it has another grid. One without a
  /// voxel on the grid makes no label. The number of its voxels there. Throws Cancelled, after which the map
  /// is of no use.
  std::size_t add(const Volume& mask, const Label& label, const Effort& effort = {});

  /// The labels of a map that lies on the grid, all at once: `labels` holds what each of its places becomes,
  /// in order, and nothing for those whose voxels do not come along, as those of the background. Throws
  /// Cancelled, after which the map is of no use.
  void add(const LabelMap& masks, const std::vector<std::optional<Label>>& labels, const Effort& effort = {});

  /// The labels so far, the background first.
  const std::vector<Label>& labels() const { return m_labels; }

  /// Voxels that one label had and another took.
  struct Overlap {
    std::string loser, winner;
    std::size_t voxels = 0;
  };
  /// The largest of them, and how many voxels changed hands in all.
  const std::optional<Overlap>& largestOverlap() const { return m_largest; }
  std::size_t overlapping() const { return m_overlapping; }

  /// A label that later ones took voxels from until none was left, and which: empty where several did.
  struct Covered {
    std::string label, by;
  };
  /// Of the map that was finished, in its order.
  std::vector<Covered> coveredIn(const LabelMap& finished) const;

  /// What has become of them, the background first; of use once.
  std::shared_ptr<const LabelMap> finished();

private:
  void noteOverlap(std::size_t loser, std::size_t winner, std::size_t voxels);

  Grid m_grid;
  LabelMap::Places m_places;
  std::vector<Label> m_labels;
  std::map<std::size_t, std::vector<std::size_t>> m_takers; ///< of the places that lost voxels
  std::optional<Overlap> m_largest;
  std::size_t m_overlapping = 0;
};

/// The colour of the n-th label: neighbours in the list differ much.
glm::dvec3 labelColor(std::size_t n);

} // namespace limn
