// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"

namespace limn::cpu {

/// The cells between voxel centres that a ray crosses, one after the other. Within one the scalars are a
/// cubic and light is smooth, but for planes where its definition changes: there a chord ends, too. Blocks in
/// which nothing shows are leapt over. Chords are found from planes and ray alone, so that leaps move none.
class CellWalk {
public:
  /// Of a ray in unit lengths (inLengths) whose span holds what is to be walked. Nothing shows before `from`,
  /// lengths behind the span's begin.
  CellWalk(const PictureTerms& terms, const Ray& ray, double from);

  /// Where up to `most` next chords begin and end, in lengths behind the span's begin. Returns how many; 0
  /// behind the ray's end.
  int next(float* entries, float* exits, int most);

private:
  static constexpr int mostBreaks = 8;

  void addBreaks(const PictureTerms& terms, const Ray& ray);
  void addBreak(double at);
  double beginOfChord(double at) const;
  void enterAt(double at);
  void cross(int axis);
  void findDistance();
  void leap();
  int nearestAxis() const;
  double crossingOf(int axis, int plane) const { return (plane - m_first[axis]) * m_inverse[axis]; }

  BlocksAlike m_empty;
  glm::dvec3 m_first{0.0};   // voxel index at the span's begin
  glm::dvec3 m_advance{0.0}; // voxels per length
  glm::dvec3 m_inverse{0.0}; // 0 where the ray does not follow the axis
  double m_end = 0.0;
  double m_at = 0.0;
  glm::ivec3 m_cell{0};
  glm::dvec3 m_crossing{0.0}; // where the cell's face ahead is met
  glm::ivec3 m_block{0};
  int m_distance = 0; // of the cell's block to what shows
  double m_breaks[mostBreaks] = {};
  int m_breakCount = 0, m_nextBreak = 0;
};

} // namespace limn::cpu
