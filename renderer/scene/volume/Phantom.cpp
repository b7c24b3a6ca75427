// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Phantom.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

namespace hu {
constexpr double air = -1000, fat = -100, skin = 20, muscle = 50, compactBone = 1200, diploe = 450,
                 greyMatter = 38, whiteMatter = 28, fluid = 8, vitreous = 12, lens = 90, dentine = 1700,
                 enamel = 2600, metal = 8000;
}

constexpr double edge = 1.5;

void addShells(std::vector<PhantomPart>& parts) {
  // Neck first, so that the head covers its upper end.
  parts.push_back({{0, 22, -112}, {52, 50, 60}, hu::skin, edge});
  parts.push_back({{0, 22, -112}, {50, 48, 58}, hu::fat, edge});
  parts.push_back({{0, 22, -112}, {46, 44, 56}, hu::muscle, edge});
  // The face below the skull.
  parts.push_back({{0, -40, -58}, {60, 58, 60}, hu::skin, edge});
  parts.push_back({{0, -40, -58}, {58, 56, 58}, hu::fat, edge});
  parts.push_back({{0, -40, -58}, {55, 53, 55}, hu::muscle, edge});
  // Nose.
  parts.push_back({{0, -92, -34}, {13, 18, 22}, hu::skin, edge});
  // Scalp.
  parts.push_back({{0, 0, 18}, {80, 98, 92}, hu::skin, edge});
  parts.push_back({{0, 0, 18}, {78, 96, 90}, hu::fat, edge});
  parts.push_back({{0, 0, 18}, {75, 93, 87}, hu::muscle, edge});
}

void addSkullAndBrain(std::vector<PhantomPart>& parts) {
  parts.push_back({{0, 0, 18}, {71, 89, 83}, hu::compactBone, edge});
  parts.push_back({{0, 0, 18}, {69, 87, 81}, hu::diploe, edge});
  parts.push_back({{0, 0, 18}, {66, 84, 78}, hu::compactBone, edge});
  parts.push_back({{0, 0, 18}, {64, 82, 76}, hu::fluid, edge});
  parts.push_back({{0, 0, 18}, {62, 80, 74}, hu::greyMatter, edge});
  for (const double side : {-1.0, 1.0}) {
    parts.push_back({{side * 29, 0, 24}, {25, 64, 54}, hu::whiteMatter, edge});
    parts.push_back({{side * 10, -14, 30}, {6, 26, 11}, hu::fluid, edge});
    parts.push_back({{side * 15, 22, 26}, {7, 20, 10}, hu::fluid, edge});
  }
  parts.push_back({{0, 4, 16}, {3, 12, 9}, hu::fluid, edge});
}

void addFace(std::vector<PhantomPart>& parts) {
  for (const double side : {-1.0, 1.0}) {
    // Cheek bones, orbits with the eyes, maxillary sinuses.
    parts.push_back({{side * 40, -48, -25}, {13, 14, 9}, hu::compactBone, edge});
    parts.push_back({{side * 31, -61, -8}, {19, 17, 18}, hu::compactBone, edge});
    parts.push_back({{side * 31, -64, -8}, {15.5, 15.5, 15}, hu::fat, edge});
    parts.push_back({{side * 31, -67, -8}, {12, 12, 12}, hu::vitreous, edge});
    parts.push_back({{side * 31, -76, -8}, {4.5, 2.6, 4.5}, hu::lens, edge});
    parts.push_back({{side * 24, -62, -36}, {12, 17, 15}, hu::compactBone, edge});
    parts.push_back({{side * 24, -62, -36}, {10, 15, 13}, hu::air, edge});
    // The mandible's branches.
    parts.push_back({{side * 44, -24, -62}, {6.5, 15, 28}, hu::compactBone, edge});
    parts.push_back({{side * 35, -46, -86}, {8, 22, 9}, hu::compactBone, edge});
  }
  parts.push_back({{0, -70, -91}, {29, 10, 10}, hu::compactBone, edge});
  parts.push_back({{0, -66, -52}, {30, 18, 7}, hu::compactBone, edge});
  // Frontal sinus, nasal cavity, mouth.
  parts.push_back({{0, -79, 22}, {18, 9, 12}, hu::compactBone, edge});
  parts.push_back({{0, -79, 22}, {13, 5, 7}, hu::air, edge});
  parts.push_back({{0, -72, -30}, {8, 22, 18}, hu::air, edge});
  parts.push_back({{0, -48, -68}, {22, 24, 6}, hu::muscle, edge});
  parts.push_back({{0, 2, -72}, {10, 8, 44}, hu::air, edge});
}

void addTeeth(std::vector<PhantomPart>& parts) {
  // Two arcs of fourteen teeth; a molar of the lower left carries the filling.
  for (int i = 0; i < 14; ++i) {
    const double angle = (i - 6.5) / 6.5 * 1.2;
    const double x = 31.0 * std::sin(angle);
    const double y = -42.0 - 36.0 * std::cos(angle);
    const double width = 2.6 + 1.4 * std::abs(angle);
    parts.push_back({{x, y, -61}, {width, width, 6.0}, hu::enamel, 1.0});
    parts.push_back({{x, y, -60}, {width - 1.2, width - 1.2, 4.6}, hu::dentine, 1.0});
    parts.push_back({{x, y, -76}, {width, width, 6.0}, hu::enamel, 1.0});
    parts.push_back({{x, y, -77}, {width - 1.2, width - 1.2, 4.6}, hu::dentine, 1.0});
    if (i == 12)
      parts.push_back({{x, y, -72}, {2.2, 2.2, 1.8}, hu::metal, 1.0});
  }
}

void addSpine(std::vector<PhantomPart>& parts) {
  for (int i = 0; i < 5; ++i) {
    const double z = -62.0 - 19.0 * i;
    parts.push_back({{0, 26, z}, {15, 12, 7.5}, hu::compactBone, edge});
    parts.push_back({{0, 26, z}, {13, 10, 5.5}, hu::diploe, edge});
    parts.push_back({{0, 50, z - 3}, {5, 16, 5}, hu::compactBone, edge});
    parts.push_back({{0, 42, z}, {8, 7, 12}, hu::fluid, edge});
  }
}

constexpr glm::dvec3 fieldOfViewMm(192.0, 232.0, 272.0);
constexpr double outside = -1000.0; // air

double shortestRadiusOf(const PhantomPart& part) {
  return std::min({part.radiiMm.x, part.radiiMm.y, part.radiiMm.z});
}

// In radii of the part, where its edge ends.
double reachOf(const PhantomPart& part) {
  return 1.0 + part.edgeMm / 2.0 / shortestRadiusOf(part);
}

// How much of a part is at a point, 0..1.
double coverageOf(const PhantomPart& part, const glm::dvec3& p) {
  const glm::dvec3 q = (p - part.centreMm) / part.radiiMm;
  const double shortest = shortestRadiusOf(part);
  const double reach = reachOf(part);
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

// The parts that a row along x meets, in their order: few of a hundred.
void findPartsOfRow(double y, double z, std::vector<PhantomPart>& parts) {
  constexpr double rounding = 1e-9; // what just fails to meet it has nothing there
  parts.clear();
  for (const PhantomPart& part : anatomy()) {
    const double v = (y - part.centreMm.y) / part.radiiMm.y;
    const double w = (z - part.centreMm.z) / part.radiiMm.z;
    const double reach = reachOf(part);
    if (v * v + w * w < (1.0 + rounding) * reach * reach)
      parts.push_back(part);
  }
}

double valueOf(const std::vector<PhantomPart>& parts, const glm::dvec3& worldMm) {
  double value = outside;
  for (const PhantomPart& part : parts)
    value += coverageOf(part, worldMm) * (part.hu - value);
  return value;
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

std::int16_t sampleAt(const PhantomSpec& spec, const Grid& grid, const std::vector<PhantomPart>& parts, int i,
                      int j, int k) {
  double value = valueOf(parts, indexToWorld(grid, {i, j, k}));
  if (spec.noiseHu > 0.0)
    value += spec.noiseHu * gaussian(spec.seed, voxelOffset(grid.dims, i, j, k));
  return static_cast<std::int16_t>(std::clamp(std::lround(value), -1024L, 32767L));
}

} // namespace

std::vector<PhantomPart> phantomParts() {
  std::vector<PhantomPart> parts;
  addShells(parts);
  addSkullAndBrain(parts);
  addFace(parts);
  addTeeth(parts);
  addSpine(parts);
  return parts;
}

double phantomValue(const glm::dvec3& worldMm) {
  return valueOf(anatomy(), worldMm);
}

std::shared_ptr<const Volume> phantomVolume(const PhantomSpec& spec,
                                            const std::function<bool()>& isCancelled) {
  const Grid grid = gridOf(spec);
  std::vector<std::int16_t> voxels(static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z);
  forEachPiece(grid.dims.z, {0, isCancelled, {}}, [&](int k) {
    std::vector<PhantomPart> parts;
    for (int j = 0; j < grid.dims.y; ++j) {
      const glm::dvec3 row = indexToWorld(grid, {0, j, k});
      findPartsOfRow(row.y, row.z, parts);
      for (int i = 0; i < grid.dims.x; ++i)
        voxels[voxelOffset(grid.dims, i, j, k)] = sampleAt(spec, grid, parts, i, j, k);
    }
  });
  VolumeInfo info;
  info.format = "Built-in head phantom";
  info.modality = "CT";
  info.unit = "HU";
  return std::make_shared<const Volume>(grid, std::move(voxels), Rescale{}, std::nullopt, std::move(info));
}

} // namespace limn
