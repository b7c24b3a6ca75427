// SPDX-License-Identifier: GPL-3.0-or-later
// Floats, whole and in bricks, lead to the converged picture: how far from it, and as soon.
#include "accuracy/sweep/ConvergedPicture.h"
#include "cpu/CpuRenderer.h"
#include "cpu/bricks/BrickRenderer.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/ProjectionFacts.h"
#include "support/Heads.h"
#include "support/RendererRules.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 convergedSize{96, 80};

void redrawPrecisely(const Scene& scene, const glm::ivec2& size, const std::vector<std::uint8_t>& wanted,
                     PrecisePixels& pixels) {
  ReferencePicture picture{size, std::move(pixels), std::vector<int>(wanted.size(), 0)};
  redrawReference(picture, scene, wanted);
  pixels = std::move(picture.pixels);
}

DrawPrecisely inFloats(const DrawScene& draw) {
  return [draw](const Scene& scene, const glm::ivec2& size, const std::vector<std::uint8_t>& wanted,
                PrecisePixels& pixels) {
    const Image drawn = draw(scene, size);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      if (wanted[i])
        pixels[i] = glm::dvec4(drawn.pixels[i]);
  };
}

// The float pictures of a scene against the one in double precision, which must have converged, too.
double worstInFloats(const Scene& scene) {
  const ConvergedPicture exact = convergedPicture(scene, convergedSize, redrawPrecisely);
  EXPECT_TRUE(exact.facts.converged);
  double worst = 0.0;
  CpuRenderer renderer;
  for (const int bricks : {1, 4}) {
    ConvergedPicture floats = convergedPicture(
        scene, convergedSize, inFloats([&](const Scene& drawn, const glm::ivec2& size) {
          return bricks == 1 ? renderer.render(drawn, size) : drawInBricks(drawn, size, bricks);
        }));
    floats.facts.isInFloats = true;
    EXPECT_TRUE(floats.facts.converged) << bricks;
    const ImageError error = imageError(floats.pixels, exact.pixels);
    // Neither is exact.
    EXPECT_LE(error.p99_9, leastP99_9(floats.facts) + leastP99_9(exact.facts)) << bricks;
    EXPECT_LE(error.mean, leastMean(floats.facts) + leastMean(exact.facts)) << bricks;
    if (integrates(scene.projection)) {
      EXPECT_LE(error.p99_9, floatP99_9) << bricks;
      EXPECT_LE(error.mean, floatMean) << bricks;
      worst = std::max(worst, error.p99_9);
    }
  }
  return worst;
}

TEST(ConvergedInFloats, liesWithinWhatIsPromisedOfTheOneInDouble) {
  double worst = 0.0;
  for (const ShadingModel model : {ShadingModel::none, ShadingModel::robust})
    for (const Projection projection : {Projection::composite, Projection::compositeIsosurface}) {
      Scene scene = test::noisyPhantom(model);
      scene.projection = projection;
      worst = std::max(worst, worstInFloats(scene));
    }
  std::cout << "converged in floats: at most " << worst << " levels (p99.9) from the one in double\n";
}

TEST(ConvergedInFloats, ofTheCtHeadDoes) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  for (const Projection projection : {Projection::composite, Projection::mip, Projection::xray}) {
    Scene scene = test::headScene(test::ctHead(), ShadingModel::classic);
    scene.projection = projection;
    std::cout << "CT head: " << worstInFloats(scene) << " levels\n";
  }
}

} // namespace
} // namespace limn
