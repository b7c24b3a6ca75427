// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/Measures.h"
#include "stability/cases/Cases.h"

#include <cmath>

namespace limn {
namespace {

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

std::vector<HardCase> rayCases() {
  return {{"H9", "Rays that lie in a face are lit once of two faces, without holes", raysInFaces},
          {"H10", "The camera moves through the box without a jump", eyeInside},
          {"H14", "No near or far plane cuts the picture", nearAndFar}};
}

} // namespace limn
