// SPDX-License-Identifier: GPL-3.0-or-later
// Error-controlled steps: the shader takes the steps of the reference, and leaps do not show.
#include "scene/steps/LocalSteps.h"
#include "accuracy/ImageError.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/volume/Phantom.h"
#include "support/GlTest.h"
#include "support/Heads.h"

#include "EffectSwitches.h"

#include <numeric>

namespace limn {
namespace {

constexpr glm::ivec2 localSize{48, 48};

Scene finelySteppedScene(double fineness = 4.0) {
  static const std::shared_ptr<const Volume> volume = phantomVolume({.spacingMm = 6.0});
  Scene scene = test::headScene(volume, ShadingModel::robust);
  scene.quality.earlyTermination = 0.998;
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = fineness;
  return scene;
}

double sumOf(const std::vector<int>& samples) {
  return std::accumulate(samples.begin(), samples.end(), 0.0);
}

using LocalSteps = test::GlTest;

TEST_F(LocalSteps, theShaderTakesTheStepsOfTheReference) {
  RayCaster caster;
  for (const Variation& variation : test::switches())
    for (const double fineness : {2.0, 5.75}) {
      SCOPED_TRACE(std::string(variation.what) + ", fineness " + std::to_string(fineness));
      Scene scene = finelySteppedScene(fineness);
      variation.apply(scene);
      const ReferencePicture reference =
          renderReference(scene, localSize, 0, {}, Limiting::clampOrKnee, {}, ToTolerance::byLocalSteps);
      const ImageError error = imageError(caster.render(scene, localSize), reference.pixels);
      // Where float and double fall on different sides of a limit, a ray takes other steps, a few in a
      // thousand rays: that is a picture as good, not the same one. The rest differ by rounding, 1e-4 of a
      // level each.
      EXPECT_LT(error.mean, 0.005);
      EXPECT_LT(error.p99_9, 0.1);
      // The reference also ends where less than a double can tell is left of the light.
      if (scene.quality.earlyTermination == 1.0)
        continue;
      const std::vector<int> samples = caster.sampleCounts(scene, localSize);
      EXPECT_NEAR(sumOf(samples), sumOf(reference.samples), 1e-3 * sumOf(reference.samples));
    }
}

TEST_F(LocalSteps, neitherLeapsNorAStandInShow) {
  RayCaster caster;
  RayCaster walking(RayCaster::EmptySpace::sampled);
  RayCaster all(RayCaster::EmptySpace::skipped, RayCaster::Programs::allEffects);
  for (const Variation& variation : test::switches()) {
    SCOPED_TRACE(variation.what);
    Scene scene = finelySteppedScene();
    variation.apply(scene);
    const Image image = caster.render(scene, localSize);
    EXPECT_EQ(image, walking.render(scene, localSize));
    EXPECT_EQ(image, all.render(scene, localSize));
  }
}

TEST_F(LocalSteps, theyChangeWithTheFinenessWithoutANewProgram) {
  RayCaster caster;
  const Image coarse = caster.render(finelySteppedScene(2), localSize);
  EXPECT_NE(coarse, caster.render(finelySteppedScene(5), localSize));
  EXPECT_EQ(coarse, caster.render(finelySteppedScene(2), localSize));
  EXPECT_EQ(caster.compiledPrograms(), 1);
}

TEST_F(LocalSteps, aNewFunctionGetsANewMapOfSteps) {
  RayCaster used;
  used.render(finelySteppedScene(), localSize);
  Scene scene = finelySteppedScene();
  scene.transferFunction = test::boneOnly();
  RayCaster fresh;
  EXPECT_EQ(used.render(scene, localSize), fresh.render(scene, localSize));
}

TEST_F(LocalSteps, aProjectionThatDoesNotIntegrateKeepsItsEqualSteps) {
  RayCaster caster;
  for (const Projection projection :
       {Projection::mip, Projection::minip, Projection::average, Projection::isosurface}) {
    Scene scene = finelySteppedScene();
    scene.projection = projection;
    Scene equal = scene;
    equal.quality.toleranceLevels.reset();
    EXPECT_EQ(caster.render(scene, localSize), caster.render(equal, localSize));
    EXPECT_EQ(caster.sampleCounts(scene, localSize), caster.sampleCounts(equal, localSize));
  }
}

} // namespace
} // namespace limn
