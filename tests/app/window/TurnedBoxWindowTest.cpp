// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/RegionController.h"
#include "scene/regions/Cut.h"
#include "widgets/properties/CropFaces.h"
#include "widgets/properties/CropSection.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QMenu>
#include <QPushButton>
#include <QStatusBar>

#include <set>

// The crop box that lies as the picture is seen: around what shows, its faces named, its cuts taken back.

namespace limn {
namespace {

class TurnedBoxWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:6")));
    session().setCamera(orbited(scene().camera, 0.5, 0.4));
    ASSERT_TRUE(rest());
  }

  QAction& named(const char* name) { return *window->findChild<QAction*>(QLatin1String(name)); }
  const std::optional<TurnedBox>& turned() { return view().order().comparison.turnedBox; }
  [[nodiscard]] bool ready() {
    return test::waitUntil([this] { return !window->findChild<RegionController*>()->isBusy(); });
  }
  // A face moved by a share of the whole box, as a drag asks for it.
  void moveFace(const CropFace& face, double by) {
    const CropBox crop = withFaceAt(turned()->crop, turned()->grid, face, placeOf(turned()->crop, face) + by);
    emit view().input().turnedBoxEdited(crop, {nextGestureId(), QStringLiteral("move")});
    ASSERT_TRUE(ready());
  }
  QToolButton* offered(const QString& text) {
    for (QToolButton* button : messages().findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == text)
        return button;
    return nullptr;
  }
};

TEST_F(TurnedBoxWindow, liesCloseAroundWhatShows) {
  const int steps = undo().count();
  named("turnCropBox").trigger();
  ASSERT_TRUE(turned());
  EXPECT_EQ(undo().count(), steps) << "it takes nothing away yet";
  const TurnedBox box = *turned();
  const Volume& volume = *scene().volume;
  const Grid& grid = volume.grid();
  glm::dvec3 lowest(1.0), highest(0.0); // of what shows, along the axes of the box
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x) {
        if (classify(scene().transferFunction, valueAt(volume, {x, y, z})).opacity < 0.02 ||
            weightAt(scene().keep, {x, y, z}) == 0.0)
          continue;
        const glm::dvec3 at =
            (worldToIndex(box.grid, indexToWorld(grid, {x, y, z})) + 0.5) / glm::dvec3(box.grid.dims);
        lowest = glm::min(lowest, at);
        highest = glm::max(highest, at);
      }
  ASSERT_LT(lowest.x, highest.x);
  // A voxel and a half, which is as long as its diagonal where the box is turned, and the next one.
  const glm::dvec3 near = 3.0 * std::sqrt(3.0) * 6.0 / boxSizeMm(box.grid);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(box.crop.lower[axis], lowest[axis]) << axis;
    EXPECT_GE(box.crop.upper[axis], highest[axis]) << axis;
    EXPECT_GE(box.crop.lower[axis], std::max(0.0, lowest[axis] - near[axis])) << axis;
    EXPECT_LE(box.crop.upper[axis], std::min(1.0, highest[axis] + near[axis])) << axis;
  }
  EXPECT_LT(shareLeft(box.crop), 0.8) << "the volume's corners reach farther";
}

TEST_F(TurnedBoxWindow, aFaceThatNobodyMovedCutsNothing) {
  named("turnCropBox").trigger();
  ASSERT_TRUE(turned());
  const TurnedBox whole = *turned();
  for (const CropFace face : cropFaces)
    EXPECT_EQ(cutBy(whole, face), 0.0);
  moveFace({2, true}, -0.2);
  ASSERT_EQ(scene().keep.cuts.size(), 1u) << "one line says what one face cuts";
  const TurnedBox cut = *turned();
  EXPECT_NEAR(cutBy(cut, {2, true}), 0.2, 1e-9);
  EXPECT_EQ(cutBy(cut, {0, false}), 0.0);
  // Beside the box, below its cut face, all is kept: another curve may show it.
  const auto* scissors = std::get_if<Scissors>(&scene().keep.cuts.front().how);
  ASSERT_NE(scissors, nullptr);
  EXPECT_NE(cut.crop.lower.x, 0.0);
  const TurnedBox only{cut.grid, {glm::dvec3(0.0), {1.0, 1.0, cut.crop.upper.z}}};
  EXPECT_EQ(cutsOf(cut), cutsOf(only));
  undo().undo();
  ASSERT_TRUE(ready());
  undo().redo();
  ASSERT_TRUE(ready());
  ASSERT_TRUE(turned());
  EXPECT_EQ(turned()->fit, whole.fit) << "found again it stands where it stood";
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(turned()->crop.upper[axis], cut.crop.upper[axis], 1e-9);
}

TEST_F(TurnedBoxWindow, eachFaceHasANameOfItsOwn) {
  named("turnCropBox").trigger();
  ASSERT_TRUE(turned());
  std::set<QString> names;
  for (const CropFace face : cropFaces)
    names.insert(turnedFaceName(*turned(), *scene().volume, face));
  EXPECT_EQ(names, (std::set<QString>{"back", "feet", "front", "head", "left", "right"}));
  VolumeInfo unknown = scene().volume->info();
  unknown.orientationKnown = false;
  const Volume volume = scene().volume->placed(scene().volume->grid(), unknown);
  names.clear();
  for (const CropFace face : cropFaces)
    names.insert(turnedFaceName(*turned(), volume, face));
  EXPECT_EQ(names.size(), 6u);
}

TEST_F(TurnedBoxWindow, putAwayItTellsWhatStaysCutAndTakesItBack) {
  named("cropBox").trigger();
  named("cropBox").trigger();
  EXPECT_EQ(offered(QStringLiteral("Close the box's cuts")), nullptr) << "nothing is cut";
  named("turnCropBox").trigger();
  ASSERT_TRUE(turned());
  moveFace({0, false}, 0.1);
  moveFace({1, true}, -0.1);
  ASSERT_EQ(scene().keep.cuts.size(), 2u);
  named("cropBox").trigger();
  EXPECT_FALSE(view().cropBoxIsVisible());
  EXPECT_EQ(scene().keep.cuts.size(), 2u);
  QToolButton* close = offered(QStringLiteral("Close the box's cuts"));
  ASSERT_NE(close, nullptr);
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("stays")));
  // Shown again it says what is cut by itself.
  named("cropBox").trigger();
  EXPECT_EQ(offered(QStringLiteral("Close the box's cuts")), nullptr);
  named("cropBox").trigger();
  close = offered(QStringLiteral("Close the box's cuts"));
  ASSERT_NE(close, nullptr);
  QTest::mouseClick(close, Qt::LeftButton);
  ASSERT_TRUE(ready());
  EXPECT_TRUE(scene().keep.cuts.empty());
  EXPECT_FALSE(messages().isVisible());
  undo().undo();
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep.cuts.size(), 2u) << "in one step";
}

TEST_F(TurnedBoxWindow, whatWentWrongIsStillSaidOnceItIsPutAway) {
  named("turnCropBox").trigger();
  ASSERT_TRUE(turned());
  moveFace({0, false}, 0.1);
  messages().show(MessageBar::Kind::error, QStringLiteral("The picture could not be written."));
  named("cropBox").trigger();
  EXPECT_FALSE(view().cropBoxIsVisible());
  EXPECT_EQ(messages().sentence(), QStringLiteral("The picture could not be written."));
  EXPECT_TRUE(window->statusBar()->currentMessage().contains(QStringLiteral("stays")));
}

TEST_F(TurnedBoxWindow, theCropsOwnCutsAreTakenBackLikewise) {
  named("cropBox").trigger();
  CropBox crop = scene().crop;
  crop.upper.z = 0.6;
  session().setCrop(crop, {nextGestureId(), QStringLiteral("crop")});
  named("cropBox").trigger();
  QToolButton* close = offered(QStringLiteral("Close the box's cuts"));
  ASSERT_NE(close, nullptr);
  QTest::mouseClick(close, Qt::LeftButton);
  EXPECT_EQ(scene().crop, CropBox{});
  EXPECT_EQ(undo().undoText(), QStringLiteral("close the box's cuts"));
}

TEST_F(TurnedBoxWindow, isTurnedFromTheSectionAndFromTheButtonToo) {
  auto* section = window->findChild<CropSection*>();
  QPushButton* turn = nullptr;
  for (QPushButton* button : section->findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Turn to this view"))
      turn = button;
  ASSERT_NE(turn, nullptr);
  turn->click();
  EXPECT_TRUE(turned());
  named("cropBox").trigger();
  ASSERT_FALSE(turned());
  auto* button =
      qobject_cast<QToolButton*>(window->findChild<QToolBar*>()->widgetForAction(&named("cropBox")));
  ASSERT_TRUE(button && button->menu());
  EXPECT_EQ(button->popupMode(), QToolButton::MenuButtonPopup);
  ASSERT_EQ(button->menu()->actions(), QList<QAction*>{&named("turnCropBox")});
  button->menu()->actions().front()->trigger();
  EXPECT_TRUE(turned());
  EXPECT_EQ(button->defaultAction(), &named("cropBox"));
}

} // namespace
} // namespace limn
