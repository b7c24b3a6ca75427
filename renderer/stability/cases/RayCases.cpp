// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/RayFrame.h"
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace limn {
namespace {

constexpr double slabMm = 2.0;
constexpr double slabExtinction = 0.5; // per mm: alpha is 1 - 1/e over the slab

Scene slab(double samples) {
  Scene scene = rayThrough(boxOf(glm::dvec3(slabMm)));
  scene.transferFunction = constantFunction(-std::expm1(-slabExtinction), glm::dvec3(1.0));
  scene.quality.stepVoxels = stepFor(scene, slabMm, samples);
  return scene;
}

double slabError(const Draw& draw, double samples) {
  return largestAlphaError(draw(slab(samples), {1, 1}), -std::expm1(-slabExtinction * slabMm));
}

// Slices blend a layer each, and each rounds by up to 2⁻²².
Bounds boundsFor(double samples, double gl) {
  return {1e-12, gl, gl + samples / 4194304.0};
}

const char* const slabReason =
    "alpha of a homogeneous slab against 1 - 1/e, whatever the number of steps; floats round each step";

std::vector<Finding> tinySteps(Workbench& bench) {
  std::vector<Finding> findings = inEachEngine(bench, "60000 steps", boundsFor(60000, 2e-6), slabReason,
                                               [](const Draw& draw) { return slabError(draw, 60000); });
  findings += inEachEngine(bench, "a million steps asked for", boundsFor(60000, 2e-6), slabReason,
                           [](const Draw& draw) { return slabError(draw, 1e6); });
  const std::string taken = "a million steps asked for: how many are taken";
  findings.push_back(withOpenGl(bench, "gl", taken, [&] {
    return atMost("gl", taken, bench.rays().sampleCounts(slab(1e6), {1, 1}).at(0), mostSamples,
                  "drivers end loops at 65535 without a word, so no ray takes more than 60000");
  }));
  const std::string said = "a million steps asked for: it is said";
  findings.push_back(withOpenGl(bench, "gl", said, [&] {
    bench.rays().render(slab(1e6), {1, 1});
    return atMost("gl", said, bench.rays().limitation().empty() ? 1.0 : 0.0, 0.0,
                  "1 where the picture does not say that its step was limited");
  }));
  return findings;
}

std::vector<Finding> hugeSteps(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [name, share] : {std::pair{"steps of a tenth of the slab", 0.1},
                                    {"steps of  the slab", 1.0},
                                    {"steps of ten times the slab", 10.0},
                                    {"steps of a million times the slab", 1e6}})
    findings += inEachEngine(bench, name, {1e-12, 1e-6, 1e-6}, slabReason,
                             [share = share](const Draw& draw) { return slabError(draw, 1.0 / share); });
  return findings;
}

std::vector<Finding> longSums(Workbench& bench) {
  std::vector<Finding> findings;
  for (const int samples : {1000, 9999})
    findings += inEachEngine(bench, std::to_string(samples) + " steps", boundsFor(samples, 2e-6), slabReason,
                             [samples](const Draw& draw) { return slabError(draw, samples); });
  // A step at the middle of a ramp shows where samples lie: an alpha off by one sample's share.
  findings += inEngines(
      bench, {Engine::reference, Engine::rayCaster, Engine::cpu}, "9999 positions on a ramp with a step",
      {1e-12, 2e-4, 0.0},
      "alpha of the half beyond the step; positions that add up roundings would be off by samples, of which "
      "each is worth 1e-4",
      [](const Draw& draw) {
        Scene scene = rayThrough(columnOf({0.0, 1.0, 2.0, 3.0}, 1.0));
        scene.transferFunction = {1.0, {{1.5, glm::dvec3(1.0), 0.0}, {1.5, glm::dvec3(1.0), 0.5}}};
        scene.quality.stepVoxels = stepFor(scene, 4.0, 9999.0);
        // The sample in the middle lies on the step, to which the upper side belongs.
        return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-5000.0 / 9999.0 * 4.0 * std::log(2.0)));
      });
  return findings;
}

// A box of 8 mm seen by 16 x 16 pixels of 1 mm whose centres lie on whole millimetres, so in its faces.
Scene inFaces(const glm::dvec3& direction) {
  const auto volume =
      volumeOf(centredGrid(glm::ivec3(8), glm::dvec3(1.0)), [](int, int, int) { return 100.0; });
  Scene scene = rayThrough(volume, direction);
  scene.camera.heightMm = 16.0;
  const CameraBasis basis = basisOf(scene.camera);
  scene.camera.position += 0.5 * (basis.right + basis.up);
  scene.camera.target += 0.5 * (basis.right + basis.up);
  scene.transferFunction = constantFunction(0.5, glm::dvec3(1.0));
  return scene;
}

std::vector<Finding> raysInFaces(Workbench& bench) {
  const double alpha = 1.0 - std::exp2(-8.0);
  return inEachEngine(bench, "along each axis, both ways", {},
                      "pixels that are neither empty nor have the box's alpha to 1e-6, or are more or less "
                      "than the 64 that a half-open box of 8 by 8 lights",
                      [alpha](const Draw& draw) {
                        int wrong = 0;
                        for (const glm::dvec3& axis : axisDirections) {
                          int lit = 0;
                          for (const glm::dvec4& pixel : draw(inFaces(axis), {16, 16}).pixels) {
                            lit += pixel.a > 0.0;
                            wrong += !(pixel.a == 0.0 || std::abs(pixel.a - alpha) <= 1e-6);
                          }
                          wrong += std::abs(lit - 64);
                        }
                        return wrong;
                      });
}

// A box of 2 mm with extinction ln 2 per mm: alpha is 1 - 2^-(what is left of it in front of the eye).
double walkThroughBox(const Draw& draw, double side) {
  Scene scene = rayThrough(boxOf(glm::dvec3(2.0)));
  scene.camera.projection = Camera::Projection::perspective;
  scene.transferFunction = constantFunction(0.5, glm::dvec3(1.0));
  scene.quality.stepVoxels = 0.05;
  double worst = 0.0;
  const auto look = [&](double y) {
    scene.camera.position = {side, y, side};
    scene.camera.target = {side, y + 1.0, side};
    const double path = std::clamp(1.0 - y, 0.0, 2.0);
    worst = std::max(worst, largestAlphaError(draw(scene, {1, 1}), 1.0 - std::exp2(-path)));
  };
  for (double y = -1.2; y < 1.2; y += 0.02)
    look(y);
  for (double y = -0.01; y <= 0.01; y += 0.001) {
    look(-1.0 + y);
    look(1.0 + y);
  }
  return worst;
}

std::vector<Finding> eyeInside(Workbench& bench) {
  std::vector<Finding> findings;
  for (const double side : {0.0, -1.0, 1.0 - 1e-6, 1.0 / 3.0})
    findings += inEachEngine(
        bench, "through the box at a side of " + std::to_string(side).substr(0, 6) + " of half its width",
        {1e-12, 2e-6, 2e-5},
        "alpha against the path left in front of the eye; a rounding of float per step, per slice 2^-22",
        [side](const Draw& draw) { return walkThroughBox(draw, side); });
  findings += inEachEngine(bench, "standing on a corner, looking at the opposite one", {1e-12, 2e-6, 2e-5},
                           "alpha of the diagonal", [](const Draw& draw) {
                             Scene scene = rayThrough(boxOf(glm::dvec3(2.0)));
                             scene.camera.projection = Camera::Projection::perspective;
                             scene.camera.position = glm::dvec3(-1.0);
                             scene.camera.target = glm::dvec3(1.0);
                             scene.transferFunction = constantFunction(0.5, glm::dvec3(1.0));
                             scene.quality.stepVoxels = 0.05;
                             return largestAlphaError(draw(scene, {1, 1}), 1.0 - std::exp2(-std::sqrt(12.0)));
                           });
  return findings;
}

// Rays have no near and no far plane; eyes next to a face and extreme fields of view show whether one hides.
std::vector<Finding> nearAndFar(Workbench& bench) {
  std::vector<Finding> findings;
  findings += inEachEngine(bench, "the eye 1e-9 mm in front of a face", {1e-8, 2e-6, 2e-5},
                           "alpha of the middle pixel against that of the whole box", [](const Draw& draw) {
                             Scene scene = rayThrough(boxOf(glm::dvec3(2.0)));
                             scene.camera.projection = Camera::Projection::perspective;
                             scene.camera.position = {0.0, -1.0 - 1e-9, 0.0};
                             scene.camera.target = {0.0, 0.0, 0.0};
                             scene.transferFunction = constantFunction(0.5, glm::dvec3(1.0));
                             return largestAlphaError(draw(scene, {1, 1}), 0.75);
                           });
  for (const auto& [name, fov] : {std::pair{"1e-4", 1e-4}, {"1", 1.0}, {"120", 120.0}, {"179", 179.0}})
    findings += inEachEngine(bench, "a field of view of " + std::string(name) + " degrees", {},
                             "pixels that are not finite or outside 0..1, or a picture without any",
                             [fov = fov](const Draw& draw) {
                               Scene scene = wholeVolume(smoothVolume(8), ShadingModel::classic, 0.0, 100.0);
                               scene.camera.projection = Camera::Projection::perspective;
                               scene.camera.fovYDeg = fov;
                               const DrawnPicture picture = draw(scene, {25, 25}); // one sees the middle
                               return unsoundPixels(picture) + (visiblePixels(picture) == 0 ? 1 : 0);
                             });
  return findings;
}

std::vector<Camera> degenerateCameras() {
  std::vector<Camera> cameras;
  for (const glm::dvec3& direction : axisDirections)
    for (const glm::dvec3& up : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1), direction,
                                 -direction, direction + glm::dvec3(1e-9, 2e-9, -1e-9), glm::dvec3(0.0)}) {
      Camera camera;
      camera.position = -20.0 * direction;
      camera.up = up;
      cameras.push_back(camera);
    }
  Camera coincident;
  coincident.position = coincident.target = glm::dvec3(0.0);
  cameras.push_back(coincident);
  coincident.position.x += 1e-12;
  cameras.push_back(coincident);
  return cameras;
}

std::vector<Finding> degenerateUp(Workbench& bench) {
  double worst = 0.0;
  for (const Camera& camera : degenerateCameras()) {
    const CameraBasis basis = basisOf(camera);
    const glm::dmat3 axesOfCamera(basis.right, basis.up, -basis.forward);
    worst = std::max(worst, finiteOrInfinite(std::abs(glm::determinant(axesOfCamera) - 1.0)));
    for (int i = 0; i < 3; ++i)
      worst = std::max(worst, finiteOrInfinite(std::abs(glm::length(axesOfCamera[i]) - 1.0)));
  }
  std::vector<Finding> findings = {
      atMost("cpp", "axes of the camera", worst, 1e-12, "how far lengths and determinant are from 1")};
  findings += inEachEngine(bench, "every up along every axis, eye at target", {},
                           "pictures that are empty or unsound", [](const Draw& draw) {
                             Scene scene = wholeVolume(smoothVolume(8), ShadingModel::classic, 0.0, 100.0);
                             int wrong = 0;
                             for (const Camera& camera : degenerateCameras()) {
                               scene.camera = camera;
                               const DrawnPicture picture = draw(scene, {16, 16});
                               wrong += unsoundPixels(picture) > 0 || visiblePixels(picture) == 0;
                             }
                             return wrong;
                           });
  return findings;
}

std::vector<Finding> farCamera(Workbench& bench) {
  std::vector<Finding> findings;
  for (const double times : {1e3, 1e6})
    findings +=
        inEachEngine(bench, times < 1e4 ? "from 1000 diagonals" : "from a million diagonals",
                     {1.0 / 255.0, 1.0 / 255.0, 1.0 / 255.0},
                     "largest difference from the orthographic picture; its rays are parallel to 1/2000 over "
                     "the box, one level is the bound",
                     [times](const Draw& draw) {
                       Scene scene = wholeVolume(smoothVolume(16), ShadingModel::none, 0.0, 100.0);
                       scene.quality.stepVoxels = 0.25;
                       const DrawnPicture orthographic = draw(scene, {32, 32});
                       const double diagonal = scene.camera.heightMm;
                       scene.camera.projection = Camera::Projection::perspective;
                       scene.camera.position = scene.camera.target - glm::dvec3(0.0, times * diagonal, 0.0);
                       scene.camera.fovYDeg = 2.0 * std::atan(0.5 / times) * 180.0 / glm::pi<double>();
                       return largestDifference(draw(scene, {32, 32}), orthographic);
                     });
  return findings;
}

// The same voxels with everything that has a length multiplied, seen from a camera moved alike.
Scene inWorldOf(double scale, double offset) {
  Scene scene = wholeVolume(smoothVolume(12), ShadingModel::enhanced, 0.0, 100.0, {0.6, 0.64, 0.48});
  Grid grid = scene.volume->grid();
  grid.spacingMm *= scale;
  grid.originMm = grid.originMm * scale + offset;
  scene.volume =
      std::make_shared<const Volume>(grid, scene.volume->stored(), Rescale{}, std::nullopt, VolumeInfo{});
  scene.camera.position = scene.camera.position * scale + offset;
  scene.camera.target = scene.camera.target * scale + offset;
  scene.camera.heightMm *= scale;
  scene.transferFunction.unitDistanceMm *= scale;
  return scene;
}

std::vector<Finding> hugeWorlds(Workbench& bench) {
  struct World {
    const char* name;
    double scale, offset;
    Bounds bounds;
  };
  const Bounds toTheBit{};
  const Bounds rounding{1e-6, 1e-6, 1e-6};
  const World worlds[] = {{"spacing 2^-20 mm", 0x1p-20, 0.0, toTheBit},
                          {"spacing 2^20 mm", 0x1p20, 0.0, toTheBit},
                          {"spacing 1e-6 mm", 1e-6, 0.0, rounding},
                          {"spacing 1e6 mm", 1e6, 0.0, rounding},
                          {"8388608 mm from the origin", 1.0, 0x1p23, rounding}};
  std::vector<Finding> findings;
  for (const World& world : worlds)
    findings += inEachEngine(bench, world.name, world.bounds,
                             "largest difference from spacing 1 at the origin: to the bit for powers of two, "
                             "otherwise roundings of double",
                             [&world](const Draw& draw) {
                               return largestDifference(draw(inWorldOf(world.scale, world.offset), {32, 32}),
                                                        draw(inWorldOf(1.0, 0.0), {32, 32}));
                             });
  return findings;
}

// The value runs from 0 to 1 over 1 mm in 16 steps, alike in all 8 x 8 pixels; extinction k s per mm. Samples
// at the part u of their steps have the depth k/2 + k h (u - 1/2).
constexpr double slope = 8.0;
constexpr double stepLength = 1.0 / 16.0;

Scene ramp(bool isJittered) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  scene.crop.lower.y = 0.25;
  scene.crop.upper.y = 0.75;
  scene.transferFunction = {smallUnitMm,
                            {extinctionPoint(0.0, 0.0, white), extinctionPoint(1.0, slope, white)}};
  scene.quality.stepVoxels = stepLength;
  scene.quality.jitter = isJittered;
  return scene;
}

double meanAlpha(const DrawnPicture& picture) {
  double sum = 0.0;
  for (const glm::dvec4& pixel : picture.pixels)
    sum += pixel.a;
  return sum / static_cast<double>(picture.pixels.size());
}

std::vector<Finding> jitter(Workbench& bench) {
  const double halfStep = 0.5 * slope * stepLength;
  const double middle = std::exp(-0.5 * slope);
  std::vector<Finding> findings =
      inEachEngine(bench, "switched off", {},
                   "difference of two pictures with another drawn between them: none", [](const Draw& draw) {
                     Scene scene = wholeVolume(smoothVolume(12), ShadingModel::classic, 0.0, 100.0);
                     const DrawnPicture first = draw(scene, {24, 24});
                     scene.quality.jitter = true;
                     draw(scene, {24, 24});
                     scene.quality.jitter = false;
                     return largestDifference(first, draw(scene, {24, 24}));
                   });
  const double bias = middle * (std::sinh(halfStep) / halfStep - 1.0) + 2e-6;
  findings += inEachEngine(bench, "mean of the jittered pixels", {bias, bias, bias},
                           "distance from the exact alpha 1 - exp(-k/2): e^-x over a step exceeds its middle "
                           "by the factor sinh(w)/w, w = k h/2, whatever the number of pixels",
                           [middle](const Draw& draw) {
                             return std::abs(meanAlpha(draw(ramp(true), {8, 8})) - (1.0 - middle));
                           });
  const double noise = middle * std::expm1(halfStep) + 2e-6;
  findings += inEachEngine(bench, "each jittered pixel", {noise, noise, noise},
                           "largest distance from the exact alpha: half a step of the steepest place",
                           [middle](const Draw& draw) {
                             return largestAlphaError(draw(ramp(true), {8, 8}), 1.0 - middle);
                           });
  return findings;
}

Scene opaqueScene(double earlyTermination) {
  Scene scene = wholeVolume(smoothVolume(16), ShadingModel::classic, 0.0, 100.0, {0.6, 0.64, 0.48});
  scene.transferFunction.unitDistanceMm = 1.0;
  scene.quality.earlyTermination = earlyTermination;
  return scene;
}

std::vector<Finding> earlyTermination(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [what, e] : {std::pair{"ending at 0.5", 0.5},
                                {"ending at 0.98, the paper's", 0.98},
                                {"ending at 1 - 1/255", 1.0 - 1.0 / 255.0},
                                {"ending at 0.998, the program's", 0.998}}) {
    // What is left of the light where a ray ends, and what floats round of the rest.
    const double left = lastTransmittance(e) + 1e-6;
    findings += inEachEngine(
        bench, what, {left, left, 0.0},
        "largest difference from rays that never end: at most what was left of the light; slices never end "
        "and must not differ at all",
        [e = e](const Draw& draw) {
          return largestDifference(draw(opaqueScene(e), {32, 32}), draw(opaqueScene(1.0), {32, 32}));
        });
  }
  for (const auto& [what, projection] : {std::pair{"an X-ray", Projection::xray},
                                         {"a maximum", Projection::mip},
                                         {"a minimum", Projection::minip},
                                         {"an average", Projection::average}})
    findings += inEachEngine(bench, what, {},
                             "largest difference that ending at 0.5 makes: none, every sample counts",
                             [projection = projection](const Draw& draw) {
                               const auto at = [&](double e) {
                                 Scene scene = opaqueScene(e);
                                 scene.projection = projection;
                                 return draw(scene, {32, 32});
                               };
                               return largestDifference(at(0.5), at(1.0));
                             });
  return findings;
}

} // namespace

std::vector<HardCase> rayCases() {
  return {{"H6", "Tiny steps lose nothing, and their number is limited and said", tinySteps},
          {"H7", "Steps as long as the volume and longer still cover it exactly", hugeSteps},
          {"H8", "Thousands of samples neither drift nor add up roundings", longSums},
          {"H9", "Rays that lie in a face are lit once of two faces, without holes", raysInFaces},
          {"H10", "The camera moves through the box without a jump", eyeInside},
          {"H14", "No near or far plane cuts the picture", nearAndFar},
          {"H11", "Degenerate cameras still have axes and a picture", degenerateUp},
          {"H12", "Far cameras with tiny fields of view see the orthographic picture", farCamera},
          {"H13", "Neither the unit of length nor a far origin changes the picture", hugeWorlds},
          {"H31", "Jitter is off without a trace, and on it only spreads the error of a step", jitter},
          {"H32", "Rays that end early lose no more than what was left of the light", earlyTermination}};
}

} // namespace limn
