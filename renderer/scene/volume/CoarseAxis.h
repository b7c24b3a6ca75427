// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace limn {

/// Voxels of a volume along one axis, and fewer that fill the same length. Each of the fewer stands for a
/// cell of whole voxels.
class CoarseAxis {
public:
  /// `coarse` is 1 … `fine`.
  CoarseAxis(int fine, int coarse);

  /// A place between two centres of voxels of either kind, or on the first of them.
  struct Place {
    int fine = 0;            ///< the voxel at or before it
    float fineWeight = 0.0f; ///< of the one behind that
    int coarse = 0;          ///< likewise
    float coarseWeight = 0.0f;
  };

  /// All centres of either kind, from the first voxel's to the last one's. Between two of them both fields
  /// are linear.
  const std::vector<Place>& places() const { return m_places; }

  /// The first voxel of a cell; of one more than there are cells: the end.
  int cellBegin(int cell) const;

  /// The voxel behind one; the last has itself.
  int behind(int fine) const { return fine + 1 < m_fine ? fine + 1 : fine; }
  int behindCoarse(int coarse) const { return coarse + 1 < m_coarse ? coarse + 1 : coarse; }

private:
  Place placeAt(double index) const;

  int m_fine, m_coarse;
  std::vector<Place> m_places;
};

} // namespace limn
