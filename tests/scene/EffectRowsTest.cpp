// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/effects/EffectRows.h"
#include "scene/PhantomScene.h"
#include "scene/ProjectionFacts.h"
#include "scene/effects/UsualEffects.h"
#include "support/EffectNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

namespace limn {
namespace {

const SceneFacts ofVolume{.canSkipEmptySpace = true};

std::vector<EffectRow> rowsOf(const Scene& scene) {
  return effectRows(scene, requiredEffects(scene, ofVolume));
}

// Why an effect is in no row.
struct Technical {
  Effect effect;
  const char* why;
};

constexpr Technical technicalEffects[] = {
    {Effect::mip, "a choice between projections, each of which replaces the picture"},
    {Effect::minip, "a choice between projections, each of which replaces the picture"},
    {Effect::average, "a choice between projections, each of which replaces the picture"},
    {Effect::xray, "a choice between projections, each of which replaces the picture"},
    {Effect::longRays, "another order of the same work, for drivers that limit loops"},
    {Effect::denseFunctions, "another way to look up the same transfer function"},
    {Effect::localSteps, "another way to spend samples on the same picture"},
    {Effect::unlimited, "drawn to measure the overflow, never shown"},
    {Effect::sampleCounts, "drawn to measure, never shown"},
};

EffectRow row(const Scene& scene, const std::string& name) {
  const std::vector<EffectRow> rows = rowsOf(scene);
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const EffectRow& one) { return one.name == name; });
  return found == rows.end() ? EffectRow{} : *found;
}

TEST(EffectRows, areTheDocumentedOnesInTheirOrder) {
  std::vector<std::string> names;
  for (const EffectRow& one : rowsOf(test::roughPhantomScene()))
    names.push_back(one.name);
  EXPECT_EQ(names, test::documentedEffects);
}

TEST(EffectRows, holdEveryEffectButTheTechnicalOnesWhichSayWhy) {
  const std::vector<EffectRow> rows = rowsOf(test::roughPhantomScene());
  for (int i = 0; i < effectCount; ++i) {
    const auto effect = static_cast<Effect>(i);
    const auto holds = [effect](const EffectRow& one) { return one.effects.has(effect); };
    const auto isTechnical = [effect](const Technical& one) { return one.effect == effect; };
    EXPECT_EQ(std::count_if(rows.begin(), rows.end(), holds) +
                  std::count_if(std::begin(technicalEffects), std::end(technicalEffects), isTechnical),
              1)
        << describe(effect).name;
  }
}

TEST(EffectRows, shareNoEffect) {
  EffectSet seen;
  for (const EffectRow& one : rowsOf(test::roughPhantomScene())) {
    EXPECT_FALSE(seen.hasAny(one.effects)) << one.name;
    seen = seen.with(one.effects);
  }
}

// What a reader is told in every state of the scene that the plan knows.
TEST(EffectRows, giveAReasonInPlainWordsWhateverTheSceneCallsFor) {
  std::vector<Scene> scenes;
  for (const ShadingModel model :
       {ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust})
    for (const Projection projection :
         {Projection::composite, Projection::mip, Projection::minip, Projection::average, Projection::xray,
          Projection::isosurface, Projection::compositeIsosurface})
      for (const double opacity : {0.0, 0.02, 0.9}) {
        scenes.push_back(test::roughPhantomScene());
        scenes.back().shading.model = model;
        scenes.back().projection = projection;
        scenes.back().transferFunction.points.back().opacity = opacity;
        scenes.back().fog = {Fog::Mode::exp2, glm::dvec3(0.0), 0.001, 0.0, 0.0};
        scenes.back().crop.upper.x = 0.5;
        scenes.back().quality.jitter = true;
      }
  for (const Scene& scene : scenes)
    for (const EffectRow& one : rowsOf(scene)) {
      SCOPED_TRACE(one.name + ": " + one.reason.english());
      EXPECT_FALSE(one.reason.empty());
      EXPECT_FALSE(one.title.empty());
      // Words of the formulas, not of their readers.
      for (const char* word : {" term", "modulus", "coefficient", "min..", "EFFECT", "uniform"})
        EXPECT_EQ(one.reason.english().find(word), std::string::npos) << word;
      EXPECT_NE(one.reason.english().back(), '.') << "a phrase, not a sentence";
    }
}

TEST(EffectRows, areOnWhereAnyOfTheirEffectsIs) {
  Scene scene = test::roughPhantomScene();
  EXPECT_FALSE(row(scene, "fog").isOn);
  EXPECT_EQ(row(scene, "fog").reason.english(), "fog is off");
  for (const Fog::Mode mode : {Fog::Mode::linear, Fog::Mode::exp, Fog::Mode::exp2}) {
    scene.fog = {mode, glm::dvec3(0.0), 0.001, 0.0, 900.0};
    EXPECT_TRUE(row(scene, "fog").isOn);
    EXPECT_NE(row(scene, "fog").reason.english().find("fog is on"), std::string::npos)
        << row(scene, "fog").reason.english();
  }
  scene.fog.densityPerMm = 0.0;
  EXPECT_EQ(row(scene, "fog").reason.english(), "the density of the fog is 0");
  scene.projection = Projection::compositeIsosurface;
  EXPECT_TRUE(row(scene, "isosurface").isOn);
}

TEST(EffectRows, tellOfOwnWeightsWhereTheDriversAreTooCoarse) {
  Scene scene = test::roughPhantomScene();
  const auto rowWith = [&scene](int bits) {
    return effectRows(scene, requiredEffects(scene, {.filterBits = bits})).back();
  };
  EXPECT_EQ(rowWith(8).name, "own_weights");
  EXPECT_FALSE(rowWith(8).isOn);
  EXPECT_NE(rowWith(8).reason, rowWith(mostFilterBits).reason);
  scene.quality.ownWeights = true;
  EXPECT_TRUE(rowWith(8).isOn);
  EXPECT_TRUE(rowWith(mostFilterBits - 1).isOn);
  EXPECT_FALSE(rowWith(mostFilterBits).isOn) << "a driver in floats needs none";
  for (const Projection projection : projections) {
    scene.projection = projection;
    EXPECT_TRUE(rowWith(8).isOn) << nameOf(projection);
  }
}

TEST(EffectRows, tellWhatTheProjectionHasNoUseFor) {
  Scene scene = test::roughPhantomScene();
  scene.fog = {Fog::Mode::linear, glm::dvec3(0.0), 0.0, 0.0, 900.0};
  scene.projection = Projection::mip;
  EXPECT_FALSE(row(scene, "fog").isOn);
  EXPECT_EQ(row(scene, "fog").reason.english(), "this kind of picture has no use for it");
}

TEST(EffectRows, countACropBoxWhereItCuts) {
  Scene scene = test::roughPhantomScene();
  EXPECT_FALSE(row(scene, "crop").isOn);
  scene.crop.lower.z = 0.25;
  EXPECT_TRUE(row(scene, "crop").isOn);
  scene.shading.model = ShadingModel::none;
  EXPECT_TRUE(row(scene, "crop").isOn) << "an unlit picture is cut as well";
  scene.transferFunction.points.clear();
  EXPECT_FALSE(row(scene, "crop").isOn) << "nothing can be seen of it";
}

TEST(EffectCosts, areToldInWords) {
  EXPECT_EQ(costText({12.3, 1.0}).english(), "12 ms");
  EXPECT_EQ(costText({1.26, 0.1}).english(), "1.3 ms");
  EXPECT_EQ(costText({-210.4, 3.0}).english(), "saves 210 ms");
  EXPECT_EQ(costText({-303.0, 3.0, {}, 363.2}).english(), "saves 303 of 363 ms")
      << "beside a picture of 60 ms";
  EXPECT_EQ(costText({12.3, 1.0, {}, 48.0}).english(), "12 ms");
  EXPECT_EQ(costWithSpreadText({12.3, 1.0}).english(), "12 ± 1.0 ms");
  EXPECT_EQ(costWithSpreadText({-210.4, 3.0}).english(), "saves 210 ± 3.0 ms");
  EXPECT_EQ(costWithSpreadText({-303.0, 12.0, {}, 363.2}).english(), "saves 303 ± 12 of 363 ms");
  EXPECT_EQ(costWithSpreadText({2.0, 2.5}).english(), "≈ 0 ms");
  EXPECT_EQ(costText({2.0, 2.5}).english(), "≈ 0 ms");
  EXPECT_EQ(costText({-39.0, 26.7}).english(), "≈ 0 ms") << "within two spreads chance may be all of it";
  EXPECT_EQ(costText({-0.01, 0.0}).english(), "≈ 0 ms");
}

TEST(EffectCosts, ofWhatIsOffAreToldAsWhatWouldBe) {
  EXPECT_EQ(wouldCostText({38.2, 1.0, {}, 50.0}).english(), "would take 38 ms more");
  EXPECT_EQ(wouldCostText({-210.4, 3.0, {}, 270.0}).english(), "would save 210 of 270 ms");
  EXPECT_EQ(wouldCostText({2.0, 2.5, {}, 50.0}).english(), "would take hardly any time");
  EXPECT_EQ(wouldBringText({84.6, 4.23}).english(),
            "would change this picture by up to 85 of 255 levels, by 4.2 on average");
  EXPECT_EQ(wouldBringText({0.2, 0.01}).english(), "would change nothing in this picture that could be seen");
}

TEST(UsualEffects, switchOnWhatIsOffWithTheScenesOwnNumbersOrUsualOnes) {
  Scene scene = test::roughPhantomScene();
  scene.shading.shadow = {};
  scene.shading.occlusion = {0.0, 7.0};
  const std::optional<Scene> shadowed = withUsualEffect(scene, row(scene, "shadow"), ofVolume);
  ASSERT_TRUE(shadowed);
  EXPECT_GT(shadowed->shading.shadow.strength, 0.0);
  EXPECT_TRUE(shadowed->shading.lightDirection) << "a light from the viewer casts none";
  EXPECT_TRUE(row(*shadowed, "shadow").isOn);
  EXPECT_FALSE(withUsualEffect(*shadowed, row(*shadowed, "shadow"), ofVolume)) << "it is on";
  const std::optional<Scene> hollows = withUsualEffect(scene, row(scene, "occlusion"), ofVolume);
  ASSERT_TRUE(hollows);
  EXPECT_EQ(hollows->shading.occlusion.reachMm, 7.0) << "the scene's own";
  EXPECT_FALSE(withUsualEffect(scene, row(scene, "smooth_normals"), ofVolume)) << "a copy of the volume";
  EXPECT_FALSE(withUsualEffect(scene, row(scene, "region"), ofVolume)) << "nothing to cut is known";
  scene.shading.model = ShadingModel::none;
  EXPECT_FALSE(withUsualEffect(scene, row(scene, "shadow"), ofVolume)) << "no light, no shadow";
}

// Where the program chooses to integrate within steps, shifted samples would show nothing.
TEST(UsualEffects, areWhatTheFactsOfTheSceneLeaveToSee) {
  Scene scene = test::roughPhantomScene();
  scene.quality.jitter = false;
  scene.quality.preintegrated = Preintegration::automatic;
  const EffectRow jitter = row(scene, "jitter");
  EXPECT_TRUE(withUsualEffect(scene, jitter, {.steepestPerMm = 0.0}));
  SceneFacts steep;
  steep.steepestPerMm = 1e6;
  ASSERT_TRUE(requiredEffects(scene, steep).effects.has(Effect::preintegration));
  EXPECT_FALSE(withUsualEffect(scene, jitter, steep));
}

} // namespace
} // namespace limn
