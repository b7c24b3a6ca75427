// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/presets/PresetStore.h"
#include "widgets/PresetNames.h"

#include <QAbstractItemModel>
#include <QInputDialog>

// What presets make of the volume that is open, in the list of the program's window.

namespace limn {
namespace {

class ThumbnailWindow : public test::WindowHarness {
protected:
  PresetBrowser& browser() const { return *window->findChild<PresetBrowser*>(); }
  ThumbnailController& controller() const { return *window->findChild<ThumbnailController*>(); }

  QModelIndex row(const char* preset) const {
    const QAbstractItemModel* model = browser().findChild<QTreeView*>()->model();
    const QModelIndexList found = model->match(model->index(0, 0), Qt::DisplayRole, QLatin1String(preset), 1,
                                               Qt::MatchExactly | Qt::MatchRecursive);
    return found.empty() ? QModelIndex() : found.front();
  }
  // Which differ from the picture's first corner.
  static int drawnPixels(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
        count += picture.pixel(x, y) != picture.pixel(0, 0) ? 1 : 0;
    return count;
  }
  QImage picture(const char* preset) const { return row(preset).data(presetRole::picture).value<QImage>(); }
  int pictures() const {
    int count = 0;
    for (const QString& name : presetNames(browser()))
      count += !picture(name.toUtf8()).isNull();
    return count;
  }
  [[nodiscard]] bool complete() const {
    return test::waitUntil([this] { return controller().isComplete(); });
  }
};

TEST_F(ThumbnailWindow, everyPresetShowsWhatItMakesOfTheVolume) {
  EXPECT_EQ(pictures(), 0) << "there is no volume";
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const int steps = undo().count();
  ASSERT_TRUE(complete());
  EXPECT_EQ(pictures(), static_cast<int>(builtInPresets().size()));
  EXPECT_NE(picture("CT bone"), picture("CT skin and bone"));
  EXPECT_EQ(undo().count(), steps);
  window->findChild<QAction*>(QStringLiteral("closeVolume"))->trigger();
  EXPECT_EQ(pictures(), 0);
}

TEST_F(ThumbnailWindow, noPictureOfAnEarlierVolumeLandsOnTheNext) {
  ASSERT_TRUE(open(QStringLiteral("phantom:3")));
  ASSERT_TRUE(complete());
  const QImage expected = picture("CT bone");
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(test::waitUntil([this] { return pictures() > 0; }));
  const QImage other = picture("CT bone");
  ASSERT_TRUE(open(QStringLiteral("phantom:3"))); // while pictures are drawn
  EXPECT_EQ(pictures(), 0);
  ASSERT_TRUE(complete());
  EXPECT_EQ(picture("CT bone"), expected);
  EXPECT_NE(picture("CT bone"), other);
}

TEST_F(ThumbnailWindow, aDragEndsThemAndAfterItTheRestIsDrawn) {
  ASSERT_TRUE(open(QStringLiteral("phantom:2")));
  ASSERT_TRUE(test::waitUntil([this] { return pictures() > 0; }));
  const QPoint middle = view().mapTo(window.get(), view().rect().center());
  QTest::mousePress(window->windowHandle(), Qt::LeftButton, {}, middle);
  QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, {}, middle + QPoint(5, 0));
  QCoreApplication::sendPostedEvents();
  const int drawn = pictures();
  for (int step = 2; step <= 20; ++step) {
    QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, {},
                      middle + QPoint(5 * step, 0));
    QCoreApplication::processEvents();
    EXPECT_EQ(pictures(), drawn);
  }
  QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, middle + QPoint(100, 0));
  ASSERT_TRUE(complete());
  EXPECT_EQ(pictures(), static_cast<int>(builtInPresets().size()));
}

TEST_F(ThumbnailWindow, theyFollowTheViewOnceItRestsFromAnotherSide) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(complete());
  const QImage front = picture("CT bone");
  session().setCamera(orbited(scene().camera, 0.05, 0.0));
  ASSERT_TRUE(complete());
  EXPECT_EQ(picture("CT bone"), front) << "a small turn";
  window->findChild<QAction*>(QStringLiteral("view-left"))->trigger();
  ASSERT_FALSE(controller().isComplete());
  ASSERT_TRUE(complete());
  EXPECT_NE(picture("CT bone"), front);
}

TEST_F(ThumbnailWindow, theyShowTheWholeHoweverNearOrFarOffTheViewIs) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(complete());
  const QImage framed = picture("CT bone");
  const Camera at = scene().camera;
  for (const double distance : {6.0, 12.0, 0.3}) {
    Camera camera = at;
    camera.position = camera.target + distance * (camera.position - camera.target);
    session().setCamera(distance < 1.0 ? panned(camera, 0.4, 0.2) : camera);
    ASSERT_TRUE(rest() && complete());
    EXPECT_EQ(picture("CT bone"), framed) << distance;
  }
  // The head fills 0.88 of the height and is two thirds as wide as high: as an ellipse it covers 0.3 of a
  // picture of 4:3, and most of it is bone.
  EXPECT_GT(drawnPixels(framed), framed.width() * framed.height() / 6) << "no speck";
}

TEST_F(ThumbnailWindow, aPresetThatHidesEverythingSaysSo) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  session().setTransferFunction({1.0, {{5000.0, {1, 1, 1}, 0.0}, {6000.0, {1, 1, 1}, 0.5}}},
                                {nextGestureId(), QStringLiteral("nothing")});
  onceAsked<QInputDialog>([](QInputDialog& dialog) {
    dialog.setTextValue(QStringLiteral("Nothing"));
    dialog.accept();
  });
  window->findChild<QAction*>(QStringLiteral("savePreset"))->trigger();
  ASSERT_TRUE(test::waitUntil([this] { return row("Nothing").isValid(); }));
  ASSERT_TRUE(complete());
  EXPECT_TRUE(row("Nothing").data(presetRole::showsNothing).toBool());
  EXPECT_TRUE(row("Nothing").data(Qt::AccessibleTextRole).toString().contains("shows nothing"));
  EXPECT_FALSE(row("CT bone").data(presetRole::showsNothing).toBool());
}

TEST_F(ThumbnailWindow, fourHundredPresetsOfTheUsersOwnAreAllSeen) {
  const UserFolders folders = UserFolders::below(folder.path());
  Preset preset = builtInPresets().front();
  for (int i = 0; i < 400; ++i) {
    preset.name = "Mine " + std::to_string(i);
    PresetStore(folders.presets).save(preset);
  }
  window = std::make_unique<MainWindow>(folders);
  window->view().setRefinesAtRest(false);
  window->show();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(complete());
  EXPECT_EQ(pictures(), 400 + static_cast<int>(builtInPresets().size()));
}

} // namespace
} // namespace limn
