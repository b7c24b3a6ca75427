// SPDX-License-Identifier: GPL-3.0-or-later
// What light on its way keeps to, drawn by the CPU engine: what is cropped away dims nothing, steps change no
// strength, what is neutral changes no bit, and what a picture says of its light is so (DEFINITION section
// 11).
#include "accuracy/ImageError.h"
#include "accuracy/Tolerance.h"
#include "cpu/CpuRenderer.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/light/Shading.h"
#include "support/TravellingScenes.h"

#include <gtest/gtest.h>

#include <iostream>
#include <optional>

namespace limn {
namespace {

using test::brightness;
using test::croppedToSkull;
using test::headCutAtTheJaw;
using test::shadowedHead;
using test::skullOverJaw;
using test::withoutTravel;

constexpr LightDetail everyDetail[] = {LightDetail::sampled, LightDetail::spread, LightDetail::fine,
                                       LightDetail::coarse, LightDetail::moving};

Image pictureIn(Scene scene, LightDetail detail, const glm::ivec2& size) {
  scene.quality.light = detail;
  CpuRenderer renderer;
  return renderer.render(scene, size);
}

double errorByGrid(const Scene& scene, const glm::ivec2& size) {
  CpuRenderer renderer;
  const DrawScene draw = [&](const Scene& drawn, const glm::ivec2& pixels) {
    return renderer.render(drawn, pixels);
  };
  return errorOfFilter(scene, size, draw, mostFilterBits).p99_9;
}

TEST(CpuLightKept, aJawThatIsCroppedAwayDimsNothing) {
  const glm::ivec2 size{72, 80};
  const Scene cropped = croppedToSkull(skullOverJaw(true)), without = skullOverJaw(false);
  for (const LightDetail detail : everyDetail) {
    const Image expected = pictureIn(without, detail, size);
    const ImageError error = imageError(pictureIn(cropped, detail, size), expected);
    std::cout << "detail " << static_cast<int>(detail) << ": 99.9th percentile " << error.p99_9
              << ", largest " << error.largest << " levels\n";
    // Marched, paths to another end of the box are divided otherwise: both keep the level that a tolerance of
    // one asks of them. The nodes of a grid lie elsewhere: each picture is off by what it says.
    Scene of = cropped;
    of.quality.light = detail;
    const double bound = detail == LightDetail::sampled ? 1.0 : 2.0 * errorByGrid(of, size);
    EXPECT_LE(error.p99_9, bound);
    // What is left of a jaw that stays in the light's way, over the skull alone.
    Scene whole = skullOverJaw(true);
    whole.camera = without.camera;
    const Image dimmed = pictureIn(whole, detail, size);
    double darker = 0.0;
    for (int y = 0; y < size.y / 2; ++y)
      for (int x = 0; x < size.x; ++x)
        darker = std::max(darker, 255.0 * (expected.at(x, y).r - dimmed.at(x, y).r));
    EXPECT_GE(darker, 20.0);
  }
}

// The crop is the same, and so are the nodes.
TEST(CpuLightKept, whatLiesBehindACutFaceMayAsWellBeAir) {
  const glm::ivec2 size{64, 72};
  for (const LightDetail detail : everyDetail) {
    const Image cut = pictureIn(headCutAtTheJaw(true), detail, size);
    const ImageError error = imageError(cut, pictureIn(headCutAtTheJaw(false), detail, size));
    EXPECT_LE(error.largest, 0.01) << static_cast<int>(detail); // sums of floats
    EXPECT_GE(imageError(cut, pictureIn(withoutTravel(headCutAtTheJaw(true)), detail, size)).p99_9, 10.0);
  }
}

TEST(CpuLightKept, stepsChangeNoStrength) {
  for (const LightDetail detail : everyDetail)
    test::expectStepsToChangeNoStrength(
        [detail](const Scene& scene) {
          return pictureIn(scene, detail, {44, 44});
        },
        "detail " + std::to_string(static_cast<int>(detail)));
}

// Strengths of 0, whatever else is told of the light.
TEST(CpuLightKept, lightOfNoStrengthLeavesNoTrace) {
  const glm::ivec2 size{48, 40};
  for (const ShadingModel model : localModels)
    for (const Projection projection :
         {Projection::composite, Projection::mip, Projection::average, Projection::xray,
          Projection::isosurface, Projection::compositeIsosurface}) {
      Scene plain = withoutTravel(shadowedHead(6.0, model));
      plain.projection = projection;
      Scene neutral = plain;
      neutral.shading.shadow = {0.0, 30.0};
      neutral.shading.occlusion = {0.0, 50.0};
      neutral.quality.light = LightDetail::sampled;
      CpuRenderer one, other;
      EXPECT_EQ(other.render(neutral, size), one.render(plain, size));
      EXPECT_EQ(other.memoryMb(), one.memoryMb());
      EXPECT_EQ(other.plan(neutral).effects, one.plan(plain).effects);
    }
}

// A headlight casts none, whatever is asked of it, and the effects say why.
TEST(CpuLightKept, aHeadlightCastsNoShadowAndSaysSo) {
  Scene scene = shadowedHead(6.0);
  scene.shading.lightDirection.reset();
  scene.shading.occlusion = {};
  CpuRenderer renderer;
  const std::vector<EffectRow> rows = effectRows(scene, renderer.plan(scene));
  const auto row = std::ranges::find(rows, "shadow", &EffectRow::name);
  ASSERT_NE(row, rows.end());
  EXPECT_FALSE(row->isOn);
  EXPECT_EQ(row->reason.english(), "a light that comes from the viewer casts no shadow");
}

// What a grid adds is told from a part of the pixels; the whole picture must bear it out.
TEST(CpuLightKept, theErrorThatIsToldIsTheErrorThatIsFound) {
  const glm::ivec2 size{160, 160};
  for (const bool isOfShadow : {true, false}) {
    Scene scene = shadowedHead(3.0);
    if (isOfShadow)
      scene.shading.occlusion = {};
    else
      scene.shading.shadow = {};
    const Image sampled = pictureIn(scene, LightDetail::sampled, size);
    for (const LightDetail detail : {LightDetail::fine, LightDetail::spread}) {
      scene.quality.light = detail;
      const double told = errorByGrid(scene, size);
      const double found = imageError(pictureIn(scene, detail, size), sampled).p99_9;
      std::cout << (isOfShadow ? "shadow" : "occlusion") << ": told " << told << ", found " << found
                << " levels\n";
      EXPECT_GE(told, 0.8 * found); // what issues ask of every figure of error
      EXPECT_LE(told, 1.2 * found);
    }
  }
}

} // namespace
} // namespace limn
