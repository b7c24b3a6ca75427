// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/RayFrame.h"
#include "stability/Measures.h"
#include "stability/cases/Cases.h"

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

} // namespace

std::vector<HardCase> stepCases() {
  return {{"H6", "Tiny steps lose nothing, and their number is limited and said", tinySteps},
          {"H7", "Steps as long as the volume and longer still cover it exactly", hugeSteps},
          {"H8", "Thousands of samples neither drift nor add up roundings", longSums}};
}

std::vector<HardCase> rayCases() {
  return {{"H9", "Rays that lie in a face are lit once of two faces, without holes", raysInFaces},
          {"H10", "The camera moves through the box without a jump", eyeInside},
          {"H14", "No near or far plane cuts the picture", nearAndFar}};
}

} // namespace limn
