// SPDX-License-Identifier: GPL-3.0-or-later
// The GLSL ray caster against the reference under the same discretisation: 256², step 0.25. The bounds are
// the product's: half an 8-bit level at most and 0.01 in the mean where both take the same number of samples,
// and at most one ray in a thousand where rounding gives one sample more or less.
#include "raycaster/RayCaster.h"
#include "scene/light/Shading.h"
#include "scene/volume/Phantom.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/ImageCompare.h"
#include "support/TestData.h"

#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 comparedSize{256, 256};
constexpr double largestLevels = 0.5;
constexpr double meanLevels = 0.01;
constexpr double unequalShare = 0.001;

class AgainstReference : public test::GlTest {
protected:
  void compare(const Scene& scene, const std::string& what) {
    RayCaster caster;
    const Image image = caster.render(scene, comparedSize);
    const std::vector<int> counts = caster.sampleCounts(scene, comparedSize);
    const ReferencePicture reference = renderReference(scene, comparedSize);
    const auto isEqual = [&](std::size_t i) { return counts[i] == reference.samples[i]; };
    const auto isUnequal = [&](std::size_t i) { return counts[i] != reference.samples[i]; };
    const test::Difference equal = test::differenceOf(image, reference, isEqual);
    const test::Difference unequal = test::differenceOf(image, reference, isUnequal);
    std::size_t rays = 0, unequalRays = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      rays += counts[i] > 0 || reference.samples[i] > 0;
      unequalRays += isUnequal(i);
    }
    std::cout << what << ": equal N: " << equal << "; unequal N: " << unequalRays << " of " << rays
              << " rays, " << unequal << "\n";
    EXPECT_LE(equal.largest, largestLevels) << what;
    EXPECT_LE(equal.mean, meanLevels) << what;
    EXPECT_LE(static_cast<double>(unequalRays), unequalShare * static_cast<double>(rays)) << what;
    EXPECT_GT(equal.pixels, rays / 10) << what << " shows almost nothing";
  }

  void compareModels(const std::shared_ptr<const Volume>& volume, double earlyTermination) {
    for (const ShadingModel model :
         {ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust}) {
      Scene scene = test::headScene(volume, model);
      scene.quality.earlyTermination = earlyTermination;
      compare(scene, nameOf(model));
    }
  }
};

TEST_F(AgainstReference, allModelsAgreeOnThePhantom) {
  compareModels(phantomVolume({.spacingMm = 1.5}), 1.0);
}

TEST_F(AgainstReference, allModelsAgreeOnThePhantomWithEarlyTermination) {
  compareModels(phantomVolume({.spacingMm = 1.5}), Quality{}.earlyTermination);
}

TEST_F(AgainstReference, allModelsAgreeOnANoisyPhantom) {
  compareModels(phantomVolume({.spacingMm = 2.0, .noiseHu = 20.0}), 1.0);
}

TEST_F(AgainstReference, allModelsAgreeOnTheCtHead) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  compareModels(test::ctHead(), 1.0);
}

TEST_F(AgainstReference, allModelsAgreeOnTheCtHeadWithEarlyTermination) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  compareModels(test::ctHead(), Quality{}.earlyTermination);
}

} // namespace
} // namespace limn
