// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes whose voxels lie in a file: the same pictures, and what is made of them lies there, too.
#include "support/MappedVolume.h"
#include "accuracy/ImageError.h"
#include "cpu/CpuRenderer.h"
#include "scene/basics/Error.h"
#include "scene/basics/Room.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/Heads.h"
#include "support/Sanitizers.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 mappedPicture{61, 50};

// The head with its numbers in another type.
template <class T>
std::shared_ptr<const Volume> inType(const Volume& volume) {
  std::vector<T> stored;
  stored.reserve(volume.voxelCount());
  visitVoxels(volume, [&](const auto& voxels) {
    for (const auto voxel : voxels)
      stored.push_back(static_cast<T>(voxel));
  });
  return std::make_shared<const Volume>(volume.grid(), std::move(stored), volume.rescale(), std::nullopt,
                                        volume.info());
}

std::vector<Scene> scenesWithEverything(const std::shared_ptr<const Volume>& volume) {
  std::vector<Scene> scenes;
  Scene scene = test::noisyPhantom(ShadingModel::robust);
  scene.volume = volume;
  scenes.push_back(scene);
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = 4;
  scenes.push_back(scene);
  scene.keep = cubesRegion(volume->grid().dims, 11, {0.0, 1.0, 0.0, 0.3});
  scenes.push_back(scene);
  scene.quality.toleranceLevels.reset();
  scene.projection = Projection::mip;
  scenes.push_back(scene);
  return scenes;
}

TEST(MappedVolume, isDrawnWithTheSameBits) {
  const test::TemporaryFolder folder;
  const Volume& head = *test::noisyPhantom(ShadingModel::classic).volume;
  for (const auto& volume : {inType<std::int16_t>(head), inType<double>(head)}) {
    SCOPED_TRACE(voxelTypeName(volume->stored()));
    const std::shared_ptr<const Volume> onDisk = test::mapped(*volume, folder.path() / "voxels");
    CpuRenderer inMemory, mapped;
    const std::vector<Scene> expected = scenesWithEverything(volume), scenes = scenesWithEverything(onDisk);
    for (std::size_t n = 0; n < scenes.size(); ++n)
      EXPECT_EQ(mapped.render(scenes[n], mappedPicture), inMemory.render(expected[n], mappedPicture)) << n;
    EXPECT_GT(onDisk->room()->taken(), 0u) << "what is made of it lies beside it";
    EXPECT_EQ(mapped.memoryMb(), 0.0);
  }
}

// Floats are read where they lie instead of from a normalised copy, which rounds a sample otherwise in the
// last of its 24 bits; over the hundreds of samples of a ray that stays below a hundredth of a level.
TEST(MappedVolume, ofFloatsIsNotCopiedAndDrawnAlikeToAHundredthOfALevel) {
  const test::TemporaryFolder folder;
  const auto volume = inType<float>(*test::noisyPhantom(ShadingModel::classic).volume);
  const std::shared_ptr<const Volume> onDisk = test::mapped(*volume, folder.path() / "voxels");
  CpuRenderer inMemory, mapped;
  const std::vector<Scene> expected = scenesWithEverything(volume), scenes = scenesWithEverything(onDisk);
  for (std::size_t n = 0; n < scenes.size(); ++n) {
    const Image picture = mapped.render(scenes[n], mappedPicture);
    EXPECT_LE(imageError(picture, inMemory.render(expected[n], mappedPicture)).p99_9, 0.01) << n;
  }
  EXPECT_LT(onDisk->room()->taken(), volume->voxelCount() * sizeof(float)) << "what is made of blocks alone";
}

// Doubles, which are copied to floats: 67 MB, and blocks, their facts and steps.
TEST(MappedVolume, takesNoMemoryThatGrowsWithItsVoxels) {
  const test::TemporaryFolder folder;
  Grid grid;
  grid.dims = glm::ivec3(256);
  std::vector<double> voxels(std::size_t{256} * 256 * 256);
  for (std::size_t n = 0; n < voxels.size(); ++n)
    voxels[n] = static_cast<double>(n % 256 + n / 65536);
  std::shared_ptr<const Volume> onDisk;
  {
    const Volume volume(grid, std::move(voxels), {}, std::nullopt, {});
    onDisk = test::mapped(volume, folder.path() / "voxels");
  }
  CpuRenderer renderer;
  Scene scene = test::noisyPhantom(ShadingModel::robust);
  scene.camera.position *= 3.0;
  scene.volume = onDisk;
  scene.quality.toleranceLevels = 1.0;
  const std::uint64_t before = test::ownMemory();
  renderer.render(scene, mappedPicture);
  const std::uint64_t made = onDisk->room()->taken();
  const std::uint64_t after = test::ownMemory();
  std::cout << "own memory " << before / 1e6 << " MB before, " << after / 1e6 << " MB after; in the room "
            << made / 1e6 << " MB\n";
  EXPECT_GT(made, 69e6) << "256³ floats, and 9 bytes for each block of 4³";
  if (test::isSanitised)
    GTEST_SKIP() << "checked all but its memory, which a sanitizer's own would be counted in";
  EXPECT_LT(after, before + 24e6);
}

// A ball that shows in a volume of which the rest does not: rays read its blocks and leave the others on
// disk.
TEST(MappedVolume, isTouchedOnlyWhereItShows) {
  const glm::ivec3 dims(400, 400, 400);
  const auto volume = test::sparseVolume(dims, [&](std::int16_t* voxels) {
    for (int k = 180; k < 220; ++k)
      for (int j = 180; j < 220; ++j)
        for (int i = 180; i < 220; ++i)
          voxels[voxelOffset(dims, i, j, k)] = 1000;
  });
  Scene scene = test::noisyPhantom(ShadingModel::classic);
  scene.volume = volume;
  scene.transferFunction.points = {{400.0, {1.0, 1.0, 1.0}, 0.0}, {600.0, {1.0, 1.0, 1.0}, 0.9}};
  scene.camera = {};
  scene.camera.position = {199.5, -900.0, 199.5};
  scene.camera.target = {199.5, 199.5, 199.5};
  CpuRenderer renderer;
  const Image whole = renderer.render(scene, mappedPicture);
  EXPECT_GT(whole.at(mappedPicture.x / 2, mappedPicture.y / 2).a, 0.9f) << "the ball is in the middle";
  test::forgetPages(*volume);
  EXPECT_EQ(test::touchedBytes(*volume), 0u);
  EXPECT_EQ(renderer.render(scene, mappedPicture), whole);
  // Pages of 4 KiB hold five rows; the system maps some around each.
  const std::uint64_t touched = test::touchedBytes(*volume), all = std::uint64_t{2} * 400 * 400 * 400;
  std::cout << "rays touched " << touched / 1e6 << " of " << all / 1e6 << " MB\n";
  EXPECT_GT(touched, 0u);
  EXPECT_LT(touched, all / 10);
}

TEST(MappedVolume, canBeLeftWhileItIsRead) {
  const auto volume = test::sparseVolume({500, 500, 400}, [](std::int16_t* voxels) { voxels[77] = 5; });
  Scene scene = test::noisyPhantom(ShadingModel::robust);
  scene.volume = volume;
  CpuRenderer renderer;
  int asked = 0;
  const Effort effort{2, [&] { return ++asked > 3; }, {}};
  EXPECT_THROW(renderer.makeReady(scene, effort), Cancelled);
  EXPECT_EQ(asked, 4);
  EXPECT_EQ(volume->room()->taken(), 0u) << "what was begun is given back";
  std::vector<double> told;
  renderer.makeReady(scene, {2, {}, [&](double fraction) { told.push_back(fraction); }});
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_DOUBLE_EQ(told.back(), 1.0);
}

} // namespace
} // namespace limn
