// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of physical light (DEFINITION section 12): the same bytes whoever draws them, what their error is
// said to be, what is cropped, and that nothing keeps them from ending.
#include "cpu/paths/PathPicture.h"
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "cpu/bricks/BrickRenderer.h"
#include "cpu/paths/PlainPaths.h"
#include "cpu/paths/SlabPaths.h"
#include "engine/VolumeTooLarge.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/RandomScene.h"
#include "support/JudgedTime.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace limn {
namespace {

using test::PathsOf;
using test::Tally;

constexpr glm::ivec2 pathPicture{24, 20};

Scene physicalHead(int paths, double spacingMm = 6.0) {
  Scene scene = headScene(phantomVolume({.spacingMm = spacingMm}), ShadingModel::physical);
  scene.camera = orbited(scene.camera, 0.5, 0.3);
  scene.shading.lightDirection = glm::dvec3(0.6, -0.7, 1.0);
  scene.shading.lightAxes = LightAxes::camera;
  scene.shading.physical.sky = {0.2, 0.4};
  scene.shading.physical.until = UntilPaths{paths};
  return scene;
}

// The same volume: a renderer goes on.
Scene until(Scene scene, int paths) {
  scene.shading.physical.until = UntilPaths{paths};
  return scene;
}

bool isFinite(const Image& image) {
  return std::ranges::all_of(image.pixels, [](const glm::vec4& pixel) {
    return std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b) && pixel.a >= 0.0f &&
           pixel.a <= 1.0f && pixel.r >= 0.0f && pixel.r <= 1.0f;
  });
}

TEST(PathPictures, areTheSameWithAnyThreadsTilesAndPasses) {
  const Scene scene = physicalHead(24);
  const Image whole = CpuRenderer(1).render(scene, pathPicture);
  for (const int threads : {2, 7})
    EXPECT_EQ(CpuRenderer(threads).render(scene, pathPicture), whole) << threads;
  CpuRenderer inPasses(2);
  for (const int paths : {1, 5, 24})
    EXPECT_EQ(inPasses.render(until(scene, paths), pathPicture) == whole, paths == 24) << paths;
  // Fewer are drawn anew, and are those that would have been drawn first.
  EXPECT_EQ(inPasses.render(until(scene, 5), pathPicture),
            CpuRenderer(1).render(until(scene, 5), pathPicture));
  CpuRenderer inTiles(2);
  Image tiled(pathPicture);
  for (int y = 0; y < pathPicture.y; y += 7)
    for (int x = 0; x < pathPicture.x; x += 11) {
      const PixelRect tile{{x, y}, glm::min(glm::ivec2(11, 7), pathPicture - glm::ivec2(x, y))};
      const Image part = inTiles.draw(scene, pathPicture, tile);
      for (int j = 0; j < tile.size.y; ++j)
        for (int i = 0; i < tile.size.x; ++i)
          tiled.at(x + i, y + j) = part.at(i, j);
    }
  EXPECT_EQ(tiled, whole);
  Scene other = scene;
  other.shading.physical.seed = 2;
  EXPECT_NE(CpuRenderer(2).render(other, pathPicture), whole);
}

TEST(PathPictures, areCancelledWithinAPassAndGoOn) {
  const Scene scene = physicalHead(400);
  CpuRenderer renderer(2);
  int asked = 0;
  EXPECT_THROW(renderer.draw(scene, pathPicture, {{0, 0}, pathPicture}, [&asked] { return ++asked > 12; }),
               Cancelled);
  EXPECT_EQ(renderer.render(scene, pathPicture), CpuRenderer(1).render(scene, pathPicture));
}

// Exposure and knee say how light is shown: what was found of it stays.
TEST(PathPictures, areExposedAnewWithoutAPathMore) {
  CpuRenderer renderer(2);
  const Scene scene = physicalHead(16);
  EXPECT_EQ(renderer.followedPaths(scene, pathPicture), 0);
  renderer.render(scene, pathPicture);
  Scene exposed = scene;
  exposed.shading.physical.exposureEv = 1.5;
  exposed.shading.knee = 0.5;
  exposed.shading.ambient = 0.3; // of other models
  EXPECT_EQ(renderer.followedPaths(exposed, pathPicture), 16);
  const Image expected = CpuRenderer(2).render(exposed, pathPicture);
  exposed.quality.paths = 0; // none more
  EXPECT_EQ(renderer.render(exposed, pathPicture), expected);
  // The error is that of the colours shown.
  EXPECT_NE(renderer.pathFigures(exposed, pathPicture)->rmsLevels,
            renderer.pathFigures(scene, pathPicture)->rmsLevels);
  Scene other = exposed;
  other.shading.physical.keyRadiusDeg = 10.0;
  EXPECT_EQ(renderer.followedPaths(other, pathPicture), 0);
}

TEST(PathPictures, goOnFromThePathsThatHalfOfTheirPixelsHave) {
  CpuRenderer renderer(2);
  const Scene scene = physicalHead(16);
  renderer.render(until(scene, 8), pathPicture);
  renderer.draw(scene, pathPicture, {{0, 0}, {pathPicture.x, 4}});
  EXPECT_EQ(renderer.followedPaths(scene, pathPicture), 8);
  renderer.draw(scene, pathPicture, {{0, 0}, {pathPicture.x, 16}});
  EXPECT_EQ(renderer.followedPaths(scene, pathPicture), 16);
  EXPECT_EQ(renderer.render(scene, pathPicture), CpuRenderer(1).render(scene, pathPicture));
}

// Back where a drag began, everything is there that was followed before it.
TEST(PathPictures, goOnAfterADragThatDrewManyCoarseOnes) {
  CpuRenderer renderer(2);
  const Scene scene = physicalHead(16);
  renderer.render(scene, pathPicture);
  Scene dragged = until(scene, 1);
  for (int frame = 0; frame < 20; ++frame) {
    dragged.camera = orbited(dragged.camera, 0.02, 0.0);
    renderer.render(dragged, {6, 5});
  }
  EXPECT_EQ(renderer.followedPaths(scene, pathPicture), 16);
}

// Where there is room for little, a drag drops its own coarse pictures and not the whole ones it began from.
TEST(PathPictures, letCoarseOnesGoFirst) {
  constexpr glm::ivec2 whole{40, 30}, half{20, 15}, coarse{5, 4};
  const Scene left = physicalHead(1);
  Scene right = left; // of one volume
  right.camera = orbited(right.camera, 1.0, 0.0);
  const std::size_t ofWhole = cpu::PathPicture(left, whole).bytes();
  // Of two wholes, two halves of their width and one coarse.
  const std::size_t most =
      2 * ofWhole + 2 * cpu::PathPicture(left, half).bytes() + cpu::PathPicture(left, coarse).bytes();
  cpu::PathPictures kept(most);
  for (const glm::ivec2& size : {coarse, half, whole})
    for (const Scene& side : {left, right})
      kept.of(side, size);
  EXPECT_LE(kept.bytes(), most);
  // A drag of both sides, then a rest of half the width.
  Scene draggedLeft = left, draggedRight = right;
  for (int frame = 0; frame < 10; ++frame)
    for (Scene* side : {&draggedLeft, &draggedRight}) {
      side->camera = orbited(side->camera, 0.02, 0.0);
      kept.of(*side, coarse);
    }
  for (const Scene& side : {draggedLeft, draggedRight})
    kept.of(side, half);
  EXPECT_LE(kept.bytes(), most);
  for (const Scene& side : {left, right})
    EXPECT_NE(kept.find(side, whole), nullptr) << "where the drag began";
  // Whole ones of the new view take their place, and no more memory.
  for (const Scene& side : {draggedLeft, draggedRight})
    kept.of(side, whole);
  EXPECT_LE(kept.bytes(), most);
  for (const Scene& side : {draggedLeft, draggedRight})
    EXPECT_NE(kept.find(side, whole), nullptr);
}

// Two, the sides of a comparison, whatever their size; more while all take 268 MB at most.
TEST(PathPictures, takeLittleMemoryBesideTheLastTwo) {
  CpuRenderer renderer(2);
  Scene scene = physicalHead(1);
  const double before = (renderer.plan(scene), renderer.memoryMb());
  constexpr glm::ivec2 large{2048, 1280}; // 72 bytes a pixel
  for (int n = 1; n <= 4; ++n) {
    scene.shading.physical.seed = static_cast<std::uint32_t>(n);
    renderer.draw(scene, large, {{0, 0}, {1, 1}});
    EXPECT_NEAR(renderer.memoryMb() - before, std::min(n, 2) * 72e-6 * large.x * large.y, 2.0) << n;
  }
  const auto drawSmall = [&scene](CpuRenderer& by) {
    for (int n = 10; n <= 30; ++n) {
      scene.shading.physical.seed = static_cast<std::uint32_t>(n);
      by.draw(scene, {512, 512}, {{0, 0}, {1, 1}});
    }
  };
  drawSmall(renderer);
  EXPECT_LE(renderer.memoryMb() - before, 268.5 + 2.0);
  CpuRenderer other(2);
  drawSmall(other);
  EXPECT_NEAR(other.memoryMb() - before, 6 * 72e-6 * 512 * 512, 2.0);
}

TEST(PathPictures, tellTheErrorOfEachPixel) {
  CpuRenderer renderer(2);
  const Scene scene = physicalHead(64);
  EXPECT_TRUE(renderer.pathErrors(scene, pathPicture).empty());
  const Image image = renderer.render(scene, pathPicture);
  const PathFigures figures = *renderer.pathFigures(scene, pathPicture);
  const std::vector<float> errors = renderer.pathErrors(scene, pathPicture);
  ASSERT_EQ(errors.size(), image.pixels.size());
  double largest = 0.0, over = 0.0, covered = 0.0;
  for (std::size_t n = 0; n < errors.size(); ++n) {
    EXPECT_EQ(errors[n] < 0.0f, image.pixels[n].a < 1.0f / 510.0f) << n;
    largest = std::max(largest, double(errors[n]));
    over += errors[n] > 1.0f ? 1.0 : 0.0;
    covered += errors[n] >= 0.0f ? 1.0 : 0.0;
  }
  EXPECT_EQ(figures.largestLevels, largest);
  EXPECT_DOUBLE_EQ(figures.shareOverOne, over / covered);
  EXPECT_LT(figures.meanLevels, *figures.rmsLevels);
}

TEST(PathPictures, tellTheErrorThatTheyHave) {
  CpuRenderer renderer;
  const Image exact = renderer.render(physicalHead(4096), pathPicture);
  for (const int paths : {32, 256}) {
    // Other numbers, or the paths of one would be among those of the other.
    Scene scene = physicalHead(paths);
    scene.shading.physical.seed = 77;
    CpuRenderer few;
    const Image noisy = few.render(scene, pathPicture);
    const PathFigures figures = *few.pathFigures(scene, pathPicture);
    ASSERT_EQ(figures.paths, paths);
    double squares = 0.0;
    int count = 0;
    for (std::size_t n = 0; n < exact.pixels.size(); ++n)
      if (exact.pixels[n].a >= 1.0f / 510.0f)
        for (int c = 0; c < 3; ++c, ++count)
          squares += std::pow(255.0 * double(noisy.pixels[n][c] - exact.pixels[n][c]), 2.0);
    const double found = std::sqrt(squares / count);
    std::printf("%d paths: %.3f levels RMS said, %.3f found; 99.9th percentile %.2f\n", paths,
                *figures.rmsLevels, found, *figures.p99_9Levels);
    EXPECT_NEAR(*figures.rmsLevels, found, 0.2 * found);
    EXPECT_GT(*figures.p99_9Levels, *figures.rmsLevels);
  }
}

TEST(PathPictures, ofOnePathTellNoError) {
  CpuRenderer renderer;
  const Scene scene = physicalHead(1);
  renderer.render(scene, pathPicture);
  const PathFigures figures = *renderer.pathFigures(scene, pathPicture);
  EXPECT_EQ(figures.paths, 1);
  EXPECT_FALSE(figures.rmsLevels);
  EXPECT_FALSE(renderer.pathFigures(scene, {5, 5}));
}

TEST(PathPictures, haveTheAlphaOfTheTissue) {
  Scene scene = physicalHead(2);
  scene.shading.physical.density = 0.5;
  Scene thin = scene;
  thin.shading.model = ShadingModel::none;
  thin.transferFunction.unitDistanceMm *= 2.0;
  thin.quality.earlyTermination = 1.0;
  CpuRenderer renderer;
  const Image alpha = renderer.render(thin, pathPicture);
  const Image physical = renderer.render(scene, pathPicture);
  for (std::size_t n = 0; n < alpha.pixels.size(); ++n)
    EXPECT_EQ(physical.pixels[n].a, alpha.pixels[n].a);
}

// The mean of what the left half of a picture shows, and its error by its own paths.
Tally lightOnTheLeft(const Scene& scene) {
  Tally tally;
  const PathsOf of(scene, pathPicture);
  const cpu::LinearSky sky{of.paths};
  const cpu::PathTracer<std::int16_t> tracer(of.paths, sky);
  EXPECT_EQ(of.paths.voxels.kind, cpu::VoxelSource::Kind::signedHalf);
  for (std::uint32_t path = 0; path < 150; ++path)
    for (int y = 0; y < pathPicture.y; ++y)
      for (int x = 0; x < pathPicture.x / 2; ++x) {
        const cpu::PathStart start = cpu::pathStart(of.paths, of.terms, x, y);
        cpu::PathRandom random(4, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), path);
        const auto radiance = start.length > 0.0f ? tracer.radiance(start, random) : std::nullopt;
        tally.add(radiance ? double(radiance->r + radiance->g + radiance->b) : 0.0);
      }
  return tally;
}

// Two blocks of tissue with air between them; the light comes past one to the other.
std::shared_ptr<const Volume> twoBlocks(bool hasSecond) {
  VolumeInfo info;
  std::vector<std::int16_t> voxels;
  const Grid grid = centredGrid({24, 24, 24}, glm::dvec3(2.0));
  for (int k = 0; k < 24; ++k)
    for (int j = 0; j < 24; ++j)
      for (int i = 0; i < 24; ++i) {
        const bool isFirst = i >= 3 && i < 9 && j > 3 && j < 20 && k > 3 && k < 20;
        const bool isSecond = i >= 15 && i < 21 && j > 3 && j < 20 && k > 3 && k < 20;
        voxels.push_back(static_cast<std::int16_t>(isFirst || (isSecond && hasSecond) ? 1000 : 0));
      }
  return std::make_shared<const Volume>(grid, StoredVoxels<std::int16_t>(std::move(voxels)), Rescale{},
                                        std::nullopt, info);
}

TEST(PathPictures, showCroppedTissueAsAir) {
  Scene scene = physicalHead(1);
  scene.camera = defaultCamera(centredGrid({24, 24, 24}, glm::dvec3(2.0)));
  scene.transferFunction.points = {{200.0, {0.8, 0.6, 0.5}, 0.0}, {800.0, {0.9, 0.7, 0.6}, 0.9}};
  scene.shading.lightAxes = LightAxes::world;
  scene.shading.lightDirection = glm::dvec3(-1.0, 0.1, 0.1);
  scene.shading.gradientReference = FixedReference{250.0}; // a percentile counts cropped voxels, too
  scene.volume = twoBlocks(true);
  const Tally both = lightOnTheLeft(scene);
  scene.crop.upper.x = 0.5;
  const Tally cropped = lightOnTheLeft(scene);
  scene.crop = {};
  scene.volume = twoBlocks(false);
  const Tally alone = lightOnTheLeft(scene);
  EXPECT_LT(std::abs(cropped.mean() - alone.mean()), 4.0 * std::hypot(cropped.error(), alone.error()));
  // The other block's shadow is gone.
  EXPECT_GT(std::abs(both.mean() - alone.mean()), 4.0 * std::hypot(both.error(), alone.error()));
}

TEST(PathPictures, endWhateverIsAskedOfThem) {
  const struct {
    const char* what;
    void (*apply)(Scene&);
  } cases[] = {
      {"white and dense",
       [](Scene& s) {
         for (ControlPoint& point : s.transferFunction.points)
           point = {point.value, glm::dvec3(1.0), 1.0};
         s.shading.physical.density = 100.0;
         s.shading.physical.surface = 0.0;
       }},
      {"opaque within a nanometre",
       [](Scene& s) {
         s.transferFunction.unitDistanceMm = 1e-6;
         s.shading.physical.density = 100.0;
       }},
      {"the camera inside", [](Scene& s) { s.camera.position = s.camera.target = glm::dvec3(0.0); }},
      {"one slice",
       [](Scene& s) {
         s.volume = volumeOf(centredGrid({12, 12, 1}, {2.0, 2.0, 5.0}),
                             [](int i, int j, int) { return 40.0 * i * j; });
         s.camera = defaultCamera(s.volume->grid());
         s.camera.position = {0.0, 0.0, 200.0};
       }},
      {"voxels of 1 : 10",
       [](Scene& s) {
         s.volume = volumeOf(centredGrid({12, 12, 6}, {1.0, 1.0, 10.0}),
                             [](int i, int j, int k) { return 30.0 * i * j - 100.0 * k; });
       }},
      {"one voxel", [](Scene& s) { s.volume = boxOf(glm::dvec3(80.0), 1000.0); }},
      {"an empty curve", [](Scene& s) { s.transferFunction.points.clear(); }},
      {"a cropped corner",
       [](Scene& s) {
         s.crop = {{0.5, 0.0, 0.4}, {1.0, 0.6, 1.0}};
       }},
      {"a kept region with looks",
       [](Scene& s) {
         s.keep = withVariedLooks(cubesRegion(s.volume->grid().dims, 5, {0.0, 1.0, 0.4}), s.transferFunction);
       }},
      {"forwards",
       [](Scene& s) {
         s.shading.physical.anisotropy = 0.95;
         s.shading.physical.surface = 0.0;
       }},
      {"mirrors",
       [](Scene& s) {
         s.shading.physical.surface = s.shading.physical.specularShare = 1.0;
         s.shading.exponentRange = {0.01, 1024.0};
       }},
      {"a headlight", [](Scene& s) { s.shading.lightDirection.reset(); }},
      {"fog and a surface, which are left out",
       [](Scene& s) {
         s.fog = distanceFog(0.0, 600.0);
         s.projection = Projection::compositeIsosurface;
       }},
      {"far too bright",
       [](Scene& s) {
         s.shading.physical.keyIrradiance = 1e6;
         s.shading.physical.exposureEv = 20.0;
       }},
  };
  for (const auto& one : cases) {
    Scene scene = physicalHead(4);
    one.apply(scene);
    CpuRenderer renderer;
    const auto begin = std::chrono::steady_clock::now();
    const Image image = renderer.render(scene, pathPicture);
    const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - begin;
    EXPECT_TRUE(isFinite(image)) << one.what;
    test::judgeMs(one.what, ms.count(), 5000.0);
  }
}

TEST(PathPictures, ofRandomScenesHoldNumbers) {
  int drawn = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomScene random;
    try {
      random = randomScene(seed);
    } catch (const Error&) {
      continue; // a volume that is refused
    }
    random.scene.shading.model = ShadingModel::physical;
    random.scene.shading.physical.until = UntilPaths{2};
    if (!isPhysical(random.scene))
      continue;
    ++drawn;
    EXPECT_TRUE(isFinite(CpuRenderer().render(random.scene, random.size)))
        << seed << " " << random.description;
  }
  EXPECT_GE(drawn, 5);
}

TEST(PathPictures, leaveOutWhatTheyDoNotKnow) {
  Scene scene = physicalHead(3);
  const Image plain = CpuRenderer().render(scene, pathPicture);
  scene.fog = distanceFog(0.0, 600.0);
  scene.projection = Projection::compositeIsosurface;
  EXPECT_EQ(CpuRenderer().render(scene, pathPicture), plain);
  const EffectPlan plan = requiredEffects(scene, {});
  EXPECT_TRUE(plan.effects.has(Effect::physical));
  EXPECT_FALSE(plan.effects.hasAny(fogs.with({Effect::hybrid, Effect::lighting})));
  // MIP and the like show values, whatever the model.
  scene.projection = Projection::mip;
  EXPECT_FALSE(isPhysical(scene));
  Scene unlit = scene;
  unlit.shading.model = ShadingModel::none;
  EXPECT_EQ(CpuRenderer().render(scene, pathPicture), CpuRenderer().render(unlit, pathPicture));
}

TEST(PathPictures, areRefusedByWhoFollowsNoPaths) {
  const Scene scene = physicalHead(1);
  EXPECT_THROW(requireLightOfShaders(scene), BeyondDriver);
  EXPECT_THROW(renderReference(scene, pathPicture), Error);
  BrickRenderer bricks;
  EXPECT_THROW(bricks.begin(scene, pathPicture, croppedBox(scene.volume->grid(), {}), {}), Error);
}

// Mean light of some pixels, its standard error, and the time that it took.
struct Followed {
  double mean, error, ms;
  double timeToError() const { return ms * error * error; }
};

template <class Follow>
Followed followed(const PathsOf& of, int paths, const Follow& follow) {
  Tally tally;
  double variance = 0.0;
  const double begin = test::threadMs();
  for (int y = 1; y < pathPicture.y; y += 3)
    for (int x = 1; x < pathPicture.x; x += 3) {
      const cpu::PathStart start = cpu::pathStart(of.paths, of.terms, x, y);
      if (!(start.length > 0.0f))
        continue;
      Tally pixel;
      for (int n = 0; n < paths; ++n) {
        cpu::PathRandom random(6, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                               static_cast<std::uint32_t>(n));
        const auto radiance = follow(start, random);
        pixel.add(radiance ? double(radiance->g) : 0.0);
      }
      tally.add(pixel.mean());
      variance += pixel.error() * pixel.error();
    }
  return {tally.mean(), std::sqrt(variance) / static_cast<double>(tally.count), test::threadMs() - begin};
}

// The same light by both, and what either takes to the same error: time times variance.
TEST(PathPictures, agreeWithPlainPathsAndAreFaster) {
  // Plain paths meet a disc of 4° hardly ever; one of 45° shows how exactly both agree.
  for (const double radiusDeg : {45.0, 4.0}) {
    Scene scene = physicalHead(1, 4.0);
    scene.shading.physical.anisotropy = 0.3;
    scene.shading.physical.keyRadiusDeg = radiusDeg;
    const PathsOf of(scene, pathPicture);
    ASSERT_EQ(of.paths.voxels.kind, cpu::VoxelSource::Kind::signedHalf);
    const cpu::LinearSky sky{of.paths};
    const cpu::PathTracer<std::int16_t> tracer(of.paths, sky);
    const test::PlainPaths<std::int16_t> plain(of.paths);
    const Followed fast =
        followed(of, 3000, [&](const auto& start, auto& random) { return tracer.radiance(start, random); });
    const Followed slow =
        followed(of, 3000, [&](const auto& start, auto& random) { return plain.radiance(start, random); });
    EXPECT_LT(std::abs(fast.mean - slow.mean), 4.0 * std::hypot(fast.error, slow.error)) << radiusDeg;
    const double gain = slow.timeToError() / fast.timeToError();
    std::printf("key of %.0f°: mean %.5f ± %.5f in %.0f ms, plain %.5f ± %.5f in %.0f ms: %.1f times as fast "
                "to equal "
                "error\n",
                radiusDeg, fast.mean, fast.error, fast.ms, slow.mean, slow.error, slow.ms, gain);
    if (radiusDeg == 4.0) {
      EXPECT_GE(gain, 5.0);
    }
  }
}

} // namespace
} // namespace limn
