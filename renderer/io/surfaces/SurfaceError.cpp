// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceError.h"

#include "scene/volume/Grid.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

namespace limn {
namespace {

vtkNew<vtkPolyData> polyDataOf(const SurfaceMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), &mesh.points[i].x);
  vtkNew<vtkCellArray> cells;
  cells->Use32BitStorage();
  cells->AllocateExact(static_cast<vtkIdType>(mesh.triangles.size()),
                       3 * static_cast<vtkIdType>(mesh.triangles.size()));
  for (const glm::uvec3& triangle : mesh.triangles)
    cells->InsertNextCell({triangle.x, triangle.y, triangle.z});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

// The distances in mm from points to a mesh that has triangles (VTK's static cell locator). Throws
// Cancelled.
std::vector<double> distancesTo(const SurfaceMesh& mesh, const std::vector<glm::dvec3>& points,
                                const Effort& effort) {
  const vtkNew<vtkPolyData> data = polyDataOf(mesh);
  data->BuildCells();
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();
  std::vector<double> distances(points.size());
  constexpr std::size_t perPiece = 1 << 10;
  forEachPiece(static_cast<int>((points.size() + perPiece - 1) / perPiece), effort, [&](int piece) {
    vtkNew<vtkGenericCell> cell;
    const std::size_t begin = static_cast<std::size_t>(piece) * perPiece;
    for (std::size_t i = begin; i < std::min(begin + perPiece, points.size()); ++i) {
      double nearest[3], squared = 0.0;
      vtkIdType id = 0;
      int side = 0;
      locator->FindClosestPoint(&points[i].x, nearest, cell, id, side, squared);
      distances[i] = std::sqrt(squared);
    }
  });
  return distances;
}

struct SurfacePoint {
  glm::dvec3 atMm{0.0};
  glm::dvec3 normal{0.0};
};

// Numbers from 0 to 1 that are the same on every machine.
double evenly(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

// Points of the mesh, each bit of its area as likely as another.
std::vector<SurfacePoint> spreadPoints(const SurfaceMesh& mesh) {
  std::vector<double> areas;
  areas.reserve(mesh.triangles.size());
  double sum = 0.0;
  for (const glm::uvec3& triangle : mesh.triangles)
    areas.push_back(sum += glm::length(areaVector(mesh, triangle)));
  std::mt19937_64 random(16);
  std::vector<SurfacePoint> points;
  points.reserve(pointsTried);
  for (std::size_t i = 0; i < pointsTried && sum > 0.0; ++i) {
    const double at = sum * (static_cast<double>(i) + evenly(random)) / pointsTried;
    const auto found = std::upper_bound(areas.begin(), areas.end(), at);
    const std::size_t which = std::min<std::size_t>(found - areas.begin(), areas.size() - 1);
    const glm::uvec3& t = mesh.triangles[which];
    // The square root makes the spread even over the triangle.
    const double root = std::sqrt(evenly(random)), share = evenly(random);
    points.push_back({(1.0 - root) * glm::dvec3(mesh.points[t.x]) +
                          root * (1.0 - share) * glm::dvec3(mesh.points[t.y]) +
                          root * share * glm::dvec3(mesh.points[t.z]),
                      glm::normalize(areaVector(mesh, t))});
  }
  return points;
}

// The directions of a cube's corners, edges and faces, unit length.
std::array<glm::dvec3, 26> cubeDirections() {
  std::array<glm::dvec3, 26> directions;
  for (int which = 0, next = 0; which < 27; ++which)
    if (which != 13)
      directions[static_cast<std::size_t>(next++)] =
          glm::normalize(glm::dvec3(which % 3 - 1, which / 3 % 3 - 1, which / 9 - 1));
  return directions;
}

// Where a predicate that does not hold at `from` and holds at `to` begins to hold, a thousandth of the way
// exactly.
template <class Predicate>
double changeBetween(double from, double to, Predicate&& holds) {
  for (int halving = 0; halving < 10; ++halving) {
    const double middle = 0.5 * (from + to);
    (holds(middle) ? to : from) = middle;
  }
  return to;
}

double farthestMm(const Grid& grid) {
  return 4.0 * std::max({grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z});
}

// Along the normal, against it and, farther off, along the other directions.
std::optional<glm::dvec3> wayAlongDirections(const Solid& solid, const glm::dvec3& index,
                                             const glm::dvec3& normal) {
  static const std::array<glm::dvec3, 26> others = cubeDirections();
  constexpr double growth = 1.5;
  const Grid& grid = solid.volume().grid();
  const bool isInside = solid.contains(index);
  const auto leaves = [&](const glm::dvec3& way) {
    return solid.contains(index + solid.vectorToIndex(way)) != isInside;
  };
  const double firstMm = smallestSpacingMm(grid) / 16.0;
  double same = 0.0;
  const auto wayOf = [&](const glm::dvec3& direction, double mm) {
    return direction * changeBetween(same, mm, [&](double at) { return leaves(at * direction); });
  };
  for (double mm = firstMm; same < farthestMm(grid); same = mm, mm *= growth) {
    for (const glm::dvec3& direction : {normal, -normal})
      if (leaves(mm * direction))
        return wayOf(direction, mm);
    for (const glm::dvec3& direction : others)
      if (mm > firstMm && leaves(mm * direction))
        return wayOf(direction, mm);
  }
  return std::nullopt;
}

// To the nearest place where an edge of the cell around, which ends where the crop does, crosses the
// boundary: what is too small to lie in any direction is met there.
std::optional<glm::dvec3> wayToCell(const Solid& solid, const glm::dvec3& pointMm) {
  const glm::dvec3 low = glm::floor(solid.withinCrop(solid.toIndex(pointMm)));
  std::optional<glm::dvec3> nearest;
  for (int edge = 0; edge < 12; ++edge) {
    const int axis = edge / 4;
    glm::dvec3 from = low;
    from[(axis + 1) % 3] += edge & 1;
    from[(axis + 2) % 3] += edge >> 1 & 1;
    glm::dvec3 to = from;
    to[axis] += 1.0;
    from = solid.withinCrop(from);
    to = solid.withinCrop(to);
    const bool isInside = solid.contains(from);
    if (solid.contains(to) == isInside)
      continue;
    const double share = changeBetween(
        0.0, 1.0, [&](double at) { return solid.contains(glm::mix(from, to, at)) != isInside; });
    const glm::dvec3 way = indexToWorld(solid.volume().grid(), glm::mix(from, to, share)) - pointMm;
    if (!nearest || glm::length(way) < glm::length(*nearest))
      nearest = way;
  }
  return nearest;
}

Distances summary(const std::vector<double>& distances) {
  if (distances.empty())
    return {};
  return {*std::max_element(distances.begin(), distances.end()),
          std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size()),
          distances.size()};
}

constexpr std::size_t placesPerPiece = 1 << 12;

template <class Function>
void forEachOf(std::size_t count, const Effort& effort, Function&& function) {
  forEachPiece(static_cast<int>((count + placesPerPiece - 1) / placesPerPiece), effort, [&](int piece) {
    const std::size_t begin = static_cast<std::size_t>(piece) * placesPerPiece;
    for (std::size_t i = begin; i < std::min(begin + placesPerPiece, count); ++i)
      function(i);
  });
}

const Message measuring = Message::tr("Measuring the surface");

} // namespace

std::optional<glm::dvec3> wayToBoundary(const Solid& solid, const glm::dvec3& pointMm,
                                        const glm::dvec3& normal) {
  const auto along = wayAlongDirections(solid, solid.toIndex(pointMm), normal);
  const double spacing = smallestSpacingMm(solid.volume().grid());
  if (along && glm::length(*along) < 0.02 * spacing)
    return along;
  const auto corner = wayToCell(solid, pointMm);
  return !along || (corner && glm::length(*corner) < glm::length(*along)) ? corner : along;
}

std::vector<glm::dvec3> boundaryPoints(const Solid& solid, const SurfaceMesh& full,
                                       const Progress& progress) {
  const std::vector<SurfacePoint> spread = spreadPoints(full);
  std::vector<std::optional<glm::dvec3>> ways(spread.size());
  forEachOf(spread.size(), effortOf(progress, measuring),
            [&](std::size_t i) { ways[i] = wayToBoundary(solid, spread[i].atMm, spread[i].normal); });
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < ways.size(); ++i)
    if (ways[i])
      points.push_back(spread[i].atMm + *ways[i]);
  return points;
}

SurfaceError measuredError(const Solid& solid, const SurfaceMesh& mesh,
                           const std::vector<glm::dvec3>& boundary, const Progress& progress) {
  const std::vector<SurfacePoint> spread = spreadPoints(mesh);
  std::vector<double> ofMesh(spread.size());
  forEachOf(spread.size(), effortOf(part(progress, 0.0, 0.4), measuring), [&](std::size_t i) {
    const auto way = wayToBoundary(solid, spread[i].atMm, spread[i].normal);
    ofMesh[i] = way ? glm::length(*way) : farthestMm(solid.volume().grid());
  });
  return {summary(ofMesh),
          summary(distancesTo(mesh, boundary, effortOf(part(progress, 0.4, 1.0), measuring)))};
}

} // namespace limn
