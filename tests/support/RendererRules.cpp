// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/RendererRules.h"

#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/AnalyticCases.h"
#include "support/AnalyticScenes.h"
#include "support/CaseLedger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace limn::test {

Scene noisyPhantom(ShadingModel model) {
  static const std::shared_ptr<const Volume> volume = phantomVolume({.spacingMm = 4.0, .noiseHu = 10.0});
  Scene scene = headScene(volume, model);
  scene.quality = Quality{};
  scene.quality.stepVoxels = 0.5;
  return scene;
}

double largestDifference(const Image& a, const Image& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 4; ++channel)
      largest = std::max<double>(largest, std::abs(a.pixels[i][channel] - b.pixels[i][channel]));
  return largest;
}

void expectClosedForms(const DrawPicture& draw) {
  const nlohmann::json cases = analyticCases();
  CaseLedger ledger;
  for (AnalyticRay& ray : analyticRays(cases)) {
    if (ray.glStepVoxels > 0.0)
      ray.scene.quality.stepVoxels = ray.glStepVoxels;
    const glm::dvec4 pixel(draw(ray.scene, ray.size).pixels[ray.pixel]);
    if (ray.alpha)
      ledger.expectNear(ray.id, ray.what + " alpha", pixel.a, *ray.alpha, ray.glTolerance);
    for (int channel = 0; ray.color && channel < 3; ++channel)
      ledger.expectNear(ray.id, ray.what + " channel " + std::to_string(channel), pixel[channel],
                        (*ray.color)[channel], ray.glTolerance);
  }
  // A grid holds every field but the curved ones, which the file marks or gives an order.
  ledger.expectEvery(cases, [](const nlohmann::json& one) {
    return isOfKind(one, "render") && one.value("grid_exact", true) &&
           !one["tolerance"].contains("order_in_voxel_size");
  });
  ledger.print();
}

void expectNoJumpThroughTheBox(const DrawPicture& draw) {
  // An extinction of ln 2 per mm.
  Scene scene = rayThrough(boxOf(glm::dvec3(2.0)));
  scene.camera.projection = Camera::Projection::perspective;
  scene.transferFunction = constantFunction(0.5, glm::dvec3(1.0));
  scene.quality.stepVoxels = 0.05;
  for (const double side : {-1.0, 0.0, 1.0 - 1e-6, 0.999, 1.0 / 3.0})
    for (double y = -1.2; y < 1.2; y += 0.05) {
      scene.camera.position = {side, y, side};
      scene.camera.target = {side, y + 1.0, side};
      const double path = std::clamp(1.0 - y, 0.0, 2.0);
      EXPECT_NEAR(draw(scene, {1, 1}).pixels[0].a, 1.0 - std::exp2(-path), 2e-6)
          << "at " << side << ", " << y;
    }
}

void expectFacesLitOnce(const DrawPicture& draw) {
  Grid grid;
  grid.dims = glm::ivec3(8);
  grid.originMm = glm::dvec3(-3.5);
  const auto volume = std::make_shared<const Volume>(grid, std::vector<std::uint8_t>(512, 100), Rescale{},
                                                     std::nullopt, VolumeInfo{});
  for (const glm::dvec3& direction : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0),
                                      glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)}) {
    Scene scene = rayThrough(volume, direction);
    scene.camera.heightMm = 16.0;
    // Shift the picture by half a pixel, so that centres fall on whole millimetres.
    const CameraBasis basis = basisOf(scene.camera);
    scene.camera.position += 0.5 * (basis.right + basis.up);
    scene.camera.target += 0.5 * (basis.right + basis.up);
    scene.transferFunction = constantFunction(0.5, glm::dvec3(1.0));
    int lit = 0;
    for (const glm::vec4& pixel : draw(scene, {16, 16}).pixels) {
      EXPECT_TRUE(pixel.a == 0.0f || std::abs(pixel.a - (1.0 - std::exp2(-8.0))) < 1e-6) << pixel.a;
      lit += pixel.a > 0.0f;
    }
    EXPECT_EQ(lit, 64);
  }
}

} // namespace limn::test
