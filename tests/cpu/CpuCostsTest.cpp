// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/CpuCosts.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

constexpr glm::ivec2 costSize{64, 48};

Scene foggyHead() {
  Scene scene = headScene(phantomVolume({8.0, 0.0, 1}), ShadingModel::enhanced);
  scene.fog = {Fog::Mode::exp, glm::dvec3(0.0), 0.001, 0.0, 0.0};
  return scene;
}

TEST(CpuCosts, withoutLightThePictureIsTheUnlitOne) {
  Scene scene = foggyHead();
  CpuRenderer renderer(1);
  const Image without =
      renderer.drawWithout({Effect::lighting, Effect::opacityMap}, scene, costSize, {{0, 0}, costSize});
  scene.shading.model = ShadingModel::none;
  EXPECT_EQ(without, renderer.render(scene, costSize));
}

TEST(CpuCosts, areMeasuredOfWhatIsOnAndChangeNoPicture) {
  const Scene scene = foggyHead();
  CpuRenderer renderer(1);
  const Image before = renderer.render(scene, costSize);
  const EffectPlan plan = renderer.plan(scene);
  const auto measurement = measurementOf(std::make_unique<CpuCosts>(renderer), scene, costSize, plan);
  while (!measurement->figures().isComplete) {
    EXPECT_TRUE(measurement->figures().costs.empty()) << "told before all is measured";
    measurement->step();
  }
  const EffectFigures figures = measurement->figures();
  const std::vector<EffectRow> rows = effectRows(scene, plan);
  ASSERT_EQ(figures.costs.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_EQ(figures.costs[i].has_value(), rows[i].isOn) << rows[i].name;
  EXPECT_GT(figures.wholeMs, 0.0);
  EXPECT_FALSE(figures.method.empty());
  EXPECT_EQ(renderer.render(scene, costSize), before);
}

} // namespace
} // namespace limn
