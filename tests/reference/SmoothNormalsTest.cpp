// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth normals in the reference (DEFINITION section 2): its own smoothed field against that of the engines,
// what follows it and what stays, and where it is neutral.
#include "reference/ProfileAlong.h"
#include "reference/ReferenceIntegrator.h"
#include "reference/SmoothedField.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"
#include "scene/light/Gradient.h"
#include "scene/light/GradientField.h"
#include "scene/light/GradientSmoothing.h"
#include "scene/steps/RayFrame.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

constexpr glm::ivec2 smoothPicture{40, 36};

Scene smoothHead(ShadingModel model, double sigmaMm) {
  Scene scene = headScene(phantomVolume({.spacingMm = 5.0}), model);
  scene.camera = orbited(scene.camera, 0.4, 0.3);
  scene.shading.gradientSmoothing = sigmaMm;
  return scene;
}

TEST(SmoothNormals, theFieldInDoubleIsThatOfTheEnginesInFloats) {
  const auto volume = phantomVolume({.spacingMm = 4.0, .noiseHu = 30.0});
  const double width = volume->range().highest - volume->range().lowest;
  for (const double sigma : {1.5, 6.0}) {
    const Volume exact = smoothedField(*volume, sigma);
    const auto fast = smoothedVolume(volume, sigma);
    double largest = 0.0;
    for (int k = 0; k < volume->grid().dims.z; ++k)
      for (int j = 0; j < volume->grid().dims.y; ++j)
        for (int i = 0; i < volume->grid().dims.x; ++i)
          largest = std::max(largest, std::abs(exact.value({i, j, k}) - fast->value({i, j, k})));
    EXPECT_LE(largest, 0x1p-22 * width); // what floats of which a few are added up are off by
    EXPECT_EQ(exact.range(), volume->range());
    // The steepest of it follows: two such values over two spacings, along three axes.
    EXPECT_NEAR(largestGradient(exact), largestGradient(*fast), 2.0 * 0x1p-22 * width / 4.0);
    EXPECT_LT(largestGradient(exact), 0.9 * largestGradient(*volume));
  }
}

TEST(SmoothNormals, finerThanAVoxelAreNoneToTheLastBit) {
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced}) {
    const auto without = renderReference(smoothHead(model, 0.0), smoothPicture);
    // 3σ of 1.66 mm is less than the 5 mm to the next voxel.
    EXPECT_EQ(renderReference(smoothHead(model, 1.66), smoothPicture).pixels, without.pixels);
    EXPECT_NE(renderReference(smoothHead(model, 1.67), smoothPicture).pixels, without.pixels);
  }
}

TEST(SmoothNormals, areAskedForWhereSomethingReadsTheGradient) {
  Scene scene = smoothHead(ShadingModel::classic, 6.0);
  EXPECT_TRUE(smoothsNormals(scene));
  EXPECT_TRUE(requiredEffects(scene, {}).effects.has(Effect::smoothNormals));
  for (const Projection projection :
       {Projection::mip, Projection::minip, Projection::average, Projection::xray}) {
    Scene other = scene;
    other.projection = projection;
    EXPECT_FALSE(smoothsNormals(other));
    EXPECT_FALSE(requiredEffects(other, {}).effects.has(Effect::smoothNormals));
  }
  scene.shading.model = ShadingModel::none;
  EXPECT_FALSE(requiredEffects(scene, {}).effects.has(Effect::smoothNormals));
  scene.gradientOpacity = GradientOpacity{{{0.0, 0.0}, {50.0, 1.0}}};
  EXPECT_TRUE(requiredEffects(scene, {}).effects.has(Effect::smoothNormals));
}

TEST(SmoothNormals, moveNoSurfaceAndChangeNoOpacityByThemselves) {
  // Under classic light nothing of alpha depends on the gradient.
  const auto without = renderReference(smoothHead(ShadingModel::classic, 0.0), smoothPicture);
  const auto with = renderReference(smoothHead(ShadingModel::classic, 8.0), smoothPicture);
  std::size_t lit = 0;
  for (std::size_t i = 0; i < with.pixels.size(); ++i) {
    EXPECT_EQ(with.pixels[i].a, without.pixels[i].a);
    lit += glm::dvec3(with.pixels[i]) != glm::dvec3(without.pixels[i]) ? 1 : 0;
  }
  EXPECT_GT(lit, 200u);
}

// A ball of radius 30 mm whose scalar falls linearly with the distance from its middle, in slices that are
// thick: between them the field is linear, so its normals have terraces.
std::shared_ptr<const Volume> thickBall() {
  Grid grid;
  grid.dims = {64, 64, 11};
  grid.spacingMm = {1.0, 1.0, 7.0};
  std::vector<float> voxels;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const double away = glm::length(glm::dvec3(i - 31.5, j - 31.5, (k - 5) * 7.0));
        voxels.push_back(static_cast<float>(std::clamp(100.0 * (30.0 - away), -100.0, 100.0)));
      }
  return std::make_shared<const Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{});
}

// By how much normals of `lit` at the surface differ from those of the ball, RMS in degrees.
double offBall(const Volume& volume, const Volume& lit) {
  double sum = 0.0;
  int count = 0;
  for (double z = -14.0; z <= 14.0; z += 0.5)
    for (double angle = 0.05; angle < 6.28; angle += 0.1) {
      // Where the linear interpolation between slices has its surface.
      const glm::dvec2 towards(std::cos(angle), std::sin(angle));
      double inside = 10.0, outside = 40.0;
      const auto indexAt = [&](double across) {
        return glm::dvec3(31.5 + across * towards.x, 31.5 + across * towards.y, 5.0 + z / 7.0);
      };
      for (int n = 0; n < 40; ++n) {
        const double middle = 0.5 * (inside + outside);
        (valueAt(volume, indexAt(middle)) > 0.0 ? inside : outside) = middle;
      }
      const glm::dvec3 normal = -glm::normalize(gradientAt(lit, indexAt(inside)));
      const glm::dvec3 ofBall = glm::normalize(glm::dvec3(inside * towards, z));
      sum += std::pow(glm::degrees(std::acos(std::clamp(glm::dot(normal, ofBall), -1.0, 1.0))), 2.0);
      ++count;
    }
  return std::sqrt(sum / count);
}

TEST(SmoothNormals, takeTheTerracesOfThickSlicesOffABall) {
  const auto volume = thickBall();
  const double without = offBall(*volume, *volume),
               with = offBall(*volume, *smoothedVolume(volume, 0.7 * 7.0));
  std::cout << "normals of a ball of radius 30 mm in slices of 7 mm are off by " << without
            << " degrees, smooth by " << with << "\n";
  EXPECT_GT(without, 6.0);
  EXPECT_LT(with, 0.5 * without);
}

TEST(SmoothNormals, ofOneRayAreThoseOfThePicture) {
  // An enhanced ray reads r, gmax and the normal: its contributions add up to the pixel's alpha.
  Scene scene = smoothHead(ShadingModel::enhanced, 6.0);
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.earlyTermination = 1.0;
  const auto picture = renderReference(scene, smoothPicture);
  GradientField field;
  field.update(scene.volume, scene.shading.gradientSmoothing);
  const GradientScale scale = field.scale(scene.shading, true);
  const glm::ivec2 pixel{20, 18};
  const auto profile =
      profileAlong(scene, scale, rayThroughPixel(scene.camera, pixel.x, pixel.y, smoothPicture));
  ASSERT_TRUE(profile.has_value());
  const double alpha = picture.pixels[static_cast<std::size_t>(pixel.y) * smoothPicture.x + pixel.x].a;
  EXPECT_GT(alpha, 0.1);
  // Both take the same steps; the scale comes from floats.
  EXPECT_NEAR(profile->alpha, alpha, 1e-4);
}

TEST(SmoothNormals, picturesSideBySideKeepTheirOwnField) {
  const std::shared_ptr<const Volume> volume = smoothHead(ShadingModel::classic, 6.0).volume;
  GradientField field;
  field.update(volume, 6.0);
  const std::shared_ptr<const Volume> one = field.smoothed();
  const std::size_t bytes = field.ownBytes();
  field.update(volume, 3.0);
  const std::shared_ptr<const Volume> other = field.smoothed();
  EXPECT_NE(one, other);
  EXPECT_EQ(field.ownBytes(), 2 * bytes);
  for (int turn = 0; turn < 2; ++turn) { // they take turns, and nothing is smoothed anew
    field.update(volume, 6.0);
    EXPECT_EQ(field.smoothed(), one);
    field.update(volume, 3.0);
    EXPECT_EQ(field.smoothed(), other);
  }
  field.update(volume, 1.0); // the one that was asked for longest ago makes room
  EXPECT_EQ(field.ownBytes(), 2 * bytes);
  field.update(volume, 3.0);
  EXPECT_EQ(field.smoothed(), other);
  field.update(volume, 6.0);
  EXPECT_NE(field.smoothed(), one);
  field.update(volume, 0.0);
  EXPECT_EQ(field.smoothed(), nullptr);
}

// Memory for one field alone: pictures side by side smooth anew at each turn. Memory for none is said.
TEST(SmoothNormals, takeTheMemoryThereIsOrSayThatThereIsNone) {
  const std::shared_ptr<const Volume> volume = smoothHead(ShadingModel::classic, 6.0).volume;
  const std::uint64_t each = volume->voxelCount() * sizeof(float);
  std::uint64_t all = each;
  GradientField field([&]() -> std::optional<std::uint64_t> { return all - field.ownBytes(); });
  field.update(volume, 6.0);
  const std::shared_ptr<const Volume> one = field.smoothed();
  ASSERT_NE(one, nullptr);
  field.update(volume, 3.0);
  EXPECT_EQ(field.ownBytes(), each);
  field.update(volume, 6.0);
  EXPECT_EQ(field.ownBytes(), each);
  EXPECT_TRUE(field.smoothed()->stored() == one->stored()) << "as before";
  all = 2 * each;
  field.update(volume, 3.0);
  EXPECT_EQ(field.ownBytes(), 2 * each) << "again there is room for both";
  // Whoever draws holds a field until it has the next one, which takes its place then.
  std::uint64_t free = each;
  GradientField drawn([&]() -> std::optional<std::uint64_t> { return free; });
  drawn.update(volume, 6.0);
  std::shared_ptr<const Volume> held = drawn.smoothed();
  free = 0;
  drawn.update(volume, 3.0);
  EXPECT_NE(drawn.smoothed(), nullptr);
  held.reset();
  EXPECT_THROW(drawn.update(volume, 4.0), Error);
  all = each - 1;
  GradientField another([&]() -> std::optional<std::uint64_t> { return all; });
  try {
    another.update(volume, 6.0);
    FAIL() << "made without memory";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("close other programs"), std::string::npos) << error.what();
  }
  EXPECT_EQ(another.ownBytes(), 0u);
  EXPECT_EQ(another.smoothed(), nullptr);
  another.update(volume, 0.0); // as the field is they need none
}

} // namespace
} // namespace limn
