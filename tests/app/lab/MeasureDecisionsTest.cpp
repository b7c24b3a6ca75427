// SPDX-License-Identifier: GPL-3.0-or-later
// The table of what each decision about accuracy costs, on a small phantom.
#include "app/lab/accuracy/MeasureDecisions.h"

#include "glsl/decisions/Decisions.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "scene/volume/Phantom.h"
#include "support/GlTest.h"

#include <algorithm>
#include <map>

namespace limn {
namespace {

constexpr glm::ivec2 measuredSize{48, 48};

using MeasuredDecisions = test::GlTest;

Scene phantomScene() {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 6.0});
  scene.camera = defaultCamera(scene.volume->grid());
  const glm::dvec3 skin(0.9, 0.7, 0.55), bone(1.0, 0.95, 0.85);
  scene.transferFunction = {1.0, {{-500, skin, 0.0}, {0, skin, 0.05}, {250, bone, 0.3}, {1200, bone, 0.9}}};
  scene.shading.model = ShadingModel::enhanced;
  return scene;
}

PrecisePixels exactOf(Scene scene) {
  scene.quality.stepVoxels = 1.0 / 64.0;
  scene.quality.earlyTermination = 1.0;
  scene.quality.preintegrated = Preintegration::never;
  return renderReference(scene, measuredSize).pixels;
}

const DecisionCost& costOf(const std::vector<DecisionCost>& costs, const std::string& group,
                           const std::string& start) {
  return *std::find_if(costs.begin(), costs.end(), [&](const DecisionCost& cost) {
    return cost.group == group && cost.name.rfind(start, 0) == 0;
  });
}

TEST_F(MeasuredDecisions, areEachComparedWithTheProgramsOwn) {
  const Scene scene = phantomScene();
  const std::vector<DecisionCost> costs = measureDecisions(scene, measuredSize, exactOf(scene));
  ASSERT_EQ(costs.size(), decisionVariants().size());
  const DecisionCost& own = costs.front();
  for (const DecisionCost& cost : costs) {
    SCOPED_TRACE(cost.group + ", " + cost.name);
    EXPECT_GT(cost.ms.median, 0.0);
    EXPECT_GT(cost.timesDefault, 0.0);
    EXPECT_GT(cost.error.mean, 0.0);
    if (cost.isDefault && cost.group != "early termination") {
      EXPECT_EQ(cost.error, own.error);
      EXPECT_EQ(cost.fineError, own.fineError);
      EXPECT_EQ(cost.extraMb, 0.0);
    }
    EXPECT_LT(own.fineError.mean, cost.error.mean) << "a step of 1/8 is finer than the scene's";
  }
  // What it costs in memory follows from the formats: 4 bytes a texel are the program's own.
  const double texels = costOf(costs, "volume texture", "8 bits").extraMb / -3.0;
  EXPECT_NEAR(costOf(costs, "volume texture", "16 bits").extraMb, -2.0 * texels, 1e-9);
  EXPECT_NEAR(costOf(costs, "gradient", "stored as 16").extraMb, 8.0 * texels, 1e-9);
  EXPECT_NEAR(costOf(costs, "gradient", "stored as 8").extraMb, 4.0 * texels, 1e-9);
  EXPECT_NEAR(costOf(costs, "classification", "before interpolation, 16").extraMb, 8.0 * texels, 1e-9);
  EXPECT_FALSE(costOf(costs, "classification", "before interpolation, 16").remark.empty());
  // Ending at 0.98 leaves out up to 5.1 levels, at 0.998 half a level, never ending none (HARD_CASES H32).
  EXPECT_GT(costOf(costs, "early termination", "at 0.98").fineError.mean,
            costOf(costs, "early termination", "at 0.998").fineError.mean);
  EXPECT_EQ(costOf(costs, "early termination", "never").fineError, own.fineError);
}

TEST_F(MeasuredDecisions, endWhenAskedTo) {
  const Scene scene = phantomScene();
  int calls = 0;
  const auto stopAtThird = [&calls](double fraction, const Message& doing) {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LT(fraction, 1.0);
    EXPECT_FALSE(doing.empty());
    if (++calls == 3)
      throw Cancelled();
  };
  EXPECT_THROW(measureDecisions(scene, measuredSize, PrecisePixels(48 * 48), stopAtThird), Cancelled);
  EXPECT_EQ(calls, 3);
}

} // namespace
} // namespace limn
