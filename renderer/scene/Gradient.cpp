// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/Gradient.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Voxels of one volume in their stored type, with differences in scalar units.
template <class T>
struct Stencil {
  const Volume& volume;
  const std::vector<T>& stored;
  glm::ivec3 dims = volume.grid().dims;
  std::size_t stride[3] = {1, static_cast<std::size_t>(dims.x), static_cast<std::size_t>(dims.x) * dims.y};

  // Derivative along one grid axis at a voxel, value/mm.
  double derivative(std::size_t offset, int index, int axis) const {
    const bool hasLower = index > 0;
    const bool hasUpper = index + 1 < dims[axis];
    const int distance = int(hasLower) + int(hasUpper);
    if (distance == 0)
      return 0.0;
    const double upper = static_cast<double>(stored[offset + (hasUpper ? stride[axis] : 0)]);
    const double lower = static_cast<double>(stored[offset - (hasLower ? stride[axis] : 0)]);
    return volume.rescale().slope * (upper - lower) / (distance * volume.grid().spacingMm[axis]);
  }

  glm::dvec3 alongAxes(int i, int j, int k) const {
    const std::size_t offset = voxelOffset(dims, i, j, k);
    return {derivative(offset, i, 0), derivative(offset, j, 1), derivative(offset, k, 2)};
  }

  bool isEligible(int i, int j, int k) const {
    const std::vector<bool>& invalid = volume.invalidMask();
    if (invalid.empty())
      return true;
    const std::size_t offset = voxelOffset(dims, i, j, k);
    const int index[3] = {i, j, k};
    if (invalid[offset])
      return false;
    for (int axis = 0; axis < 3; ++axis)
      if ((index[axis] > 0 && invalid[offset - stride[axis]]) ||
          (index[axis] + 1 < dims[axis] && invalid[offset + stride[axis]]))
        return false;
    return true;
  }
};

template <class Function>
void forEachEligibleModulus(const Volume& volume, Function&& function) {
  visitVoxels(volume, [&]<class T>(const std::vector<T>& stored) {
    const Stencil<T> stencil{volume, stored};
    for (int k = 0; k < stencil.dims.z; ++k)
      for (int j = 0; j < stencil.dims.y; ++j)
        for (int i = 0; i < stencil.dims.x; ++i)
          if (stencil.isEligible(i, j, k))
            function(glm::length(stencil.alongAxes(i, j, k)));
  });
}

} // namespace

glm::dvec3 gradientAtVoxel(const Volume& volume, const glm::ivec3& index) {
  const glm::dvec3 alongAxes = visitVoxels(volume, [&]<class T>(const std::vector<T>& stored) {
    return Stencil<T>{volume, stored}.alongAxes(index.x, index.y, index.z);
  });
  return volume.grid().direction * alongAxes;
}

glm::dvec3 gradientAt(const Volume& volume, const glm::dvec3& index) {
  const glm::ivec3 dims = volume.grid().dims;
  const glm::dvec3 p = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(dims - 1));
  const glm::ivec3 low = glm::ivec3(glm::floor(p));
  const glm::dvec3 w = p - glm::dvec3(low);
  glm::dvec3 sum(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec3 weights = glm::mix(1.0 - w, w, glm::dvec3(step));
    const double weight = weights.x * weights.y * weights.z;
    if (weight > 0.0)
      sum += weight * gradientAtVoxel(volume, glm::min(low + step, dims - 1));
  }
  return sum;
}

double largestGradient(const Volume& volume) {
  double largest = 0.0;
  forEachEligibleModulus(volume, [&](double modulus) { largest = std::max(largest, modulus); });
  return largest;
}

double gradientPercentile(const Volume& volume, double percent) {
  // Floats order as the doubles they came from, and halve the memory of a large volume.
  std::vector<float> moduli;
  moduli.reserve(volume.voxelCount());
  forEachEligibleModulus(volume, [&](double modulus) { moduli.push_back(static_cast<float>(modulus)); });
  if (moduli.empty())
    return 0.0;
  const double rank = std::ceil(percent / 100.0 * static_cast<double>(moduli.size()));
  const auto index = static_cast<std::size_t>(std::clamp(rank, 1.0, static_cast<double>(moduli.size()))) - 1;
  std::nth_element(moduli.begin(), moduli.begin() + static_cast<std::ptrdiff_t>(index), moduli.end());
  return moduli[index];
}

GradientReference resolvedReference(const Shading& shading) {
  if (!std::holds_alternative<AutomaticReference>(shading.gradientReference))
    return shading.gradientReference;
  if (shading.model == ShadingModel::robust)
    return PercentileReference{99.5};
  return LargestReference{};
}

GradientScale gradientScale(const Volume& volume, const Shading& shading) {
  const GradientReference reference = resolvedReference(shading);
  GradientScale scale;
  scale.largest = largestGradient(volume);
  if (const auto* percentile = std::get_if<PercentileReference>(&reference))
    scale.reference = gradientPercentile(volume, percentile->percent);
  else if (const auto* fixed = std::get_if<FixedReference>(&reference))
    scale.reference = fixed->valuePerMm;
  else
    scale.reference = scale.largest;
  return scale;
}

} // namespace limn
