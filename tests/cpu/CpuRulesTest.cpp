// SPDX-License-Identifier: GPL-3.0-or-later
// Rules that every picture of the CPU engine keeps, to the bit where the rule is an equality.
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "scene/ProjectionFacts.h"
#include "scene/basics/Error.h"
#include "scene/light/LightingTerms.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/Heads.h"
#include "support/NeedleScene.h"
#include "support/RendererRules.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 cpuPicture{97, 80};

std::vector<Scene> scenesOfEveryKind() {
  std::vector<Scene> scenes;
  for (const Projection projection : projections) {
    Scene scene = test::noisyPhantom(ShadingModel::robust);
    scene.projection = projection;
    scene.quality.jitter = true;
    scenes.push_back(scene);
    scene.quality.preintegrated = Preintegration::always;
    scenes.push_back(scene);
    scene.quality.toleranceLevels = 1.0;
    scene.quality.fineness = 4;
    scenes.push_back(scene);
    scene.quality.jitter = false;
    scenes.push_back(scene);
    scene.keep = cubesRegion(scene.volume->grid().dims, 11, {0.0, 1.0, 0.0, 0.3});
    scenes.push_back(scene);
    scene.keep = withVariedLooks(scene.keep, scene.transferFunction);
    scenes.push_back(scene);
    scene.quality.toleranceLevels.reset();
    scenes.push_back(scene);
    scene.keep = withLooks(scene.keep, {});
    scenes.push_back(scene);
  }
  return scenes;
}

TEST(CpuRules, anyNumberOfThreadsAndTilesGivesTheSameBits) {
  CpuRenderer single(1), oneInSteps(1, CpuRenderer::Tolerance::stepsFirst);
  CpuRenderer severalInSteps(3, CpuRenderer::Tolerance::stepsFirst);
  for (const Scene& scene : scenesOfEveryKind()) {
    EXPECT_EQ(severalInSteps.render(scene, cpuPicture), oneInSteps.render(scene, cpuPicture));
    const Image expected = single.render(scene, cpuPicture);
    for (const int threads : {2, 3, 8}) {
      CpuRenderer several(threads);
      EXPECT_EQ(several.render(scene, cpuPicture), expected) << threads;
    }
    const PixelRect tile{{13, 7}, {31, 22}};
    const Image part = single.draw(scene, cpuPicture, tile);
    for (int y = 0; y < tile.size.y; ++y)
      for (int x = 0; x < tile.size.x; ++x)
        ASSERT_EQ(part.at(x, y), expected.at(tile.topLeft.x + x, tile.topLeft.y + y));
  }
}

TEST(CpuRules, aNeedleOfTheFunctionNarrowerThanACellIsSeenWhole) {
  CpuRenderer renderer;
  for (const double width : {1e-1, 1e-3}) {
    test::NeedleScene needle = test::needleScene(width);
    needle.scene.quality.toleranceLevels = 1.0;
    needle.scene.quality.fineness = 12;
    // Floats tell places on 16 mm apart to 1e-6 mm, of 1e-3 a thousandth.
    EXPECT_NEAR(renderer.render(needle.scene, {1, 1}).at(0, 0).a, needle.alpha, 1e-3) << width;
  }
}

TEST(CpuRules, steppingOverEmptySpaceChangesNoBit) {
  CpuRenderer skipping(0), sampling(0, CpuRenderer::EmptySpace::sampled);
  CpuRenderer skippingSteps(0, CpuRenderer::Tolerance::stepsFirst);
  CpuRenderer samplingSteps(0, CpuRenderer::EmptySpace::sampled, CpuRenderer::Weights::floats,
                            CpuRenderer::Tolerance::stepsFirst);
  for (const Scene& scene : scenesOfEveryKind()) {
    EXPECT_EQ(skippingSteps.render(scene, cpuPicture), samplingSteps.render(scene, cpuPicture))
        << "steps first, projection " << static_cast<int>(scene.projection);
    const bool isScalar = classifiesOnce(scene.projection);
    EXPECT_TRUE(isScalar || scene.quality.toleranceLevels ||
                skipping.plan(scene).effects.has(Effect::emptySpaceSkipping));
    const Image skipped = skipping.render(scene, cpuPicture), sampled = sampling.render(scene, cpuPicture);
    EXPECT_EQ(skipped, sampled) << "projection " << static_cast<int>(scene.projection)
                                << (isRestricting(scene.keep) ? ", region" : "")
                                << (scene.quality.toleranceLevels ? ", tolerance" : "");
  }
}

TEST(CpuRules, enhancedWithEqualRangesIsClassicToTheBit) {
  CpuRenderer renderer;
  Scene classic = test::noisyPhantom(ShadingModel::classic);
  classic.shading.exponent = 20.0;
  Scene enhanced = classic;
  enhanced.shading.model = ShadingModel::enhanced;
  enhanced.shading.exponentRange = {20.0, 20.0};
  enhanced.shading.opacityRange = {1.0, 1.0};
  EXPECT_EQ(renderer.render(enhanced, cpuPicture), renderer.render(classic, cpuPicture));
}

TEST(CpuRules, facesAreLitOnceAndNothingJumpsThroughTheBox) {
  CpuRenderer renderer;
  const auto draw = [&](const Scene& scene, const glm::ivec2& size) { return renderer.render(scene, size); };
  test::expectFacesLitOnce(draw);
  test::expectNoJumpThroughTheBox(draw);
}

// Between two questions nothing is drawn but one strip of a row: at most 64 rays.
TEST(CpuRules, aCancelledPictureEndsWithItsNextStrip) {
  const std::unique_ptr<DrawingEngine> engine = makeCpuEngine(1);
  Scene scene = test::noisyPhantom(ShadingModel::robust);
  for (const int after : {0, 1, 40}) {
    int asked = 0;
    const auto isCancelled = [&] { return asked++ == after; };
    EXPECT_THROW(engine->draw(scene, cpuPicture, {{0, 0}, cpuPicture}, isCancelled), Cancelled);
    EXPECT_EQ(asked, after + 1);
  }
  int asked = 0;
  engine->draw(scene, cpuPicture, {{0, 0}, cpuPicture}, [&] {
    ++asked;
    return false;
  });
  EXPECT_GT(asked, 41) << "a strip at a time of the rows that the head covers";
}

// A volume is read in pieces of 65,536 voxels; in between it can be left, and gone on with as if nothing
// were.
TEST(CpuRules, aCancelledPreparationEndsWithItsPieceAndSpoilsNothing) {
  Scene scene = test::noisyPhantom(ShadingModel::robust);
  scene.volume = phantomVolume({.spacingMm = 1.5, .noiseHu = 20.0});
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = 4;
  const glm::ivec2 size(16, 16);
  const PixelRect whole{{0, 0}, size};
  int asked = 0;
  const auto stopsAfter = [&asked](int questions) {
    return [&asked, questions] { return asked++ == questions; };
  };
  const Image expected = CpuRenderer(1).draw(scene, size, whole, stopsAfter(-1));
  const int all = asked;
  EXPECT_GT(all, 100) << "of 55 pieces of voxels, twice over: blocks, gradients";
  CpuRenderer renderer(1);
  for (int after = 0; after < all; after = after * 3 / 2 + 1) {
    asked = 0;
    CpuRenderer fresh(1);
    EXPECT_THROW(fresh.draw(scene, size, whole, stopsAfter(after)), Cancelled);
    EXPECT_EQ(asked, after + 1);
    asked = 0;
    EXPECT_THROW(renderer.draw(scene, size, whole, stopsAfter(2)), Cancelled);
  }
  EXPECT_EQ(renderer.render(scene, size), expected);
}

TEST(CpuRules, whatNobodySeesIsEmpty) {
  CpuRenderer renderer;
  Scene scene = test::noisyPhantom(ShadingModel::classic);
  scene.transferFunction.points.clear();
  EXPECT_EQ(renderer.render(scene, cpuPicture), Image(cpuPicture));
  EXPECT_THROW(renderer.render(Scene{}, cpuPicture), Error);
}

} // namespace
} // namespace limn
