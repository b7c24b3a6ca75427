// SPDX-License-Identifier: GPL-3.0-or-later
// Loading on a thread of its own, with an event loop and without a window: what ThreadSanitizer watches.
#include "app/files/opening/OpeningController.h"
#include "io/dicom/SyntheticSeries.h"
#include "support/FileBytes.h"
#include "support/Openings.h"
#include "support/TemporaryFolder.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <gtest/gtest.h>

namespace limn {
namespace {

class VolumeLoading : public testing::Test {
protected:
  VolumeLoading() {
    std::string bytes = "NRRD0004\ntype: short\ndimension: 3\nsizes: 64 64 64\nspacings: 1 1 1\n"
                        "endian: little\nencoding: raw\n\n";
    for (int i = 0; i < 64 * 64 * 64; ++i)
      bytes += {static_cast<char>(i), static_cast<char>(i >> 15)};
    test::writeBytes(folder.path() / "good.nrrd", bytes);
    test::writeBytes(folder.path() / "bad.nrrd", bytes.substr(0, 1000));
    QObject::connect(&loader, &VolumeLoader::loaded, &loop,
                     [this](const LoadedScene& scene, const Histogram&) {
                       loaded = scene;
                       loop.quit();
                     });
    QObject::connect(&loader, &VolumeLoader::failed, &loop, [this](const QString&, const QString& why) {
      sentence = why;
      loop.quit();
    });
    QObject::connect(&loader, &VolumeLoader::progressed, &loop,
                     [this](double, const QString&) { ++reports; });
  }

  QString pathOf(const char* name) const { return QString::fromStdString((folder.path() / name).string()); }

  // Runs the event loop until a load has ended.
  void waitForTheEnd() { loop.exec(); }

  test::TemporaryFolder folder;
  QEventLoop loop;
  LoadedScene loaded;
  QString sentence;
  int reports = 0;
  VolumeLoader loader; // ends its threads before what they tell goes
};

TEST_F(VolumeLoading, endsWithTheVolumeOrASentence) {
  loader.start(pathOf("good.nrrd"), {});
  waitForTheEnd();
  ASSERT_TRUE(loaded.scene.volume);
  EXPECT_EQ(loaded.scene.volume->grid().dims, glm::ivec3(64));
  loader.start(pathOf("bad.nrrd"), {});
  waitForTheEnd();
  EXPECT_TRUE(sentence.contains(QLatin1String("bad.nrrd"))) << sentence.toStdString();
}

TEST_F(VolumeLoading, onlyTheLastOfManyStartsIsTold) {
  for (int i = 0; i < 20; ++i)
    loader.start(pathOf(i % 2 == 0 ? "bad.nrrd" : "good.nrrd"), {});
  waitForTheEnd();
  EXPECT_TRUE(loaded.scene.volume);
  EXPECT_TRUE(sentence.isEmpty()) << sentence.toStdString();
}

// What is cancelled must not go on reading: its end is waited for.
TEST_F(VolumeLoading, ofAFolderOfFiveThousandImagesEndsWithinASecond) {
  const std::filesystem::path series = folder.path() / "series";
  std::filesystem::create_directory(series);
  for (int k = 0; k < 5000; ++k)
    test::slice(k + 1, k).write(series / std::to_string(10000 + k));
  auto another = std::make_unique<VolumeLoader>();
  double told = -1.0;
  QObject::connect(another.get(), &VolumeLoader::progressed, &loop, [&](double fraction, const QString&) {
    told = fraction;
    loop.quit();
  });
  test::Openings openings(series);
  another->start(QString::fromStdString(series.string()), {});
  waitForTheEnd();
  EXPECT_EQ(told, 0.0) << "the first headers are reported";
  const auto start = std::chrono::steady_clock::now();
  another->cancel();
  another.reset(); // waits for its thread
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  std::printf("time: a folder of 5,000 images is let go after %.1f ms\n", taken.count());
  EXPECT_LT(taken.count(), 1000.0);
  EXPECT_LT(openings.counted().size(), 5000u);
}

TEST_F(VolumeLoading, aCancelledLoadTellsNothingMore) {
  loader.start(pathOf("good.nrrd"), {});
  loader.cancel();
  EXPECT_FALSE(loader.isLoading());
  loader.start(pathOf("bad.nrrd"), {});
  waitForTheEnd();
  EXPECT_FALSE(loaded.scene.volume);
}

} // namespace
} // namespace limn

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const QCoreApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
