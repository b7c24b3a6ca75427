// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/GlslEvaluator.h"
#include "stability/Measures.h"
#include "stability/cases/Cases.h"

#include <array>
#include <cmath>

namespace limn {
namespace {

const std::array<glm::dvec3, 3> axes = {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
const char* const axisNames[] = {"x", "y", "z"};

// Opacity 0.3 per mm through a voxel of 0.5 x 2 x 3 mm; without a gradient the enhanced model takes Omin of
// it.
double singleVoxelError(const Draw& draw, ShadingModel model, const Quality& quality = {}) {
  const glm::dvec3 size(0.5, 2.0, 3.0);
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    Scene scene = rayThrough(boxOf(size, 0.5), axes[axis]);
    scene.transferFunction = constantFunction(0.3, white);
    scene.shading.model = model;
    scene.shading.opacityRange = {0.5, 1.0};
    scene.quality.preintegrated = quality.preintegrated;
    scene.quality.toleranceLevels = quality.toleranceLevels;
    const double opacity = model == ShadingModel::enhanced ? 0.5 * 0.3 : 0.3;
    const double expected = -std::expm1(size[axis] * std::log1p(-opacity));
    largest = std::max(largest, largestAlphaError(draw(scene, {1, 1}), expected));
  }
  return largest;
}

// A field that does not change along one axis, in `count` voxels that share 2 mm along it.
Scene slab(int axis, int count) {
  glm::ivec3 dims(9);
  dims[axis] = count;
  glm::dvec3 spacing(1.0);
  spacing[axis] = 2.0 / count;
  const auto volume = volumeOf(centredGrid(dims, spacing), [axis](int i, int j, int k) {
    const glm::ivec3 index(i, j, k);
    return 50.0 + 5.0 * index[(axis + 1) % 3] + 40.0 * std::sin(0.7 * index[(axis + 2) % 3]);
  });
  return wholeVolume(volume, ShadingModel::enhanced, 0.0, 130.0, {0.6, 0.64, 0.48});
}

std::vector<Finding> flatVolumes(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [what, model] : {std::pair{"a single voxel, unlit", ShadingModel::none},
                                    {"a single voxel, classic", ShadingModel::classic},
                                    {"a single voxel, enhanced", ShadingModel::enhanced}})
    findings += inEachEngine(bench, what, {1e-12, 1e-6, 1e-6},
                             "alpha along each axis against that of the voxel's own extent",
                             [model = model](const Draw& draw) { return singleVoxelError(draw, model); });
  Quality exact, controlled;
  exact.preintegrated = Preintegration::always;
  controlled.toleranceLevels = 1.0;
  for (const auto& [what, quality] : {std::pair{"a single voxel in exact steps", exact},
                                      {"a single voxel in error-controlled steps", controlled}})
    findings += inEachEngine(bench, what, {1e-12, 1e-6, 1e-6},
                             "alpha along each axis against that of the voxel's own extent",
                             [quality = quality](const Draw& draw) {
                               return singleVoxelError(draw, ShadingModel::enhanced, quality);
                             });
  for (int axis = 0; axis < 3; ++axis)
    findings +=
        inEachEngine(bench, std::string("one slice of 2 mm along ") + axisNames[axis], {1e-12, 2e-6, 2e-6},
                     "largest difference from two equal slices of 1 mm: a slice has a thickness, and no "
                     "gradient across it; floats round differently in the two",
                     [axis](const Draw& draw) {
                       return largestDifference(draw(slab(axis, 1), {24, 24}), draw(slab(axis, 2), {24, 24}));
                     });
  return findings;
}

// Values 0 and 1 at two voxels, extinction 2 s per mm: along the 1 mm between them alpha is 1 - 1/e.
double manySamplesInACell(const Draw& draw) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  scene.crop.lower.y = 0.25;
  scene.crop.upper.y = 0.75;
  scene.transferFunction = {smallUnitMm,
                            {extinctionPoint(0.0, 0.0, white), extinctionPoint(1.0, 2.0, white)}};
  scene.quality.stepVoxels = 1.0 / 1500.0;
  return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-1.0));
}

std::vector<Finding> filterWeights(Workbench& bench) {
  const double eightBits = 1.0 / 512.0;
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  std::vector<glm::vec4> places;
  for (int i = 0; i <= 1500; ++i)
    places.push_back({static_cast<float>(i) / 1500.0f - 0.5f, 0.0f, 0.0f, 0.0f});
  const auto worst = [&places](const auto& valueOf) {
    double largest = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i)
      largest = std::max(largest, finiteOrInfinite(std::abs(valueOf(i) - (places[i].x + 0.5))));
    return largest;
  };
  const auto inCpp = [&](std::size_t i) { return valueAt(*scene.volume, {0.0, places[i].x + 0.5, 0.0}); };
  const std::string what = "1500 places between two voxels";
  std::vector<Finding> findings = {
      atMost("cpp", what, worst(inCpp), 1e-12, "largest distance from the straight line between the voxels"),
      withOpenGl(bench, "glsl", what, [&] {
        const std::vector<glm::vec4> values =
            GlslEvaluator({"volume.glsl"})("scalarAt(toTexture(vec3(0.0, v.x, 0.0)))", places, scene);
        return atMost("glsl", what, worst([&](std::size_t i) { return double(values[i].r); }), eightBits,
                      "largest distance from the straight line: graphics cards round the weights to 8 bits, "
                      "half of one is 1/512");
      })};
  findings += inEachEngine(
      bench, "1500 samples between two voxels", {1e-8, 2e-6 + eightBits, 2e-6 + 1500.0 * 0x1p-22 + eightBits},
      "alpha against 1 - 1/e; weights of 8 bits are worth 1/512 at most, of 1500 slices each rounds by up to "
      "2^-22; extinction over 1e-9 mm is linear in the value to 1e-9",
      manySamplesInACell);
  return findings;
}

// f = xyz in bytes along the diagonal between opposite voxels: s = t³ over √3 mm, extinction 6 s.
std::vector<Finding> bytes(Workbench& bench) {
  return inEachEngine(
      bench, "a cell of bytes along its diagonal", {1e-7, 2e-5, 2e-5 + 3000.0 * 0x1p-22},
      "alpha against 1 - exp(-6 √3 / 4): 256 levels of filtered bytes would be off by 3e-4; of 3000 slices "
      "each rounds by up to 2^-22",
      [](const Draw& draw) {
        const Grid grid = centredGrid(glm::ivec3(2), glm::dvec3(1.0));
        const std::vector<std::uint8_t> voxels{0, 0, 0, 0, 0, 0, 0, 255};
        Scene scene =
            rayThrough(std::make_shared<const Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{}),
                       glm::normalize(glm::dvec3(1.0)));
        scene.crop = {glm::dvec3(0.25), glm::dvec3(0.75)};
        scene.transferFunction = {smallUnitMm,
                                  {extinctionPoint(0.0, 0.0, white), extinctionPoint(255.0, 6.0, white)}};
        scene.quality.stepVoxels = std::sqrt(3.0) / 3000.0;
        return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-6.0 * std::sqrt(3.0) / 4.0));
      });
}

} // namespace

std::vector<HardCase> volumeShapeCases() {
  return {
      {"H21", "Volumes of one voxel or one slice have a thickness and no gradient across it", flatVolumes},
      {"H29", "Many samples between two voxels follow the straight line between them", filterWeights},
      {"H30", "Volumes of bytes are interpolated in more than 256 levels", bytes}};
}

} // namespace limn
