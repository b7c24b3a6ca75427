// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/Gradient.h"

#include "scene/light/ModulusSearch.h"
#include "scene/volume/VolumePart.h"

namespace limn {

glm::dvec3 gradientAtVoxel(const Volume& volume, const glm::ivec3& index) {
  const glm::dvec3 alongAxes = visitVoxels(volume, [&]<class T>(const StoredVoxels<T>& stored) {
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

double largestGradient(const Volume& volume, const Effort& effort) {
  return findModuli(volume, std::nullopt, effort).largest;
}

double gradientPercentile(const Volume& volume, double percent, const Effort& effort) {
  return findModuli(volume, percent, effort).percentile;
}

double steepness(const Volume& volume) {
  return steepness(volume, latticeModuli(volume, allVoxels(volume.grid())));
}

LatticeModuli latticeModuli(const Volume& volume, const VoxelBox& of) {
  constexpr int mostPerAxis = 32;
  const glm::ivec3 stride = (volume.grid().dims + mostPerAxis - 1) / mostPerAxis;
  // The lattice is the whole volume's: the first of its places at or above the lower end.
  const glm::ivec3 steps = glm::max(of.lower - stride / 2 + stride - 1, glm::ivec3(0)) / stride;
  const glm::ivec3 first = stride / 2 + steps * stride;
  LatticeModuli lattice;
  const auto look = [&](const Volume& held, const glm::ivec3& lower) {
    const EligibleVoxels eligible(held);
    visitVoxels(held, [&]<class T>(const StoredVoxels<T>& stored) {
      const Stencil<T> stencil{held, stored};
      for (int k = first.z - lower.z; k < of.upper.z - lower.z; k += stride.z)
        for (int j = first.y - lower.y; j < of.upper.y - lower.y; j += stride.y)
          for (int i = first.x - lower.x; i < of.upper.x - lower.x; i += stride.x)
            if (eligible.has(i, j, k))
              lattice.moduli.push_back(stencil.modulus(i, j, k));
    });
  };
  if (volume.part())
    look(volume.held(), volume.part()->box.lower);
  else
    look(volume, glm::ivec3(0));
  return lattice;
}

LatticeModuli joined(const LatticeModuli& a, const LatticeModuli& b) {
  LatticeModuli both = a;
  both.moduli.insert(both.moduli.end(), b.moduli.begin(), b.moduli.end());
  return both;
}

double steepness(const Volume& volume, LatticeModuli lattice) {
  std::vector<double>& moduli = lattice.moduli;
  if (moduli.empty())
    return 0.0;
  const auto rank =
      moduli.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(moduli.size() - 1));
  std::nth_element(moduli.begin(), rank, moduli.end());
  return *rank * modulusUnit(volume);
}

GradientReference resolvedReference(const Shading& shading) {
  if (!std::holds_alternative<AutomaticReference>(shading.gradientReference))
    return shading.gradientReference;
  if (shading.model == ShadingModel::robust || shading.model == ShadingModel::physical)
    return PercentileReference{99.5};
  return LargestReference{};
}

GradientScale gradientScale(const Volume& volume, const Shading& shading, const Effort& effort) {
  const GradientReference reference = resolvedReference(shading);
  const auto* percentile = std::get_if<PercentileReference>(&reference);
  const FoundModuli found =
      findModuli(volume, percentile ? std::optional(percentile->percent) : std::nullopt, effort);
  if (percentile)
    return {found.largest, found.percentile};
  const auto* fixed = std::get_if<FixedReference>(&reference);
  return {found.largest, fixed ? fixed->valuePerMm : found.largest};
}

} // namespace limn
