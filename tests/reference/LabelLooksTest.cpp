// SPDX-License-Identifier: GPL-3.0-or-later
// Looks of labels in the reference (DEFINITION section 10) against closed forms, and where they are neutral.
#include "scene/LabelLooks.h"
#include "accuracy/ImageError.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/light/Shading.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/LookScenes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

const glm::dvec3 pureRed(1.0, 0.0, 0.0);
const glm::dvec3 pureGreen(0.0, 1.0, 0.0);

// Eight voxels of 1 mm and one value along y: the scene's look in the first four, another one behind.
Scene twoSlabs(const TransferFunction& first, const TransferFunction& second,
               const std::vector<double>& weights = {1.0, 1.0}) {
  Scene scene = rayThrough(columnOf(std::vector<double>(8, 1.0), 1.0));
  scene.transferFunction = first;
  const std::vector<std::uint8_t> places{0, 0, 0, 0, 1, 1, 1, 1};
  const std::vector<Label> labels{{0, "", glm::dvec3(1.0)}, {1, "", glm::dvec3(1.0)}};
  scene.keep = {Region::Kind::labels, "",
                std::make_shared<const LabelMap>(glm::ivec3(1, 8, 1), places, labels), weights};
  scene.keep = withLooks(scene.keep, {{1, second}});
  scene.quality.stepVoxels = 1.0 / 64.0;
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

glm::dvec4 lookPixel(const Scene& scene, ToTolerance way = ToTolerance::byCells) {
  return renderReference(scene, {1, 1}, 1, {}, Limiting::clampOrKnee, {}, way).pixels[0];
}

// Of 3.5 mm, the millimetre over which the share falls to nothing, and 3.5 mm: 4 mm of either look, whose
// extinctions mix.
double depthOfSlabs(double perMm, double otherPerMm) {
  return 4.0 * perMm + 4.0 * otherPerMm;
}

TEST(ReferenceLooks, twoSlabsAbsorbEachByItsOwnLookAndUnitDistance) {
  const Scene scene = twoSlabs(constantFunction(0.3, pureRed), constantFunction(0.2, pureGreen, 2.5));
  // Extinction is linear along the ray, which midpoints integrate exactly.
  const double depth = depthOfSlabs(-std::log1p(-0.3), -std::log1p(-0.2) / 2.5);
  EXPECT_NEAR(lookPixel(scene).a, -std::expm1(-depth), 1e-14);
}

TEST(ReferenceLooks, whereTwoLooksAbsorbAlikeTheirColoursMixByTheirShares) {
  // The same extinction over another unit distance: light falls as exp(-κt), the share of pureRed over 1 mm
  // to 0.
  const double kappa = -std::log1p(-0.3);
  const Scene scene =
      twoSlabs(constantFunction(0.3, pureRed), constantFunction(1.0 - 0.7 * 0.7, pureGreen, 2.0));
  const double before = std::exp(-3.5 * kappa);
  const double redness = 1.0 - before + before * (1.0 - (1.0 - std::exp(-kappa)) / kappa);
  const glm::dvec4 pixel = lookPixel(scene);
  // Midpoints of 1/64 mm err by h²/24 (κ² + 2κ) κ over that millimetre.
  const double error = (kappa * kappa + 2.0 * kappa) * kappa / 24.0 / 64.0 / 64.0;
  EXPECT_NEAR(pixel.r, redness, error);
  EXPECT_NEAR(pixel.g, -std::expm1(-8.0 * kappa) - redness, error);
  EXPECT_EQ(pixel.b, 0.0);
}

TEST(ReferenceLooks, aToleranceIsKeptCellByCellAndInLocalSteps) {
  Scene scene = twoSlabs(constantFunction(0.3, pureRed), constantFunction(0.2, pureGreen, 2.5));
  const glm::dvec4 exact = lookPixel(scene);
  scene.quality.toleranceLevels = 0.1;
  for (const ToTolerance way : {ToTolerance::byCells, ToTolerance::byLocalSteps})
    for (int channel = 0; channel < 4; ++channel)
      EXPECT_NEAR(lookPixel(scene, way)[channel], exact[channel], 0.1 / 255.0);
}

TEST(ReferenceLooks, aWeightIsThatOfTheVoxelsOfTheLook) {
  // Label 1 counts half wherever it has a share, and label 0 wholly: no voxel fades its neighbour.
  const Scene scene = twoSlabs(constantFunction(0.3, pureRed), constantFunction(0.8, pureGreen), {1.0, 0.5});
  const double depth = depthOfSlabs(-std::log1p(-0.3), -std::log1p(-0.4));
  EXPECT_NEAR(lookPixel(scene).a, -std::expm1(-depth), 1e-14);
}

TEST(ReferenceLooks, anXRayAbsorbsByEachLook) {
  Scene scene = twoSlabs(constantFunction(0.3, pureRed), constantFunction(0.2, pureGreen, 2.5));
  scene.projection = Projection::xray;
  scene.shading.model = ShadingModel::enhanced; // O does not count
  scene.shading.opacityRange = {3.0, 3.0};
  const double depth = depthOfSlabs(-std::log1p(-0.3), -std::log1p(-0.2) / 2.5);
  EXPECT_NEAR(lookPixel(scene).a, -std::expm1(-depth), 1e-14);
}

TEST(ReferenceLooks, aCoefficientOfTheModelCountsBeforeAnOpacityBecomesAnExtinction) {
  Scene scene = twoSlabs(constantFunction(0.3, pureRed), constantFunction(0.2, pureGreen, 2.5));
  scene.shading.model = ShadingModel::enhanced;
  scene.shading.opacityRange = {2.0, 2.0};
  const double depth = depthOfSlabs(-std::log1p(-0.6), -std::log1p(-0.4) / 2.5);
  EXPECT_NEAR(lookPixel(scene).a, -std::expm1(-depth), 1e-14);
}

TEST(ReferenceLooks, aStepIsPreintegratedWithinOneLook) {
  for (const double weight : {1.0, 0.5})
    for (const double factor : {1.0, 0.7}) {
      Scene scene = test::rampOfFourSteps(weight);
      scene.shading.model = ShadingModel::enhanced; // no light of its own
      scene.shading.opacityRange = {factor, factor};
      const double alpha = -std::expm1(-test::depthOfFourSteps(weight, factor));
      EXPECT_NEAR(lookPixel(scene).a, alpha, 1e-14);
    }
  Scene scene = test::rampOfFourSteps(0.5);
  scene.projection = Projection::xray;
  EXPECT_NEAR(lookPixel(scene).a, -std::expm1(-test::depthOfFourSteps(0.5, 1.0)), 1e-14);
}

Scene cubesSeen(ShadingModel model, const std::vector<double>& weights) {
  Scene scene = headScene(phantomVolume({.spacingMm = 6.0}), model);
  scene.camera = orbited(scene.camera, 0.5, 0.3);
  scene.keep = cubesRegion(scene.volume->grid().dims, 5, weights);
  return scene;
}

bool drawsTheSame(const Scene& a, const Scene& b) {
  return renderReference(a, {40, 32}).pixels == renderReference(b, {40, 32}).pixels;
}

TEST(ReferenceLooks, equalLooksInAllLabelsAreOneLook) {
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust})
    for (const std::vector<double>& weights : {std::vector{1.0, 1.0, 1.0}, std::vector{1.0, 0.6, 0.0}}) {
      Scene scene = cubesSeen(model, weights);
      const TransferFunction look = shifted(scene.transferFunction, 40.0);
      scene.keep = withLooks(scene.keep, {{0, look}, {1, look}, {2, look}});
      ASSERT_EQ(scene.keep.looks.size(), 1u);
      ASSERT_TRUE(hasLabelLooks(scene));
      Scene one = scene;
      one.keep = withLooks(scene.keep, {});
      one.transferFunction = look;
      for (const Preintegration choice : {Preintegration::never, Preintegration::always}) {
        one.quality.preintegrated = scene.quality.preintegrated = choice;
        const ImageError error =
            imageError(toImage(renderReference(scene, {40, 32})), toImage(renderReference(one, {40, 32})));
        EXPECT_LE(error.largest, 0.05);
      }
    }
}

TEST(ReferenceLooks, whatNoVoxelShowsChangesNoBit) {
  const Scene plain = cubesSeen(ShadingModel::robust, {1.0, 0.0, 0.4});
  const TransferFunction other = shifted(plain.transferFunction, 60.0);
  // The scene's own function; a label that weighs nothing; a label that no voxel has.
  Scene scene = plain;
  scene.keep = withLooks(plain.keep, {{2, plain.transferFunction}});
  EXPECT_FALSE(hasLabelLooks(scene));
  EXPECT_TRUE(drawsTheSame(scene, plain));
  scene.keep = withLooks(plain.keep, {{1, other}});
  EXPECT_FALSE(hasLabelLooks(scene));
  EXPECT_TRUE(drawsTheSame(scene, plain));
  std::vector<Label> labels = plain.keep.labels->labels();
  labels.push_back({3, "nowhere", glm::dvec3(1.0)});
  scene.keep.labels =
      std::make_shared<const LabelMap>(plain.keep.labels->dims(), plain.keep.labels->places(), labels);
  scene.keep.weights.push_back(1.0);
  scene.keep = withLooks(scene.keep, {{3, other}});
  EXPECT_FALSE(hasLabelLooks(scene));
  EXPECT_TRUE(drawsTheSame(scene, plain));
}

TEST(ReferenceLooks, whatTakesOneValueOfARayKnowsNoLooks) {
  for (const Projection projection :
       {Projection::mip, Projection::minip, Projection::average, Projection::isosurface}) {
    Scene plain = cubesSeen(ShadingModel::classic, {1.0, 1.0, 1.0});
    plain.projection = projection;
    Scene scene = plain;
    scene.keep = withVariedLooks(plain.keep, plain.transferFunction);
    EXPECT_TRUE(drawsTheSame(scene, plain));
  }
}

TEST(ReferenceLooks, finerStepsCellsAndLocalStepsMeetOnAnObliqueGridWithCutsAndFog) {
  Scene scene = cubesSeen(ShadingModel::robust, {1.0, 0.5, 0.0, 1.0});
  Grid grid = scene.volume->grid();
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), 0.4, glm::normalize(glm::dvec3(1.0, 2.0, 0.5))));
  grid.direction = turn * grid.direction;
  scene.volume = std::visit(
      [&](const auto& stored) {
        return std::make_shared<const Volume>(grid, stored, scene.volume->rescale(), std::nullopt,
                                              VolumeInfo{});
      },
      scene.volume->stored());
  scene.camera = orbited(defaultCamera(grid), 0.3, 0.2);
  scene.keep = withVariedLooks(scene.keep, scene.transferFunction);
  scene.crop = {{0.1, 0.2, 0.0}, {0.9, 1.0, 0.8}};
  scene.fog = distanceFog(300.0, 700.0);
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.stepVoxels = 1.0 / 64.0;
  const Image fine = toImage(renderReference(scene, {32, 28}));
  scene.quality.toleranceLevels = 0.25;
  scene.quality.fineness = 10.0;
  for (const ToTolerance way : {ToTolerance::byCells, ToTolerance::byLocalSteps}) {
    const Image image = toImage(renderReference(scene, {32, 28}, 0, {}, Limiting::clampOrKnee, {}, way));
    const ImageError error = imageError(image, fine);
    EXPECT_LE(error.p99_9, 0.25) << "levels asked for";
    EXPECT_LE(error.mean, 0.05);
  }
}

} // namespace
} // namespace limn
