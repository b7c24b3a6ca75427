// SPDX-License-Identifier: GPL-3.0-or-later
// Exact pictures are cheap: cell by cell an error falls at least with the square of the evaluations spent. In
// local steps, which were taken before, it does so with more of them (EVIDENCE).
#include "accuracy/EvaluationCosts.h"

#include "io/VolumeReader.h"
#include "io/scenefile/SceneFile.h"
#include "scene/light/Shading.h"
#include "scene/volume/Phantom.h"
#include "support/Heads.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace limn {
namespace {

using test::EvaluationCost;
using test::EvaluationWay;

constexpr glm::ivec2 costedPicture(64, 64);

// Gauss's rule and quadratics through three nodes err by the cube of their length at least, of which pieces
// whose light stands still already take none. A line of 2 is what was asked for, and what equal steps of a
// smooth field reach; they reach 1 where the field has the kinks of cells.
constexpr double steepest = -2.0;

void expectSteep(Scene scene, const std::string& what) {
  for (const ShadingModel model : localModels) {
    scene.shading.model = model;
    SCOPED_TRACE(what + ", " + nameOf(model));
    const std::vector<glm::dvec4> exact = test::exactByCells(scene, costedPicture);
    const std::vector<EvaluationCost> costs =
        test::evaluationCosts(scene, costedPicture, EvaluationWay::cells, exact);
    EXPECT_LE(costs.back().error, test::toldErrors.back());
    const double slope = test::slopeOf(costs);
    std::printf("%s, %s: %.2f level for %.0f evaluations a ray to %.3f for %.0f, slope %.1f\n", what.c_str(),
                nameOf(model), costs.front().error, costs.front().evaluations, costs.back().error,
                costs.back().evaluations, slope);
    // Where the coarsest picture of all errs by less than half a level there is no line to speak of.
    if (std::isnan(slope))
      EXPECT_LT(costs.front().error, 0.5);
    else
      EXPECT_LE(slope, steepest);
  }
}

TEST(ErrorByEvaluations, fallsOnAPhantomWithTheirSquareAtLeast) {
  expectSteep(headScene(phantomVolume({.spacingMm = 4.0}), ShadingModel::none), "phantom");
}

TEST(ErrorByEvaluations, fallsOnHeadsWithTheirSquareAtLeast) {
  const std::string ct = test::ctHeadFile, mr = "data/mr_t1_head/mr_t1_head.nii.gz";
  LIMN_NEEDS_SHARED(ct);
  LIMN_NEEDS_SHARED(mr);
  for (const auto& [look, file] : {std::pair{"ct_bone", ct}, std::pair{"ct_soft", ct},
                                   std::pair{"mr_bone", mr}, std::pair{"mr_soft", mr}}) {
    const std::string text =
        readTextFile(test::sourceFolder() / "tests/benchmarks/scenes" / (std::string(look) + ".json"));
    Scene scene = parseScene(text, look).scene;
    scene.volume = readVolume((test::sharedFolder() / file).string());
    scene.camera = defaultCamera(scene.volume->grid());
    expectSteep(scene, look);
  }
}

// A line that is known: 1, 2, 4 … evaluations err by 16, 4, 1 … levels.
TEST(ErrorByEvaluations, ofASquareIsALineOfSlopeTwo) {
  std::vector<EvaluationCost> costs;
  for (int k = 0; k < 6; ++k)
    costs.push_back({16.0 / std::exp2(2 * k), std::exp2(k)});
  EXPECT_NEAR(test::slopeOf(costs), -2.0, 1e-9);
  EXPECT_NEAR(test::evaluationsFor(costs, 2.0), std::sqrt(8.0), 1e-9);
  EXPECT_TRUE(std::isnan(test::evaluationsFor(costs, 17.0)));
  EXPECT_TRUE(std::isnan(test::slopeOf({{8.0, 1.0}, {3.0, 2.0}}))) << "three of the errors told at least";
}

} // namespace
} // namespace limn
