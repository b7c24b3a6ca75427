// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/CrosshairController.h"
#include "app/picture/RegionController.h"
#include "regions/ScissorSet.h"
#include "scene/light/Gradient.h"
#include "scene/volume/Phantom.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"
#include "widgets/view/gestures/ViewDrag.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/overlay/Titles.h"

#include <QMenu>
#include <QStatusBar>

// The crosshair of the slices in the picture: the cut that opens the volume to it, and its mark.

namespace limn {
namespace {

Grid gridOf(const glm::dmat3& direction) {
  Grid grid;
  grid.dims = {10, 20, 40};
  grid.spacingMm = {2.0, 1.0, 0.5};
  grid.originMm = {5.0, 6.0, 7.0};
  grid.direction = direction;
  return grid;
}

glm::dmat3 mirroredAndTurned() {
  const double a = 0.4;
  return {glm::dvec3(-std::cos(a), -std::sin(a), 0), glm::dvec3(-std::sin(a), std::cos(a), 0),
          glm::dvec3(0, 0, 1)};
}

TEST(CutOpen, theFaceThatFacesTheEyeMostGoesToThePlace) {
  for (const glm::dmat3& direction : {glm::dmat3(1.0), mirroredAndTurned()}) {
    const Grid grid = gridOf(direction);
    const glm::dvec3 place = indexToWorld(grid, {2.0, 12.0, 30.0});
    for (const CropFace face : cropFaces)
      for (const auto projection : {Camera::Projection::perspective, Camera::Projection::orthographic}) {
        Camera camera;
        camera.projection = projection;
        camera.target = boxCentreMm(grid);
        // From its side, and a little from another, too.
        const double side = face.isUpper ? 1.0 : -1.0;
        camera.position = camera.target + 400.0 * (side * grid.direction[face.axis] +
                                                   0.5 * grid.direction[(face.axis + 1) % 3]);
        ASSERT_EQ(faceTowards(camera, grid, place), face);
        const CropBox open = openedAt({}, grid, face, place);
        const glm::dvec3 fractions = (glm::dvec3(2.0, 12.0, 30.0) + 0.5) / glm::dvec3(grid.dims);
        EXPECT_NEAR(placeOf(open, face), fractions[face.axis], 1e-12); // rounding
        for (const CropFace other : cropFaces) {
          if (other != face) {
            EXPECT_EQ(placeOf(open, other), other.isUpper ? 1.0 : 0.0);
          }
        }
      }
  }
}

TEST(CutOpen, neverShowsWhatWasCroppedAndLeavesAVoxel) {
  const Grid grid = gridOf(glm::dmat3(1.0));
  CropBox crop;
  crop.lower.y = 0.5;
  crop.upper.y = 0.8;
  const CropFace front{1, false};
  EXPECT_EQ(openedAt(crop, grid, front, indexToWorld(grid, {0, 4, 0})), crop) << "cut off already";
  const CropBox thin = openedAt(crop, grid, front, indexToWorld(grid, {0, 19, 0}));
  EXPECT_NEAR(thin.lower.y, 0.75, 1e-12) << "one of twenty voxels is left";
  EXPECT_EQ(thin.upper.y, 0.8);
}

TEST(CutOpen, aCornerIsWhatLiesOnTheEyesSideAlongAllThreeAxes) {
  for (const glm::dmat3& direction : {glm::dmat3(1.0), mirroredAndTurned()}) {
    const Grid grid = gridOf(direction);
    const glm::ivec3 voxel(4, 12, 30);
    const glm::dvec3 place = indexToWorld(grid, voxel);
    for (int n = 0; n < 8; ++n) {
      const glm::dvec3 side(n & 1 ? 1 : -1, n & 2 ? 1 : -1, n & 4 ? 1 : -1);
      Camera camera;
      camera.target = boxCentreMm(grid);
      camera.position = place + 400.0 * (grid.direction * side);
      const std::array<bool, 3> corner = cornerTowards(camera, grid, place);
      EXPECT_EQ(corner, (std::array<bool, 3>{side.x > 0, side.y > 0, side.z > 0}));
      const BitGrid taken = takenBy(cornerAt(grid, corner, place), grid);
      int wrong = 0;
      for (int k = 0; k < grid.dims.z; ++k)
        for (int j = 0; j < grid.dims.y; ++j)
          for (int i = 0; i < grid.dims.x; ++i)
            wrong +=
                taken.at({i, j, k}) !=
                glm::all(glm::greaterThan(side * glm::dvec3(glm::ivec3(i, j, k) - voxel), glm::dvec3(0.0)));
      EXPECT_EQ(wrong, 0) << "corner " << n;
    }
  }
}

TEST(HiddenPlace, isOneBehindWhatGivesHalfOfTheLight) {
  Scene scene;
  scene.volume = phantomVolume({4.0, 0.0, 1});
  scene.camera = defaultCamera(scene.volume->grid());
  scene.shading.model = ShadingModel::classic;
  scene.transferFunction.points = {{-300, {1, 1, 1}, 0.0}, {-100, {1, 1, 1}, 0.9}};
  const glm::dvec3 middle = boxCentreMm(scene.volume->grid());
  const GradientScale scale = gradientScale(*scene.volume, scene.shading);
  EXPECT_TRUE(isHidden(scene, scale, middle)) << "the skin is in front";
  EXPECT_FALSE(isHidden(scene, scale, middle + glm::dvec3(0, -500, 0))) << "before the body";
  for (const Projection open : {Projection::mip, Projection::minip, Projection::average, Projection::xray}) {
    scene.projection = open;
    EXPECT_FALSE(isHidden(scene, scale, middle)) << "nothing hides anything";
  }
  scene.projection = Projection::composite;
  scene.crop =
      openedAt({}, scene.volume->grid(), faceTowards(scene.camera, scene.volume->grid(), middle), middle);
  EXPECT_FALSE(isHidden(scene, scale, middle)) << "it lies on the cut";
  scene.crop = {};
  scene.transferFunction.points = {{-300, {1, 1, 1}, 0.0}, {4000, {1, 1, 1}, 0.0}};
  EXPECT_FALSE(isHidden(scene, scale, middle)) << "nothing is seen";
}

class CrosshairWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:4")));
    named("planes-picture_and_three").trigger();
    ASSERT_TRUE(rest());
  }

  QAction& named(const char* name) const { return *window->findChild<QAction*>(QLatin1String(name)); }
  QAction& cutOpen() const { return named("cutOpen"); }
  PlaneView& plane(PatientPlane which) const { return *window->findChild<PlaneDeck*>()->view(which); }
  const CropBox& crop() const { return scene().crop; }
  glm::dvec3 crosshair() const { return crosshairOf(plane(PatientPlane::axial).content()); }
  Overlay overlay() { return overlayOf({view().order(), view().pictureState()}); }
  QString said() const { return window->statusBar()->currentMessage(); }

  // Of the window, as the display sends events there.
  void clickIn(PatientPlane which, const glm::dvec3& worldMm) {
    const PlaneView& in = plane(which);
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {},
                      in.mapTo(window.get(), pointOf(in.frame(), worldMm)).toPoint());
    QCoreApplication::processEvents();
  }
  void press(Qt::Key key, QWidget& focus) {
    focus.setFocus();
    QTest::keyClick(window->windowHandle(), key);
    QCoreApplication::processEvents();
  }
  // Of the crop box in front of whoever looks from the front: rows run backwards.
  double frontAt(const glm::dvec3& place) const {
    const Grid& grid = scene().volume->grid();
    return (worldToIndex(grid, place).y + 0.5) / grid.dims.y;
  }
  static constexpr double rounding = 1e-12;
};

TEST_F(CrosshairWindow, oCutsOpenToTheCrosshairAndEscClosesItAndLeavesNoTrace) {
  press(Qt::Key_O, view());
  EXPECT_NEAR(crop().lower.y, frontAt(crosshair()), rounding) << "from the front";
  CropBox rest = crop();
  rest.lower.y = 0.0;
  EXPECT_EQ(rest, CropBox{}) << "one face alone";
  EXPECT_TRUE(cutOpen().isChecked());
  EXPECT_EQ(undo().count(), 1);
  EXPECT_EQ(undo().undoText(), QStringLiteral("cut open to the crosshair"));
  EXPECT_TRUE(said().contains(QStringLiteral("Front"))) << said().toStdString();
  press(Qt::Key_Escape, view());
  EXPECT_EQ(crop(), CropBox{});
  EXPECT_FALSE(cutOpen().isChecked());
  EXPECT_EQ(undo().count(), 0) << "nothing is left of it";
  EXPECT_EQ(view().tool(), ViewTool::rotate);
}

TEST_F(CrosshairWindow, theKeyWorksInSlicesAndTheCutGoesWithTheCrosshair) {
  clickIn(PatientPlane::axial, crosshair() + glm::dvec3(20.0, -30.0, 0.0));
  ASSERT_TRUE(session().planes().crosshairMm);
  const double first = frontAt(crosshair());
  press(Qt::Key_O, plane(PatientPlane::axial));
  EXPECT_NEAR(crop().lower.y, first, rounding);
  clickIn(PatientPlane::axial, crosshair() + glm::dvec3(0.0, 60.0, 0.0));
  EXPECT_NEAR(crop().lower.y, frontAt(crosshair()), rounding);
  EXPECT_GT(crop().lower.y, first + 0.1);
  press(Qt::Key_Up, plane(PatientPlane::axial));
  EXPECT_NEAR(crop().lower.y, frontAt(crosshair()), rounding);
  EXPECT_EQ(undo().count(), 1) << "one step, wherever it went";
  press(Qt::Key_Escape, plane(PatientPlane::axial));
  EXPECT_EQ(crop(), CropBox{});
  EXPECT_EQ(undo().count(), 0);
  clickIn(PatientPlane::axial, crosshair() + glm::dvec3(0.0, -20.0, 0.0));
  EXPECT_EQ(crop(), CropBox{}) << "it is closed";
}

TEST_F(CrosshairWindow, askedAgainItClosesOrFromAnotherSideOpensThere) {
  press(Qt::Key_O, view());
  press(Qt::Key_L, view()); // from the left: columns run there
  EXPECT_GT(crop().lower.y, 0.0) << "turning alone moves no cut";
  press(Qt::Key_O, view());
  EXPECT_EQ(crop().lower.y, 0.0);
  EXPECT_LT(crop().upper.x, 1.0);
  EXPECT_TRUE(cutOpen().isChecked());
  EXPECT_EQ(undo().count(), 1);
  press(Qt::Key_O, view());
  EXPECT_EQ(crop(), CropBox{});
  EXPECT_FALSE(cutOpen().isChecked());
}

TEST_F(CrosshairWindow, theButtonWithTheSlicesAndBothMenusDoTheSame) {
  QToolButton* button = nullptr;
  for (QToolButton* one : window->findChild<PlaneDeck*>()->findChildren<QToolButton*>())
    if (one->defaultAction() == &cutOpen())
      button = one;
  ASSERT_NE(button, nullptr);
  ASSERT_TRUE(button->isVisible());
  EXPECT_FALSE(button->icon().isNull());
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_GT(crop().lower.y, 0.0);
  EXPECT_TRUE(button->isChecked());
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(crop(), CropBox{});
  const QPoint middle = view().mapTo(window.get(), view().rect().center());
  QTest::mouseClick(window->windowHandle(), Qt::RightButton, {}, middle);
  QCoreApplication::processEvents();
  auto* menu = view().findChild<QMenu*>(QStringLiteral("pictureMenu"));
  ASSERT_NE(menu, nullptr);
  EXPECT_TRUE(menu->actions().contains(&cutOpen()));
  menu->setActiveAction(&cutOpen());
  QTest::keyClick(menu, Qt::Key_Return);
  EXPECT_GT(crop().lower.y, 0.0);
}

TEST_F(CrosshairWindow, whatWasCroppedComesBackAsItWas) {
  CropBox before;
  before.lower = {0.1, 0.05, 0.0};
  before.upper = {0.9, 1.0, 0.8};
  session().setCrop(before, {nextGestureId(), QStringLiteral("crop")});
  press(Qt::Key_O, view());
  CropBox open = before;
  open.lower.y = crop().lower.y;
  EXPECT_EQ(crop(), open);
  EXPECT_GT(crop().lower.y, 0.3);
  press(Qt::Key_Escape, view());
  EXPECT_EQ(crop(), before);
  EXPECT_EQ(undo().count(), 1);
}

TEST_F(CrosshairWindow, undoClosesItAndAnotherEditOfTheCropMakesItOneLikeEveryOther) {
  press(Qt::Key_O, view());
  QTest::keyClick(window->windowHandle(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(crop(), CropBox{});
  EXPECT_FALSE(cutOpen().isChecked());
  press(Qt::Key_O, view());
  CropBox other = crop();
  other.upper.z = 0.5;
  session().setCrop(other, {nextGestureId(), QStringLiteral("crop")});
  EXPECT_FALSE(cutOpen().isChecked());
  press(Qt::Key_Escape, view());
  EXPECT_EQ(crop(), other) << "Esc has nothing to close";
}

TEST_F(CrosshairWindow, aCurveThatIsEditedMeanwhileStays) {
  press(Qt::Key_O, view());
  const TransferFunction faint = withOpacityScaled(scene().transferFunction, 0.5);
  session().setTransferFunction(faint, {nextGestureId(), QStringLiteral("faint")});
  press(Qt::Key_Escape, view());
  EXPECT_EQ(crop(), CropBox{});
  EXPECT_EQ(scene().transferFunction, faint);
  undo().undo();
  EXPECT_GT(crop().lower.y, 0.0);
}

TEST_F(CrosshairWindow, whereNothingLiesBeforeItThatIsSaid) {
  clickIn(PatientPlane::axial, crosshair());
  CropBox before;
  before.lower.y = 0.9;
  session().setCrop(before, {nextGestureId(), QStringLiteral("crop")});
  press(Qt::Key_O, view());
  EXPECT_EQ(crop(), before);
  EXPECT_FALSE(cutOpen().isChecked());
  EXPECT_TRUE(said().startsWith(QStringLiteral("Nothing lies before the crosshair"))) << said().toStdString();
}

TEST_F(CrosshairWindow, withoutSlicesItCutsNothingAndSaysWhy) {
  named("planes-picture").trigger();
  EXPECT_TRUE(cutOpen().toolTip().contains(QStringLiteral("View ▸ Slices")));
  press(Qt::Key_O, view());
  EXPECT_EQ(crop(), CropBox{});
  EXPECT_FALSE(cutOpen().isChecked());
  EXPECT_TRUE(said().startsWith(QStringLiteral("Choose a layout with slices first"))) << said().toStdString();
  named("planes-picture_and_three").trigger();
  press(Qt::Key_O, view());
  named("planes-picture").trigger();
  EXPECT_TRUE(cutOpen().isEnabled()) << "what is open can be closed";
  cutOpen().trigger();
  EXPECT_EQ(crop(), CropBox{});
}

TEST_F(CrosshairWindow, shiftOCutsTheCornerOpenInOneGestureAndEscClosesItWithoutATrace) {
  const auto ready = [this] {
    const RegionController* regions = window->findChild<RegionController*>();
    return test::waitUntil([&] { return !regions->isBusy(); });
  };
  const auto weight = [this](const glm::dvec3& offMm) {
    return weightAt(scene().keep, worldToIndex(scene().volume->grid(), crosshair() + offMm));
  };
  view().setFocus();
  QTest::keyClick(window->windowHandle(), Qt::Key_O, Qt::ShiftModifier);
  ASSERT_TRUE(ready());
  ASSERT_EQ(scene().keep.cuts.size(), 1u);
  EXPECT_TRUE(named("cutOpenCorner").isChecked());
  EXPECT_EQ(crop(), CropBox{});
  // From the front: the eye is at the patient's anterior side, a little above or below and beside.
  const glm::dvec3 toEye = glm::sign(scene().camera.position - crosshair() + glm::dvec3(0, -1e-9, 0));
  EXPECT_LT(toEye.y, 0.0);
  int gone = 0;
  for (const double x : {-20.0, 20.0})
    for (const double z : {-20.0, 20.0})
      gone += weight({x, -20.0, z}) == 0.0;
  EXPECT_EQ(gone, 1) << "one of the four corners in front";
  EXPECT_EQ(weight({0.0, 20.0, 0.0}), 1.0) << "nothing behind";

  // It goes with the crosshair, in the same step of undo.
  const Cut before = scene().keep.cuts.front();
  clickIn(PatientPlane::axial, crosshair() + glm::dvec3(12.0, 12.0, 0.0));
  ASSERT_TRUE(ready());
  ASSERT_EQ(scene().keep.cuts.size(), 1u);
  EXPECT_NE(scene().keep.cuts.front(), before);
  EXPECT_EQ(undo().count(), 1);

  // A session that is opened again has it open.
  saving().writeSession(pathTo("corner.json"));
  ASSERT_TRUE(open(pathTo("corner.json")));
  ASSERT_TRUE(ready());
  EXPECT_TRUE(named("cutOpenCorner").isChecked());
  press(Qt::Key_Escape, view());
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep, Region{});
  EXPECT_FALSE(named("cutOpenCorner").isChecked());
}

TEST_F(CrosshairWindow, aPlaneThatIsOpenIsOpenInASessionThatIsOpenedAgain) {
  press(Qt::Key_O, view());
  const CropBox opened = crop();
  ASSERT_NE(opened, CropBox{});
  saving().writeSession(pathTo("plane.json"));
  ASSERT_TRUE(open(pathTo("plane.json")));
  ASSERT_TRUE(rest());
  EXPECT_EQ(crop(), opened);
  EXPECT_TRUE(cutOpen().isChecked());
  clickIn(PatientPlane::axial, crosshair() + glm::dvec3(0.0, 12.0, 0.0));
  EXPECT_GT(crop().lower.y, opened.lower.y) << "it goes with the crosshair";
  press(Qt::Key_Escape, view());
  EXPECT_EQ(crop(), CropBox{});
}

TEST_F(CrosshairWindow, anotherVolumeIsNotCut) {
  press(Qt::Key_O, view());
  ASSERT_TRUE(open(QStringLiteral("phantom:5")));
  EXPECT_EQ(crop(), CropBox{});
  EXPECT_FALSE(cutOpen().isChecked());
  clickIn(PatientPlane::axial, crosshair() + glm::dvec3(10.0, 10.0, 0.0));
  EXPECT_EQ(crop(), CropBox{});
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(CrosshairWindow, theMarkIsDashedUnderTheSkinAndWholeOnTheCut) {
  EXPECT_EQ(overlay().marks.size(), 0u);
  ASSERT_EQ(overlay().hiddenMarks.size(), 1u) << "the middle of a head";
  const auto inFront = [this](const Overlay& now) {
    const QPointF at = pixelOf(viewProjection(scene().camera, view().logicalRect(0)), crosshair()).value();
    return QLineF(at, now.marks.empty() ? now.hiddenMarks.at(0) : now.marks.at(0)).length();
  };
  EXPECT_LT(inFront(overlay()), 1e-9);
  press(Qt::Key_O, view());
  EXPECT_EQ(overlay().marks.size(), 1u);
  EXPECT_EQ(overlay().hiddenMarks.size(), 0u);
  EXPECT_LT(inFront(overlay()), 1e-9);
  press(Qt::Key_P, view()); // from behind the back of the head is in front of it
  EXPECT_EQ(overlay().hiddenMarks.size(), 1u);
  press(Qt::Key_Escape, view());
  session().setPlanes(withCrosshair(plane(PatientPlane::axial).content(),
                                    crosshair() + glm::dvec3(0.0, 500.0, 0.0))); // the outermost slice: air
  named("view-posterior").trigger();
  EXPECT_EQ(overlay().marks.size(), 1u);
}

TEST_F(CrosshairWindow, aPlaceThatIsSeenIsMarkedAsSeen) {
  // Shift+click pins what is seen most of, there where the picture shows it.
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, Qt::ShiftModifier,
                    view().mapTo(window.get(), view().rect().center()));
  ASSERT_TRUE(test::waitUntil([this] { return session().planes().crosshairMm.has_value(); }));
  EXPECT_EQ(overlay().marks.size(), 1u);
  EXPECT_TRUE(overlay().hiddenMarks.empty());
}

} // namespace
} // namespace limn
