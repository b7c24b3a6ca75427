// SPDX-License-Identifier: GPL-3.0-or-later
// Light on its way drawn by the CPU engine (DEFINITION section 11): along many paths as the reference finds
// it, along few, looked up on a grid, and without a trace where there is none.
#include "accuracy/ImageError.h"
#include "accuracy/Tolerance.h"
#include "cpu/CpuRenderer.h"
#include "cpu/bricks/BrickRenderer.h"
#include "engine/VolumeTooLarge.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/light/LightDirections.h"
#include "scene/light/LightGrid.h"
#include "scene/light/Shading.h"
#include "scene/steps/RayFrame.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/JudgedTime.h"
#include "support/TravellingScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <numeric>
#include <string>

namespace limn {
namespace {

using test::shadowedHead;
using test::TravelCase;
using test::travelCases;
using test::withoutTravel;

constexpr glm::ivec2 travelPicture{20, 18};

ImageError errorFrom(const Image& reference, const Scene& scene) {
  CpuRenderer renderer;
  return imageError(renderer.render(scene, reference.size), reference);
}

TEST(CpuTravellingLight, foundAlongManyPathsItIsTheReferences) {
  for (const TravelCase& one : travelCases) {
    Scene scene = shadowedHead(8.0);
    one.apply(scene);
    scene.quality.light = LightDetail::sampled;
    const Image reference = toImage(renderReference(scene, travelPicture));
    const ImageError error = errorFrom(reference, scene);
    const double travel =
        imageError(reference, toImage(renderReference(withoutTravel(scene), travelPicture))).p99_9;
    std::cout << one.what << ": 99.9th percentile " << error.p99_9 << ", mean " << error.mean
              << " levels, of " << travel << " that light on its way makes\n";
    // What a tolerance of one level asks for. Of a surface a ray has one sample, to which light comes or does
    // not: both stop where M changes by a thousandth or two, which is 0.3 levels.
    const bool isSurface = scene.projection == Projection::isosurface;
    EXPECT_LE(error.p99_9, isSurface ? 3.0 : 1.0) << one.what;
    EXPECT_LE(error.mean, isSurface ? 0.3 : 0.1) << one.what;
    EXPECT_GE(travel, 2.5) << one.what << " shows nothing of it";
  }
}

TEST(CpuTravellingLight, aToleranceHasItFoundAlongSoManyPaths) {
  Scene scene = shadowedHead(8.0);
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = 4.75;
  const ImageError error = errorFrom(toImage(renderReference(scene, travelPicture)), scene);
  EXPECT_LE(error.p99_9, 1.0);
  EXPECT_LE(error.mean, 0.1);
}

TEST(CpuTravellingLight, aToleranceIsKeptAndSpent) {
  Scene scene = shadowedHead(4.0);
  const glm::ivec2 size{96, 96};
  CpuRenderer renderer(0, CpuRenderer::Tolerance::stepsFirst);
  const DrawScene draw = [&](const Scene& drawn, const glm::ivec2& pixels) {
    return renderer.render(drawn, pixels);
  };
  scene.quality.toleranceLevels = 0.5;
  scene.quality.fineness = 9.0; // 16 times as many as 5, with which heads err by half a level
  const Image exact = draw(scene, size);
  for (const double tolerance : {2.0, 1.0}) {
    scene.quality.toleranceLevels = tolerance;
    scene.quality.fineness.reset();
    const WithinTolerance found = withinTolerance(scene, size, draw, StepControl::cells);
    EXPECT_TRUE(found.holds);
    EXPECT_LE(found.estimateLevels, tolerance);
    const double error = imageError(draw(found.scene, size), exact).p99_9;
    std::cout << "asked " << tolerance << ": fineness " << *found.scene.quality.fineness << ", estimated "
              << found.estimateLevels << ", found " << error << " levels\n";
    EXPECT_LE(error, tolerance);
    EXPECT_GE(error, 0.4 * tolerance); // a fineness less would be twice as far off
  }
}

constexpr glm::ivec2 nearPicture{72, 64};

Scene nearScene(const TravelCase& one) {
  static const Scene head = shadowedHead(3.0);
  Scene scene = head;
  one.apply(scene);
  return scene;
}

// With light found along many paths, once for all tests that lie near it.
const Image& sampledPicture(const TravelCase& one) {
  static std::map<std::string, Image> pictures;
  Image& picture = pictures[one.what];
  if (picture.pixels.empty()) {
    Scene scene = nearScene(one);
    scene.quality.light = LightDetail::sampled;
    picture = CpuRenderer().render(scene, nearPicture);
  }
  return picture;
}

TEST(CpuTravellingLight, lookedUpOnAGridItLiesNear) {
  // What it reaches on voxels of 3 mm, with a quarter to spare. An eighth of the voxels' bytes is few nodes:
  // of both lights 56 000 and 14 000.
  struct Bound {
    double p99_9, mean;
  };
  struct Bounds {
    const char* what;
    Bound fine, coarse;
  };
  for (const Bounds& bounds : {Bounds{"shadow alone", {4.5, 0.26}, {16.0, 0.95}},
                               Bounds{"occlusion alone", {8.2, 1.56}, {13.2, 2.75}},
                               Bounds{"enhanced, with gradient opacity", {13.5, 1.32}, {32.3, 2.65}},
                               Bounds{"looks of labels", {9.2, 2.05}, {37.0, 3.5}}}) {
    const TravelCase& one = *std::ranges::find(travelCases, std::string(bounds.what), &TravelCase::what);
    Scene scene = nearScene(one);
    const Image& sampled = sampledPicture(one);
    for (const LightDetail detail : {LightDetail::fine, LightDetail::coarse}) {
      CpuRenderer own;
      scene.quality.light = detail;
      const ImageError error = imageError(own.render(scene, nearPicture), sampled);
      const bool isFine = detail == LightDetail::fine;
      const Bound& bound = isFine ? bounds.fine : bounds.coarse;
      std::cout << bounds.what << (isFine ? ", fine" : ", coarse") << ": 99.9th percentile " << error.p99_9
                << ", mean " << error.mean << " levels\n";
      EXPECT_LE(error.p99_9, bound.p99_9) << bounds.what;
      EXPECT_LE(error.mean, bound.mean) << bounds.what;
      if (isFine) { // whose nodes serve what moves next
        scene.quality.light = LightDetail::coarse;
        const ImageError moving = imageError(own.render(scene, nearPicture), sampled);
        std::cout << bounds.what << ", moving with fine nodes: 99.9th percentile " << moving.p99_9
                  << ", mean " << moving.mean << " levels\n";
        EXPECT_LE(moving.p99_9, bounds.coarse.p99_9) << bounds.what;
        EXPECT_LE(moving.mean, bounds.coarse.mean) << bounds.what;
      }
    }
  }
}

// The bounds that are asked of pictures at rest, on every kind of scene.
TEST(CpuTravellingLight, alongPathsThatARaysSamplesShareItLiesNear) {
  for (const TravelCase& one : travelCases) {
    Scene scene = nearScene(one);
    scene.quality.light = LightDetail::spread;
    const ImageError error = imageError(CpuRenderer().render(scene, nearPicture), sampledPicture(one));
    std::cout << one.what << ": 99.9th percentile " << error.p99_9 << ", mean " << error.mean << " levels\n";
    EXPECT_LE(error.p99_9, 5.0) << one.what;
    EXPECT_LE(error.mean, 0.5) << one.what;
    EXPECT_GT(error.p99_9, 0.0) << one.what;
  }
}

TEST(CpuTravellingLight, anyNumberOfThreadsAndTilesAndLeapsGivesTheSameBits) {
  for (const LightDetail detail : {LightDetail::fine, LightDetail::coarse, LightDetail::spread,
                                   LightDetail::moving, LightDetail::sampled})
    for (const Projection projection : {Projection::composite, Projection::isosurface}) {
      Scene scene = shadowedHead(6.0);
      scene.projection = projection;
      scene.quality.light = detail;
      CpuRenderer single(1), several(3), sampling(2, CpuRenderer::EmptySpace::sampled);
      const glm::ivec2 size{61, 53};
      const Image expected = single.render(scene, size);
      EXPECT_EQ(several.render(scene, size), expected);
      EXPECT_EQ(sampling.render(scene, size), expected);
      const PixelRect tile{{13, 7}, {31, 22}};
      const Image part = several.draw(scene, size, tile);
      for (int y = 0; y < tile.size.y; ++y)
        for (int x = 0; x < tile.size.x; ++x)
          ASSERT_EQ(part.at(x, y), expected.at(tile.topLeft.x + x, tile.topLeft.y + y));
    }
}

TEST(CpuTravellingLight, changesNoBitAndKeepsNoByteWhereItIsNeutral) {
  const glm::ivec2 size{96, 80};
  for (const Projection projection : {Projection::composite, Projection::mip, Projection::xray}) {
    Scene plain = withoutTravel(shadowedHead(4.0));
    plain.projection = projection;
    Scene headlight = plain;
    headlight.shading.lightDirection.reset();
    CpuRenderer one, other;
    const Image expected = one.render(headlight, size);
    headlight.shading.shadow = {1.0, 20.0};
    EXPECT_EQ(other.render(headlight, size), expected);
    EXPECT_EQ(other.memoryMb(), one.memoryMb());
  }
}

TEST(CpuTravellingLight, takesAnEighthOfTheVoxelsBytesAtMost) {
  for (const double spacing : {3.0, 5.0}) {
    Scene scene = shadowedHead(spacing);
    scene.quality.light = LightDetail::fine; // paths along rays need no nodes
    CpuRenderer without, with;
    without.render(withoutTravel(scene), {64, 64});
    with.render(scene, {64, 64});
    const double voxelMb = 2e-6 * static_cast<double>(scene.volume->voxelCount());
    EXPECT_LE(with.memoryMb() - without.memoryMb(), voxelMb / 8.0);
    EXPECT_GE(with.memoryMb() - without.memoryMb(), voxelMb / 16.0); // and makes use of it
  }
}

TEST(CpuTravellingLight, nodesLieEvenlyOverWhatShows) {
  const Grid grid = centredGrid({64, 64, 20}, {0.5, 0.5, 2.0});
  const IndexBox box{{-20.0, -30.0, -10.0}, {20.0, 30.0, 10.0}};
  const LightNodes nodes = lightNodes(grid, box.lower, box.upper, 5, 40000);
  EXPECT_LE(nodes.size() * 5, 40000u);
  EXPECT_GE(nodes.size() * 5, 30000u);
  const glm::dvec3 mm = nodes.stride * grid.spacingMm;
  EXPECT_LT(std::max({mm.x, mm.y, mm.z}) / std::min({mm.x, mm.y, mm.z}), 1.2);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(nodes.first[axis] + (nodes.count[axis] - 1) * nodes.stride[axis], box.upper[axis], 1e-9);
  EXPECT_EQ(lightNodes(grid, box.lower, box.lower, 1, 1000), LightNodes{});
  EXPECT_EQ(lightNodes(grid, box.lower, box.upper, 5, 1).count, glm::ivec3(2)); // as few as there can be
}

// Fine nodes leave out what is near, so what moves asks them behind the place that is lit: behind all that
// shows, too, where a plate hides the lamp from its own far face.
TEST(CpuTravellingLight, whatMovesLeavesTheFarFaceOfAPlateInTheDark) {
  Scene scene;
  scene.volume = volumeOf(centredGrid({48, 24, 48}, glm::dvec3(2.0)), [](int i, int j, int k) {
    const bool isPlate = j >= 10 && j < 14 && i >= 8 && i < 40 && k >= 8 && k < 40;
    return isPlate ? 1000.0 : -1000.0;
  });
  scene.transferFunction = {1.0, {{-200.0, {0.9, 0.8, 0.7}, 0.0}, {600.0, {0.9, 0.8, 0.7}, 0.9}}};
  scene.camera = defaultCamera(scene.volume->grid());
  scene.shading.lightDirection = glm::dvec3(0.1, 0.1, -1.0);
  scene.shading.lightAxes = LightAxes::camera;
  scene.shading.twoSided = true;
  scene.shading.shadow = {1.0, 5.0};
  scene.quality.stepVoxels = 0.5;
  scene.quality.preintegrated = Preintegration::never;
  constexpr glm::ivec2 size{64, 64};
  CpuRenderer renderer;
  const double open = test::brightness(renderer.render(withoutTravel(scene), size));
  scene.quality.light = LightDetail::fine;
  renderer.render(scene, size);
  scene.quality.light = LightDetail::coarse; // with the fine nodes
  const double moving = test::brightness(renderer.render(scene, size));
  scene.quality.light = LightDetail::sampled;
  const double sampled = test::brightness(renderer.render(scene, size));
  std::cout << "a plate's far face: " << open << " levels without shadows, " << moving << " while it moves, "
            << sampled << " with light found along many paths\n";
  EXPECT_LE(sampled, 0.75 * open) << "shows nothing of it";
  EXPECT_LE(moving - sampled, 0.25 * (open - sampled));
}

TEST(CpuTravellingLight, codesTellSharesToHalfOfA254th) {
  for (double share = 0.0; share <= 1.0; share += 0.001) {
    EXPECT_NEAR(shareOfCode(codeOfShare(share)), share, 0.5001 / 254.0);
    EXPECT_NEAR(alongAxisOfCode(codeOfAlongAxis(share - 0.5)), share - 0.5, 0.5001 / 254.0);
  }
  EXPECT_GT(codeOfShare(0.0), 0);
}

TEST(CpuTravellingLight, layersDimAsSlabsDo) {
  // All paths through the same tissue on all sides are as long as they reach.
  for (const double from : {0.0, 1.5})
    for (const auto& path : layerLengths(from))
      EXPECT_NEAR(std::accumulate(path.begin(), path.end(), 0.0), LightLook::layersReach - from, 1e-6);
  // Under a slab of the depth τ 2E₃(τ) is left (shared NUMERICS, section 10); six angles tell 0.4419 and
  // 0.2215.
  const double height = LightLook::layersReach / 4.0;
  for (const auto& [depth, left] : {std::pair(0.5, 0.443209), std::pair(1.0, 0.219384)}) {
    double sum = 0.0;
    for (const auto& path : layerLengths(0.0))
      sum += std::exp(-depth * path[0] / height) / 6.0;
    EXPECT_NEAR(sum, left, 0.004);
  }
}

TEST(CpuTravellingLight, directionsSpreadAsTheyAreTo) {
  glm::dvec3 cone(0.0), cosine(0.0), sphere(0.0);
  constexpr int count = 4096;
  for (int n = 0; n < count; ++n) {
    const glm::dvec2 point = spreadPoint(n);
    EXPECT_LE(std::acos(std::min(1.0, directionInCone(point, 6.0).z)), glm::radians(6.0) + 1e-7);
    cone += directionInCone(point, 60.0);
    cosine += directionByCosine(point);
    sphere += directionOnSphere(point);
  }
  // The mean height is (1 + cos 60°)/2 over a cap, 2/3 by the cosine, 0 over the sphere.
  EXPECT_NEAR(cone.z / count, 0.75, 1e-3);
  EXPECT_NEAR(cosine.z / count, 2.0 / 3.0, 1e-3);
  EXPECT_NEAR(glm::length(sphere) / count, 0.0, 2e-3);
  // Of the few points of a lattice the mean height is exact, and aside they balance to a point's share.
  glm::dvec3 few(0.0);
  for (int n = 0; n < 24; ++n)
    few += directionInCone(latticePoint(n, 24), 60.0) / 24.0;
  EXPECT_NEAR(few.z, 0.75, 1e-12);
  EXPECT_LE(glm::length(glm::dvec2(few)), 1.0 / 24.0);
  for (const glm::dvec3& axis :
       {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::normalize(glm::dvec3(1, 2, -3))}) {
    const glm::dmat3 axes = axesAround(axis);
    EXPECT_NEAR(glm::determinant(axes), 1.0, 1e-12);
    EXPECT_EQ(axes[2], axis);
  }
}

TEST(CpuTravellingLight, whatTheGridAddsIsMeasured) {
  const Scene scene = shadowedHead(4.0);
  CpuRenderer renderer;
  const DrawScene draw = [&](const Scene& drawn, const glm::ivec2& size) {
    return renderer.render(drawn, size);
  };
  const ImageError told = errorOfFilter(scene, {128, 128}, draw, mostFilterBits);
  Scene sampled = scene;
  sampled.quality.light = LightDetail::sampled;
  const ImageError found = imageError(draw(scene, {128, 128}), draw(sampled, {128, 128}));
  std::cout << "told " << told.p99_9 << ", found " << found.p99_9 << " levels\n";
  EXPECT_GE(told.p99_9, 0.8 * found.p99_9);
  EXPECT_LE(told.p99_9, 1.2 * found.p99_9);
  EXPECT_GT(found.p99_9, 0.0);
  EXPECT_EQ(errorOfFilter(sampled, {128, 128}, draw, mostFilterBits).p99_9, 0.0);
  EXPECT_EQ(errorOfFilter(withoutTravel(scene), {128, 128}, draw, mostFilterBits).p99_9, 0.0);
}

TEST(CpuTravellingLight, whoCannotDrawItSaysSo) {
  const Scene scene = shadowedHead(8.0);
  EXPECT_THROW(drawInBricks(scene, {16, 16}, 2, 1), Error);
  EXPECT_NO_THROW(drawInBricks(withoutTravel(scene), {16, 16}, 2, 1));
  EXPECT_NO_THROW(requireLightOfShaders(scene));
  Scene exact = scene;
  exact.quality.toleranceLevels = 1.0;
  EXPECT_THROW(requireLightOfShaders(exact), BeyondDriver);
  EXPECT_NO_THROW(requireLightOfShaders(withoutTravel(exact)));
  exact.projection = Projection::mip;
  EXPECT_NO_THROW(requireLightOfShaders(exact));
}

TEST(CpuTravellingLight, badCasesHaveFinitePictures) {
  const auto isFinite = [](const Scene& scene) {
    CpuRenderer renderer;
    const Image image = renderer.render(scene, {24, 20});
    return std::ranges::all_of(image.pixels, [](const glm::vec4& pixel) {
      return !glm::any(glm::isnan(pixel)) && glm::all(glm::greaterThanEqual(pixel, glm::vec4(0.0f))) &&
             glm::all(glm::lessThanEqual(pixel, glm::vec4(1.0f)));
    });
  };
  for (const LightDetail detail : {LightDetail::fine, LightDetail::coarse, LightDetail::spread,
                                   LightDetail::moving, LightDetail::sampled}) {
    Scene scene = shadowedHead(10.0);
    scene.quality.light = detail;
    scene.transferFunction = constantFunction(1.0, white);
    EXPECT_TRUE(isFinite(scene)) << "opacity 1";
    scene.transferFunction = {};
    EXPECT_TRUE(isFinite(scene)) << "no curve";
    scene = shadowedHead(10.0);
    scene.quality.light = detail;
    for (const glm::dvec3& travels : {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, -1e-300),
                                      glm::dvec3(0.0, 1.0, 0.0)}) { // along planes of voxels, and from behind
      scene.shading.lightAxes = LightAxes::world;
      scene.shading.lightDirection = travels;
      EXPECT_TRUE(isFinite(scene));
    }
    scene.shading.shadow.softnessDeg = 45.0;
    scene.shading.occlusion.reachMm = 1e6;
    EXPECT_TRUE(isFinite(scene)) << "the softest and the farthest";
    for (const glm::ivec3& dims : {glm::ivec3(1, 1, 1), glm::ivec3(9, 1, 9), glm::ivec3(40, 2, 3)}) {
      scene.volume = volumeOf(centredGrid(dims, {1.0, 10.0, 1.0}),
                              [](int i, int j, int k) { return 100.0 * (i + 2 * j - k); });
      EXPECT_TRUE(isFinite(scene)) << "few voxels of 1:10";
    }
  }
}

double travelMs(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

TEST(CpuTravellingLight, isFoundWhileAHandMovesAndLookedUpAtLittleCost) {
  Scene scene = shadowedHead(test::isTimeJudged() ? 1.0 : 4.0);
  std::cout << "voxels: " << scene.volume->voxelCount() << "\n";
  const glm::ivec2 size(test::isTimeJudged() ? 512 : 64);
  CpuRenderer renderer;
  scene.quality.light = LightDetail::coarse;
  renderer.render(withoutTravel(scene), size);
  const double plain = travelMs([&] { renderer.render(withoutTravel(scene), size); });
  const double first = travelMs([&] { renderer.render(scene, size); });
  const double again = travelMs([&] { renderer.render(scene, size); });
  test::judgeMs("a coarse grid of light", first - again, 150.0);
  // Wanted are 1.5 times; eight nodes for each of two lights take somewhat more (EVIDENCE).
  test::judgeMs("a picture with light looked up", again, 2.0 * plain);
  scene.quality.light = LightDetail::fine;
  const double fine = travelMs([&] { renderer.render(scene, size); });
  test::judgeMs("a fine grid of light", fine - again, 5000.0);
}

} // namespace
} // namespace limn
