// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/programs/GlslEvaluator.h"
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"

#include <array>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr double opacityPerMm = 0.3; // over a millimetre

// A column of 1 mm voxels along y, everywhere of one opacity, a label and a weight for each.
Scene columnOfWeights(const std::vector<double>& weights) {
  Scene scene = rayThrough(columnOf(std::vector<double>(weights.size(), 1.0), 1.0));
  scene.transferFunction = constantFunction(opacityPerMm, white);
  const glm::ivec3& dims = scene.volume->grid().dims;
  std::vector<Label> labels;
  std::vector<std::uint8_t> places;
  for (int y = 0; y < dims.y; ++y) {
    labels.push_back({y, "Voxel", white});
    places.push_back(static_cast<std::uint8_t>(y));
  }
  scene.keep = {Region::Kind::labels, "", std::make_shared<const LabelMap>(dims, places, labels), weights};
  scene.quality.stepVoxels = 1.0 / 64.0;
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

// ∫ -ln(1 - a w) dw over w in 0..1: the depth of the millimetre over which a weight rises from 0 to 1.
double rampDepth() {
  return ((1.0 - opacityPerMm) * std::log1p(-opacityPerMm) + opacityPerMm) / opacityPerMm;
}

// Midpoints of 1/64 mm err by at most κ''/24 h² a millimetre of a ramp, κ'' = (a/(1-a))²; renderers that keep
// 16 bits of a weight by up to 8 of its last places.
std::vector<Finding> shapesOf(Workbench& bench) {
  struct Case {
    const char* what;
    std::vector<double> weights;
    double depth;
  };
  const double full = -std::log1p(-opacityPerMm);
  const Case cases[] = {
      {"all hidden", {0, 0, 0, 0, 0}, 0.0},
      {"every weight a half", {0.5, 0.5, 0.5, 0.5, 0.5}, -5.0 * std::log1p(-0.5 * opacityPerMm)},
      {"one voxel kept", {0, 0, 1, 0, 0}, 2.0 * rampDepth()},
      {"one voxel hidden", {1, 1, 0, 1, 1}, 3.0 * full + 2.0 * rampDepth()},
      {"kept at the border", {1, 0, 0, 0, 0}, 0.5 * full + rampDepth()},
      {"taking turns", {1, 0, 1, 0, 1}, full + 4.0 * rampDepth()},
      {"a volume of one voxel, hidden", {0}, 0.0},
      {"a volume of one voxel, faded", {0.25}, -std::log1p(-0.25 * opacityPerMm)},
  };
  std::vector<Finding> findings;
  for (const Case& one : cases)
    findings += inEachEngine(
        bench, one.what, {1e-5, 3e-5, 3e-5}, "alpha against that of the weights' integral",
        [&](const Draw& draw) {
          return largestAlphaError(draw(columnOfWeights(one.weights), {1, 1}), -std::expm1(-one.depth));
        });
  return findings;
}

constexpr int regionEdge = 32;
constexpr glm::ivec3 spoilt{13, 17, 20};

// Along y with a pixel per voxel: pixel (x, y) sees the column i = x, k = regionEdge - 1 - y.
Scene alongY(std::shared_ptr<const Volume> volume) {
  Scene scene = wholeVolume(std::move(volume), ShadingModel::enhanced, 0.0, 100.0);
  scene.camera.heightMm = regionEdge;
  scene.shading.gradientReference = FixedReference{10.0}; // else the voxel could change every pixel's r
  return scene;
}

double besideSpoiltVoxel(const Draw& draw, float value) {
  const auto clean = smoothVolume(regionEdge);
  std::vector<float> voxels;
  for (const double v : std::get<StoredVoxels<double>>(clean->stored()))
    voxels.push_back(static_cast<float>(v));
  const auto volumeOfFloats = [&] {
    return std::make_shared<const Volume>(clean->grid(), voxels, Rescale{}, std::nullopt, VolumeInfo{});
  };
  const DrawnPicture expected = draw(alongY(volumeOfFloats()), glm::ivec2(regionEdge));
  voxels[voxelOffset(clean->grid().dims, spoilt.x, spoilt.y, spoilt.z)] = value;
  const DrawnPicture picture = draw(alongY(volumeOfFloats()), glm::ivec2(regionEdge));
  return std::max<double>(unsoundPixels(picture), differenceBeside(spoilt, picture, expected));
}

std::vector<Finding> notNumbers(Workbench& bench) {
  const float infinity = std::numeric_limits<float>::infinity();
  std::vector<Finding> findings;
  for (const auto& [name, value] : {std::pair{"one voxel is NaN", std::numeric_limits<float>::quiet_NaN()},
                                    {"one voxel is +Inf", infinity},
                                    {"one voxel is -Inf", -infinity}})
    findings += inEachEngine(bench, name, {},
                             "largest difference of pixels two voxels away from the clean picture, or pixels "
                             "that are unsound: the voxel takes the smallest valid value on loading",
                             [value = value](const Draw& draw) { return besideSpoiltVoxel(draw, value); });
  return findings;
}

// The picture of a volume times `scale` against that of the volume itself.
double scaledDifference(const Draw& draw, double scale) {
  const auto at = [&](double s) {
    return draw(wholeVolume(smoothVolume(12, s), ShadingModel::enhanced, 0.0, 100.0 * s), {24, 24});
  };
  return largestDifference(at(1.0), at(scale));
}

const char* const scaledReason = "largest difference from the unscaled picture: to the bit for powers of "
                                 "two, because values are normalised in double, otherwise roundings";

std::vector<Finding> hugeValues(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [name, scale, bounds] : {std::tuple{"values times 2^100", 0x1p100, Bounds{}},
                                            {"values times 2^-100", 0x1p-100, Bounds{}},
                                            {"values times 1e30", 1e30, Bounds{1e-6, 1e-6, 1e-6}}})
    findings += inEachEngine(bench, name, bounds, scaledReason,
                             [scale = scale](const Draw& draw) { return scaledDifference(draw, scale); });
  const float largest = std::numeric_limits<float>::max();
  findings += inEachEngine(bench, "values from the most negative float to the largest", {2e-6, 2e-6, 2e-6},
                           "largest difference from a volume of -1 and 1; their range exceeds a float's",
                           [largest](const Draw& draw) {
                             const auto at = [&](double s) {
                               const auto volume = volumeOf(
                                   centredGrid(glm::ivec3(6), glm::dvec3(1.0)),
                                   [s](int i, int j, int k) { return (i + j + k) % 2 == 0 ? s : -s; });
                               return draw(wholeVolume(volume, ShadingModel::enhanced, -s, s), {24, 24});
                             };
                             return largestDifference(at(largest), at(1.0));
                           });
  return findings;
}

std::vector<Finding> denormals(Workbench& bench) {
  std::vector<Finding> findings =
      inEachEngine(bench, "denormal doubles, 0x1p-1060", {1e-3, 1e-3, 1e-3},
                   "largest difference from the unscaled picture; such numbers have 14 bits left, so values "
                   "are off by 1e-4",
                   [](const Draw& draw) { return scaledDifference(draw, 0x1p-1060); });
  findings +=
      inEachEngine(bench, "multiples of the smallest float", {},
                   "difference from the same multiples of 1: none", [](const Draw& draw) {
                     const auto at = [&](double unit) {
                       std::vector<float> voxels;
                       voxels.reserve(125);
                       for (int i = 0; i < 125; ++i)
                         voxels.push_back(static_cast<float>(unit * (i * 37 % 101)));
                       const auto volume =
                           std::make_shared<const Volume>(centredGrid(glm::ivec3(5), glm::dvec3(1.0)), voxels,
                                                          Rescale{}, std::nullopt, VolumeInfo{});
                       return draw(wholeVolume(volume, ShadingModel::enhanced, 0.0, 100.0 * unit), {24, 24});
                     };
                     return largestDifference(at(0x1p-149), at(1.0));
                   });
  return findings;
}

// Without a gradient r = 0: opacity 0.1 times Omin 0.2 over 20 unit distances, 1 - (1 - 0.02)^20.
std::vector<Finding> constantVolumes(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [name, value] :
       {std::pair{"0", 0.0}, {"1", 1.0}, {"-1024", -1024.0}, {"1e30", 1e30}, {"1e-30", 1e-30}})
    findings += inEachEngine(
        bench, "every voxel is " + std::string(name), {1e-12, 2e-6, 2e-6},
        "alpha against 1 - (1 - 0.1 · 0.2)^20 of the enhanced model", [value = value](const Draw& draw) {
          const auto volume =
              volumeOf(centredGrid(glm::ivec3(4), glm::dvec3(5.0)), [value](int, int, int) { return value; });
          Scene scene = rayThrough(volume);
          scene.transferFunction = constantFunction(0.1, glm::dvec3(1.0));
          scene.shading.model = ShadingModel::enhanced;
          scene.shading.opacityRange = {0.2, 1.0};
          return largestAlphaError(draw(scene, {1, 1}), -std::expm1(20.0 * std::log1p(-0.02)));
        });
  return findings;
}

// A ball of 300 in air of -1000, and beyond a cylinder along z either air or padding, declared as such.
std::shared_ptr<const Volume> ballInRing(std::int16_t beyond, std::optional<PaddingRange> padding) {
  const Grid grid = centredGrid(glm::ivec3(24), glm::dvec3(1.0));
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < 24; ++k)
    for (int j = 0; j < 24; ++j)
      for (int i = 0; i < 24; ++i) {
        const glm::dvec3 p = glm::dvec3(i, j, k) - 11.5;
        voxels.push_back(glm::length(p) < 7.0          ? std::int16_t(300)
                         : std::hypot(p.x, p.y) < 11.0 ? std::int16_t(-1000)
                                                       : beyond);
      }
  return std::make_shared<const Volume>(grid, voxels, Rescale{}, padding, VolumeInfo{});
}

std::vector<Finding> declaredPadding(Workbench& bench) {
  std::vector<Finding> findings;
  for (const int padding : {-32768, -3024, -2000})
    findings += inEachEngine(
        bench, "padding of " + std::to_string(padding), {},
        "largest difference from the picture with air in its place: padding takes the smallest valid value "
        "and counts neither for the range nor for gradients",
        [padding](const Draw& draw) {
          const auto picture = [&](std::shared_ptr<const Volume> volume) {
            return draw(
                wholeVolume(std::move(volume), ShadingModel::enhanced, -900.0, 300.0, {0.6, 0.64, 0.48}),
                {32, 32});
          };
          const auto value = static_cast<std::int16_t>(padding);
          return largestDifference(picture(ballInRing(value, PaddingRange{double(padding), double(padding)})),
                                   picture(ballInRing(-1000, std::nullopt)));
        });
  return findings;
}

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
        const std::vector<glm::vec4> values = GlslEvaluator({"driver_weights.glsl", "volume.glsl"})(
            "scalarAt(toTexture(vec3(0.0, v.x, 0.0)))", places, scene);
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

std::vector<HardCase> voxelCases() {
  return {
      {"H15", "A voxel that is no number harms only its neighbourhood", notNumbers},
      {"H16", "Values at the ends of float give the picture of their scaled copy", hugeValues},
      {"H17", "Denormal values are not lost", denormals},
      {"H18", "A constant volume has a range of nothing and still its closed form", constantVolumes},
      {"H19", "Padding outside a scanner's circle changes nothing", declaredPadding},
      {"H48", "Kept regions of any shape leave what their weights say", shapesOf},
      {"H21", "Volumes of one voxel or one slice have a thickness and no gradient across it", flatVolumes},
      {"H29", "Many samples between two voxels follow the straight line between them", filterWeights},
      {"H30", "Volumes of bytes are interpolated in more than 256 levels", bytes}};
}

} // namespace limn
