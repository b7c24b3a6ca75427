// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/ThumbnailController.h"
#include "app/presets/PresetStore.h"
#include "scene/basics/Error.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Phantom.h"
#include "support/JudgedTime.h"

#include <QElapsedTimer>

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include <pthread.h>

namespace limn {
namespace {

constexpr QSize thumbSize{48, 36};

Scene phantomSceneOf(double spacingMm) {
  Scene scene;
  scene.volume = phantomVolume({spacingMm, 0.0, 1});
  scene.camera = defaultCamera(scene.volume->grid());
  scene.transferFunction.points = {{-300, {0.9, 0.6, 0.5}, 0.0}, {1500, {1.0, 1.0, 1.0}, 0.9}};
  return scene;
}

struct DrawnThumbnail {
  QString name;
  QImage picture;
  bool showsNothing = false;
};

std::vector<DrawnThumbnail> thumbnailsOf(const std::vector<Thumbnail>& wanted, std::size_t endAfter = 1000) {
  std::vector<DrawnThumbnail> drawn;
  const auto isEnded = [&] { return drawn.size() >= endAfter; };
  try {
    ThumbnailPainter().draw(wanted, thumbSize, isEnded,
                            [&](const QString& name, const QImage& picture, bool showsNothing) {
                              drawn.push_back({name, picture, showsNothing});
                            });
  } catch (const Cancelled&) {
    EXPECT_TRUE(isEnded());
  }
  return drawn;
}

TEST(Thumbnail, showsTheSceneAndTellsWhereThereIsNothingToSee) {
  const Scene scene = phantomSceneOf(4.0);
  Scene hidden = scene;
  hidden.transferFunction.points = {{0.0, {1, 1, 1}, 0.0}};
  const std::vector<DrawnThumbnail> drawn =
      thumbnailsOf({{QStringLiteral("head"), scene}, {QStringLiteral("nothing"), hidden}});
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_EQ(drawn[0].picture.size(), thumbSize);
  EXPECT_FALSE(drawn[0].showsNothing);
  EXPECT_GT(qGray(drawn[0].picture.pixel(24, 18)), 60);
  EXPECT_TRUE(drawn[1].showsNothing);
  EXPECT_EQ(drawn[1].picture.pixel(24, 18), drawn[0].picture.pixel(0, 0)) << "the background";
}

TEST(Thumbnail, honoursWhatIsKeptAndCut) {
  const Scene scene = phantomSceneOf(4.0);
  Scene dropped = scene;
  const glm::ivec3 dims = scene.volume->grid().dims;
  dropped.keep =
      bodyRegion(dims, std::vector<std::uint8_t>(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 0));
  Scene cut = scene;
  cut.crop.upper.x = 0.5;
  const std::vector<DrawnThumbnail> drawn = thumbnailsOf(
      {{QStringLiteral("whole"), scene}, {QStringLiteral("dropped"), dropped}, {QStringLiteral("cut"), cut}});
  ASSERT_EQ(drawn.size(), 3u);
  EXPECT_FALSE(drawn[0].showsNothing);
  EXPECT_TRUE(drawn[1].showsNothing);
  EXPECT_NE(drawn[2].picture, drawn[0].picture);
}

// Twice as many voxels along each axis as a thumbnail has a use for: the picture hardly changes.
TEST(Thumbnail, ofALargeVolumeIsThatOfTheVolumeMadeCoarser) {
  const std::vector<DrawnThumbnail> fine =
      thumbnailsOf({{QStringLiteral("fine"), phantomSceneOf(1.4)}}); // 4 million voxels
  const std::vector<DrawnThumbnail> coarse = thumbnailsOf({{QStringLiteral("coarse"), phantomSceneOf(2.8)}});
  ASSERT_EQ(fine.size() + coarse.size(), 2u);
  double sum = 0.0;
  for (int y = 0; y < thumbSize.height(); ++y)
    for (int x = 0; x < thumbSize.width(); ++x)
      sum += std::abs(qGray(fine[0].picture.pixel(x, y)) - qGray(coarse[0].picture.pixel(x, y)));
  EXPECT_LT(sum / (thumbSize.width() * thumbSize.height()), 4.0) << "levels of 255, on average";
}

TEST(Thumbnail, nothingIsDrawnOfAnOrderThatHasEnded) {
  const Scene scene = phantomSceneOf(4.0);
  const std::vector<Thumbnail> wanted(5, {QStringLiteral("head"), scene});
  EXPECT_EQ(thumbnailsOf(wanted, 2).size(), 2u);
}

// Spare time is short: all built-in presets take 3 s of one core at most.
TEST(Thumbnail, allBuiltInPresetsTakeLittleTime) {
  Scene scene = phantomSceneOf(1.4);
  const Histogram histogram = histogramOf(*scene.volume);
  std::vector<Thumbnail> wanted;
  for (const Preset& preset : builtInPresets())
    wanted.push_back({QString::fromStdString(preset.name),
                      withPreset(scene, fittedTo(preset, histogram, scene.volume->grid()), true)});
  int drawn = 0;
  QElapsedTimer clock;
  clock.start();
  ThumbnailPainter().draw(
      wanted, {96, 72}, [] { return false; }, [&](auto&&...) { ++drawn; });
  test::judgeMs("thumbnails of all built-in presets", static_cast<double>(clock.elapsed()), 3000.0);
  EXPECT_EQ(drawn, static_cast<int>(builtInPresets().size()));
}

double msOf(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

// A drag must not wait for them: what is still computed after the word, in processor time.
TEST(Thumbnail, anOrderEndsWithinAMoment) {
  const std::vector<Thumbnail> wanted(1000, {QStringLiteral("head"), phantomSceneOf(2.0)});
  ThumbnailPainter painter;
  std::atomic<int> drawn = 0;
  std::atomic<bool> isEnded = false;
  double longest = 0.0;
  for (int order = 1; order <= 20; ++order) {
    drawn = 0;
    isEnded = false;
    double atEndMs = 0.0;
    std::thread thread([&] {
      EXPECT_THROW(painter.draw(
                       wanted, {192, 144}, [&] { return isEnded.load(); }, [&](auto&&...) { ++drawn; }),
                   Cancelled);
      atEndMs = test::threadMs();
    });
    clockid_t clock{};
    pthread_getcpuclockid(thread.native_handle(), &clock);
    while (drawn < 1)
      std::this_thread::yield();
    const double atWordMs = msOf(clock);
    isEnded = true;
    thread.join();
    longest = std::max(longest, atEndMs - atWordMs);
    EXPECT_LT(drawn, static_cast<int>(wanted.size()));
  }
  test::judgeMs("thumbnails until they have ended, the longest of 20", longest, 10.0);
}

TEST(Thumbnail, isNotDrawnAnewForASmallTurn) {
  Camera camera;
  EXPECT_TRUE(seeAlike(camera, orbited(camera, 0.1, 0.1)));
  EXPECT_FALSE(seeAlike(camera, orbited(camera, 0.3, 0.0)));
  EXPECT_FALSE(seeAlike(camera, rolled(camera, 0.3)));
  EXPECT_TRUE(seeAlike(camera, zoomed(camera, 1.1)));
  EXPECT_FALSE(seeAlike(camera, zoomed(camera, 1.5)));
  EXPECT_TRUE(seeAlike(camera, panned(camera, 0.1, 0.0)));
  EXPECT_FALSE(seeAlike(camera, panned(camera, 0.4, 0.0)));
}

} // namespace
} // namespace limn
