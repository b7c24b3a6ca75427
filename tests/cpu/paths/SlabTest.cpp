// SPDX-License-Identifier: GPL-3.0-or-later
// Random paths against closed forms of radiative transfer (DEFINITION section 12): slabs, half-spaces,
// furnaces, single scattering. Fixed seeds; four standard errors are exceeded by chance in one of 16,000.
#include "cpu/CpuRenderer.h"
#include "cpu/paths/SlabPaths.h"
#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

#include <numbers>

namespace limn {
namespace {

using test::PathsOf;
using test::slabScene;
using test::Tally;

// The radiance that paths of the one pixel find; 0 where they meet nothing.
Tally pixelLight(const Scene& scene, int paths) {
  const PathsOf of(scene);
  const cpu::LinearSky sky{of.paths};
  const cpu::PathTracer<float> tracer(of.paths, sky);
  const cpu::PathStart start = cpu::pathStart(of.paths, of.terms, 0, 0);
  Tally tally;
  for (int n = 0; n < paths; ++n) {
    cpu::PathRandom random(5, 0, 0, static_cast<std::uint32_t>(n));
    const auto radiance = tracer.radiance(start, random);
    tally.add(radiance ? double(radiance->r) : 0.0);
  }
  return tally;
}

// Under a key of irradiance π along the normal and no sky: the mean is πI/E.
Scene underKey(double albedo, double depth) {
  Scene scene = slabScene(albedo, depth, 0.0);
  scene.shading.lightDirection = glm::dvec3(0.0, 0.0, -1.0);
  scene.shading.physical.keyIrradiance = std::numbers::pi;
  scene.shading.physical.sky = {0.0, 0.0};
  return scene;
}

// Seen, or lit, so far from the normal.
glm::dvec3 tilted(double cosine) {
  return {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
}

TEST(PathSlabs, sendOnWhatAddingDoublingSays) {
  EXPECT_LT(test::largestSlabZ(40'000), 4.0);
}

TEST(PathSlabs, areToldFromScatteringOnePercentTooStrong) {
  // A phase function whose integral is 1.01 scatters as an albedo so much larger does.
  EXPECT_GT(test::largestSlabZ(40'000, 1.01), 4.0);
}

TEST(PathSlabs, halfSpacesAreAsBrightAsChandrasekharSays) {
  // πI/E = a H(μ) H(μ₀) / (4(μ+μ₀)), both along the normal.
  const struct {
    double albedo, depth, expected;
  } rows[] = {{0.5, 30.0, 0.097853}, {0.9, 60.0, 0.385073}, {0.99, 200.0, 0.756698}};
  for (const auto& row : rows)
    EXPECT_LT(std::abs(pixelLight(underKey(row.albedo, row.depth), 100'000).z(row.expected)), 4.0)
        << row.albedo;
}

TEST(PathSlabs, cameraAndLightMayChangePlaces) {
  // a H(1) H(½) / (4 · 1.5) where the camera is tilted; times the cosine where the light is, as an irradiance
  // is told of a face turned to it.
  const double expected = 0.9 * 1.850099 * 1.556034 / 6.0;
  Scene scene = underKey(0.9, 60.0);
  scene.camera.position = 100.0 * tilted(0.5);
  EXPECT_LT(std::abs(pixelLight(scene, 200'000).z(expected)), 4.0);
  scene = underKey(0.9, 60.0);
  scene.shading.lightDirection = -tilted(0.5);
  EXPECT_LT(std::abs(pixelLight(scene, 200'000).z(0.5 * expected)), 4.0);
}

TEST(PathSlabs, scatterOnceAsTheClosedFormSays) {
  // Of an albedo so small a second event adds a ten-thousandth: πI/E = a/8 · (1 - exp(-2τ)).
  constexpr double albedo = 1e-4;
  Scene scene = underKey(albedo, 1.0);
  const double isotropic = albedo / 8.0 * -std::expm1(-2.0);
  EXPECT_LT(std::abs(pixelLight(scene, 200'000).z(isotropic)), 4.0);
  // Backwards Henyey and Greenstein send (1-g²)/(1+g)³ = (1-g)/(1+g)² of what isotropic tissue does.
  scene.shading.physical.anisotropy = 0.6;
  EXPECT_LT(std::abs(pixelLight(scene, 200'000).z(isotropic * 0.4 / 2.56)), 4.0);
  // A disc as wide as is allowed has the irradiance that it says: on a black half-space with one event of
  // isotropic tissue πI/E₀ = a/4 · F ∫ 1/(1+μ) over its directions, F its fluence.
  scene = underKey(albedo, 60.0);
  scene.shading.physical.keyRadiusDeg = 45.0;
  const double c = std::sqrt(0.5);
  const double fluence = 2.0 / (1.0 + c);
  const double mean = (1.0 - c + std::log((1.0 + c) / 2.0)) / (1.0 - c); // of μ/(1+μ), evenly over the cone
  EXPECT_LT(std::abs(pixelLight(scene, 200'000).z(albedo / 4.0 * fluence * mean)), 4.0);
}

TEST(PathFurnaces, halfSpacesInAGreyOneShowWhatTheyDoNotAbsorb) {
  // 1 - H(μ) √(1-a).
  EXPECT_LT(std::abs(pixelLight(slabScene(0.9, 60.0, 0.0), 100'000).z(0.414947)), 4.0);
}

// A head as white as can be under a sky of 1 alone.
Scene whiteHead(double density) {
  Scene scene = headScene(phantomVolume({.spacingMm = 8.0}), ShadingModel::physical);
  for (ControlPoint& point : scene.transferFunction.points)
    point.color = glm::dvec3(1.0);
  PhysicalLight& light = scene.shading.physical;
  light.density = density;
  light.anisotropy = 0.4;
  light.surface = 0.0;
  light.keyIrradiance = 0.0;
  light.sky = {1.0, 1.0};
  light.until = UntilPaths{64};
  return scene;
}

TEST(PathFurnaces, whiteTissueUnderAWhiteSkyCannotBeSeen) {
  for (const double density : {0.05, 1.0, 100.0}) {
    const Scene scene = whiteHead(density);
    CpuRenderer renderer;
    renderer.render(scene, {24, 24});
    const Image radiance = *renderer.radiance(scene, {24, 24});
    Tally tally;
    int covered = 0;
    for (const glm::vec4& pixel : radiance.pixels)
      if (pixel.a > 1.0f / 510.0f) {
        ++covered;
        tally.add(double(pixel.r) / double(pixel.a));
      }
    EXPECT_GT(covered, 60);
    // Paths that end by chance make the only noise; where there are none all is 1 to the last digits.
    EXPECT_NEAR(tally.mean(), 1.0, std::max(3.0 * tally.error(), 1e-5)) << density;
  }
}

TEST(PathFurnaces, surfacesMakeNoLight) {
  for (const double share : {0.0, 0.1, 1.0}) {
    Scene scene = whiteHead(1.0);
    scene.shading.physical.surface = 1.0;
    scene.shading.physical.specularShare = share;
    CpuRenderer renderer;
    renderer.render(scene, {24, 24});
    const Image radiance = *renderer.radiance(scene, {24, 24});
    Tally tally;
    for (const glm::vec4& pixel : radiance.pixels)
      if (pixel.a > 1.0f / 510.0f)
        tally.add(double(pixel.r) / double(pixel.a));
    EXPECT_LE(tally.mean(), 1.0 + 3.0 * tally.error()) << share;
    EXPECT_GT(tally.mean(), 0.3) << share;
  }
}

} // namespace
} // namespace limn
