// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/rays/CellWalk.h"

#include "scene/steps/EmptySpace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn::cpu {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// So near behind a plane counts as on it, voxels: far less than floats tell apart.
constexpr double onPlane = 1e-9;

// floor() is a call below SSE4.
int wholeBelow(double value) {
  const int towardsZero = static_cast<int>(value);
  return towardsZero - (value < towardsZero ? 1 : 0);
}

} // namespace

CellWalk::CellWalk(const PictureTerms& terms, const Ray& ray, double from)
    : m_empty(terms.empty), m_end((ray.span.end - ray.span.begin) / terms.lengthMm) {
  const FramedRay framed = framedRay(terms.frame, ray.pixel.x, ray.pixel.y, terms.size);
  m_first = framed.anchor + ray.span.begin * framed.direction + terms.centre;
  m_advance = terms.lengthMm * framed.direction;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(m_advance[axis]) > 1e-20)
      m_inverse[axis] = 1.0 / m_advance[axis];
  addBreaks(terms, ray);
  enterAt(from);
  m_at = beginOfChord(from);
}

// Where the chord begins that holds a place in the cell which was entered.
double CellWalk::beginOfChord(double at) const {
  double begin = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    if (m_inverse[axis] != 0.0)
      begin = std::max(begin, crossingOf(axis, m_cell[axis] + (m_inverse[axis] < 0.0 ? 1 : 0)));
  for (int n = 0; n < m_breakCount && m_breaks[n] <= at; ++n)
    begin = std::max(begin, m_breaks[n]);
  return begin;
}

// Near a cut face its normal takes the gradient's place, from one length on; fog sets in at a distance.
void CellWalk::addBreaks(const PictureTerms& terms, const Ray& ray) {
  if (terms.effects.has(Effect::cutFaces)) {
    for (int axis = 0; axis < 3; ++axis) {
      if (m_inverse[axis] == 0.0)
        continue;
      const double inside = 1.0 / terms.spacing[axis];
      for (const double face : {terms.cut.lower[axis] + inside, terms.cut.upper[axis] - inside})
        addBreak((face + terms.centre[axis] - m_first[axis]) * m_inverse[axis]);
    }
  }
  if (terms.effects.hasAny(fogs)) {
    addBreak(double(terms.fogStart) - ray.firstDepth);
    if (terms.effects.has(Effect::fogLinear))
      addBreak(double(terms.fogEnd) - ray.firstDepth);
  }
  std::sort(m_breaks, m_breaks + m_breakCount);
}

void CellWalk::addBreak(double at) {
  if (at > 0.0 && at < m_end)
    m_breaks[m_breakCount++] = at;
}

void CellWalk::enterAt(double at) {
  m_at = at;
  for (int axis = 0; axis < 3; ++axis) {
    const double p = m_first[axis] + at * m_advance[axis];
    const bool isBackward = m_inverse[axis] < 0.0;
    m_cell[axis] = isBackward ? -1 - wholeBelow(onPlane - p) : wholeBelow(p + onPlane);
    m_crossing[axis] = m_inverse[axis] == 0.0 ? never : crossingOf(axis, m_cell[axis] + (isBackward ? 0 : 1));
  }
  findDistance();
}

void CellWalk::cross(int axis) {
  const bool isBackward = m_inverse[axis] < 0.0;
  m_cell[axis] += isBackward ? -1 : 1;
  m_crossing[axis] = crossingOf(axis, m_cell[axis] + (isBackward ? 0 : 1));
  if ((m_cell[axis] & (blockSize - 1)) == (isBackward ? blockSize - 1 : 0))
    findDistance();
}

void CellWalk::findDistance() {
  static_assert((blockSize & (blockSize - 1)) == 0);
  if (!m_empty.distances)
    return;
  const glm::ivec3 last = m_empty.first + m_empty.blocks - 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int rest = m_cell[axis] & (blockSize - 1);
    m_block[axis] = std::clamp((m_cell[axis] - rest) / blockSize, m_empty.first[axis], last[axis]);
  }
  const glm::ivec3 place = m_block - m_empty.first;
  m_distance = m_empty.distances[voxelOffset(m_empty.blocks, place.x, place.y, place.z)];
}

// Leaves the cube of empty blocks through the face ahead that is met first.
void CellWalk::leap() {
  double exit = never;
  for (int axis = 0; axis < 3; ++axis) {
    if (m_inverse[axis] == 0.0)
      continue;
    const int block = m_block[axis] + (m_inverse[axis] < 0.0 ? 1 - m_distance : m_distance);
    exit = std::min(exit, crossingOf(axis, blockSize * block));
  }
  if (exit > m_at) {
    enterAt(exit);
    return;
  }
  const int axis = nearestAxis();
  m_at = std::max(m_at, m_crossing[axis]);
  cross(axis);
}

int CellWalk::nearestAxis() const {
  const int axis = m_crossing.y < m_crossing.x ? 1 : 0;
  return m_crossing.z < m_crossing[axis] ? 2 : axis;
}

int CellWalk::next(float* entries, float* exits, int most) {
  int count = 0;
  while (count < most && m_at < m_end) {
    if (m_distance > 0) {
      leap();
      continue;
    }
    while (m_nextBreak < m_breakCount && m_breaks[m_nextBreak] <= m_at)
      ++m_nextBreak;
    const int axis = nearestAxis();
    const double exit = std::max(m_crossing[axis], m_at);
    const bool isBroken = m_nextBreak < m_breakCount && m_breaks[m_nextBreak] < exit;
    const double stop = std::min(isBroken ? m_breaks[m_nextBreak] : exit, m_end);
    const auto from = static_cast<float>(m_at);
    const auto to = static_cast<float>(stop);
    m_at = stop;
    if (!isBroken && stop == exit)
      cross(axis);
    // What floats cannot tell apart has no length.
    if (!(to > from))
      continue;
    entries[count] = from;
    exits[count++] = to;
  }
  return count;
}

} // namespace limn::cpu
