// SPDX-License-Identifier: GPL-3.0-or-later
// Loading on a thread of its own, with an event loop and without a window: what ThreadSanitizer watches.
#include "app/opening/VolumeLoader.h"
#include "app/opening/SparseReports.h"
#include "support/FileBytes.h"
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

// A report has the window painted: work that tells of each of its pieces must not flood it.
TEST(SparseReports, passOnWhatSaysSomethingElseAndTheRestNowAndThen) {
  std::vector<std::string> told;
  SparseReports reports([&](double, const Message& what) { told.push_back(what.english()); });
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 100000; ++i)
    reports(1e-5 * i, "Reading");
  const auto took = std::chrono::steady_clock::now() - start;
  EXPECT_GE(told.size(), 1u);
  EXPECT_LE(told.size(), static_cast<std::size_t>(took / betweenReports) + 1);
  const std::size_t before = told.size();
  reports(0.0, "Counting");
  reports(0.0, "Reading");
  EXPECT_EQ(told.size(), before + 2);
}

TEST_F(VolumeLoading, onlyTheLastOfManyStartsIsTold) {
  for (int i = 0; i < 20; ++i)
    loader.start(pathOf(i % 2 == 0 ? "bad.nrrd" : "good.nrrd"), {});
  waitForTheEnd();
  EXPECT_TRUE(loaded.scene.volume);
  EXPECT_TRUE(sentence.isEmpty()) << sentence.toStdString();
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
