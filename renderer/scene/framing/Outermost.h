// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/framing/VisibleVoxels.h"

namespace limn {

/// On each side so much of the visible voxels does not count: specks (DEFINITION section 8).
inline constexpr double speckShare = 0.0005;

/// Without the blocks that no direction can ask for: those that have more voxels than do not count in all
/// eight octants beside them, one of which lies beyond them along any direction. What is found stays the
/// same.
VisibleVoxels withoutInner(VisibleVoxels visible);

/// How far visible voxels reach, asked for one direction after another. Exact: blocks tell which of them can
/// hold the voxel that is looked for, and only those are opened. Refers to what it is made of.
class Outermost {
public:
  Outermost(const Grid& grid, const VisibleVoxels& visible);

  /// The centre (world mm) of the outermost visible voxel along a direction, once the `speckShare` of all
  /// that lie farther is left out. Of any length but zero.
  glm::dvec3 along(const glm::dvec3& direction) const;

private:
  struct Measure;
  double boundOf(const Measure& measure) const;
  template <class Visit>
  void visitBeyond(const Measure& measure, double bound, const Visit& visit) const;

  const Grid& m_grid;
  const VisibleVoxels& m_visible;
  double m_left = 0.0; // voxels that do not count on a side
};

} // namespace limn
