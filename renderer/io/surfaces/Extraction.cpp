// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/Extraction.h"

#include "io/surfaces/FlyingEdges.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace limn {
namespace {

constexpr int layersPerSlab = 48;
constexpr double nearestToCorner = 1e-3; // voxels
constexpr std::uint32_t noPoint = std::numeric_limits<std::uint32_t>::max();

/// An edge of the lattice that the boundary crosses.
struct CrossedEdge {
  glm::ivec3 low{0};
  int axis = 0;
};

CrossedEdge edgeAt(const glm::ivec3& halves, int firstLayer) {
  CrossedEdge edge;
  edge.axis = halves.x & 1 ? 0 : halves.y & 1 ? 1 : 2;
  edge.low = halves / 2 + glm::ivec3(0, 0, firstLayer);
  return edge;
}

glm::ivec3 highEnd(const CrossedEdge& edge) {
  glm::ivec3 high = edge.low;
  ++high[edge.axis];
  return high;
}

/// Where the boundary crosses an edge.
struct Crossing {
  glm::dvec3 index{0.0};
  bool isOfField = false; ///< and not of the region
};

// Both the field and the weight are linear along the edge; the nearer of both ends the solid.
Crossing crossingOf(const SurfaceLattice& lattice, const CrossedEdge& edge) {
  const Solid& solid = lattice.solid();
  glm::dvec3 inside = lattice.indexOf(edge.low), outside = lattice.indexOf(highEnd(edge));
  if (!solid.contains(inside))
    std::swap(inside, outside);
  const auto zeroBetween = [](double in, double out) { return out < 0.0 ? in / (in - out) : 1.0; };
  const double ofField = zeroBetween(solid.excess(inside), solid.excess(outside));
  const double ofRegion =
      solid.isWholeVolumeKept() ? 1.0 : zeroBetween(solid.keeping(inside), solid.keeping(outside));
  const double length = glm::length(outside - inside);
  const double margin = std::min(nearestToCorner, length / 3.0) / length;
  const double share = std::clamp(std::min(ofField, ofRegion), margin, 1.0 - margin);
  return {inside + share * (outside - inside), ofField <= ofRegion};
}

class Extraction {
public:
  explicit Extraction(const SurfaceLattice& lattice)
      : m_lattice(lattice), m_inPlane(2 * static_cast<std::size_t>(lattice.dims().x) * lattice.dims().y) {}

  void addSlab(int first, int layers, const Effort& effort);
  ExtractedSurface take() { return std::move(m_surface); }

private:
  std::uint32_t pointOn(const CrossedEdge& edge, int first, int last);
  std::uint32_t newPoint(const CrossedEdge& edge);
  std::uint32_t pointOnEnd(const CrossedEdge& edge);
  void place(std::size_t from, const Effort& effort);
  void addTriangle(const glm::uvec3& triangle);

  const SurfaceLattice& m_lattice;
  ExtractedSurface m_surface;
  std::vector<CrossedEdge> m_edges; ///< of the points
  std::vector<std::uint8_t> m_cuts; ///< of the points: a bit for each face of the crop, one for the region
  std::vector<std::uint32_t> m_inPlane; ///< points on edges along x and y in the slab's last layer
  std::vector<std::uint32_t> m_nextPlane;
  std::unordered_map<std::uint64_t, std::uint32_t> m_onEnds; ///< points where the crop ends, by place
};

std::uint32_t Extraction::newPoint(const CrossedEdge& edge) {
  m_edges.push_back(edge);
  return static_cast<std::uint32_t>(m_edges.size() - 1);
}

// Edges to the outermost layers have no length: all from one place share a point.
std::uint32_t Extraction::pointOnEnd(const CrossedEdge& edge) {
  const glm::ivec3 place = m_lattice.isOutside(edge.axis, edge.low[edge.axis]) ? highEnd(edge) : edge.low;
  const auto [found, isNew] =
      m_onEnds.try_emplace(voxelOffset(m_lattice.dims(), place.x, place.y, place.z), 0);
  if (isNew)
    found->second = newPoint(edge);
  return found->second;
}

std::uint32_t Extraction::pointOn(const CrossedEdge& edge, int first, int last) {
  const int axis = edge.axis;
  if (m_lattice.isOutside(axis, edge.low[axis]) || m_lattice.isOutside(axis, edge.low[axis] + 1))
    return pointOnEnd(edge);
  const std::size_t inPlane =
      2 * (static_cast<std::size_t>(edge.low.y) * m_lattice.dims().x + edge.low.x) + axis;
  if (axis != 2 && edge.low.z == first && first > 0)
    return m_inPlane[inPlane];
  const std::uint32_t point = newPoint(edge);
  if (axis != 2 && edge.low.z == last)
    m_nextPlane[inPlane] = point;
  return point;
}

void Extraction::addSlab(int first, int layers, const Effort& effort) {
  std::vector<std::uint8_t> marks = m_lattice.marked(first, layers, effort);
  const LatticeTriangles found = trianglesBetween(marks, {m_lattice.dims().x, m_lattice.dims().y, layers});
  const std::size_t before = m_edges.size();
  m_nextPlane.assign(m_inPlane.size(), noPoint);
  std::vector<std::uint32_t> points;
  points.reserve(found.halves.size());
  for (const glm::ivec3& halves : found.halves)
    points.push_back(pointOn(edgeAt(halves, first), first, first + layers - 1));
  std::swap(m_inPlane, m_nextPlane);
  place(before, effort);
  for (const glm::uvec3& t : found.triangles)
    addTriangle({points[t.x], points[t.y], points[t.z]});
}

// Works out where the points from one on lie, and which faces of the crop they lie on.
void Extraction::place(std::size_t from, const Effort& effort) {
  m_surface.mesh.points.resize(m_edges.size());
  m_cuts.resize(m_edges.size());
  constexpr std::size_t perPiece = 1 << 14;
  const std::size_t count = m_edges.size() - from;
  forEachPiece(static_cast<int>((count + perPiece - 1) / perPiece), effort, [&](int piece) {
    const std::size_t begin = from + static_cast<std::size_t>(piece) * perPiece;
    for (std::size_t i = begin; i < std::min(begin + perPiece, m_edges.size()); ++i) {
      const CrossedEdge& edge = m_edges[i];
      const bool isOnEnd = m_lattice.isOutside(edge.axis, edge.low[edge.axis]) ||
                           m_lattice.isOutside(edge.axis, edge.low[edge.axis] + 1);
      const Crossing crossing =
          isOnEnd ? Crossing{m_lattice.indexOf(edge.low), true} : crossingOf(m_lattice, edge);
      m_surface.mesh.points[i] = indexToWorld(m_lattice.solid().volume().grid(), crossing.index);
      std::uint8_t cuts = crossing.isOfField ? 0 : 64;
      for (int axis = 0; axis < 3; ++axis) {
        cuts |= crossing.index[axis] == m_lattice.solid().lower()[axis] ? 1 << axis : 0;
        cuts |= crossing.index[axis] == m_lattice.solid().upper()[axis] ? 8 << axis : 0;
      }
      m_cuts[i] = cuts;
    }
  });
}

void Extraction::addTriangle(const glm::uvec3& triangle) {
  if (triangle.x == triangle.y || triangle.y == triangle.z || triangle.z == triangle.x)
    return; // within an edge of the crop box
  m_surface.mesh.triangles.push_back(triangle);
  const std::uint8_t a = m_cuts[triangle.x], b = m_cuts[triangle.y], c = m_cuts[triangle.z];
  constexpr std::uint8_t region = 64;
  m_surface.isCut.push_back((a & b & c) != 0 || ((a | b | c) & region) != 0);
}

} // namespace

ExtractedSurface extractedSurface(const SurfaceLattice& lattice, const Progress& progress) {
  const Message what = Message::tr("Finding the surface");
  Extraction extraction(lattice);
  Effort effort;
  effort.isCancelled = progress.isCancelled;
  const int last = lattice.dims().z - 1;
  for (int first = 0; first < last; first += layersPerSlab) {
    reportOrStop(progress, 1.0 * first / last, what);
    extraction.addSlab(first, std::min(layersPerSlab, last - first) + 1, effort);
  }
  ExtractedSurface surface = extraction.take();
  // In a mirrored grid the same triangles turn the other way.
  if (glm::determinant(lattice.solid().volume().grid().direction) < 0.0)
    for (glm::uvec3& triangle : surface.mesh.triangles)
      std::swap(triangle.y, triangle.z);
  return surface;
}

} // namespace limn
