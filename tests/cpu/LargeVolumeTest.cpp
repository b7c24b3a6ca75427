// SPDX-License-Identifier: GPL-3.0-or-later
// More voxels, bytes and blocks than 32 bits count, in files without a block on disk.
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "scene/basics/Room.h"
#include "support/MappedVolume.h"
#include "support/Sanitizers.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 largePicture{64, 64};

// A cube of 1000 about a voxel.
void writeCube(std::int16_t* voxels, const glm::ivec3& dims, const glm::ivec3& middle,
               const glm::ivec3& half) {
  for (int k = middle.z - half.z; k <= middle.z + half.z; ++k)
    for (int j = middle.y - half.y; j <= middle.y + half.y; ++j)
      for (int i = middle.x - half.x; i <= middle.x + half.x; ++i)
        voxels[voxelOffset(dims, i, j, k)] = 1000;
}

// The cube from below, and half as much again around it.
Scene sceneAround(const std::shared_ptr<const Volume>& volume, const glm::ivec3& middle, double halfMm) {
  Scene scene;
  scene.volume = volume;
  scene.transferFunction = {0.1, {{400.0, {1.0, 1.0, 1.0}, 0.0}, {600.0, {1.0, 1.0, 1.0}, 0.9}}};
  scene.camera.projection = Camera::Projection::orthographic;
  scene.camera.target = indexToWorld(volume->grid(), middle);
  scene.camera.position = scene.camera.target - glm::dvec3(0.0, 0.0, 1e5);
  scene.camera.up = {0.0, 1.0, 0.0};
  scene.camera.heightMm = 3.0 * halfMm;
  scene.projection = Projection::xray; // needs no gradients, which are one more pass over all voxels
  return scene;
}

void expectTheCube(const Image& image) {
  for (int y = 0; y < largePicture.y; ++y)
    for (int x = 0; x < largePicture.x; ++x) {
      const int off = std::max(std::abs(2 * x + 1 - largePicture.x), std::abs(2 * y + 1 - largePicture.y));
      const float alpha = image.at(x, y).a;
      if (off < largePicture.x * 3 / 5) {
        EXPECT_GT(alpha, 0.99f) << x << " " << y;
      } else if (off > largePicture.x * 3 / 4) {
        EXPECT_EQ(alpha, 0.0f) << x << " " << y;
      }
    }
}

void expectItDrawn(const glm::ivec3& dims, const glm::ivec3& middle, const glm::ivec3& half) {
  const auto volume =
      test::sparseVolume(dims, [&](std::int16_t* voxels) { writeCube(voxels, dims, middle, half); });
  const std::uint64_t before = test::ownMemory();
  const auto start = std::chrono::steady_clock::now();
  CpuRenderer renderer;
  expectTheCube(renderer.render(sceneAround(volume, middle, half.x), largePicture));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::cout << 2e-9 * static_cast<double>(volume->voxelCount()) << " GB: drawn in " << took.count()
            << " s; own memory grew by "
            << (static_cast<double>(test::ownMemory()) - static_cast<double>(before)) / 1e6
            << " MB, in the room " << static_cast<double>(volume->room()->taken()) / 1e9 << " GB\n";
  if (test::isSanitised)
    GTEST_SKIP() << "checked all but its memory, which a sanitizer's own would be counted in";
  EXPECT_LT(test::ownMemory(), before + 300e6);
}

double secondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Nested shells about the middle.
void writeShells(std::int16_t* voxels, const glm::ivec3& dims) {
  forEachPiece(dims.z, {}, [&](int k) {
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) {
        const glm::ivec3 off = glm::ivec3(i, j, k) - dims / 2;
        const int squares = off.x * off.x + off.y * off.y + off.z * off.z;
        voxels[voxelOffset(dims, i, j, k)] = static_cast<std::int16_t>(squares / 64 % 1000);
      }
  });
}

// A budget of 300 MB for 1.5 GB: what the process keeps for itself beside what it has anyway.
TEST(LargeVolume, isMovedAndDrawnWithinABudgetOfAFifth) {
  const glm::ivec3 dims(1024, 1024, 700);
  const glm::ivec2 size(512, 512);
  const auto volume = test::sparseVolume(dims, [&](std::int16_t* voxels) { writeShells(voxels, dims); });
  Scene scene = sceneAround(volume, dims / 2, 400.0);
  const MemoryBudget budget(300'000'000);
  const auto engine = makeCpuEngine(0, budget);
  const double before = static_cast<double>(test::ownMemory());
  const auto grown = [&] { return static_cast<double>(test::ownMemory()) - before; };
  const double ready = secondsOf([&] { engine->makeReady(scene, {}); });
  const std::optional<StandIn> standIn = engine->standInFor(scene, size);
  ASSERT_TRUE(standIn);
  const PixelRect whole{{0, 0}, size};
  const auto draws = [&](const Scene& drawn) { engine->draw(drawn, size, whole, {}); };
  draws(standIn->scene);
  const double moving = secondsOf([&] { draws(standIn->scene); });
  const double first = secondsOf([&] { draws(scene); });
  const double rest = secondsOf([&] { draws(scene); });
  std::cout << "ready in " << ready << " s; moving at 1/" << standIn->coarseness.reduction
            << " of the voxels (off by at most " << 100.0 * standIn->coarseness.largestError
            << " % of the range) in " << moving << " s, at rest in " << first << " s, then " << rest
            << " s; own memory grew by " << grown() / 1e6 << " MB, in the room "
            << static_cast<double>(volume->room()->taken()) / 1e6 << " MB\n";
  if (test::isSanitised)
    GTEST_SKIP() << "checked all but its memory, which a sanitizer's own would be counted in";
  EXPECT_LT(grown(), 0.5 * static_cast<double>(budget.bytes()));
}

// Light finds as few nodes of 1024³ voxels as of any: a coarser grid, in memory that does not grow with them.
TEST(LargeVolume, shadowsAndOcclusionOfVoxelsOnDiskTakeLittle) {
  const glm::ivec3 dims(1024), middle(500, 520, 480);
  const auto volume = test::sparseVolume(
      dims, [&](std::int16_t* voxels) { writeCube(voxels, dims, middle, glm::ivec3(40)); });
  Scene scene = sceneAround(volume, middle, 40.0);
  scene.projection = Projection::composite;
  scene.shading.model = ShadingModel::classic;
  scene.shading.lightDirection = glm::dvec3(0.5, 0.6, 1.0);
  scene.shading.occlusion = {0.8, 15.0};
  CpuRenderer renderer;
  const Image plain = renderer.render(scene, largePicture); // blocks and gradients are found once
  const std::uint64_t before = test::ownMemory();
  scene.shading.shadow = {0.85, 5.0};
  Image lit;
  const double took = secondsOf([&] { lit = renderer.render(scene, largePicture); });
  std::cout << "light of 1024³ voxels on disk: " << took << " s, own memory grew by "
            << (static_cast<double>(test::ownMemory()) - static_cast<double>(before)) / 1e6 << " MB\n";
  EXPECT_NE(lit, plain);
  for (const glm::vec4& pixel : lit.pixels)
    ASSERT_TRUE(pixel.a >= 0.0f && pixel.a <= 1.0f && pixel.r <= 1.0f && pixel.r >= 0.0f);
  if (test::isSanitised)
    GTEST_SKIP() << "checked all but its memory, which a sanitizer's own would be counted in";
  EXPECT_LT(test::ownMemory(), before + 100e6);
}

// A slice of 4.4 GB.
TEST(LargeVolume, aSliceMayTakeMoreThanFourGigabytes) {
  expectItDrawn({66000, 33000, 1}, {65000, 32000, 0}, {400, 400, 0});
}

TEST(LargeVolume, threeThousandVoxelsAlongEachAxisAreDrawn) {
  expectItDrawn(glm::ivec3(3000), {2800, 2900, 2750}, glm::ivec3(50));
}

} // namespace
} // namespace limn
