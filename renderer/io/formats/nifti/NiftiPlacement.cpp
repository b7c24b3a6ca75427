// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/nifti/NiftiFile.h"
#include "io/formats/voxels/AxisGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace limn {
namespace {

// An affine map from voxel index to mm.
struct Affine {
  glm::dmat3 steps{1.0};
  glm::dvec3 origin{0.0};
};

// Millimetres per unit of length; files that name no unit mean millimetres.
double millimetresPerUnit(int units) {
  switch (units & 7) {
  case 1:
    return 1000.0;
  case 3:
    return 0.001;
  default:
    return 1.0;
  }
}

Affine sformOf(const NiftiHeader& header) {
  const auto& rows = header.sformRows;
  Affine affine;
  for (int axis = 0; axis < 3; ++axis)
    affine.steps[axis] = {rows[0][axis], rows[1][axis], rows[2][axis]};
  affine.origin = {rows[0].w, rows[1].w, rows[2].w};
  return affine;
}

// The rotation of the quaternion (a, b, c, d), a ≥ 0 left out, times the voxel size; a negative pixdim[0]
// turns the third axis round (nifti1.h, "METHOD 2").
Affine qformOf(const NiftiHeader& header) {
  glm::dvec3 v = header.quaternion;
  const double rest = 1.0 - glm::dot(v, v);
  const double a = rest > 1e-7 ? std::sqrt(rest) : 0.0;
  if (a == 0.0)
    v /= glm::length(v);
  const double b = v.x, c = v.y, d = v.z;
  Affine affine;
  affine.steps[0] = {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
  affine.steps[1] = {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)};
  affine.steps[2] = {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c};
  affine.steps[2] *= header.pixdim[0] < 0.0 ? -1.0 : 1.0;
  for (int axis = 0; axis < 3; ++axis)
    affine.steps[axis] *= std::abs(header.pixdim[static_cast<std::size_t>(axis) + 1]);
  affine.origin = header.quaternionOffset;
  return affine;
}

bool isValid(int code, const Affine& affine) {
  return code > 0 && isUsable(affine.steps) && std::isfinite(glm::length(affine.origin));
}

// Whether the quaternion is one of unit length, but for the rounding of float32.
bool isRotation(const NiftiHeader& header) {
  return glm::dot(header.quaternion, header.quaternion) <= 1.0 + 1e-4;
}

// The largest distance between the places of one corner of the volume in two maps.
double largestCornerDistance(const Affine& a, const Affine& b, const NiftiHeader& header) {
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 index(0.0);
    for (int axis = 0; axis < 3; ++axis)
      index[axis] =
          (corner >> axis & 1) ? std::max(header.dim[static_cast<std::size_t>(axis) + 1] - 1.0, 0.0) : 0.0;
    largest = std::max(largest, glm::distance(a.steps * index + a.origin, b.steps * index + b.origin));
  }
  return largest;
}

NiftiPlacement placed(const Affine& affine, double millimetres) {
  NiftiPlacement placement;
  placement.stepsMm = rasToLps(affine.steps) * millimetres;
  placement.originMm = rasToLps(affine.origin) * millimetres;
  return placement;
}

NiftiPlacement spacingOnly(const NiftiHeader& header, double millimetres) {
  NiftiPlacement placement;
  placement.orientationKnown = false;
  for (int axis = 0; axis < 3; ++axis) {
    const double spacing = std::abs(header.pixdim[static_cast<std::size_t>(axis) + 1]) * millimetres;
    const bool isGiven = spacing > 0.0 && std::isfinite(spacing);
    placement.spacingKnown = placement.spacingKnown && isGiven;
    placement.stepsMm[axis] *= isGiven ? spacing : 1.0;
  }
  return placement;
}

} // namespace

NiftiPlacement placementOf(const NiftiHeader& header) {
  const double millimetres = millimetresPerUnit(header.units);
  const Affine sform = sformOf(header);
  const Affine qform = qformOf(header);
  const bool qformIsValid = isRotation(header) && isValid(header.qformCode, qform);
  if (isValid(header.sformCode, sform)) {
    NiftiPlacement placement = placed(sform, millimetres);
    const double apart = largestCornerDistance(sform, qform, header) * millimetres;
    if (qformIsValid && apart > 0.5 * glm::length(placement.stepsMm[0]))
      placement.warnings.push_back(
          Message::tr("The file's two placements (sform, qform) differ by up to %1 mm; the sform is used.")
              .arg(Message::fixed(apart, 1)));
    return placement;
  }
  NiftiPlacement placement = qformIsValid ? placed(qform, millimetres) : spacingOnly(header, millimetres);
  if (header.sformCode > 0)
    placement.warnings.emplace_back(Message::tr("The file's placement (sform) is damaged and was left out."));
  if (header.qformCode > 0 && !qformIsValid)
    placement.warnings.emplace_back(Message::tr("The file's placement (qform) is damaged and was left out."));
  return placement;
}

} // namespace limn
