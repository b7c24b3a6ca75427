// SPDX-License-Identifier: GPL-3.0-or-later
// Kept regions in the reference against closed forms (DEFINITION section 10).
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/StableMath.h"
#include "stability/scenes/SimpleScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

// A column of 1 mm voxels along y, everywhere of one opacity a millimetre, with one weight a voxel.
Scene columnWith(const std::vector<double>& weights, double opacity = 0.3) {
  Scene scene = rayThrough(columnOf(std::vector<double>(weights.size(), 1.0), 1.0));
  scene.transferFunction = constantFunction(opacity, white);
  const glm::ivec3 dims = scene.volume->grid().dims;
  std::vector<Label> labels;
  std::vector<std::uint8_t> places;
  for (int i = 0; i < dims.y; ++i) {
    labels.push_back({i, "", glm::dvec3(1.0)});
    for (int k = 0; k < dims.x * dims.z; ++k)
      places.push_back(static_cast<std::uint8_t>(i));
  }
  scene.keep = {Region::Kind::labels, "", std::make_shared<const LabelMap>(dims, places, labels), weights};
  scene.quality.stepVoxels = 1.0 / 64.0;
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

glm::dvec4 pixelOf(const Scene& scene) {
  return renderReference(scene, {1, 1}, 1).pixels[0];
}

// ∫ -ln(1 - a w) dw over w in 0..1: the depth of the millimetre over which a weight rises to 1.
double depthOfRamp(double a) {
  return ((1.0 - a) * std::log1p(-a) + a) / a;
}

TEST(ReferenceRegion, aHalfWeightHalvesTheOpacityOverTheUnitDistance) {
  const double depth = -8.0 * std::log1p(-0.15);
  EXPECT_NEAR(pixelOf(columnWith(std::vector<double>(8, 0.5))).a, -std::expm1(-depth), 1e-14);
}

TEST(ReferenceRegion, aSlabThatIsKeptFadesOverTheMillimetreBesideIt) {
  // 4 kept voxels: the weight rises over 1 mm, is 1 over 3 mm, and falls over 1 mm.
  const Scene scene = columnWith({0, 0, 1, 1, 1, 1, 0, 0});
  const double depth = -3.0 * std::log1p(-0.3) + 2.0 * depthOfRamp(0.3);
  // Midpoints of 1/64 mm err by at most κ''/24 h² over the 2 mm of the ramps, κ'' = a²/(1-a)².
  EXPECT_NEAR(pixelOf(scene).a, -std::expm1(-depth), 2.0 * 0.09 / 0.49 / 24.0 / 64.0 / 64.0);
}

TEST(ReferenceRegion, voxelsThatTakeTurnsGiveAsManyRamps) {
  // 1 0 1 0 1 0 1: six ramps between seven centres, and half a voxel of weight 1 at either end.
  const Scene scene = columnWith({1, 0, 1, 0, 1, 0, 1});
  const double depth = -1.0 * std::log1p(-0.3) + 6.0 * depthOfRamp(0.3);
  EXPECT_NEAR(pixelOf(scene).a, -std::expm1(-depth), 6.0 * 0.09 / 0.49 / 24.0 / 64.0 / 64.0);
}

TEST(ReferenceRegion, preintegratedAndErrorControlledStepsSeeTheSame) {
  Scene scene = columnWith({0, 0, 1, 1, 1, 1, 0, 0});
  const double expected = -std::expm1(3.0 * std::log1p(-0.3) - 2.0 * depthOfRamp(0.3));
  scene.quality.preintegrated = Preintegration::always;
  EXPECT_NEAR(pixelOf(scene).a, expected, 1e-5);
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.toleranceLevels = 0.1;
  EXPECT_NEAR(pixelOf(scene).a, expected, 0.1 / 255.0);
}

TEST(ReferenceRegion, anXRayAbsorbsByTheWeightAlone) {
  Scene scene = columnWith(std::vector<double>(8, 0.5));
  scene.projection = Projection::xray;
  scene.shading.model = ShadingModel::enhanced; // O does not count
  scene.shading.opacityRange = {3.0, 3.0};
  EXPECT_NEAR(pixelOf(scene).a, -std::expm1(8.0 * std::log1p(-0.15)), 1e-14);
}

// Values 0 … 7 along the ray.
Scene stairs(const std::vector<double>& weights, Projection projection) {
  Scene scene = columnWith(weights);
  scene.volume = columnOf({0, 1, 2, 3, 4, 5, 6, 7}, 1.0);
  scene.transferFunction.points = {{0.0, white, 0.0}, {7.0, white, 0.7}};
  scene.projection = projection;
  return scene;
}

TEST(ReferenceRegion, maximumAndMinimumTakeTheSamplesThatAreKept) {
  // Kept where the weight is at least half: from 1.5 to 4.5.
  const std::vector<double> weights{0, 0, 1, 1, 1, 0, 0, 0};
  EXPECT_NEAR(pixelOf(stairs(weights, Projection::mip)).a, 0.45, 0.1 / 64.0);
  EXPECT_NEAR(pixelOf(stairs(weights, Projection::minip)).a, 0.15, 0.1 / 64.0);
  EXPECT_NEAR(pixelOf(stairs(weights, Projection::average)).a, 0.3, 0.1 / 64.0);
}

TEST(ReferenceRegion, aRayThatKeepsNoSampleIsEmpty) {
  const std::vector<double> weights(8, 0.49);
  for (const Projection projection : {Projection::mip, Projection::minip, Projection::average})
    EXPECT_EQ(pixelOf(stairs(weights, projection)), glm::dvec4(0.0));
}

TEST(ReferenceRegion, aSurfaceIsHitOnlyInWhatIsKept) {
  // The isovalue is reached at 2, what is kept begins at 4.5: the hit lies there, in linear fog.
  Scene scene = stairs({0, 0, 0, 0, 0, 1, 1, 1}, Projection::isosurface);
  scene.isovalue = 2.0;
  scene.shading.model = ShadingModel::none;
  const glm::dvec4 kept = pixelOf(scene);
  EXPECT_EQ(kept.a, 1.0);
  scene.keep.weights.assign(8, 0.4);
  EXPECT_EQ(pixelOf(scene), glm::dvec4(0.0));
  scene.keep.weights = {0, 0, 0, 0, 0, 1, 1, 1};
  const double behindEntry = 5.0; // from the box's face at -0.5 to index 4.5
  const double eye = glm::length(scene.camera.position - boxCentreMm(scene.volume->grid()));
  const double face = eye - 4.0;
  scene.fog = distanceFog(face, face + 8.0);
  scene.fog.color = glm::dvec3(0.0);
  scene.transferFunction = constantFunction(0.7, white);
  EXPECT_NEAR(pixelOf(scene).r, 1.0 - behindEntry / 8.0, 1e-4);
}

} // namespace
} // namespace limn
