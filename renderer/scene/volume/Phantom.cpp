// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Phantom.h"

#include "scene/basics/Error.h"
#include "scene/volume/PhantomParts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

constexpr glm::dvec3 fieldOfViewMm(192.0, 232.0, 272.0);
constexpr double outside = -1000.0; // air

// How much of a part is at a point, 0..1.
double coverageOf(const PhantomPart& part, const glm::dvec3& p) {
  const glm::dvec3 q = (p - part.centreMm) / part.radiiMm;
  const double shortest = std::min({part.radiiMm.x, part.radiiMm.y, part.radiiMm.z});
  const double reach = 1.0 + part.edgeMm / 2.0 / shortest;
  const double squared = glm::dot(q, q);
  if (squared >= reach * reach)
    return 0.0;
  // The depth below the surface along the shortest radius fades the part in by a smooth step.
  const double radius = std::sqrt(squared);
  const double t = std::clamp((1.0 - radius) * shortest / part.edgeMm + 0.5, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

const std::vector<PhantomPart>& anatomy() {
  static const std::vector<PhantomPart> parts = phantomParts();
  return parts;
}

// A well-mixed 64-bit hash of a counter (splitmix64), so that noise needs no state between voxels.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

double unitUniform(std::uint64_t bits) {
  return (static_cast<double>(bits >> 11) + 0.5) * 0x1.0p-53;
}

// Box–Muller from two hashes of the voxel's number.
double gaussian(std::uint64_t seed, std::uint64_t voxel) {
  const double u = unitUniform(mixed(mixed(seed) ^ (2 * voxel)));
  const double v = unitUniform(mixed(mixed(seed) ^ (2 * voxel + 1)));
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
}

Grid gridOf(const PhantomSpec& spec) {
  const auto refuse = [] {
    throw Error(Error::Kind::usage,
                Message::tr("The phantom cannot be made at this spacing; choose 0.2 to 20 mm."));
  };
  if (!(spec.spacingMm >= 0.2 && spec.spacingMm <= 20.0))
    refuse();
  Grid grid;
  grid.dims = glm::max(glm::ivec3(glm::round(fieldOfViewMm / spec.spacingMm)), 1);
  grid.spacingMm = glm::dvec3(spec.spacingMm);
  grid.originMm = -(glm::dvec3(grid.dims) - 1.0) / 2.0 * spec.spacingMm;
  return grid;
}

std::int16_t sampleAt(const PhantomSpec& spec, const Grid& grid, int i, int j, int k) {
  double value = phantomValue(indexToWorld(grid, {i, j, k}));
  if (spec.noiseHu > 0.0)
    value += spec.noiseHu * gaussian(spec.seed, voxelOffset(grid.dims, i, j, k));
  return static_cast<std::int16_t>(std::clamp(std::lround(value), -1024L, 32767L));
}

} // namespace

double phantomValue(const glm::dvec3& worldMm) {
  double value = outside;
  for (const PhantomPart& part : anatomy())
    value += coverageOf(part, worldMm) * (part.hu - value);
  return value;
}

std::shared_ptr<const Volume> phantomVolume(const PhantomSpec& spec,
                                            const std::function<bool()>& isCancelled) {
  const Grid grid = gridOf(spec);
  std::vector<std::int16_t> voxels(static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z);
  forEachPiece(grid.dims.z, {0, isCancelled, {}}, [&](int k) {
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        voxels[voxelOffset(grid.dims, i, j, k)] = sampleAt(spec, grid, i, j, k);
  });
  VolumeInfo info;
  info.format = "Built-in head phantom";
  info.modality = "CT";
  info.unit = "HU";
  return std::make_shared<const Volume>(grid, std::move(voxels), Rescale{}, std::nullopt, std::move(info));
}

} // namespace limn
