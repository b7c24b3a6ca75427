// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/CpuCosts.h"
#include "scene/effects/UsualEffects.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/TravellingScenes.h"

#include <gtest/gtest.h>

#include <algorithm>

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

const EffectCost& costOf(const std::string& name, const std::vector<EffectRow>& rows,
                         const EffectFigures& figures) {
  const auto row = std::ranges::find(rows, name, &EffectRow::name);
  return figures.costs[static_cast<std::size_t>(row - rows.begin())].value();
}

EffectFigures measured(CpuRenderer& renderer, const Scene& scene) {
  const auto measurement =
      measurementOf(std::make_unique<CpuCosts>(renderer), scene, costSize, renderer.plan(scene));
  while (!measurement->figures().isComplete)
    measurement->step();
  return measurement->figures();
}

TEST(CpuCosts, lightOnItsWayTellsWhatItBroughtToThePicture) {
  Scene scene = test::shadowedHead(8.0);
  CpuRenderer renderer(1);
  const std::vector<EffectRow> rows = effectRows(scene, renderer.plan(scene));
  const EffectFigures figures = measured(renderer, scene);
  const PictureChange shadow = costOf("shadow", rows, figures).brought.value();
  const PictureChange occlusion = costOf("occlusion", rows, figures).brought.value();
  EXPECT_GE(shadow.mostLevels, 10.0);
  EXPECT_GE(occlusion.mostLevels, 5.0);
  EXPECT_GT(shadow.mostLevels, shadow.meanLevels);
  EXPECT_FALSE(costOf("lighting", rows, figures).brought);

  // The change is that of two pictures, whose shadows are the same.
  const LightVolumes light = renderer.lightOf(scene);
  const Image without =
      renderer.drawWithout({Effect::occlusion}, scene, costSize, {{0, 0}, costSize}, &light);
  EXPECT_EQ(occlusion, changeBetween(renderer.render(scene, costSize), without));

  // So little of it that nobody sees it: half a level is 1/510.
  scene.shading.occlusion.strength = 1e-3;
  const EffectFigures faint = measured(renderer, scene);
  EXPECT_EQ(broughtText(*costOf("occlusion", rows, faint).brought).english(),
            "changes nothing in this picture that could be seen");
}

TEST(CpuCosts, whatIsOffIsToldWithWhatItWouldAddAndThePictureStays) {
  const Scene scene = foggyHead();
  CpuRenderer renderer(1);
  const Image before = renderer.render(scene, costSize);
  const double mb = renderer.memoryMb();
  const std::vector<EffectRow> rows = effectRows(scene, renderer.plan(scene));
  const SceneFacts facts = renderer.sceneFacts(scene);
  const EffectFigures figures = measured(renderer, scene);
  ASSERT_EQ(figures.wouldCosts.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_FALSE(figures.costs[i] && figures.wouldCosts[i]) << rows[i].name;
    EXPECT_EQ(figures.wouldCosts[i].has_value(), withUsualEffect(scene, rows[i], facts).has_value())
        << rows[i].name;
    if (rows[i].name != "shadow" && rows[i].name != "occlusion")
      continue;
    ASSERT_TRUE(figures.wouldCosts[i]) << rows[i].name;
    EXPECT_GE(figures.wouldCosts[i]->brought.value().mostLevels, 1.0) << rows[i].name;
    const Scene with = *withUsualEffect(scene, rows[i], facts);
    const PictureChange change = changeBetween(CpuRenderer(1).render(with, costSize), before);
    EXPECT_NEAR(figures.wouldCosts[i]->brought->meanLevels, change.meanLevels, 0.05)
        << rows[i].name << ": against this picture, whatever its light has to do for it";
    EXPECT_GT(figures.wouldCosts[i]->withoutMs, 0.0) << rows[i].name;
  }
  EXPECT_EQ(renderer.render(scene, costSize), before);
  EXPECT_EQ(renderer.memoryMb(), mb) << "nothing of the other scenes stays";
}

// By the facts of the data, which have steps integrated where nobody chose.
TEST(CpuCosts, ofShiftedSamplesAreNotToldWhereNoSampleIsLeftToShift) {
  Scene scene = foggyHead();
  scene.quality.jitter = false;
  scene.quality.preintegrated = Preintegration::automatic;
  scene.quality.stepVoxels = 8.0;
  CpuRenderer renderer(1);
  const std::vector<EffectRow> rows = effectRows(scene, renderer.plan(scene));
  ASSERT_TRUE(renderer.plan(scene).effects.has(Effect::preintegration));
  const auto jitter = std::ranges::find(rows, std::string("jitter"), &EffectRow::name) - rows.begin();
  EXPECT_FALSE(measured(renderer, scene).wouldCosts[static_cast<std::size_t>(jitter)]);
}

class WatchedCosts : public CpuCosts {
public:
  WatchedCosts(CpuRenderer& renderer, bool& isGone) : CpuCosts(renderer), m_isGone(isGone) {}
  ~WatchedCosts() override { m_isGone = true; }

private:
  bool& m_isGone;
};

// What is measured stands as long as its picture; the voxels that light of its own was found in do not.
TEST(CpuCosts, whatDrewGoesOnceAllIsMeasured) {
  const Scene scene = foggyHead();
  CpuRenderer renderer(1);
  bool isGone = false;
  const auto measurement =
      measurementOf(std::make_unique<WatchedCosts>(renderer, isGone), scene, costSize, renderer.plan(scene));
  while (!measurement->figures().isComplete) {
    EXPECT_FALSE(isGone);
    measurement->step();
  }
  EXPECT_TRUE(isGone);
  const EffectFigures figures = measurement->figures();
  EXPECT_FALSE(figures.method.empty());
  EXPECT_FALSE(figures.costs.empty());
  measurement->step();
  EXPECT_EQ(measurement->figures().costs, figures.costs) << "there is nothing left to do";
}

// Counts the whole pictures that are asked for.
class CountedCosts : public CpuCosts {
public:
  using CpuCosts::CpuCosts;
  void draw(const Scene& scene, EffectSet leftOut, const glm::ivec2& size, const PixelRect& tile) override {
    wholes += tile.size == size ? 1 : 0;
    CpuCosts::draw(scene, leftOut, size, tile);
  }
  Image picture(const Scene& scene, EffectSet leftOut, const glm::ivec2& size) override {
    ++wholes;
    return CpuCosts::picture(scene, leftOut, size);
  }
  int wholes = 0;
};

// A window draws a step in a turn of its event loop.
TEST(CpuCosts, noStepDrawsMoreThanOneWholePicture) {
  const Scene scene = test::shadowedHead(8.0);
  CpuRenderer renderer(1);
  const std::vector<EffectRow> rows = effectRows(scene, renderer.plan(scene));
  CountedCosts drawing(renderer);
  EffectCosts costs(scene, costSize, rows, 3);
  int steps = 0;
  bool goesOn = true;
  while (goesOn) {
    drawing.wholes = 0;
    goesOn = costs.step(drawing);
    EXPECT_LE(drawing.wholes, 1) << steps;
    ++steps;
  }
  // One that is timed, one to compare with, one without each effect, then three pairs for each.
  const auto measured = static_cast<int>(std::ranges::count_if(rows, &EffectRow::isOn));
  EXPECT_EQ(steps, 2 + measured + 3 * 2 * measured);
}

TEST(CpuCosts, noLightIsFoundWhileEffectsAreMeasured) {
  Scene scene = test::shadowedHead(6.0, ShadingModel::enhanced);
  scene.crop.lower.y = 0.3; // without which the light is another, as it is without O
  CpuRenderer renderer(1);
  const Image before = renderer.render(scene, costSize);
  const double mb = renderer.memoryMb();
  measured(renderer, scene);
  EXPECT_EQ(renderer.memoryMb(), mb);
  EXPECT_EQ(renderer.render(scene, costSize), before);
}

} // namespace
} // namespace limn
