// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/LightFinder.h"
#include "gl/PictureTarget.h"
#include "raycaster/CasterCosts.h"
#include "scene/effects/UsualEffects.h"
#include "scene/volume/Phantom.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/TravellingScenes.h"

#include <algorithm>
#include <iostream>

namespace limn {
namespace {

using EffectCostsOnADriver = test::GlTest;

constexpr glm::ivec2 costsSize{96, 96};

Scene croppedScene() {
  Scene scene = test::headScene(phantomVolume({4.0, 0.0, 1}), ShadingModel::enhanced);
  scene.quality.earlyTermination = 0.998;
  scene.crop.upper = {1.0, 0.04, 1.0};
  scene.fog = {Fog::Mode::exp, glm::dvec3(0.0), 0.001, 0.0, 0.0};
  return scene;
}

TEST(EffectCostFigures, areDifferencesOfMediansWithTheSpreadOfTheirRounds) {
  EXPECT_EQ(medianOf({}), 0.0);
  EXPECT_EQ(medianOf({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(medianOf({4.0, 1.0, 2.0, 3.0}), 2.5);
  // Differences 5, 6, 1, 5, 9; sorted 1 5 5 6 9: the middle half reaches from 5 to 6.
  const EffectCost cost = costBetween({10, 11, 10, 12, 13}, {5, 5, 9, 7, 4});
  EXPECT_EQ(cost.ms, 11.0 - 5.0);
  EXPECT_EQ(cost.spreadMs, 0.5);
  EXPECT_EQ(cost.withoutMs, 5.0);
}

TEST_F(EffectCostsOnADriver, areMeasuredOfWhatIsOnAndChangeNoPicture) {
  const Scene scene = croppedScene();
  RayCaster caster;
  const Image before = caster.render(scene, costsSize);
  const FloatTarget target(costsSize);
  const std::vector<EffectRow> rows = effectRows(scene, caster.plan(scene));
  CasterCosts drawing(caster);
  EffectCosts costs(scene, costsSize, rows, 5);
  EXPECT_EQ(costs.fraction(), 0.0);
  int steps = 1;
  while (costs.step(drawing)) {
    ++steps;
    for (const auto& cost : costs.costs())
      EXPECT_FALSE(cost) << "told before all is measured";
  }
  EXPECT_EQ(costs.fraction(), 1.0);
  int measured = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(costs.costs()[i].has_value(), rows[i].isOn) << rows[i].name;
    measured += rows[i].isOn;
  }
  EXPECT_GT(measured, 5);
  // The whole picture and one without each effect to compile, then five pairs for each.
  EXPECT_EQ(steps, measured + 1 + 5 * 2 * measured);
  EXPECT_GT(costs.wholeMs(), 0.0);
  EXPECT_FALSE(drawing.method().empty());
  EXPECT_EQ(caster.render(scene, costsSize), before);
}

TEST_F(EffectCostsOnADriver, timeTheWholePictureWhereNothingIsOn) {
  Scene scene = croppedScene();
  scene.transferFunction.points.clear();
  RayCaster caster;
  const FloatTarget target(costsSize);
  CasterCosts drawing(caster);
  EffectCosts costs(scene, costsSize, effectRows(scene, caster.plan(scene)), 5);
  int steps = 1;
  while (costs.step(drawing))
    ++steps;
  EXPECT_EQ(steps, 6);
  EXPECT_GT(costs.wholeMs(), 0.0);
}

// The slab left is a twentieth of the volume: whatever the machine does, drawing all of it takes longer.
TEST_F(EffectCostsOnADriver, areBelowZeroWhereAnEffectSavesTime) {
  Scene scene = croppedScene();
  scene.fog = {};
  scene.quality.earlyTermination = 1.0;
  RayCaster caster;
  const FloatTarget target(costsSize);
  std::vector<EffectRow> rows = effectRows(scene, caster.plan(scene));
  for (EffectRow& row : rows)
    row.isOn = row.name == "crop";
  CasterCosts drawing(caster);
  EffectCosts costs(scene, costsSize, rows, 9);
  while (costs.step(drawing)) {
  }
  const auto crop = std::find_if(rows.begin(), rows.end(), [](const EffectRow& row) { return row.isOn; });
  EXPECT_LT(costs.costs()[static_cast<std::size_t>(crop - rows.begin())]->ms, 0.0);
}

// Whoever knows the light is asked once: what is cropped or left out would have it found anew, beside
// drawing.
TEST_F(EffectCostsOnADriver, areDrawnInOneLightThatTellsWhatItBrought) {
  Scene scene = test::shadowedHead(6.0, ShadingModel::enhanced);
  scene.crop.lower.y = 0.3;
  RayCaster caster;
  LightFinder finder;
  int asked = 0;
  caster.askForLight([&](const Scene& of) {
    ++asked;
    return finder.find(of);
  });
  const Image before = caster.render(scene, costsSize);
  const FloatTarget target(costsSize);
  const std::vector<EffectRow> rows = effectRows(scene, caster.plan(scene));
  asked = 0;
  CasterCosts drawing(caster);
  EffectCosts costs(scene, costsSize, rows, 5);
  while (costs.step(drawing)) {
  }
  EXPECT_EQ(asked, 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].isOn)
      continue;
    const std::optional<PictureChange> brought = costs.costs()[i]->brought;
    const bool isLight = rows[i].effects.hasAny(travellingLight);
    EXPECT_EQ(brought.has_value(), isLight) << rows[i].name;
    if (isLight) {
      std::cout << rows[i].name << " " << broughtText(*brought).english() << "\n";
      EXPECT_GE(brought->mostLevels, 5.0) << rows[i].name;
    }
  }
  EXPECT_EQ(caster.render(scene, costsSize), before);
}

// In a light of its own, found on a thread, which the picture itself is then drawn without.
TEST_F(EffectCostsOnADriver, ofWhatIsOffAreWhatItWouldAdd) {
  Scene scene = test::shadowedHead(6.0, ShadingModel::enhanced);
  scene.shading.shadow.strength = 0.0;
  scene.shading.occlusion.strength = 0.0;
  RayCaster caster;
  const Image before = caster.render(scene, costsSize);
  const FloatTarget target(costsSize);
  const std::vector<EffectRow> rows = effectRows(scene, caster.plan(scene));
  const SceneFacts facts = caster.sceneFacts(scene);
  CasterCosts drawing(caster);
  EffectCosts costs(scene, costsSize, rows, 5);
  costs.addWhatIsOff(drawing);
  while (costs.step(drawing)) {
  }
  EXPECT_EQ(costs.fraction(), 1.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(costs.costs()[i].has_value(), rows[i].isOn) << rows[i].name;
    const std::optional<EffectCost> wouldCost = costs.wouldCosts()[i];
    EXPECT_EQ(wouldCost.has_value(), withUsualEffect(scene, rows[i], facts).has_value()) << rows[i].name;
    if (wouldCost && rows[i].effects.hasAny(travellingLight)) {
      EXPECT_GT(wouldCost->brought.value().mostLevels, 0.5) << rows[i].name;
    }
  }
  EXPECT_EQ(caster.render(scene, costsSize), before);
}

} // namespace
} // namespace limn
