// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/voxels/AxisGrid.h"

#include "io/reading/ReadError.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double largestCosine = 1e-4;

// Divides by the length (not by its inverse root), which is exact for an axis along the world's.
glm::dvec3 unit(const glm::dvec3& vector) {
  return vector / glm::length(vector);
}

glm::dmat3 unitColumns(const glm::dmat3& steps) {
  return {unit(steps[0]), unit(steps[1]), unit(steps[2])};
}

// Turns -0 into 0, which reads better.
glm::dvec3 withPlainZeros(const glm::dvec3& vector) {
  return vector + glm::dvec3(0.0);
}

} // namespace

bool isUsable(const glm::dmat3& stepsMm) {
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(stepsMm[axis]);
    if (!std::isfinite(length) || length <= 0.0)
      return false;
  }
  return std::abs(glm::determinant(unitColumns(stepsMm))) > 1e-6;
}

Grid gridFromAxes(const std::filesystem::path& file, const glm::ivec3& dims, const glm::dmat3& stepsMm,
                  const glm::dvec3& originMm) {
  const bool originIsFinite =
      std::isfinite(originMm.x) && std::isfinite(originMm.y) && std::isfinite(originMm.z);
  if (!isUsable(stepsMm) || !originIsFinite)
    failReading(file, Message::tr("its header places the voxels with numbers that span no volume"),
                Message::tr("export the file again with a valid orientation"));
  const glm::dmat3 axes = unitColumns(stepsMm);
  const double shear = std::max({std::abs(glm::dot(axes[0], axes[1])), std::abs(glm::dot(axes[0], axes[2])),
                                 std::abs(glm::dot(axes[1], axes[2]))});
  if (shear > largestCosine) {
    const double degrees = std::abs(90.0 - glm::degrees(std::acos(shear)));
    failReading(
        file,
        Message::tr("its axes are sheared (%1 degrees off the right angle), which would be drawn distorted")
            .arg(Message::rounded(degrees, 4)),
        Message::tr("resample it to a rectangular grid first, e.g. with 3D Slicer or FSL"));
  }
  const glm::dvec3 x = axes[0];
  const glm::dvec3 y = unit(axes[1] - glm::dot(x, axes[1]) * x);
  const glm::dvec3 z = glm::cross(x, y);
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {glm::length(stepsMm[0]), glm::length(stepsMm[1]), glm::length(stepsMm[2])};
  grid.originMm = withPlainZeros(originMm);
  grid.direction = {withPlainZeros(x), withPlainZeros(y),
                    withPlainZeros(glm::dot(z, axes[2]) < 0.0 ? -z : z)};
  return grid;
}

glm::dmat3 rasToLps(const glm::dmat3& matrix) {
  return {rasToLps(matrix[0]), rasToLps(matrix[1]), rasToLps(matrix[2])};
}

glm::dvec3 rasToLps(const glm::dvec3& point) {
  return {-point.x, -point.y, point.z};
}

} // namespace limn
