// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/SceneSource.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace limn {
namespace {

TEST(SceneSource, aSceneWithoutACurveTakesOnlyThatFromThePreset) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "scene.json";
  std::ofstream(path) << R"({"limn_scene": 1, "volume": "phantom:8", "projection": "xray",
      "gradient_opacity": {"points": [{"gradient": 5, "opacity": 0.5}]},
      "shading": {"model": "robust", "exponent": 77}})";
  const LoadedScene loaded = loadScene(path.string(), {}, {});
  EXPECT_FALSE(loaded.preset.empty());
  EXPECT_FALSE(loaded.scene.transferFunction.points.empty());
  EXPECT_EQ(loaded.scene.projection, Projection::xray);
  EXPECT_EQ(loaded.scene.gradientOpacity, (GradientOpacity{{{5.0, 0.5}}}));
  EXPECT_EQ(loaded.scene.shading.model, ShadingModel::robust);
  EXPECT_EQ(loaded.scene.shading.exponent, 77.0);
}

TEST(SceneSource, aVolumeAloneOpensAsItsPresetSays) {
  const LoadedScene loaded = loadScene("phantom:8", {}, {});
  EXPECT_EQ(loaded.preset, "CT skin and bone");
  EXPECT_EQ(loaded.scene.projection, Projection::composite);
  EXPECT_FALSE(loaded.hasOwnCamera);
}

} // namespace
} // namespace limn
