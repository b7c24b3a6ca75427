// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/Extraction.h"

#include "scene/basics/Effort.h"

#include <glm/glm.hpp>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace limn {
namespace {

// A plane that lies nearer to voxel centres, in voxels, stands for them: cells would be too thin for
// triangles.
constexpr double thinnestCell = 0.003;

std::vector<double> placesBetween(double lower, double upper, int cells) {
  std::vector<double> places{lower, lower};
  for (double part = std::ceil((lower + thinnestCell) * cells); part < (upper - thinnestCell) * cells; ++part)
    places.push_back(part / cells);
  places.insert(places.end(), {upper, upper});
  return places;
}

bool isCentre(double at, int count) {
  return at == std::floor(at) && at >= 0.0 && at < count;
}

// Which triangles separate the marked places of a lattice from the others.
struct LatticeTriangles {
  /// Points, each in the middle of an edge of the lattice, in half steps: one coordinate is odd.
  std::vector<glm::ivec3> halves;
  std::vector<glm::uvec3> triangles; ///< anticlockwise seen from the places that are not marked
};

// VTK's flying edges (W. Schroeder, R. Maynard, B. Geveci, "Flying Edges: A High-Performance Scalable
// Isocontouring Algorithm", LDAV 2015). `marks` are 1 or 0, x fastest, at least two along each axis.
LatticeTriangles trianglesBetween(std::vector<std::uint8_t>& marks, const glm::ivec3& dims) {
  vtkNew<vtkUnsignedCharArray> scalars;
  constexpr int keepsTheArray = 1;
  scalars->SetArray(marks.data(), static_cast<vtkIdType>(marks.size()), keepsTheArray);
  vtkNew<vtkImageData> image;
  image->SetDimensions(dims.x, dims.y, dims.z);
  image->GetPointData()->SetScalars(scalars);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  edges->SetValue(0, 0.5);
  edges->Update();
  vtkPolyData* output = edges->GetOutput();

  LatticeTriangles result;
  result.halves.resize(static_cast<std::size_t>(output->GetNumberOfPoints()));
  for (std::size_t i = 0; i < result.halves.size(); ++i) {
    double at[3];
    output->GetPoint(static_cast<vtkIdType>(i), at);
    for (int axis = 0; axis < 3; ++axis)
      result.halves[i][axis] = static_cast<int>(std::lround(2.0 * at[axis]));
  }
  const auto cells = vtk::TakeSmartPointer(output->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(count, corners);
    result.triangles.emplace_back(corners[0], corners[1], corners[2]);
  }
  return result;
}

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

SurfaceLattice::SurfaceLattice(const Solid& solid, int cells) : m_solid(&solid), m_cells(cells) {
  for (int axis = 0; axis < 3; ++axis) {
    m_at[axis] = placesBetween(solid.lower()[axis], solid.upper()[axis], cells);
    m_dims[axis] = static_cast<int>(m_at[axis].size());
  }
}

std::vector<std::uint8_t> SurfaceLattice::marked(int firstLayer, int layers, const Effort& effort) const {
  const std::size_t width = m_dims.x;
  std::vector<std::uint8_t> marks(width * m_dims.y * layers, 0);
  forEachPiece(layers, effort, [&](int layer) {
    const int k = firstLayer + layer;
    if (isOutside(2, k))
      return;
    for (int j = 1; j + 1 < m_dims.y; ++j)
      markRow(j, k, marks.data() + (static_cast<std::size_t>(layer) * m_dims.y + j) * width);
  });
  return marks;
}

void SurfaceLattice::markRow(int j, int k, std::uint8_t* out) const {
  const glm::ivec3& voxels = m_solid->volume().grid().dims;
  const double y = m_at[1][j], z = m_at[2][k];
  const auto ask = [&](int i) { out[i] = m_solid->contains({m_at[0][i], y, z}) ? 1 : 0; };
  // Between the planes at which the crop ends, rows through centres are read as they are stored.
  const int between = m_dims.x - 4;
  if (m_cells == 1 && between > 0 && isCentre(y, voxels.y) && isCentre(z, voxels.z)) {
    ask(1);
    m_solid->markRow(static_cast<int>(m_at[0][2]), between, static_cast<int>(y), static_cast<int>(z),
                     out + 2);
    ask(m_dims.x - 2);
    return;
  }
  for (int i = 1; i + 1 < m_dims.x; ++i)
    ask(i);
}

std::uint64_t crossedEdges(const SurfaceLattice& lattice, const Effort& effort) {
  constexpr int layersEach = 16;
  const glm::ivec3& dims = lattice.dims();
  const std::size_t width = dims.x, area = width * dims.y;
  std::atomic<std::uint64_t> crossed = 0;
  Effort alone;
  alone.threads = 1;
  forEachPiece((dims.z - 1 + layersEach - 1) / layersEach, effort, [&](int piece) {
    const int first = piece * layersEach;
    const int layers = std::min(layersEach + 1, dims.z - first);
    const std::vector<std::uint8_t> marks = lattice.marked(first, layers, alone);
    // The outermost places are all outside, so that what has no neighbour crosses nothing.
    std::uint64_t here = 0;
    for (std::size_t i = 0; i < area * (layers - 1); ++i)
      here += (marks[i] != marks[i + 1]) + (marks[i] != marks[i + width]) + (marks[i] != marks[i + area]);
    crossed += here;
  });
  return crossed;
}

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
