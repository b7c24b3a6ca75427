// SPDX-License-Identifier: GPL-3.0-or-later
// A tolerance kept cell by cell: closed forms, edges and needles of the function, and errors that fall with
// the fineness.
#include "reference/CellMarch.h"

#include "accuracy/ImageError.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/volume/Phantom.h"
#include "support/AnalyticScenes.h"
#include "support/Heads.h"
#include "support/NeedleScene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

void keepTolerance(Scene& scene, double fineness) {
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = fineness;
  scene.quality.earlyTermination = 1.0;
}

TEST(CellMarch, aHomogeneousSlabIsExactWithAnyFinenessHoweverOpaque) {
  // A1: 1 - exp(-κ D), and one colour.
  for (const double opacity : {1e-6, 0.4, 0.999})
    for (const int fineness : {0, 3, 9}) {
      Scene scene = test::rayThrough(test::boxOf(glm::dvec3(2.0)));
      scene.transferFunction = test::constantFunction(opacity, glm::dvec3(1.0, 0.5, 0.25));
      keepTolerance(scene, fineness);
      const glm::dvec4 pixel = renderReference(scene, {1, 1}, 1).pixels[0];
      const double alpha = 1.0 - (1.0 - opacity) * (1.0 - opacity);
      EXPECT_NEAR(pixel.a, alpha, 1e-12);
      EXPECT_NEAR(pixel.g, 0.5 * alpha, 1e-12);
    }
}

TEST(CellMarch, anEdgeOfTheFunctionIsMetWhereItIs) {
  // κ is 16.6 per micrometre behind the edge, and the colour gains 2 per mm.
  Scene scene = test::edgeScene();
  keepTolerance(scene, 12);
  const ReferencePicture picture = renderReference(scene, {1, 1}, 1);
  EXPECT_NEAR(picture.pixels[0].a, 1.0, 1e-12);
  EXPECT_LT(picture.pixels[0].r, 1e-3)
      << "2 per mm, of which 1e-3/16.6 are seen, and half of a 32nd of a piece";
  EXPECT_LT(picture.samples[0], 200) << "an edge is cut at, not sampled through";
}

TEST(CellMarch, aNeedleOfTheFunctionNarrowerThanACellIsSeenWhole) {
  for (const double width : {1e-1, 1e-3, 1e-6}) {
    const test::NeedleScene needle = test::needleScene(width);
    Scene scene = needle.scene;
    keepTolerance(scene, 12);
    EXPECT_NEAR(renderReference(scene, {1, 1}, 1).pixels[0].a, needle.alpha, largestPieceChange(12)) << width;
  }
}

TEST(CellMarch, everyUnitOfFinenessHalvesTheError) {
  Scene scene = test::headScene(phantomVolume({.spacingMm = 6.0}), ShadingModel::robust);
  const glm::ivec2 size(40, 40);
  keepTolerance(scene, 22);
  const ReferencePicture exact = renderReference(scene, size);
  keepTolerance(scene, 2);
  const double coarse = imageError(toImage(renderReference(scene, size)), exact.pixels).p99_9;
  keepTolerance(scene, 12);
  const double fine = imageError(toImage(renderReference(scene, size)), exact.pixels).p99_9;
  EXPECT_LE(fine, coarse / 256.0) << "ten units: 1024, and a factor of four for so few pixels";
  EXPECT_GT(coarse, 0.1);
}

} // namespace
} // namespace limn
