// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/NearestTriangle.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>

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

} // namespace

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

} // namespace limn
