// SPDX-License-Identifier: GPL-3.0-or-later
// Lights that are chosen in one go, on pictures.
#include "cpu/CpuRenderer.h"
#include "scene/light/LightPresets.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

#include <gtest/gtest.h>

#include <iostream>
#include <optional>

namespace limn {
namespace {

// The mean of what shows, of its alpha.
double brightnessOf(const Scene& scene) {
  double sum = 0.0, alpha = 0.0;
  for (const glm::vec4& pixel : CpuRenderer().render(scene, {96, 96}).pixels) {
    sum += pixel.r + pixel.g + pixel.b;
    alpha += 3.0 * pixel.a;
  }
  return sum / alpha;
}

TEST(CpuLightPresets, keepTheBrightnessOfAHead) {
  std::optional<Shading> physical; // is the same whichever model was before, and paths take long
  double brightnessOfPhysical = 0.0;
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust}) {
    Scene scene = headScene(phantomVolume({.spacingMm = 2.0}), model);
    scene.shading.specular = 0.2; // as the built-in presets have it
    scene.shading.physical.until = UntilPaths{32};
    const double headlight = brightnessOf(scene);
    for (const LightPreset preset : lightPresets) {
      Scene lit = scene;
      lit.shading = withLight(scene.shading, preset);
      EXPECT_EQ(lightPresetOf(lit.shading), preset);
      if (preset == LightPreset::physical && !physical) {
        physical = lit.shading;
        brightnessOfPhysical = brightnessOf(lit);
      }
      const double ratio = (lit.shading == physical ? brightnessOfPhysical : brightnessOf(lit)) / headlight;
      std::cout << nameOf(model) << ", light " << static_cast<int>(preset) << ": " << ratio << "\n";
      // What heads of the shared volumes reach (LightPresets.h), and as much again.
      EXPECT_NEAR(ratio, 1.0, 0.22);
    }
  }
}

TEST(CpuLightPresets, physicalLightBringsItsModelAndTakesItAlong) {
  Shading shading;
  shading.model = ShadingModel::robust;
  shading.physical.density = 3.0; // tissue, not light
  const Shading physical = withLight(shading, LightPreset::physical);
  EXPECT_EQ(physical.model, ShadingModel::physical);
  EXPECT_EQ(physical.physical.density, 3.0);
  EXPECT_EQ(lightPresetOf(physical), LightPreset::physical);
  Shading exposed = physical;
  exposed.physical.exposureEv += 1.0;
  EXPECT_EQ(lightPresetOf(exposed), LightPreset::physical);
  exposed.physical.keyRadiusDeg = 30.0;
  EXPECT_NE(lightPresetOf(exposed), LightPreset::physical);
  // Its lamp is the studio's.
  Shading robust = physical;
  robust.model = ShadingModel::robust;
  EXPECT_EQ(lightPresetOf(robust), LightPreset::studio);
  EXPECT_EQ(withLight(physical, LightPreset::headlight).model, Shading().model);
  EXPECT_EQ(withLight(shading, LightPreset::overcast).model, ShadingModel::robust);
}

TEST(CpuLightPresets, theHeadlightIsTodaysLight) {
  EXPECT_EQ(withLight(Shading(), LightPreset::headlight), Shading());
}

} // namespace
} // namespace limn
