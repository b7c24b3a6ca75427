// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray meets, against closed forms and against the pictures of the reference (DEFINITION section 7).
#include "reference/ProfileAlong.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/ProjectionFacts.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/JudgedTime.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numeric>

namespace limn {
namespace {

// The step of a profile in a volume of 1 mm voxels, mm.
constexpr double pieceMm = 0.25;

RayProfile profileOf(const Scene& scene) {
  const GradientScale scale = gradientScale(*scene.volume, scene.shading);
  return profileAlong(scene, scale, rayThroughPixel(scene.camera, 0, 0, {1, 1})).value();
}

double givenBy(const RayProfile& profile, double fromMm, double toMm) {
  double sum = 0.0;
  for (const RayProfile::Sample& sample : profile.samples)
    sum += sample.depthMm >= fromMm && sample.depthMm < toMm ? sample.contribution : 0.0;
  return sum;
}

// The values 0 … 9 along y in voxels of 1 mm: f = depth - 1/2, constant in the outer halves of the end
// voxels.
Scene ramp() {
  std::vector<double> values(10);
  std::iota(values.begin(), values.end(), 0.0);
  return rayThrough(columnOf(values, 1.0));
}

TEST(RayProfile, ofASlabIsTheExponential) {
  Scene scene = rayThrough(boxOf({1.0, 10.0, 1.0}, 7.0));
  scene.transferFunction = constantFunction(0.2, white);
  const RayProfile profile = profileOf(scene);
  ASSERT_EQ(profile.samples.size(), 40u);
  EXPECT_NEAR(profile.lengthMm, 10.0, 1e-12);
  EXPECT_NEAR(profile.alpha, 1.0 - std::pow(0.8, 10.0), 1e-14);
  for (const RayProfile::Sample& sample : profile.samples) {
    EXPECT_EQ(sample.value, 7.0);
    EXPECT_NEAR(sample.opacityPerMm, 0.2, 1e-14);
    const double front = sample.depthMm - pieceMm / 2.0;
    EXPECT_NEAR(sample.contribution, std::pow(0.8, front) * (1.0 - std::pow(0.8, pieceMm)), 1e-13);
  }
  // Between the ends of a piece light is taken to grow evenly: a chord, off by κ·Δt²/8 of depth at most.
  const double kappa = -std::log(0.8);
  EXPECT_NEAR(halfLightDepth(profile).value(), std::log(1.0 - profile.alpha / 2.0) / -kappa,
              kappa * pieceMm * pieceMm / 8.0);
}

TEST(RayProfile, countsOpacityPerMillimetreWhateverTheUnitDistance) {
  Scene scene = rayThrough(boxOf({1.0, 10.0, 1.0}));
  scene.transferFunction = constantFunction(0.36, white, 2.0); // 0.64 = 0.8² are left behind 2 mm
  EXPECT_NEAR(profileOf(scene).samples.front().opacityPerMm, 0.2, 1e-14);
}

TEST(RayProfile, ofTwoSlabsGivesTheSecondWhatTheFirstLeaves) {
  Scene scene = ramp();
  // A step at 4.5, which is 5 mm deep: faint before it, dense behind.
  scene.transferFunction.points = {{4.5, {1, 0, 0}, 0.02}, {4.5, {1, 1, 1}, 0.3}};
  const RayProfile profile = profileOf(scene);
  const double behindFirst = std::pow(0.98, 5.0);
  EXPECT_NEAR(givenBy(profile, 0.0, 5.0), 1.0 - behindFirst, 1e-13);
  EXPECT_NEAR(givenBy(profile, 5.0, 10.0), behindFirst * (1.0 - std::pow(0.7, 5.0)), 1e-13);
  // In the second: 0.98⁵ · 0.7^(d-5) = 1 - alpha/2.
  const double kappa = -std::log(0.7);
  EXPECT_NEAR(halfLightDepth(profile).value(),
              5.0 + std::log((1.0 - profile.alpha / 2.0) / behindFirst) / -kappa,
              kappa * pieceMm * pieceMm / 8.0);
  // A veil that takes most of the light: what is dense behind it gives most at one place all the same.
  scene.transferFunction.points.front().opacity = 0.2;
  scene.transferFunction.points.back().opacity = 0.95;
  const RayProfile veiled = profileOf(scene);
  ASSERT_LT(halfLightDepth(veiled).value(), 5.0);
  EXPECT_NEAR(strongestDepth(veiled).value(), 5.0 + pieceMm / 2.0, 1e-9);
  EXPECT_EQ(sampleAt(profile, 1.0).color, glm::dvec3(1, 0, 0));
  EXPECT_EQ(sampleAt(profile, 9.0).color, glm::dvec3(1, 1, 1));
}

TEST(RayProfile, ofARampOfExtinctionIsItsIntegral) {
  Scene scene = ramp();
  scene.transferFunction = {smallUnitMm,
                            {extinctionPoint(0.0, 0.0, white), extinctionPoint(9.0, 0.09, white)}};
  const RayProfile profile = profileOf(scene);
  // κ rises by 0.01 per mm² between the centres of the end voxels and is 0.09 in the last half: the midpoint
  // rule has no error in straight pieces.
  EXPECT_NEAR(profile.alpha, -std::expm1(-(0.005 * 81.0 + 0.045)), 1e-9);
  const double tau = -std::log1p(-profile.alpha / 2.0);
  // A chord again: κ'/κ and κ are below 0.2 there.
  EXPECT_NEAR(halfLightDepth(profile).value(), 0.5 + std::sqrt(tau / 0.005), 0.2 * pieceMm * pieceMm / 8.0);
  for (const RayProfile::Sample& sample : profile.samples)
    EXPECT_NEAR(sample.value, std::clamp(sample.depthMm - 0.5, 0.0, 9.0), 1e-12);
}

TEST(RayProfile, ofAnXRayCountsWhatIsAbsorbedWhateverLiesBeforeIt) {
  Scene scene = ramp();
  scene.projection = Projection::xray;
  scene.transferFunction.points = {{4.5, {1, 0, 0}, 0.3}, {4.5, {1, 1, 1}, 0.02}};
  const RayProfile profile = profileOf(scene);
  const double first = -5.0 * std::log(0.7);
  const double second = -5.0 * std::log(0.98);
  EXPECT_NEAR(profile.alpha, -std::expm1(-first - second), 1e-13);
  EXPECT_NEAR(givenBy(profile, 5.0, 10.0), profile.alpha * second / (first + second), 1e-13);
  EXPECT_NEAR(halfLightDepth(profile).value(), 5.0 * (first + second) / 2.0 / first, 1e-9);
}

TEST(RayProfile, ofExtremesHasOneSampleThatGivesEverything) {
  Scene scene = ramp();
  scene.transferFunction.points = {{0, white, 0.1}, {9, white, 0.7}};
  scene.projection = Projection::mip;
  const RayProfile highest = profileOf(scene);
  EXPECT_NEAR(highest.alpha, 0.7, 1e-14);
  EXPECT_NEAR(halfLightDepth(highest).value(), 9.5, pieceMm); // the first sample of 9
  EXPECT_EQ(sampleAt(highest, 9.625).contribution, highest.alpha);
  scene.projection = Projection::minip;
  EXPECT_NEAR(profileOf(scene).alpha, 0.1, 1e-14);
  EXPECT_LT(halfLightDepth(profileOf(scene)).value(), 0.5);
}

TEST(RayProfile, ofAnAverageCountsAllAlikeAndHasNoHalf) {
  Scene scene = ramp();
  scene.projection = Projection::average;
  scene.transferFunction.points = {{0, white, 0.0}, {9, white, 0.9}};
  const RayProfile profile = profileOf(scene);
  EXPECT_NEAR(profile.alpha, 0.45, 1e-12); // the mean of the ramp is 4.5
  for (const RayProfile::Sample& sample : profile.samples)
    EXPECT_NEAR(sample.contribution, 0.45 / 40.0, 1e-12);
  EXPECT_FALSE(halfLightDepth(profile));
  EXPECT_FALSE(strongestDepth(profile));
}

TEST(RayProfile, ofASurfaceEndsThere) {
  Scene scene = ramp();
  scene.transferFunction = constantFunction(0.1, white);
  scene.isovalue = 4.0; // 4.5 mm deep
  scene.projection = Projection::isosurface;
  const RayProfile bare = profileOf(scene);
  EXPECT_EQ(bare.alpha, 1.0);
  EXPECT_NEAR(halfLightDepth(bare).value(), 4.5, 1e-4 * pieceMm);
  scene.projection = Projection::compositeIsosurface;
  const RayProfile covered = profileOf(scene);
  EXPECT_NEAR(covered.alpha, 1.0, 1e-14);
  EXPECT_NEAR(givenBy(covered, 0.0, 4.49), 1.0 - std::pow(0.9, 4.5), 0.1 * pieceMm);
  EXPECT_NEAR(halfLightDepth(covered).value(), 4.5, 1e-4 * pieceMm); // 0.9^4.5 = 0.62 are left for it
  EXPECT_EQ(covered.samples.back().contribution, 0.0);
  EXPECT_NEAR(covered.samples.back().value, 9.0, 1e-12);
}

TEST(RayProfile, ofNothingToSeeHasNoHalfAndOfAMissNothingAtAll) {
  Scene scene = ramp();
  scene.transferFunction.points.clear();
  EXPECT_EQ(profileOf(scene).alpha, 0.0);
  EXPECT_FALSE(halfLightDepth(profileOf(scene)));
  EXPECT_FALSE(profileAlong(scene, {}, {{30.0, -50.0, 0.0}, {0.0, 1.0, 0.0}}));
  EXPECT_FALSE(profileAlong(scene, {}, {{0.0, 50.0, 0.0}, {0.0, 1.0, 0.0}})); // looking away
  EXPECT_FALSE(profileAlong(Scene{}, {}, {}));
}

// A head under everything that changes opacities: model, gradient curve, crop, region, perspective.
Scene head() {
  Scene scene;
  scene.volume = phantomVolume({8.0, 0.0, 1});
  scene.camera = orbited(defaultCamera(scene.volume->grid()), 0.5, 0.3);
  scene.transferFunction = skinMuscleBone();
  scene.shading.model = ShadingModel::enhanced;
  scene.shading.opacityRange = {0.4, 2.0};
  scene.gradientOpacity = GradientOpacity{{{0.0, 0.5}, {40.0, 1.0}}};
  scene.crop.upper = {0.8, 1.0, 0.9};
  scene.keep = cubesRegion(scene.volume->grid().dims, 4, {1.0, 0.3});
  scene.quality.stepVoxels = 0.25;
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.earlyTermination = 1.0;
  return scene;
}

constexpr glm::ivec2 pictureSize(18, 22);

double alphaAlong(const Scene& scene, const GradientScale& scale, int x, int y) {
  const auto profile = profileAlong(scene, scale, rayThroughPixel(scene.camera, x, y, pictureSize));
  return profile ? profile->alpha : 0.0;
}

TEST(RayProfile, addsUpToThePixelOfEveryProjection) {
  Scene scene = head();
  scene.isovalue = 300.0;
  const GradientScale scale = gradientScale(*scene.volume, scene.shading);
  for (const Projection projection :
       {Projection::composite, Projection::mip, Projection::minip, Projection::average, Projection::xray,
        Projection::isosurface, Projection::compositeIsosurface}) {
    scene.projection = projection;
    const ReferencePicture picture = renderReference(scene, pictureSize, 1);
    int covered = 0;
    for (int i = 0; i < pictureSize.x * pictureSize.y; ++i) {
      const double alpha = picture.pixels[static_cast<std::size_t>(i)].a;
      covered += alpha > 0.01 ? 1 : 0;
      // The same samples, from another origin: places differ by rounding, and rays that graze a corner of the
      // box by a sample.
      EXPECT_NEAR(alphaAlong(scene, scale, i % pictureSize.x, i / pictureSize.x), alpha, 1e-9)
          << "projection " << static_cast<int>(projection) << ", pixel " << i;
    }
    // The least along nearly every ray is air.
    EXPECT_GT(covered, projection == Projection::minip ? -1 : 20) << static_cast<int>(projection);
  }
}

TEST(RayProfile, liesWithinEarlyTerminationAndStepOfThePictureAsItIsDrawn) {
  const Scene exact = head();
  Scene drawn = exact;
  drawn.quality = {};
  const GradientScale scale = gradientScale(*exact.volume, exact.shading);
  const ReferencePicture fine = renderReference(exact, pictureSize, 1);
  const ReferencePicture picture = renderReference(drawn, pictureSize, 1);
  for (int i = 0; i < pictureSize.x * pictureSize.y; ++i) {
    const auto pixel = static_cast<std::size_t>(i);
    const double step = std::abs(fine.pixels[pixel].a - picture.pixels[pixel].a);
    EXPECT_NEAR(alphaAlong(drawn, scale, i % pictureSize.x, i / pictureSize.x), picture.pixels[pixel].a,
                step + 1.0 - drawn.quality.earlyTermination);
  }
}

// The chart follows the pointer: the longest ray of a chest, every piece of which reads its gradient.
TEST(RayProfile, ofAChestTakesLessThanAFrame) {
  Grid grid;
  grid.dims = {512, 512, 300};
  grid.spacingMm = {0.7, 0.7, 1.0};
  std::vector<std::int16_t> stored(static_cast<std::size_t>(512) * 512 * 300);
  for (std::size_t i = 0; i < stored.size(); ++i)
    stored[i] = static_cast<std::int16_t>(i % 1713);
  Scene scene;
  scene.volume =
      std::make_shared<const Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
  scene.transferFunction = constantFunction(0.001, white);
  scene.shading.model = ShadingModel::enhanced;
  const Ray diagonal{indexToWorld(grid, {-10, -10, -6}),
                     glm::normalize(glm::dvec3(512 * 0.7, 512 * 0.7, 300))};
  double shortest = 1e9;
  std::size_t pieces = 0;
  for (int repeat = 0; repeat < 5; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    pieces = profileAlong(scene, {1000.0, 1000.0}, diagonal)->samples.size();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    shortest = std::min(shortest, taken.count());
  }
  EXPECT_GT(pieces, 3000u);
  test::judgeMs("the profile of the longest ray of a chest", shortest, 16.0);
}

} // namespace
} // namespace limn
