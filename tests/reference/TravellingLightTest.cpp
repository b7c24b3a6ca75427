// SPDX-License-Identifier: GPL-3.0-or-later
// Light on its way in the reference (DEFINITION section 11) against closed forms, and where it is neutral.
#include "reference/LightPaths.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/light/Shading.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace limn {
namespace {

// M changed by less than a thousandth when the directions were doubled; what is left of a mean that falls as
// their number or faster is no more.
constexpr double quadrature = 1e-3;

// A light that shines along `travels` and casts shadows.
Scene underLight(std::shared_ptr<const Volume> volume, const glm::dvec3& travels, double softnessDeg) {
  Scene scene = rayThrough(std::move(volume));
  scene.shading.model = ShadingModel::classic;
  scene.shading.lightDirection = travels;
  scene.shading.shadow = {1.0, softnessDeg};
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

Scene inSurroundings(std::shared_ptr<const Volume> volume, double reachMm) {
  Scene scene = rayThrough(std::move(volume));
  scene.shading.model = ShadingModel::classic;
  scene.shading.occlusion = {1.0, reachMm};
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

// Asks the paths of light of a scene.
double pathsOf(const Scene& scene, const std::function<double(const LightPaths<double>&)>& ask) {
  const PictureTerms terms{scene, EffectSet{Effect::shadow, Effect::occlusion}};
  const PictureTerms paths = lightPathTerms(terms);
  const auto& stored = std::get<StoredVoxels<double>>(scene.volume->stored());
  const FieldSampler<double> field(*scene.volume, stored);
  return ask(LightPaths<double>(paths, field));
}

// From the centre of the box, mm.
double comesOfLight(const Scene& scene, const glm::dvec3& placeMm) {
  return pathsOf(scene, [&](const LightPaths<double>& paths) {
    return paths.ofLight(placeMm / scene.volume->grid().spacingMm);
  });
}

double comesOfSurroundings(const Scene& scene, const glm::dvec3& placeMm, const glm::dvec3& normal) {
  return pathsOf(scene, [&](const LightPaths<double>& paths) {
    return paths.ofSurroundings(placeMm / scene.volume->grid().spacingMm, normal);
  });
}

// ∫ exp(-τ/μ) μ dμ over 0..1 by Simpson's rule, which is smooth: E3(τ).
double thirdExponentialIntegral(double tau) {
  constexpr int panels = 20000;
  double sum = 0.0;
  for (int i = 1; i <= panels; ++i) {
    const double mu = double(i) / panels;
    const double weight = i == panels ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * std::exp(-tau / mu) * mu;
  }
  return sum / (3.0 * panels);
}

TEST(TravellingLight, theThirdExponentialIntegralIsTheTabledOne) {
  EXPECT_NEAR(2.0 * thirdExponentialIntegral(0.5), 0.443209, 5e-7);
  EXPECT_NEAR(2.0 * thirdExponentialIntegral(1.0), 0.219384, 5e-7);
}

TEST(TravellingLight, aSlabLetsThroughWhatItsSlantedThicknessDoes) {
  // 20 mm of it lie before the centre: along a light at the cosine 0.6 it is 20/0.6, less δ = 1.5 mm.
  const double kappa = -std::log1p(-0.05);
  for (const double cosine : {1.0, 0.6}) {
    Scene scene =
        underLight(volumeOf(centredGrid({200, 40, 40}, glm::dvec3(1.0)), [](int, int, int) { return 1.0; }),
                   {std::sqrt(1.0 - cosine * cosine), cosine, 0.0}, 0.0);
    scene.transferFunction = constantFunction(0.05, white);
    EXPECT_NEAR(comesOfLight(scene, glm::dvec3(0.0)), std::exp(-kappa * (20.0 / cosine - 1.5)), 1e-12);
  }
}

TEST(TravellingLight, aRampLetsThroughTheIntegralOfItsExtinction) {
  // f runs as y; κ = 0.001 (y + 50): from y = 0 towards -y the light passes κ over 1.5..49.5 mm. Midpoints
  // integrate what is linear exactly; the box ends half a voxel behind the outermost centres, where f stays.
  Scene scene = underLight(
      volumeOf(centredGrid({3, 100, 3}, glm::dvec3(1.0)), [](int, int j, int) { return j - 49.5; }),
      {0.0, 1.0, 0.0}, 0.0);
  scene.transferFunction = {smallUnitMm,
                            {extinctionPoint(-50.0, 0.0, white), extinctionPoint(50.0, 0.1, white)}};
  const double depth = 0.001 * (50.0 * 48.0 - 0.5 * (49.5 * 49.5 - 1.5 * 1.5)) + 0.5 * 0.0005;
  // κ is linear in f up to a relative κu/2.
  EXPECT_NEAR(comesOfLight(scene, glm::dvec3(0.0)), std::exp(-depth), 1e-6);
}

TEST(TravellingLight, underASlabTheCosineWeighsAmbientLightAsTheThirdExponentialIntegral) {
  // The centre lies 10 mm below an endless face; paths of every direction leave out the first 1.5 mm.
  for (const double kappa : {0.05, 0.1}) {
    Scene scene = inSurroundings(
        volumeOf(centredGrid({401, 20, 401}, glm::dvec3(1.0)), [](int, int, int) { return 1.0; }), 1e4);
    scene.transferFunction = constantFunction(-std::expm1(-kappa), white);
    const double expected = std::exp(1.5 * kappa) * 2.0 * thirdExponentialIntegral(10.0 * kappa);
    // What leaves through the sides (200 mm away, where exp(-κ·200) of it is left) has a weight of 0.0025.
    EXPECT_NEAR(comesOfSurroundings(scene, glm::dvec3(0.0), {0.0, -1.0, 0.0}), expected,
                quadrature + 0.0025 * std::exp(-200.0 * kappa));
  }
}

std::shared_ptr<const Volume> distances(const glm::ivec3& dims, const glm::dvec3& centreMm) {
  const Grid grid = centredGrid(dims, glm::dvec3(1.0));
  return volumeOf(grid, [&](int i, int j, int k) {
    return glm::length(glm::dvec3(i, j, k) - (glm::dvec3(dims) - 1.0) / 2.0 - centreMm);
  });
}

// Opaque as far as `radius` from the centre of distances, then clear.
TransferFunction ballOf(double radius, double opacity) {
  return {1.0, {{0.0, white, opacity}, {radius, white, opacity}, {radius, white, 0.0}}};
}

TEST(TravellingLight, atTheCentreOfABallAmbientLightIsWhatItsRadiusLeaves) {
  Scene scene = inSurroundings(distances(glm::ivec3(61), glm::dvec3(0.0)), 1e4);
  scene.transferFunction = ballOf(20.0, 0.05);
  const double kappa = -std::log1p(-0.05);
  const double expected = std::exp(-kappa * (20.0 - 1.5));
  // The radius is off by what trilinear distances are (3/8 mm²/20 mm) and by half a step of 0.25 mm.
  const double radius = 3.0 / 8.0 / 20.0 + 0.125;
  EXPECT_NEAR(comesOfSurroundings(scene, glm::dvec3(0.0), glm::dvec3(0.0)), expected,
              quadrature + kappa * radius * expected);
}

TEST(TravellingLight, aReachEndsWhatCounts) {
  Scene scene = inSurroundings(distances(glm::ivec3(61), glm::dvec3(0.0)), 11.5);
  scene.transferFunction = ballOf(20.0, 0.05);
  EXPECT_NEAR(comesOfSurroundings(scene, glm::dvec3(0.0), glm::dvec3(0.0)), std::pow(0.95, 10.0), 1e-9);
  scene.shading.occlusion.reachMm = 1.0; // before δ
  EXPECT_EQ(comesOfSurroundings(scene, glm::dvec3(0.0), glm::dvec3(0.0)), 1.0);
}

TEST(TravellingLight, beforeAnOpaqueHalfSpaceAnOpeningIsWhatTheNormalSees) {
  // Opaque where y > 0, endless but for 1 % of the half sphere: M = (1 + cos)/2 of the angle to the way out.
  const Grid grid = centredGrid({201, 21, 201}, glm::dvec3(1.0));
  Scene scene = inSurroundings(volumeOf(grid, [](int, int j, int) { return j - 10.0; }), 1e4);
  scene.transferFunction = {1.0, {{0.0, white, 0.0}, {0.0, white, 1.0}, {10.0, white, 1.0}}};
  const glm::dvec3 place(0.0, -1.0, 0.0);
  for (const double cosine : {1.0, 0.5, 0.0, -0.5}) {
    const glm::dvec3 normal(std::sqrt(1.0 - cosine * cosine), -cosine, 0.0);
    // 1 mm over a plane of 100 mm to its edge.
    EXPECT_NEAR(comesOfSurroundings(scene, place, normal), 0.5 * (1.0 + cosine), quadrature + 0.01) << cosine;
  }
  EXPECT_NEAR(comesOfSurroundings(scene, place, glm::dvec3(0.0)), 0.5, quadrature + 0.01);
}

TEST(TravellingLight, aSoftLightIsTheShareOfItsDiscThatIsSeen) {
  // The edge of an opaque quarter space, x > 0 and y < -10, cuts the disc above the centre in half.
  const Grid grid = centredGrid({121, 41, 121}, glm::dvec3(1.0));
  Scene scene = underLight(volumeOf(grid,
                                    [](int i, int j, int) {
                                      return i > 60 && j < 10 ? 1.0 : i == 60 && j < 10 ? 0.5 : 0.0;
                                    }),
                           {0.0, 1.0, 0.0}, 10.0);
  scene.transferFunction = {1.0, {{0.5, white, 0.0}, {0.5, white, 1.0}}};
  EXPECT_NEAR(comesOfLight(scene, glm::dvec3(0.0)), 0.5, quadrature + 0.01);
  EXPECT_NEAR(comesOfLight(scene, {-5.0, 0.0, 0.0}), 1.0, 1e-9); // farther than 20 tan(10°)
  EXPECT_NEAR(comesOfLight(scene, {8.0, 0.0, 0.0}), 0.0, 1e-6);  // paths end where a millionth is left
}

TEST(TravellingLight, whatIsCroppedOrRemovedStopsNoLight) {
  // A ball 20 mm towards the light; 5 mm around the centre alone is left of it, then nothing.
  Scene whole = underLight(distances(glm::ivec3(81), {0.0, -20.0, 0.0}), {0.0, 1.0, 0.0}, 3.0);
  whole.transferFunction = ballOf(8.0, 0.9);
  Scene empty = whole;
  empty.transferFunction = ballOf(8.0, 0.0);
  EXPECT_LT(comesOfLight(whole, glm::dvec3(0.0)), 1e-3);
  EXPECT_EQ(comesOfLight(empty, glm::dvec3(0.0)), 1.0);
  Scene cropped = whole;
  cropped.crop.lower.y = 0.4;
  EXPECT_EQ(comesOfLight(cropped, glm::dvec3(0.0)), comesOfLight(empty, glm::dvec3(0.0)));
  Scene removed = whole;
  removed.keep = cubesRegion(whole.volume->grid().dims, 81, {0.0});
  EXPECT_EQ(comesOfLight(removed, glm::dvec3(0.0)), 1.0);
}

TEST(TravellingLight, aSurfaceStopsAllOfIt) {
  Scene scene = underLight(distances(glm::ivec3(81), {0.0, -20.0, 0.0}), {0.0, 1.0, 0.0}, 0.0);
  // A ball of what is at most 8 mm away, as a surface of its negative.
  scene.volume = volumeOf(scene.volume->grid(), [volume = scene.volume](int i, int j, int k) {
    return -volume->value({i, j, k});
  });
  scene.transferFunction = constantFunction(0.02, white);
  scene.isovalue = -8.0;
  const double alone = comesOfLight(scene, glm::dvec3(0.0));
  EXPECT_GT(alone, 0.4);
  scene.projection = Projection::compositeIsosurface;
  EXPECT_EQ(comesOfLight(scene, glm::dvec3(0.0)), 0.0);
  EXPECT_EQ(comesOfLight(scene, {10.0, 0.0, 0.0}), comesOfLight(scene, {-10.0, 0.0, 0.0}));
  EXPECT_NEAR(comesOfLight(scene, {10.0, 0.0, 0.0}), alone, 1e-12); // it passes the ball by
  scene.projection = Projection::isosurface;
  EXPECT_EQ(comesOfLight(scene, glm::dvec3(0.0)), 0.0);
  EXPECT_EQ(comesOfLight(scene, {10.0, 0.0, 0.0}), 1.0);
}

// A small head under a light from above left.
Scene litHead(ShadingModel model) {
  Scene scene = headScene(phantomVolume({.spacingMm = 8.0}), model);
  scene.shading.lightDirection = glm::dvec3(1.0, 1.0, -1.0);
  return scene;
}

constexpr glm::ivec2 headSize{12, 14};

TEST(TravellingLight, asksForNothingWhereItIsNeutral) {
  const auto pixels = [](const Scene& scene) { return renderReference(scene, headSize).pixels; };
  for (const ShadingModel model : {ShadingModel::none, ShadingModel::classic, ShadingModel::robust})
    for (const Projection projection :
         {Projection::composite, Projection::mip, Projection::xray, Projection::average}) {
      Scene plain = litHead(model);
      plain.projection = projection;
      plain.shading.lightDirection.reset();
      Scene headlight = plain;
      headlight.shading.shadow = {1.0, 10.0}; // casts none
      EXPECT_EQ(pixels(headlight), pixels(plain));
      Scene asking = headlight;
      asking.shading.occlusion = {1.0, 10.0};
      asking.shading.lightDirection = glm::dvec3(1.0, 1.0, -1.0);
      Scene fixed = plain;
      fixed.shading.lightDirection = asking.shading.lightDirection;
      const bool isLit = model != ShadingModel::none && projection == Projection::composite;
      EXPECT_EQ(hasTravellingLight(asking), isLit);
      EXPECT_EQ(pixels(asking) != pixels(fixed), isLit) << nameOf(model) << " " << nameOf(projection);
    }
}

TEST(TravellingLight, strengthIsTheShareOfTheLightThatMayBeMissing) {
  // Pixels are linear in both strengths where no sum of light terms is limited.
  Scene scene = litHead(ShadingModel::classic);
  scene.shading.specular = 0.0;
  const auto pixels = [&](double shadow, double occlusion) {
    scene.shading.shadow.strength = shadow;
    scene.shading.occlusion = {occlusion, 20.0};
    return renderReference(scene, headSize).pixels;
  };
  const auto none = pixels(0.0, 0.0), half = pixels(0.5, 0.5), all = pixels(1.0, 1.0);
  double darkest = 1.0;
  for (std::size_t i = 0; i < none.size(); ++i) {
    for (int channel = 0; channel < 4; ++channel)
      EXPECT_NEAR(half[i][channel], 0.5 * (none[i][channel] + all[i][channel]), 1e-12);
    EXPECT_LE(all[i].g, none[i].g + 1e-12);
    darkest = std::min(darkest, all[i].g - none[i].g);
  }
  EXPECT_LT(darkest, -0.1);
}

TEST(TravellingLight, aLightInTheCamerasAxesTurnsWithIt) {
  Scene studio = litHead(ShadingModel::classic);
  studio.camera = orbited(studio.camera, 0.7, 0.2);
  studio.shading.shadow = {0.8, 4.0};
  studio.shading.lightDirection = glm::dvec3(0.5, -0.7, 1.0);
  studio.shading.lightAxes = LightAxes::camera;
  const CameraBasis basis = basisOf(studio.camera);
  Scene fixed = studio;
  fixed.shading.lightAxes = LightAxes::world;
  fixed.shading.lightDirection = 0.5 * basis.right - 0.7 * basis.up + basis.forward;
  EXPECT_EQ(renderReference(studio, headSize).pixels, renderReference(fixed, headSize).pixels);
  fixed.camera = orbited(fixed.camera, 0.3, 0.0);
  studio.camera = fixed.camera;
  EXPECT_NE(renderReference(studio, headSize).pixels, renderReference(fixed, headSize).pixels);
}

TEST(TravellingLight, atACutFaceAmbientLightComesOverTheFace) {
  // Nothing but the cut has a normal. Around it all is open before the face: A = 1 for samples up to δ deep
  // in the directions whose path there is shorter than δ, and the sphere of those behind is half closed.
  Scene scene = inSurroundings(
      volumeOf(centredGrid(glm::ivec3(41), glm::dvec3(1.0)), [](int, int, int) { return 1.0; }), 1e4);
  scene.transferFunction = constantFunction(0.9999, white, 0.5);
  scene.shading.ambientIntensity = 1.0;
  scene.shading.diffuse = scene.shading.specular = 0.0;
  scene.quality.stepVoxels = 0.05;
  const double uncut = renderReference(scene, {1, 1}).pixels[0].g; // N = 0: the whole sphere
  scene.crop.lower.y = 0.5;
  const double cut = renderReference(scene, {1, 1}).pixels[0].g;
  // Of light weighed by cosines the share (z/1.5)² comes along paths longer than δ from z mm deep; at a mean
  // depth of 1/κ = 0.054 mm that is 0.3 %.
  EXPECT_NEAR(cut, 1.0, 0.01);
  EXPECT_NEAR(uncut, 0.5, 0.05); // the near half sphere, and what of it is open
}

TEST(TravellingLight, viewerAndLightMayChangePlaces) {
  // All light that a picture shows is ∫ exp(-τ to the viewer) κ M dV. f rises alike towards both, so that N·L
  // is N·V; an off-centre block of 0.2 makes the volume differ from its mirror image.
  const Grid grid = centredGrid(glm::ivec3(24), glm::dvec3(1.0));
  const auto volume = volumeOf(grid, [](int i, int j, int) { return double(i + j); });
  const auto sum = [&](const glm::dvec3& view, const glm::dvec3& light) {
    Scene scene = underLight(volume, light, 0.0);
    scene.transferFunction = constantFunction(0.02, white);
    scene.camera.position = -100.0 * view;
    scene.camera.target = glm::dvec3(0.0);
    scene.camera.heightMm = 24.0;
    scene.shading.ambient = scene.shading.specular = 0.0;
    std::vector<std::uint8_t> places(24 * 24 * 24, 0);
    for (int k = 0; k < 24; ++k)
      for (int j = 4; j < 20; ++j)
        for (int i = 2; i < 9; ++i)
          places[voxelOffset(grid.dims, i, j, k)] = 1;
    const std::vector<Label> labels{{0, "", white}, {1, "", white}};
    scene.keep = {
        Region::Kind::labels, "", std::make_shared<const LabelMap>(grid.dims, places, labels), {0.2, 1.0}};
    scene.quality.stepVoxels = 0.25;
    double total = 0.0;
    for (const glm::dvec4& pixel : renderReference(scene, {48, 48}).pixels)
      total += pixel.g;
    return total;
  };
  const double one = sum({0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}), other = sum({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
  // The viewer's path has no δ: behind the face towards the light up to 1.5 mm of 24 count κδ = 0.03
  // otherwise.
  EXPECT_NEAR(one / other, 1.0, 0.03 * 1.5 / 24.0);
  EXPECT_GT(one, 1.0);
}

} // namespace
} // namespace limn
