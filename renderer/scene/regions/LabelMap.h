// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Grid.h"
#include "scene/volume/StoredVoxels.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace limn {

/// What is known of the voxels that share a label.
struct Label {
  int value = 0; ///< as the file has it; 0 is the background
  std::string name;
  glm::dvec3 color{1.0};
  bool operator==(const Label&) const = default;
};

/// One label for each voxel of a volume, on the volume's own grid; immutable. Voxels hold places in the list
/// of labels, x fastest.
class LabelMap {
public:
  using Places = std::variant<StoredVoxels<std::uint8_t>, StoredVoxels<std::uint16_t>>;

  /// Throws Error (input) where `places` has not as many entries as the grid voxels, where one lies beyond
  /// the list, or where the list is empty or longer than 65536.
  LabelMap(const glm::ivec3& dims, Places places, std::vector<Label> labels);

  const glm::ivec3& dims() const { return m_dims; }
  const Places& places() const { return m_places; }
  const std::vector<Label>& labels() const { return m_labels; }

  /// The place in the list of labels of a voxel, by its position in the stored array (voxelOffset).
  std::size_t placeAt(std::size_t voxel) const;

  /// The smallest box around the voxels of a place in the list; empty where there are none.
  const VoxelBox& boxAround(std::size_t place) const { return m_boxes[place]; }

private:
  glm::ivec3 m_dims;
  Places m_places;
  std::vector<Label> m_labels;
  std::vector<VoxelBox> m_boxes; // of each label
};

} // namespace limn
