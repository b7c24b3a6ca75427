// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/programs/GlslEvaluator.h"
#include "scene/basics/StableMath.h"
#include "scene/light/Gradient.h"
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace limn {
namespace {

const std::array<glm::dvec3, 3> gradientAxes = {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0),
                                                glm::dvec3(0, 0, 1)};
const char* const gradientAxisNames[] = {"x", "y", "z"};

std::vector<glm::dvec3> directions(int count) {
  std::mt19937 generator(28);
  const auto coordinate = [&] { return 2.0 * generator() / 4294967295.0 - 1.0; };
  std::vector<glm::dvec3> drawn;
  while (static_cast<int>(drawn.size()) < count) {
    const glm::dvec3 v(coordinate(), coordinate(), coordinate());
    if (glm::length(v) > 0.1 && glm::length(v) < 1.0)
      drawn.push_back(glm::normalize(v));
  }
  return drawn;
}

// Values that rise by 1 per mm along `direction`: every gradient is that unit vector, at the border too.
std::shared_ptr<const Volume> rampAlong(const glm::dvec3& direction, const glm::ivec3& dims,
                                        const glm::dvec3& spacingMm) {
  const Grid grid = centredGrid(dims, spacingMm);
  return volumeOf(grid, [&](int i, int j, int k) {
    return glm::dot(direction, indexToWorld(grid, {i, j, k}));
  });
}

// The normal of a pixel without the signs of its components: what diffuse light along each axis shows of
// white material, on both sides.
glm::dvec3 drawnNormal(const Draw& draw, Scene scene) {
  scene.transferFunction = constantFunction(0.5, white);
  scene.shading.model = ShadingModel::classic;
  scene.shading.ambient = scene.shading.specular = 0.0;
  scene.shading.diffuse = scene.shading.lightIntensity = 1.0;
  scene.shading.twoSided = true;
  glm::dvec3 normal;
  for (int axis = 0; axis < 3; ++axis) {
    scene.shading.lightDirection = gradientAxes[axis];
    const glm::dvec4 pixel = draw(scene, {1, 1}).at(0, 0);
    normal[axis] = pixel.r / pixel.a;
  }
  return normal;
}

double largestNormalError(const Draw& draw, const glm::dvec3& spacingMm) {
  double largest = 0.0;
  for (const glm::dvec3& direction : directions(16)) {
    const Scene scene = rayThrough(rampAlong(direction, glm::ivec3(4), spacingMm));
    largest =
        std::max(largest, finiteOrInfinite(glm::length(drawnNormal(draw, scene) - glm::abs(direction))));
  }
  return largest;
}

double degreesOf(double chord) {
  return 2.0 * std::asin(std::min(0.5 * chord, 1.0)) * 180.0 / std::numbers::pi;
}

// 64 x 64 x 32 voxels of 0.3 x 0.3 x 5 mm with extinction 0.02 per mm.
std::vector<Finding> longVoxels(Workbench& bench) {
  const auto volume = volumeOf(centredGrid({64, 64, 32}, {0.3, 0.3, 5.0}), [](int, int, int) { return 1.0; });
  std::vector<Finding> findings;
  for (int axis = 0; axis < 3; ++axis)
    findings += inEachEngine(
        bench, std::string("through voxels of 0.3 x 0.3 x 5 mm along ") + gradientAxisNames[axis],
        {1e-12, 1e-5, 1e-5 + 1067.0 * 0x1p-22},
        "alpha against 1 - exp(-0.02 · length in mm); of up to 1067 slices each rounds by up to 2^-22",
        [&, axis](const Draw& draw) {
          Scene scene = rayThrough(volume, gradientAxes[axis]);
          scene.transferFunction = constantFunction(-std::expm1(-0.02), white);
          return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-0.02 * boxSizeMm(volume->grid())[axis]));
        });
  findings +=
      inEachEngine(bench, "normals of ramps in voxels of 0.3 x 0.3 x 5 mm", {1e-12, 1e-5, 1e-5},
                   "largest error of a normal of unit length; without spacing it would be 50 degrees off",
                   [](const Draw& draw) {
                     return largestNormalError(draw, {0.3, 0.3, 5.0});
                   });
  return findings;
}

// A ramp of 1 per mm and gref = 2 per mm: r = 1/2 everywhere, so that opacity 1/2 becomes 1/4 over each of
// 6 mm, in the outermost half voxels too.
double borderError(const Draw& draw, const glm::dvec3& direction) {
  Scene scene = rayThrough(rampAlong(direction, glm::ivec3(6), glm::dvec3(1.0)));
  scene.camera.heightMm = 6.0;
  scene.transferFunction = constantFunction(0.5, white);
  scene.shading.model = ShadingModel::enhanced;
  scene.shading.opacityRange = {0.0, 1.0};
  scene.shading.gradientReference = FixedReference{2.0};
  return largestAlphaError(draw(scene, {24, 24}), -std::expm1(6.0 * std::log1p(-0.25)));
}

std::vector<Finding> borders(Workbench& bench) {
  double worst = 0.0;
  for (const glm::dvec3& direction : directions(4)) {
    const auto volume = rampAlong(direction, {5, 4, 3}, {0.5, 1.0, 2.0});
    for (double x = -0.5; x <= 4.5; x += 0.25)
      for (double y = -0.5; y <= 3.5; y += 0.25)
        for (double z = -0.5; z <= 2.5; z += 0.25)
          worst = std::max(worst, finiteOrInfinite(glm::length(gradientAt(*volume, {x, y, z}) - direction)));
  }
  std::vector<Finding> findings = {
      atMost("cpp", "gradients of ramps up to the faces", worst, 1e-12,
             "largest error of a gradient of length 1; clamped edges would halve it")};
  for (const auto& [what, direction] : {std::pair{"a ramp along the view", gradientAxes[1]},
                                        {"a ramp across the view", gradientAxes[0]},
                                        {"an oblique ramp", glm::dvec3(0.6, 0.48, -0.64)}})
    findings +=
        inEachEngine(bench, what, {1e-12, 1e-5, 1e-5},
                     "alpha, which follows the gradient, against 1 - 0.75^6 in every pixel",
                     [direction = direction](const Draw& draw) { return borderError(draw, direction); });
  return findings;
}

// f = |x|²: central differences are exact and linear, so the normal is the direction from the centre.
double ballNormalError() {
  const auto volume = volumeOf(centredGrid(glm::ivec3(24), glm::dvec3(1.0)), [](int i, int j, int k) {
    const glm::dvec3 p = glm::dvec3(i, j, k) - 11.5;
    return glm::dot(p, p);
  });
  Scene scene = wholeVolume(volume, ShadingModel::classic, 0.0, 100.0);
  std::vector<glm::vec4> places;
  for (const glm::dvec3& direction : directions(256))
    for (const double radius : {1.0, 4.3, 9.0})
      places.push_back(glm::vec4(glm::vec3(radius * direction), 0.0f));
  const std::vector<glm::vec4> normals =
      GlslEvaluator({"stable_math.glsl", "driver_weights.glsl", "volume.glsl", "gradient.glsl"})(
          "safeNormal(gradientAt(toTexture(v.xyz)))", places, scene);
  double largest = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec3 expected = glm::normalize(glm::dvec3(places[i]));
    largest = std::max(largest, finiteOrInfinite(glm::length(glm::dvec3(normals[i]) - expected)));
  }
  return degreesOf(largest);
}

std::vector<Finding> storedGradients(Workbench& bench) {
  const auto degrees = [](const Draw& draw) { return degreesOf(largestNormalError(draw, glm::dvec3(1.0))); };
  const std::string reason = "largest angle between a ramp's normal and its direction, degrees";
  std::vector<Finding> findings = inEachEngine(bench, "normals of ramps", {0.1, 0.1, 0.1}, reason, degrees);
  findings.push_back(withOpenGl(bench, "glsl", "normals around a point", [] {
    return atMost("glsl", "normals around a point", ballNormalError(), 0.1,
                  "largest angle between the normal of |x|² and the direction of x, degrees");
  }));
  Decisions decisions;
  decisions.gradients = GradientFormat::halves;
  findings.push_back(
      takenOtherwise(bench, decisions, "normals stored in half floats, measured only", 0.1, reason, degrees));
  decisions.gradients = GradientFormat::directions;
  findings.push_back(
      takenOtherwise(bench, decisions, "normals stored in bytes, measured only", 0.6, reason, degrees));
  return findings;
}

// O = 1/2 on opacity 0.9 over 4 unit distances: 1 - (1 - 0.45)^4, whatever the step.
std::vector<Finding> opacityCoefficient(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [what, step] : {std::pair{"steps of 2 unit distances", 2.0},
                                   {"steps of 1", 1.0},
                                   {"steps of 1/2", 0.5},
                                   {"steps of 1/4", 0.25},
                                   {"steps of 1/16", 0.0625}})
    findings +=
        inEachEngine(bench, what, {1e-12, 1e-6, 1e-6 + 4.0 / step * 0x1p-22},
                     "alpha against 1 - (1 - 0.5 · 0.9)^4: O changes the opacity before it is corrected for "
                     "the step; each slice rounds by up to 2^-22",
                     [step = step](const Draw& draw) {
                       Scene scene = rayThrough(boxOf(glm::dvec3(4.0)));
                       scene.transferFunction = constantFunction(0.9, white);
                       scene.shading.model = ShadingModel::enhanced;
                       scene.shading.opacityRange = {0.5, 0.5};
                       scene.quality.stepVoxels = step / 4.0;
                       return largestAlphaError(draw(scene, {1, 1}), -std::expm1(4.0 * std::log1p(-0.45)));
                     });
  return findings;
}

} // namespace

std::vector<HardCase> gradientCases() {
  return {{"H22", "Voxels much longer than wide keep lengths and normals in millimetres", longVoxels},
          {"H23", "Gradients at the border are as long as inside", borders},
          {"H28", "Normals point where the analytic ones point", storedGradients},
          {"H33", "The gradient's share of the opacity does not depend on the step", opacityCoefficient}};
}

} // namespace limn
