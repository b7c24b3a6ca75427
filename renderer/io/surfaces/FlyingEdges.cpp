// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/FlyingEdges.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace limn {

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

} // namespace limn
