// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/ScissorSet.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn {
namespace {

using Word = BitGrid::Word;

// A camera by which places become homogeneous coordinates of the picture, (x, y, w).
struct Projector {
  explicit Projector(const Camera& camera)
      : basis(basisOf(camera)), eye(camera.position), half(halfHeight(camera)),
        isPerspective(camera.projection == Camera::Projection::perspective) {}

  // Of a place (w = 1) or of a direction (w = 0) relative to the eye, mm.
  glm::dvec3 of(const glm::dvec3& v, double w) const {
    return {glm::dot(v, basis.right) / half, glm::dot(v, basis.up) / half,
            isPerspective ? glm::dot(v, basis.forward) : w};
  }

  CameraBasis basis;
  glm::dvec3 eye;
  double half;
  bool isPerspective;
};

// A row of voxels as the picture has it: voxel i lies at `origin + i · step`.
struct Row {
  glm::dvec3 origin, step;           // from the eye, mm
  glm::dvec3 pictureOrigin, picture; // the same in the picture
};

// Turns the bits from `first` to before `end` over.
void invert(Word* row, int first, int end) {
  for (int x = first; x < end;) {
    const int from = x % BitGrid::wordBits, count = std::min(BitGrid::wordBits - from, end - x);
    const Word ones = count == BitGrid::wordBits ? ~Word{0} : (Word{1} << count) - 1;
    row[x / BitGrid::wordBits] ^= ones << from;
    x += count;
  }
}

// Where a row is given by a line, by which voxel it meets a point on it.
double placeAlong(const Row& row, const glm::dvec2& point) {
  const glm::dvec3 &a = row.pictureOrigin, &b = row.picture;
  const glm::dvec2 top = point * a.z - glm::dvec2(a);
  const glm::dvec2 bottom = glm::dvec2(b) - point * b.z;
  return std::abs(bottom.x) > std::abs(bottom.y) ? top.x / bottom.x : top.y / bottom.y;
}

// Marks which voxels of one row after the other lie inside a polygon.
class RowCutter {
public:
  RowCutter(const std::vector<glm::dvec2>& polygon) : m_polygon(polygon), m_sides(polygon.size()) {}

  // Voxels `first` to before `end` lie before the camera; the bits are 0.
  void mark(const Row& row, int first, int end, Word* inside) {
    const glm::dvec3 &a = row.pictureOrigin, &b = row.picture;
    const glm::dvec3 line = glm::cross(a, b);
    if (glm::length(line) <= 1e-14 * glm::length(a) * glm::length(b)) {
      // The row is seen end-on, as one point.
      const glm::dvec3 at = a + 0.5 * (first + end - 1) * b;
      if (isInside(m_polygon, glm::dvec2(at) / at.z))
        invert(inside, first, end);
      return;
    }
    // A row that comes nearer leaves the picture towards infinity, where nothing is inside; one that goes
    // away ends at its vanishing point, which may be. So crossings are counted from the end that is near.
    for (const double place : crossings(row, line))
      if (b.z >= 0.0)
        invert(inside, voxelAfter(place, first, end), end);
      else
        invert(inside, first, voxelAfter(place, first, end));
  }

private:
  // By which voxels the row crosses edges before the camera.
  const std::vector<double>& crossings(const Row& row, const glm::dvec3& line) {
    for (std::size_t n = 0; n < m_polygon.size(); ++n)
      m_sides[n] = line.x * m_polygon[n].x + line.y * m_polygon[n].y + line.z;
    m_crossings.clear();
    for (std::size_t n = 0, before = m_polygon.size() - 1; n < m_polygon.size(); before = n++) {
      if ((m_sides[n] > 0.0) == (m_sides[before] > 0.0))
        continue;
      const double share = m_sides[before] / (m_sides[before] - m_sides[n]);
      const double place = placeAlong(row, glm::mix(m_polygon[before], m_polygon[n], share));
      if (row.pictureOrigin.z + place * row.picture.z > 0.0)
        m_crossings.push_back(place);
    }
    return m_crossings;
  }

  // The first voxel beyond a place, within first..end.
  static int voxelAfter(double place, int first, int end) {
    return static_cast<int>(std::clamp(std::floor(place) + 1.0, static_cast<double>(first), double(end)));
  }

  const std::vector<glm::dvec2>& m_polygon;
  std::vector<double> m_sides; // of each corner, on which side of the row's line it lies
  std::vector<double> m_crossings;
};

// The voxels of a row that lie before the camera, which are one run.
glm::ivec2 beforeCamera(const Row& row, const glm::dvec3& forward, int length) {
  const double at = glm::dot(row.origin, forward), step = glm::dot(row.step, forward);
  int first = 0, end = length;
  while (first < end && !(at + first * step > 0.0) && step > 0.0)
    ++first;
  while (first < end && !(at + (end - 1) * step > 0.0))
    --end;
  return {first, end};
}

void keepDepths(const Row& row, const Projector& projector, const glm::dvec2& depthMm, int length,
                Word* bits) {
  for (int x = 0; x < length; ++x) {
    const glm::dvec3 at = row.origin + static_cast<double>(x) * row.step;
    const double depth = projector.isPerspective ? glm::length(at) : glm::dot(at, projector.basis.forward);
    if (depth < depthMm.x || depth > depthMm.y)
      bits[x / BitGrid::wordBits] &= ~(Word{1} << x % BitGrid::wordBits);
  }
}

} // namespace

bool isInside(const std::vector<glm::dvec2>& polygon, const glm::dvec2& place) {
  bool inside = false;
  for (std::size_t n = 0, before = polygon.size() - 1; n < polygon.size(); before = n++) {
    const glm::dvec2 &a = polygon[before], &b = polygon[n];
    if ((a.y > place.y) != (b.y > place.y) && place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
  }
  return inside;
}

double depthOfSeen(std::vector<double> depthsMm) {
  constexpr double leastJumpMm = 10.0, jumpOfDepths = 0.5;
  constexpr std::size_t beyondOneIn = 4;
  std::ranges::sort(depthsMm);
  const std::size_t count = depthsMm.size();
  for (std::size_t n = count - count / beyondOneIn; n < count; ++n) {
    const double before = depthsMm[n - 1] - depthsMm.front();
    if (depthsMm[n] - depthsMm[n - 1] > std::max(leastJumpMm, jumpOfDepths * before))
      return depthsMm[n - 1];
  }
  return depthsMm.back();
}

std::optional<glm::dvec2> placeInPicture(const Camera& camera, const glm::dvec3& worldMm) {
  const Projector projector(camera);
  const glm::dvec3 fromEye = worldMm - projector.eye;
  if (!(glm::dot(fromEye, projector.basis.forward) > 0.0))
    return std::nullopt;
  const glm::dvec3 at = projector.of(fromEye, 1.0);
  return glm::dvec2(at) / at.z;
}

BitGrid takenBy(const Scissors& scissors, const Grid& grid, const std::shared_ptr<Room>& room,
                const Effort& effort) {
  const Projector projector(scissors.camera);
  BitGrid taken(grid.dims, room);
  const std::vector<glm::dvec2> none;
  const bool isLine = scissors.polygon.size() >= 3;
  forEachPiece(grid.dims.z, effort, [&](int z) {
    RowCutter cutter(isLine ? scissors.polygon : none);
    for (int y = 0; y < grid.dims.y; ++y) {
      Row row;
      row.origin = indexToWorld(grid, {0, y, z}) - projector.eye;
      row.step = indexToWorld(grid, {1, y, z}) - projector.eye - row.origin;
      row.pictureOrigin = projector.of(row.origin, 1.0);
      row.picture = projector.of(row.step, 0.0);
      const glm::ivec2 seen = beforeCamera(row, projector.basis.forward, grid.dims.x);
      if (seen.x >= seen.y)
        continue;
      Word* bits = taken.row(y, z);
      if (isLine)
        cutter.mark(row, seen.x, seen.y, bits);
      if (!scissors.removesInside)
        invert(bits, seen.x, seen.y);
      if (scissors.depthMm)
        keepDepths(row, projector, *scissors.depthMm, grid.dims.x, bits);
    }
  });
  return taken;
}

} // namespace limn
