// SPDX-License-Identifier: GPL-3.0-or-later
#include "VtkImage.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace limn {
namespace {

// The same place in the world with the first axis turned round.
Grid turnedRound(Grid grid) {
  grid.originMm += (grid.dims.x - 1) * grid.spacingMm.x * grid.direction[0];
  grid.direction[0] = -grid.direction[0];
  return grid;
}

template <class T>
void setVoxels(vtkImageData& image, const StoredVoxels<T>& stored, const glm::ivec3& dims, bool isTurned) {
  vtkNew<vtkAOSDataArrayTemplate<T>> array;
  if (isTurned) {
    array->SetNumberOfValues(static_cast<vtkIdType>(stored.size()));
    for (std::size_t row = 0; row < stored.size(); row += static_cast<std::size_t>(dims.x))
      std::reverse_copy(stored.data() + row, stored.data() + row + dims.x, array->GetPointer(0) + row);
  } else {
    // VTK only reads what it is told to save.
    array->SetArray(const_cast<T*>(stored.data()), static_cast<vtkIdType>(stored.size()), 1);
  }
  image.GetPointData()->SetScalars(array);
}

} // namespace

VtkVolumeImage vtkImageOf(const Volume& volume) {
  VtkVolumeImage result{vtkSmartPointer<vtkImageData>::New(), volume.grid()};
  const bool isTurned = glm::determinant(result.grid.direction) < 0.0;
  if (isTurned)
    result.grid = turnedRound(result.grid);
  const glm::ivec3& dims = result.grid.dims;
  const glm::dvec3& spacing = result.grid.spacingMm;
  result.image->SetDimensions(dims.x, dims.y, dims.z);
  result.image->SetSpacing(spacing.x, spacing.y, spacing.z);
  visitVoxels(volume, [&](const auto& stored) { setVoxels(*result.image, stored, dims, isTurned); });
  return result;
}

} // namespace limn
