// SPDX-License-Identifier: GPL-3.0-or-later
// A tolerance kept cell by cell: closed forms, edges and needles of the function, and errors that fall with
// the fineness.
#include "reference/CellMarch.h"

#include "accuracy/ImageError.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/volume/Phantom.h"
#include "support/AnalyticScenes.h"
#include "support/Heads.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

// A ray along a ramp whose function shows one needle, and what it absorbs.
struct NeedleScene {
  Scene scene;
  double alpha = 0.0;
};

// The needle of opacity 0.9 is `width` mm wide on the ray either side of its tip. -log(1 - a) over a from 0
// to 0.9 has the mean 1 + (0.1/0.9) log 0.1, and the unit distance makes each side half of one.
NeedleScene needleScene(double width) {
  std::vector<double> values;
  for (int i = 0; i <= 16; ++i)
    values.push_back(i);
  NeedleScene needle;
  needle.scene = test::rayThrough(test::columnOf(values, 1.0));
  const double tip = 5.3; // between voxels; a value a millimetre
  needle.scene.transferFunction = {2.0 * width,
                                   {{tip - width, glm::dvec3(1.0), 0.0},
                                    {tip, glm::dvec3(1.0), 0.9},
                                    {tip + width, glm::dvec3(1.0), 0.0}}};
  needle.alpha = -std::expm1(-(1.0 + 0.1 / 0.9 * std::log(0.1)));
  return needle;
}

ReferencePicture byCells(const Scene& scene, const glm::ivec2& size, int threads = 0) {
  const auto pixels = static_cast<std::size_t>(size.x) * size.y;
  ReferencePicture picture{size, std::vector<glm::dvec4>(pixels), std::vector<int>(pixels)};
  redrawReference(picture, scene, std::vector<std::uint8_t>(pixels, 1), threads);
  return picture;
}

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
      const glm::dvec4 pixel = byCells(scene, {1, 1}, 1).pixels[0];
      const double alpha = 1.0 - (1.0 - opacity) * (1.0 - opacity);
      EXPECT_NEAR(pixel.a, alpha, 1e-12);
      EXPECT_NEAR(pixel.g, 0.5 * alpha, 1e-12);
    }
}

TEST(CellMarch, anEdgeOfTheFunctionIsMetWhereItIs) {
  // A ramp over 16 mm, opaque from the value 1/3 on: colour by value tells where the ray stopped. κ is 16.6
  // per micrometre there, and the colour gains 2 per mm.
  std::vector<double> values;
  for (int i = 0; i <= 16; ++i)
    values.push_back(i / 16.0);
  Scene scene = test::rayThrough(test::columnOf(values, 1.0));
  scene.transferFunction = {1e-3,
                            {{1.0 / 3.0, glm::dvec3(0.0), 0.0},
                             {1.0 / 3.0, glm::dvec3(0.0), 1.0},
                             {1.0 / 3.0 + 1.0 / 32.0, glm::dvec3(1.0), 1.0}}};
  keepTolerance(scene, 12);
  const ReferencePicture picture = byCells(scene, {1, 1}, 1);
  EXPECT_NEAR(picture.pixels[0].a, 1.0, 1e-12);
  EXPECT_LT(picture.pixels[0].r, 1e-3)
      << "2 per mm, of which 1e-3/16.6 are seen, and half of a 32nd of a piece";
  EXPECT_LT(picture.samples[0], 200) << "an edge is cut at, not sampled through";
}

TEST(CellMarch, aNeedleOfTheFunctionNarrowerThanACellIsSeenWhole) {
  for (const double width : {1e-1, 1e-3, 1e-6}) {
    const NeedleScene needle = needleScene(width);
    Scene scene = needle.scene;
    keepTolerance(scene, 12);
    EXPECT_NEAR(byCells(scene, {1, 1}, 1).pixels[0].a, needle.alpha, largestPieceChange(12)) << width;
  }
}

TEST(CellMarch, everyUnitOfFinenessHalvesTheError) {
  Scene scene = test::headScene(phantomVolume({.spacingMm = 6.0}), ShadingModel::robust);
  const glm::ivec2 size(40, 40);
  keepTolerance(scene, 22);
  const ReferencePicture exact = byCells(scene, size);
  keepTolerance(scene, 2);
  const double coarse = imageError(toImage(byCells(scene, size)), exact.pixels).p99_9;
  keepTolerance(scene, 12);
  const double fine = imageError(toImage(byCells(scene, size)), exact.pixels).p99_9;
  EXPECT_LE(fine, coarse / 256.0) << "ten units: 1024, and a factor of four for so few pixels";
  EXPECT_GT(coarse, 0.1);
}

} // namespace
} // namespace limn
