// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceNormals.h"

#include "scene/light/Gradient.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// A point farther from the isosurface, in voxels, or from the planes where the crop ends, is not on them.
constexpr double nearIsosurface = 0.5;
constexpr double onPlane = 1e-3;
// The gradient's direction and that of the triangles agree at least so far (cosine), or noise decides it.
constexpr double leastAgreement = 0.25;

glm::dvec3 unit(const glm::dvec3& vector) {
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0, 0.0, 1.0);
}

bool isOnPlane(const Solid& solid, const glm::dvec3& index) {
  return glm::any(glm::lessThan(index, solid.lower() + onPlane)) ||
         glm::any(glm::greaterThan(index, solid.upper() - onPlane));
}

glm::dvec3 normalAt(const Solid& solid, const glm::dvec3& pointMm, const glm::dvec3& ofTriangles) {
  const glm::dvec3 index = solid.toIndex(pointMm);
  if (isOnPlane(solid, index))
    return ofTriangles;
  const glm::dvec3 gradient = gradientAt(solid.volume(), index);
  const double modulus = glm::length(gradient);
  const double nearMm = nearIsosurface * smallestSpacingMm(solid.volume().grid());
  if (!(modulus > 0.0) || std::abs(solid.excess(index)) > nearMm * modulus)
    return ofTriangles;
  const glm::dvec3 normal = -gradient / modulus;
  return glm::dot(normal, ofTriangles) >= leastAgreement ? normal : ofTriangles;
}

} // namespace

SurfaceMesh withNormals(SurfaceMesh mesh, const Solid& solid, const Effort& effort) {
  std::vector<glm::dvec3> around(mesh.points.size(), glm::dvec3(0.0));
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 area = areaVector(mesh, triangle);
    for (int corner = 0; corner < 3; ++corner)
      around[triangle[corner]] += area;
  }
  mesh.normals.resize(mesh.points.size());
  constexpr std::size_t perPiece = 1 << 13;
  forEachPiece(static_cast<int>((mesh.points.size() + perPiece - 1) / perPiece), effort, [&](int piece) {
    const std::size_t begin = static_cast<std::size_t>(piece) * perPiece;
    for (std::size_t i = begin; i < std::min(begin + perPiece, mesh.points.size()); ++i)
      mesh.normals[i] = normalAt(solid, glm::dvec3(mesh.points[i]), unit(around[i]));
  });
  return mesh;
}

} // namespace limn
