// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in for a volume on disk while something moves.
#include "cpu/CpuEngine.h"
#include "engine/DrawingEngine.h"
#include "scene/basics/Error.h"
#include "scene/regions/Reduction.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/Heads.h"
#include "support/MappedVolume.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

constexpr glm::ivec2 fewPixels{48, 40};

class StandInsOfTheEngine : public testing::Test {
protected:
  StandInsOfTheEngine() {
    m_scene = test::noisyPhantom(ShadingModel::robust);
    m_inMemory = m_scene.volume;
    m_scene.volume = test::mapped(*m_inMemory, m_folder.path() / "voxels");
  }

  Image drawn(DrawingEngine& engine, const Scene& scene) {
    return *engine.draw(scene, fewPixels, {{0, 0}, fewPixels}, {});
  }

  test::TemporaryFolder m_folder;
  Scene m_scene;
  std::shared_ptr<const Volume> m_inMemory;
};

TEST_F(StandInsOfTheEngine, areThereForVolumesOnDiskOnceTheseAreReady) {
  const auto engine = makeCpuEngine(2);
  EXPECT_FALSE(engine->standInFor(m_scene, fewPixels)) << "not ready";
  EXPECT_EQ(engine->makeReady(m_scene, {}), 1.0);
  const auto standIn = engine->standInFor(m_scene, fewPixels);
  ASSERT_TRUE(standIn);
  EXPECT_FALSE(standIn->scene.volume->room()) << "it lies in memory";
  EXPECT_GT(standIn->coarseness.largestError, 0.0);
  EXPECT_LT(standIn->coarseness.largestError, 1.0);
  Scene rest = standIn->scene;
  rest.volume = m_scene.volume;
  EXPECT_EQ(rest, m_scene) << "nothing else differs";

  Scene inMemory = m_scene;
  inMemory.volume = m_inMemory;
  engine->makeReady(inMemory, {});
  EXPECT_FALSE(engine->standInFor(inMemory, fewPixels));
  EXPECT_FALSE(engine->standInFor(m_scene, fewPixels)) << "another volume's";
}

TEST_F(StandInsOfTheEngine, takeTurnsWithTheWholeVolumeAndChangeNoBit) {
  const auto engine = makeCpuEngine(2), whole = makeCpuEngine(2), coarse = makeCpuEngine(2);
  engine->makeReady(m_scene, {});
  const StandIn standIn = *engine->standInFor(m_scene, fewPixels);
  const Image exact = drawn(*whole, m_scene), rough = drawn(*coarse, standIn.scene);
  EXPECT_NE(exact, rough);
  for (int turn = 0; turn < 2; ++turn) {
    EXPECT_EQ(drawn(*engine, standIn.scene), rough);
    EXPECT_EQ(engine->gradientScale().largest, coarse->gradientScale().largest);
    EXPECT_EQ(drawn(*engine, m_scene), exact);
    EXPECT_EQ(engine->gradientScale().largest, whole->gradientScale().largest);
  }
}

TEST_F(StandInsOfTheEngine, areAsCoarseAsThePixelsAndAsTheBudget) {
  const auto engine = makeCpuEngine(2);
  engine->makeReady(m_scene, {});
  const auto reductionIn = [&](DrawingEngine& of, int pixels) {
    return of.standInFor(m_scene, glm::ivec2(pixels))->coarseness.reduction;
  };
  EXPECT_EQ(reductionIn(*engine, 4000), 2) << "the finest there is";
  EXPECT_EQ(reductionIn(*engine, 4), 8);
  EXPECT_LT(reductionIn(*engine, 64), 8);
  const std::uint64_t bytes = 2 * m_inMemory->voxelCount();
  const auto poor = makeCpuEngine(2, MemoryBudget(bytes / 4));
  poor->makeReady(m_scene, {});
  EXPECT_EQ(reductionIn(*poor, 4000), 4) << "an eighth of the budget is a thirty-second of the volume";
}

TEST_F(StandInsOfTheEngine, keepWhatTheWholeVolumeKeeps) {
  m_scene.keep = cubesRegion(m_scene.volume->grid().dims, 11, {0.0, 1.0, 0.0, 0.3});
  const auto engine = makeCpuEngine(2);
  engine->makeReady(m_scene, {});
  const StandIn standIn = *engine->standInFor(m_scene, fewPixels);
  const Region expected = reduced(m_scene.keep, glm::ivec3(standIn.coarseness.reduction));
  EXPECT_EQ(standIn.scene.keep.labels->places(), expected.labels->places());
  EXPECT_EQ(standIn.scene.keep.weights, expected.weights);
  EXPECT_EQ(standIn.scene.keep.labels->dims(), standIn.scene.volume->grid().dims);
  EXPECT_NO_THROW(drawn(*engine, standIn.scene));
}

TEST_F(StandInsOfTheEngine, canBeLeftOnTheWay) {
  const auto engine = makeCpuEngine(1);
  int asked = 0;
  engine->makeReady(m_scene, {1, [&] { return ++asked < 0; }, {}});
  const int all = asked;
  ASSERT_GT(all, 3);
  for (int after = 0; after < all; after += 1 + all / 7) {
    const auto other = makeCpuEngine(1);
    asked = 0;
    EXPECT_THROW(other->makeReady(m_scene, {1, [&] { return asked++ == after; }, {}}), Cancelled);
    EXPECT_FALSE(other->standInFor(m_scene, fewPixels));
    EXPECT_NO_THROW(drawn(*other, m_scene));
    EXPECT_EQ(other->makeReady(m_scene, {}), 1.0);
    EXPECT_TRUE(other->standInFor(m_scene, fewPixels));
  }
}

} // namespace
} // namespace limn
