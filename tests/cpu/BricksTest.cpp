// SPDX-License-Identifier: GPL-3.0-or-later
// A picture drawn in bricks is the picture drawn whole.
#include "accuracy/ImageError.h"
#include "cpu/CpuRenderer.h"
#include "cpu/bricks/BrickRenderer.h"
#include "scene/light/Shading.h"
#include "scene/volume/Phantom.h"
#include "scene/volume/VolumePart.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/RendererRules.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>

namespace limn {
namespace {

constexpr glm::ivec2 brickPicture{61, 47};

// What lies in a brick is drawn by it alone.
bool holds(const IndexBox& box, const glm::dvec3& point) {
  return glm::all(glm::greaterThanEqual(point, box.lower)) && glm::all(glm::lessThan(point, box.upper));
}

TEST(Bricks, everyPlaceLiesInExactlyOne) {
  const Grid grid = test::noisyPhantom(ShadingModel::classic).volume->grid();
  const CropBox crop{{0.1, 0.0, 0.3}, {0.9, 0.7, 1.0}};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> inBox(-40.0, 40.0);
  for (const int count : {1, 2, 3, 4, 7, 1000}) {
    const Bricks bricks(grid, crop, count);
    ASSERT_EQ(bricks.count(), count);
    for (int i = 0; i < 200; ++i) {
      // Some on the faces between bricks.
      const glm::dvec3 point = i % 2 == 0 ? glm::dvec3(inBox(random), inBox(random), inBox(random))
                                          : glm::max(bricks.box(i % count).lower, glm::dvec3(-1e3));
      int holders = 0;
      for (int brick = 0; brick < count; ++brick)
        holders += holds(bricks.box(brick), point) ? 1 : 0;
      ASSERT_EQ(holders, 1);
    }
  }
}

// Then each needs whole slices alone: its own, and those that the neighbours of its voxels lie in.
TEST(Bricks, ofSlicesAreDividedBetweenThoseWhereEachHasEnough) {
  Grid grid;
  grid.dims = {512, 512, 300};
  for (const int count : {2, 3, 4, 9}) {
    const Bricks bricks(grid, CropBox{}, count, true);
    int end = 0;
    for (int brick = 0; brick < count; ++brick) {
      const VoxelBox own = ownVoxels(grid, bricks.box(brick));
      EXPECT_EQ(own.lower, glm::ivec3(0, 0, end));
      EXPECT_EQ(own.upper, glm::ivec3(512, 512, own.upper.z));
      EXPECT_GE(own.upper.z - own.lower.z, 32);
      EXPECT_LE(own.upper.z - own.lower.z, 300 / count + 1);
      end = own.upper.z;
    }
    EXPECT_EQ(end, 300);
  }
  // Ten have fewer than 32 slices each: thin slabs would read more around them than of their own.
  const Bricks more(grid, CropBox{}, 10, true), ordinary(grid, CropBox{}, 10);
  for (int brick = 0; brick < 10; ++brick)
    EXPECT_EQ(ownVoxels(grid, more.box(brick)).upper, ownVoxels(grid, ordinary.box(brick)).upper);
  EXPECT_LT(ownVoxels(grid, ordinary.box(0)).upper.y, 512);
}

// A ray meets the bricks in the order in which they are put over each other, wherever the eye is.
TEST(Bricks, raysPassThroughThemFrontToBack) {
  const Grid grid = test::noisyPhantom(ShadingModel::classic).volume->grid();
  const double size = glm::length(glm::dvec3(grid.dims) * grid.spacingMm);
  std::mt19937 random(2);
  std::normal_distribution<double> anywhere(0.0, 0.4 * size);
  for (int trial = 0; trial < 200; ++trial) {
    Camera camera = defaultCamera(grid);
    camera.position = camera.target + glm::dvec3(anywhere(random), anywhere(random), anywhere(random));
    camera.projection = trial % 3 == 0 ? Camera::Projection::orthographic : Camera::Projection::perspective;
    const RayFrame frame = rayFrame(camera, grid, brickPicture);
    const Bricks bricks(grid, {}, 1 + trial % 9);
    const std::vector<int> order = bricks.frontToBack(frame);
    std::vector<std::size_t> placeOf(order.size());
    for (std::size_t place = 0; place < order.size(); ++place)
      placeOf[static_cast<std::size_t>(order[place])] = place;
    for (int pixel = 0; pixel < brickPicture.x; pixel += 5) {
      const FramedRay ray = framedRay(frame, pixel, (7 * pixel) % brickPicture.y, brickPicture);
      const RaySpan span = spanInBox(ray, croppedBox(grid, {}));
      std::size_t last = 0;
      for (int step = 0; step < 100 && !span.isEmpty(); ++step) {
        const glm::dvec3 point =
            ray.anchor + (span.begin + (step + 0.5) / 100.0 * (span.end - span.begin)) * ray.direction;
        for (int brick = 0; brick < bricks.count(); ++brick)
          if (holds(bricks.box(brick), point)) {
            const std::size_t place = placeOf[static_cast<std::size_t>(brick)];
            ASSERT_GE(place, last);
            last = place;
          }
      }
    }
  }
}

Scene brickScene(Projection projection, ShadingModel model) {
  Scene scene = test::noisyPhantom(model);
  scene.projection = projection;
  scene.quality.earlyTermination = 1.0;
  if (projection == Projection::minip || projection == Projection::average) // air shows, too
    scene.transferFunction.points = {{-1100.0, glm::dvec3(0.1, 0.5, 0.9), 0.2},
                                     {500.0, glm::dvec3(1.0), 1.0}};
  return scene;
}

constexpr Projection projections[] = {Projection::composite,
                                      Projection::mip,
                                      Projection::minip,
                                      Projection::average,
                                      Projection::xray,
                                      Projection::isosurface,
                                      Projection::compositeIsosurface};

// The worst error of a scene over divisions that issue 17 names, in levels.
double worstInBricks(const Scene& scene) {
  CpuRenderer whole;
  const Image expected = whole.render(scene, brickPicture);
  EXPECT_GT(std::ranges::count_if(expected.pixels, [](const glm::vec4& pixel) { return pixel.a > 0.0f; }),
            100);
  double worst = 0.0;
  for (const int count : {1, 2, 3, 4, 7}) {
    const ImageError error = imageError(drawInBricks(scene, brickPicture, count), expected);
    EXPECT_LE(error.p99_9, 0.5) << count << " bricks";
    worst = std::max(worst, error.largest);
  }
  return worst;
}

// The same samples in another order of sums: what floats lose, far below the half level that is promised.
TEST(Bricks, foldedPicturesAreWholeOnesInEveryModelAndProjection) {
  double worst = 0.0;
  for (const ShadingModel model : localModels)
    for (const Projection projection : projections) {
      Scene scene = brickScene(projection, model);
      scene.quality.preintegrated = Preintegration::never;
      worst = std::max(worst, worstInBricks(scene));
      EXPECT_LE(worst, 0.01) << nameOf(model) << ", projection " << static_cast<int>(projection);
      scene.quality.preintegrated = Preintegration::always;
      scene.quality.jitter = true;
      scene.crop = {{0.0, 0.2, 0.0}, {0.8, 1.0, 0.9}};
      worst = std::max(worst, worstInBricks(scene));
      EXPECT_LE(worst, 0.01) << nameOf(model) << ", projection " << static_cast<int>(projection);
      scene.keep = cubesRegion(scene.volume->grid().dims, 5, {1.0, 0.3, 0.0, 0.8});
      scene.quality.stepVoxels = 7.0; // over more than a block
      worst = std::max(worst, worstInBricks(scene));
      EXPECT_LE(worst, 0.01) << nameOf(model) << ", projection " << static_cast<int>(projection);
    }
  std::cout << "bricks: at most " << worst << " levels from the whole picture in equal steps\n";
}

// Bricks begin their steps anew, each within the tolerance of the exact picture.
TEST(Bricks, errorControlledStepsKeepWithinHalfALevel) {
  double worst = 0.0;
  for (const Projection projection :
       {Projection::composite, Projection::xray, Projection::compositeIsosurface}) {
    Scene scene = brickScene(projection, ShadingModel::robust);
    scene.quality.toleranceLevels = 0.5;
    scene.quality.fineness = 4;
    CpuRenderer whole;
    const Image expected = whole.render(scene, brickPicture);
    for (const int count : {1, 2, 3, 4, 7}) {
      const ImageError error = imageError(drawInBricks(scene, brickPicture, count), expected);
      EXPECT_LE(error.p99_9, 0.5) << count << " bricks, projection " << static_cast<int>(projection);
      worst = std::max(worst, error.p99_9);
    }
  }
  std::cout << "bricks: at most " << worst << " levels (p99.9) from the whole in error-controlled steps\n";
}

// Whole rays end where e of the light is taken; bricks end for themselves, where as little is left.
TEST(Bricks, earlyTerminationLeavesOutNoMoreThanItMay) {
  Scene scene = brickScene(Projection::composite, ShadingModel::enhanced);
  scene.quality.earlyTermination = 0.98;
  CpuRenderer whole;
  const Image expected = whole.render(scene, brickPicture);
  for (const int count : {2, 7})
    EXPECT_LE(imageError(drawInBricks(scene, brickPicture, count), expected).largest, 2.0 * 0.02 * 255.0);
}

TEST(Bricks, anEyeWithinThemOrOnAFaceSeesTheSame) {
  Scene scene = brickScene(Projection::composite, ShadingModel::classic);
  const Grid& grid = scene.volume->grid();
  const glm::dvec3 towards = scene.camera.target - scene.camera.position;
  for (const int count : {2, 4, 7}) {
    const Bricks bricks(grid, scene.crop, count);
    for (int brick = 0; brick < count; ++brick) {
      const glm::dvec3 corner = glm::max(bricks.box(brick).lower, glm::dvec3(-3.0)) + centreIndex(grid);
      for (const glm::dvec3& eye : {corner, corner + 0.3}) {
        scene.camera.position = indexToWorld(grid, eye);
        scene.camera.target = scene.camera.position + towards;
        const Image expected = CpuRenderer().render(scene, brickPicture);
        EXPECT_LE(imageError(drawInBricks(scene, brickPicture, count), expected).largest, 0.01) << brick;
      }
    }
  }
}

TEST(Bricks, thereMayBeMoreThanSlicesAndNobodyNeedSeeThem) {
  Scene scene = brickScene(Projection::composite, ShadingModel::classic);
  const Image expected = CpuRenderer().render(scene, brickPicture);
  EXPECT_LE(imageError(drawInBricks(scene, brickPicture, 150, 1), expected).largest, 0.02);
  scene.camera.position += 3.0 * (scene.camera.position - scene.camera.target);
  scene.camera.target = 2.0 * scene.camera.position - scene.camera.target;
  EXPECT_EQ(drawInBricks(scene, brickPicture, 4), Image(brickPicture));
  scene.transferFunction.points.clear();
  EXPECT_EQ(drawInBricks(scene, brickPicture, 3), Image(brickPicture));
}

// What grows with the voxels is a brick's alone, beside the voxels themselves where they stay as stored.
TEST(Bricks, eachKeepsItsShareOfWhatIsMadeOfTheVolume) {
  Scene scene = brickScene(Projection::composite, ShadingModel::classic);
  scene.volume = phantomVolume({.spacingMm = 1.5});
  const auto memoryOf = [&](int count, int brick) {
    BrickRenderer renderer;
    renderer.begin(scene, brickPicture, Bricks(scene.volume->grid(), scene.crop, count).box(brick));
    return renderer.memoryMb();
  };
  const double whole = memoryOf(1, 0);
  for (int brick = 0; brick < 4; ++brick)
    EXPECT_LE(memoryOf(4, brick), 0.45 * whole) << whole;
}

// MPI may fold neighbours in any grouping.
TEST(Bricks, overIsAssociativeWithinRounding) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  for (int trial = 0; trial < 1000; ++trial) {
    glm::vec4 a, b, c;
    for (glm::vec4* pixel : {&a, &b, &c}) {
      const float alpha = share(random);
      *pixel = {alpha * share(random), alpha * share(random), alpha * share(random), alpha};
    }
    glm::vec4 right = c, left = b, last = c;
    foldOver(&b, &right, 1);
    foldOver(&a, &right, 1);
    foldOver(&a, &left, 1);
    foldOver(&left, &last, 1);
    for (int channel = 0; channel < 4; ++channel)
      ASSERT_NEAR(right[channel], last[channel], 3 * 0x1p-24); // three roundings of numbers up to 1
  }
}

// The same volume in another type, of which all is found before it is divided.
template <class T>
std::shared_ptr<const Volume> storedAs(const Volume& volume) {
  std::vector<T> voxels;
  visitVoxels(volume, [&](const auto& stored) {
    for (const auto voxel : stored)
      voxels.push_back(static_cast<T>(std::is_same_v<T, std::uint8_t> ? (int(voxel) + 1100) / 16 : voxel));
  });
  const bool isByte = std::is_same_v<T, std::uint8_t>;
  return std::make_shared<const Volume>(volume.grid(), StoredVoxels<T>(std::move(voxels)),
                                        isByte ? Rescale{16.0, -1100.0} : volume.rescale(), std::nullopt,
                                        VolumeInfo{});
}

// A volume of which nothing but what a brick reads is held.
std::shared_ptr<const Volume> heldFor(const Scene& scene, const IndexBox& brick) {
  const Volume& volume = *scene.volume;
  const VoxelBox all = allVoxels(volume.grid());
  auto part = std::make_shared<VolumePart>();
  part->own = ownVoxels(volume.grid(), brick);
  part->box = voxelsRead(volume.grid(), brick, scene.quality.stepVoxels);
  EXPECT_TRUE(contains(part->box, part->own));
  return std::make_shared<const Volume>(volume.grid(), cutOut(volume.stored(), volume.grid().dims, part->box),
                                        volume.rescale(), VolumeInfo{}, factsOf(volume.stored(), all, all),
                                        part);
}

std::size_t leftAway(const Volume& held) {
  return held.voxelCount() - std::visit([](const auto& voxels) { return voxels.size(); }, held.stored());
}

// Returns how many voxels bricks did without.
std::size_t expectSameShares(const Scene& scene, int count) {
  std::size_t saved = 0;
  const cpu::WholeFacts whole{findModuli(*scene.volume, 99.5), 99.5, steepness(*scene.volume)};
  const Bricks bricks(scene.volume->grid(), scene.crop, count);
  for (int brick = 0; brick < count; ++brick) {
    BrickRenderer ofWhole(1), ofPart(1);
    ofWhole.begin(scene, brickPicture, bricks.box(brick));
    Scene held = scene;
    held.volume = heldFor(scene, bricks.box(brick));
    saved += leftAway(*held.volume);
    ofPart.setWhole(whole);
    ofPart.begin(held, brickPicture, bricks.box(brick));
    const PixelRect tile{{0, 0}, brickPicture};
    if (ofWhole.folding() != Folding::over) {
      EXPECT_EQ(ofPart.scalars(tile), ofWhole.scalars(tile));
      continue;
    }
    SurfaceHits hits, hitsOfPart;
    if (ofWhole.hasSurface()) {
      hits.own = hits.nearest = ofWhole.hits(tile);
      hitsOfPart.own = hitsOfPart.nearest = ofPart.hits(tile);
      EXPECT_EQ(hitsOfPart.own, hits.own);
    }
    EXPECT_EQ(ofPart.share(tile, hitsOfPart).pixels, ofWhole.share(tile, hits).pixels);
  }
  return saved;
}

// Bit for bit, in every model and projection, in equal, pre-integrated, long and error-controlled steps, and
// for voxels that stay as they are stored and those that become floats.
TEST(Bricks, giveTheSameWhereTheirVoxelsAloneAreHeld) {
  int n = 0;
  for (const ShadingModel model : localModels)
    for (const Projection projection : projections) {
      Scene scene = brickScene(projection, model);
      SCOPED_TRACE(n);
      const std::shared_ptr<const Volume> volume = scene.volume;
      scene.volume = n % 4 == 0   ? storedAs<double>(*volume)
                     : n % 4 == 1 ? storedAs<std::uint8_t>(*volume)
                     : n % 4 == 2 ? storedAs<float>(*volume)
                                  : volume;
      scene.quality.stepVoxels = n % 5 == 0 ? 3.0 : 0.5;
      scene.quality.preintegrated = n % 2 == 0 ? Preintegration::always : Preintegration::automatic;
      if (n % 3 == 0)
        scene.quality.toleranceLevels = 1.0;
      if (n % 7 == 3)
        scene.crop = {{0.1, 0.0, 0.3}, {0.9, 0.7, 1.0}};
      EXPECT_GT(expectSameShares(scene, 2 + n % 4), 0u) << "nothing was tried";
      ++n;
    }
}

} // namespace
} // namespace limn
