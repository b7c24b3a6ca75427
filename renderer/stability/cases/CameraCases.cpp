// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/Measures.h"
#include "stability/cases/Cases.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace limn {
namespace {

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

} // namespace

std::vector<HardCase> cameraCases() {
  return {{"H11", "Degenerate cameras still have axes and a picture", degenerateUp},
          {"H12", "Far cameras with tiny fields of view see the orthographic picture", farCamera},
          {"H13", "Neither the unit of length nor a far origin changes the picture", hugeWorlds}};
}

} // namespace limn
