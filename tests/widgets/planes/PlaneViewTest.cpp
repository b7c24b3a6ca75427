// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlaneHost.h"

#include "support/Waiting.h"
#include "widgets/planes/PlaneMeasures.h"
#include "widgets/planes/PlaneOverlay.h"
#include "widgets/planes/PlaneView.h"

#include <QAccessible>
#include <QHelpEvent>
#include <QPainterPath>
#include <QSignalSpy>
#include <QToolTip>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <numbers>
#include <set>

namespace limn {
namespace {

using test::drag;
using test::turnWheel;

class PlaneViewTest : public testing::Test {
protected:
  PlaneViewTest() : host(test::contentOf(volume), PatientPlane::axial) {
    view.resize(300, 260);
    view.show();
  }

  glm::dvec3 crosshair() const { return crosshairOf(host.content); }
  QPoint pointAt(const glm::dvec3& worldMm) { return pointOf(view.frame(), worldMm).toPoint(); }

  // 60 × 50 × 20 voxels: 60 × 50 × 40 mm.
  std::shared_ptr<const Volume> volume = test::countingVolume({60, 50, 20}, {1.0, 1.0, 2.0});
  test::PlaneHost<PlaneView> host;
  PlaneView& view = host.widget;
};

TEST_F(PlaneViewTest, aClickSetsTheCrosshairUnderThePointerAndKeepsTheSlice) {
  EXPECT_EQ(crosshair(), glm::dvec3(29.0, 24.0, 18.0)) << "the voxel in the middle";
  const QPoint at = pointAt({10.0, 40.0, 18.0});
  QTest::mouseClick(&view, Qt::LeftButton, {}, at);
  const double pixelMm = mmPerLogicalPixel(view.frame());
  EXPECT_NEAR(crosshair().x, 10.0, pixelMm);
  EXPECT_NEAR(crosshair().y, 40.0, pixelMm);
  EXPECT_EQ(crosshair().z, 18.0);
  EXPECT_EQ(host.edits, 1);
}

TEST_F(PlaneViewTest, aDragLeadsTheCrosshairAndStopsAtTheOutermostVoxels) {
  drag(view, {150, 130}, {295, 130});
  EXPECT_EQ(crosshair().x, 59.0);
  drag(view, {150, 130}, {-500, -500});
  EXPECT_EQ(crosshair(), glm::dvec3(0.0, 0.0, 18.0));
}

TEST_F(PlaneViewTest, thePatientsRightIsAtTheLeft) {
  EXPECT_LT(pointAt({0.0, 25.0, 18.0}).x(), pointAt({59.0, 25.0, 18.0}).x()) << "+x is the patient's left";
  EXPECT_LT(pointAt({30.0, 0.0, 18.0}).y(), pointAt({30.0, 49.0, 18.0}).y()) << "+y is the back";
}

TEST_F(PlaneViewTest, theWheelLeadsThroughTheSlicesToTheEndAndNoFurther) {
  turnWheel(view, {150, 130}, 120);
  EXPECT_EQ(crosshair().z, 20.0) << "towards the head";
  turnWheel(view, {150, 130}, -240);
  EXPECT_EQ(crosshair().z, 16.0);
  for (int notch = 0; notch < 40; ++notch)
    turnWheel(view, {150, 130}, 120);
  EXPECT_EQ(crosshair().z, 38.0) << "the last slice's centre";
}

TEST_F(PlaneViewTest, aTouchPadTurnsLessThanANotchAtATime) {
  for (int turn = 0; turn < 7; ++turn)
    turnWheel(view, {150, 130}, 40);
  EXPECT_EQ(crosshair().z, 22.0) << "280 of 120 each";
}

TEST_F(PlaneViewTest, theWheelWithCtrlZoomsAboutThePointer) {
  const glm::dvec3 under = worldAt(view.frame(), {100, 90});
  const double before = mmPerLogicalPixel(view.frame());
  turnWheel(view, {100, 90}, 240, Qt::ControlModifier);
  EXPECT_NEAR(mmPerLogicalPixel(view.frame()), before / (1.15 * 1.15), 1e-9);
  const glm::dvec3 after = worldAt(view.frame(), {100, 90});
  EXPECT_LT(glm::length(after - under), 1e-9);
  EXPECT_EQ(crosshair().z, 18.0);
  QTest::keyClick(&view, Qt::Key_F);
  EXPECT_DOUBLE_EQ(mmPerLogicalPixel(view.frame()), before);
}

TEST_F(PlaneViewTest, theMiddleButtonAndShiftPan) {
  const glm::dvec3 under = worldAt(view.frame(), {100, 90});
  drag(view, {100, 90}, {140, 60}, Qt::MiddleButton);
  EXPECT_LT(glm::length(worldAt(view.frame(), {140, 60}) - under), 1e-9);
  drag(view, {140, 60}, {100, 90}, Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_LT(glm::length(worldAt(view.frame(), {100, 90}) - under), 1e-9);
  EXPECT_EQ(host.edits, 0) << "panning is the view's own";
}

TEST_F(PlaneViewTest, theRightButtonDragsTheWindowAndReadsNoVoxelAgain) {
  view.grab();
  const int readings = view.readings();
  const GreyWindow before = windowOf(host.content);
  drag(view, {150, 130}, {150 + 64, 130 - 32}, Qt::RightButton);
  view.grab();
  ASSERT_TRUE(host.settings().window);
  EXPECT_EQ(*host.settings().window,
            rounded({before.centre + 32.0 / 256.0 * before.width, before.width * std::exp(64.0 / 256.0)}));
  EXPECT_EQ(view.readings(), readings);
}

TEST_F(PlaneViewTest, altAndTheToolDragTheWindowToo) {
  drag(view, {150, 130}, {182, 130}, Qt::LeftButton, Qt::AltModifier);
  EXPECT_TRUE(host.settings().window);
  host.show({});
  QSignalSpy tools(&view, &PlaneView::toolRequested);
  QTest::keyClick(&view, Qt::Key_W);
  ASSERT_EQ(tools.size(), 1);
  view.setTool(tools.front().front().value<PlaneTool>());
  drag(view, {150, 130}, {182, 130});
  EXPECT_TRUE(host.settings().window);
  EXPECT_FALSE(host.settings().crosshairMm);
}

TEST_F(PlaneViewTest, escDuringADragPutsBackWhatWas) {
  const PlaneSettings before = host.settings();
  drag(view, {150, 130}, {200, 100}, Qt::RightButton, {}, false);
  ASSERT_NE(host.settings(), before);
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_EQ(host.settings(), before);
  QTest::mouseRelease(&view, Qt::RightButton, {}, {200, 100});
  EXPECT_EQ(host.settings(), before);
  drag(view, {150, 130}, {20, 20}, Qt::LeftButton, {}, false);
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_EQ(host.settings(), before);
}

TEST_F(PlaneViewTest, measuresADistanceInMillimetresWhereverItIsZoomed) {
  view.setTool(PlaneTool::distance);
  turnWheel(view, {150, 130}, 240, Qt::ControlModifier);
  const double pixelMm = mmPerLogicalPixel(view.frame());
  drag(view, {100, 100}, {160, 180});
  ASSERT_EQ(host.measurements().size(), 1u);
  const Measurement distance = host.measurements().front();
  EXPECT_EQ(distance.kind, Measurement::Kind::distance);
  EXPECT_EQ(distance.plane, PatientPlane::axial);
  EXPECT_NEAR(lengthMm(distance), 100.0 * pixelMm, 1e-9) << "60² + 80² = 100²";
  EXPECT_EQ(distance.placesMm[0].z, 18.0) << "it lies in the slice";
  EXPECT_FALSE(host.settings().crosshairMm) << "the crosshair stays";
  EXPECT_EQ(host.content.inHand, 0u);
}

TEST_F(PlaneViewTest, threeDistancesStayAndEachIsOneGesture) {
  view.setTool(PlaneTool::distance);
  for (const int y : {60, 120, 200})
    drag(view, {80, y}, {180, y});
  ASSERT_EQ(host.measurements().size(), 3u);
  EXPECT_EQ(std::set<std::uint64_t>(host.gestures.begin(), host.gestures.end()).size(), 3u);
  EXPECT_EQ(host.content.inHand, 2u);
  const PlaneOverlay overlay = planeOverlay(host.content, PatientPlane::axial, view.frame(), view.size(), {});
  EXPECT_EQ(overlay.measures.size(), 3u);
}

TEST_F(PlaneViewTest, endsAreDraggedWithAnyToolInTheirSliceAlone) {
  view.setTool(PlaneTool::distance);
  drag(view, {100, 100}, {160, 100});
  view.setTool(PlaneTool::crosshair);
  const glm::dvec3 from = host.measurements().front().placesMm[0];
  drag(view, {163, 101}, {120, 150});
  ASSERT_EQ(host.measurements().size(), 1u);
  EXPECT_EQ(host.measurements().front().placesMm[0], from);
  EXPECT_LT(glm::length(host.measurements().front().placesMm[1] - worldAt(view.frame(), {120, 150})), 1e-9);
  EXPECT_FALSE(host.settings().crosshairMm);
  turnWheel(view, {150, 130}, 120);
  drag(view, {120, 150}, {150, 150});
  EXPECT_LT(glm::length(host.measurements().front().placesMm[0] - from), 1e-9)
      << "in another slice it is not there to drag";
  EXPECT_TRUE(host.settings().crosshairMm);
}

TEST_F(PlaneViewTest, twoClicksMeasureAsADragDoes) {
  view.setTool(PlaneTool::distance);
  QTest::mouseClick(&view, Qt::LeftButton, {}, {100, 100});
  QTest::mouseMove(&view, {130, 110});
  QTest::mouseMove(&view, {160, 100});
  QTest::mouseClick(&view, Qt::LeftButton, {}, {160, 100});
  QTest::mouseMove(&view, {30, 30});
  ASSERT_EQ(host.measurements().size(), 1u);
  EXPECT_NEAR(lengthMm(host.measurements().front()), 60.0 * mmPerLogicalPixel(view.frame()), 1e-9);
  EXPECT_EQ(std::set<std::uint64_t>(host.gestures.begin(), host.gestures.end()).size(), 1u);
  view.setTool(PlaneTool::angle);
  QTest::mouseClick(&view, Qt::LeftButton, {}, {80, 120});
  QTest::mouseClick(&view, Qt::LeftButton, {}, {80, 220});
  QTest::mouseMove(&view, {180, 220});
  QTest::mouseClick(&view, Qt::LeftButton, {}, {180, 120});
  QTest::mouseMove(&view, {30, 30});
  ASSERT_EQ(host.measurements().size(), 2u);
  EXPECT_NEAR(*angleDegrees(host.measurements().back()), 45.0, 1e-9);
}

TEST_F(PlaneViewTest, oneClickAloneMeasuresNothingAndDeleteTakesTheOneInHandAway) {
  view.setTool(PlaneTool::distance);
  QTest::mouseClick(&view, Qt::LeftButton, {}, {100, 100});
  QTest::keyClick(&view, Qt::Key_Delete);
  EXPECT_TRUE(host.measurements().empty());
  drag(view, {100, 100}, {160, 100});
  drag(view, {100, 200}, {160, 200});
  const std::vector<Measurement> measured = host.measurements();
  for (const auto& end : std::vector<std::function<void()>>{
           [&] { QTest::keyClick(&view, Qt::Key_Delete); },
           [&] { QTest::keyClick(&view, Qt::Key_Backspace); },
           [&] { QTest::keyClick(&view, Qt::Key_Escape); }, [&] { view.setTool(PlaneTool::distance); },
           [&] {
             turnWheel(view, {150, 130}, 120);
             turnWheel(view, {150, 130}, -120);
           }}) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, {40, 230});
    QEvent left(QEvent::Leave);
    QApplication::sendEvent(&view, &left);
    EXPECT_EQ(host.measurements().size(), 3u) << "it is begun, and waits";
    end();
    EXPECT_EQ(host.measurements(), measured) << "it leaves what is there";
  }
  QTest::mouseClick(&view, Qt::LeftButton, {}, {160, 100});
  EXPECT_EQ(host.measurements(), measured);
  EXPECT_EQ(host.content.inHand, 0u) << "a click on an end takes its measurement in hand";
  QTest::keyClick(&view, Qt::Key_Delete);
  EXPECT_EQ(host.measurements(), std::vector{measured[1]});
  EXPECT_FALSE(host.content.inHand);
  QTest::keyClick(&view, Qt::Key_Delete);
  EXPECT_EQ(host.measurements().size(), 1u) << "nothing is in hand";
}

// Its last leg follows the pointer and could end any time.
TEST_F(PlaneViewTest, deleteTakesTheAngleThatIsBegunAndLeavesTheOneBefore) {
  view.setTool(PlaneTool::distance);
  drag(view, {100, 100}, {160, 100});
  const std::vector<Measurement> measured = host.measurements();
  view.setTool(PlaneTool::angle);
  for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace}) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, {80, 120});
    QTest::mouseClick(&view, Qt::LeftButton, {}, {80, 220});
    QTest::mouseMove(&view, {180, 220});
    ASSERT_EQ(host.measurements().size(), 2u);
    QTest::keyClick(&view, key);
    EXPECT_EQ(host.measurements(), measured);
    EXPECT_EQ(host.content.inHand, 0u);
  }
}

TEST_F(PlaneViewTest, anAngleIsDrawnToItsCornerAndFollowsThePointerToItsEnd) {
  view.setTool(PlaneTool::angle);
  drag(view, {80, 80}, {80, 180});
  ASSERT_EQ(host.measurements().size(), 1u);
  EXPECT_FALSE(angleDegrees(host.measurements().front())) << "until the pointer says where its end is";
  const auto text = [this] {
    return measureShapes(host.content, PatientPlane::axial, view.frame()).front().text;
  };
  EXPECT_EQ(text(), QString()) << "no number that nobody measured";
  QTest::mouseMove(&view, {180, 180});
  QTest::mouseMove(&view, {180, 80});
  EXPECT_NEAR(*angleDegrees(host.measurements().front()), 45.0, 1e-9);
  EXPECT_EQ(text(), QStringLiteral("45.0°")) << "the one under the pointer";
  QTest::mouseClick(&view, Qt::LeftButton, {}, {180, 80});
  QTest::mouseMove(&view, {30, 30});
  ASSERT_EQ(host.measurements().size(), 1u);
  EXPECT_NEAR(*angleDegrees(host.measurements().front()), 45.0, 1e-9) << "it is done";
  EXPECT_EQ(std::set<std::uint64_t>(host.gestures.begin(), host.gestures.end()).size(), 1u);
  // Its corner is dragged as an end is.
  drag(view, {80, 180}, {80, 80 + 50});
  EXPECT_EQ(host.measurements().size(), 1u);
  EXPECT_LT(glm::length(host.measurements().front().placesMm[1] - worldAt(view.frame(), {80, 130})), 1e-9);
}

TEST_F(PlaneViewTest, escTakesAnAngleBackThatHasNoEnd) {
  view.setTool(PlaneTool::angle);
  drag(view, {80, 80}, {80, 180});
  ASSERT_EQ(host.measurements().size(), 1u);
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_TRUE(host.measurements().empty());
  QTest::mouseMove(&view, {180, 80});
  EXPECT_TRUE(host.measurements().empty());
  // What became of it elsewhere, such as by undo, is no longer led.
  drag(view, {80, 80}, {80, 180});
  host.content.measured.clear();
  host.widget.setContent(host.content);
  QTest::mouseMove(&view, {150, 90});
  EXPECT_TRUE(host.measurements().empty());
  // Another slice ends it where it is, or takes it back where it has one leg.
  drag(view, {80, 80}, {80, 180});
  turnWheel(view, {150, 130}, 120);
  EXPECT_TRUE(host.measurements().empty());
  drag(view, {80, 80}, {80, 180});
  QTest::mouseMove(&view, {150, 130});
  turnWheel(view, {150, 130}, 120);
  const std::vector<Measurement> there = host.measurements();
  ASSERT_EQ(there.size(), 1u);
  QTest::mouseMove(&view, {200, 90});
  EXPECT_EQ(host.measurements(), there);
}

TEST_F(PlaneViewTest, anEllipseTellsTheVoxelsThatItGoesAround) {
  view.setTool(PlaneTool::ellipse);
  const QPoint from = pointAt({10.0, 10.0, 18.0}), to = pointAt({30.0, 20.0, 18.0});
  drag(view, from, to);
  ASSERT_EQ(host.measurements().size(), 1u);
  const EllipseFigures figures = host.content.measured.front().ellipse;
  const double pixelMm = mmPerLogicalPixel(view.frame());
  EXPECT_NEAR(figures.areaMm2, std::numbers::pi / 4.0 * 20.0 * 10.0, 30.0 * pixelMm)
      << "π/4 a pixel each way";
  EXPECT_NEAR(figures.mean, 20.0 + 100.0 * 15.0 + 10000.0 * 9.0, 101.0)
      << "the value in its middle, a voxel off";
  // Its right end leads one side, its middle all of it.
  const Measurement before = host.measurements().front();
  const QPoint right = pointOf(view.frame(), {before.placesMm[1].x, middleMm(before).y, 18.0}).toPoint();
  drag(view, right, right + QPoint(40, 30));
  const Measurement wider = host.measurements().front();
  EXPECT_NEAR(wider.placesMm[1].x - before.placesMm[1].x, 40.0 * pixelMm, pixelMm);
  EXPECT_EQ(wider.placesMm[1].y, before.placesMm[1].y) << "its height stays";
  EXPECT_EQ(wider.placesMm[0], before.placesMm[0]);
  const QPoint middle = pointOf(view.frame(), middleMm(wider)).toPoint();
  drag(view, middle, middle + QPoint(0, 25));
  const Measurement moved = host.measurements().front();
  EXPECT_NEAR(glm::length((moved.placesMm[1] - moved.placesMm[0]) - (wider.placesMm[1] - wider.placesMm[0])),
              0.0, 1e-9);
  EXPECT_NEAR(moved.placesMm[0].y - wider.placesMm[0].y, 25.0 * pixelMm, pixelMm);
}

TEST_F(PlaneViewTest, marksAreNumberedAndSeenInEveryPlaneThroughThem) {
  view.setTool(PlaneTool::mark);
  QTest::mouseClick(&view, Qt::LeftButton, {}, {100, 100});
  QTest::mouseClick(&view, Qt::LeftButton, {}, {150, 150});
  ASSERT_EQ(host.measurements().size(), 2u);
  EXPECT_EQ(host.measurements()[0].name, "1");
  EXPECT_EQ(host.measurements()[1].name, "2");
  PlaneContent content = host.content;
  content.settings.crosshairMm = host.measurements()[0].placesMm[0];
  EXPECT_TRUE(isInSlice(content, PatientPlane::sagittal, host.measurements()[0]));
  EXPECT_FALSE(isInSlice(content, PatientPlane::sagittal, host.measurements()[1]));
  content.measured[0].measurement.isShown = false;
  EXPECT_EQ(measureShapes(content, PatientPlane::axial, view.frame()).size(), 1u);
}

TEST_F(PlaneViewTest, keysChooseTheToolsThatMeasure) {
  QSignalSpy tools(&view, &PlaneView::toolRequested);
  for (const auto& [key, tool] :
       {std::pair(Qt::Key_D, PlaneTool::distance), std::pair(Qt::Key_G, PlaneTool::angle),
        std::pair(Qt::Key_E, PlaneTool::ellipse), std::pair(Qt::Key_N, PlaneTool::mark)}) {
    QTest::keyClick(&view, key);
    ASSERT_FALSE(tools.empty());
    EXPECT_EQ(tools.takeLast().front().value<PlaneTool>(), tool);
  }
}

// Texts stand beside what was measured, never on it, even of hundreds; names may be long.
TEST_F(PlaneViewTest, aTextDoesNotLieOnWhatWasMeasured) {
  view.setTool(PlaneTool::distance);
  drag(view, {130, 110}, {170, 150});
  host.content.measured.front().measurement.name = std::string(500, 'W');
  const PlaneOverlay overlay =
      planeOverlay(host.content, PatientPlane::axial, view.frame(), view.size(), view.font());
  ASSERT_EQ(overlay.measures.size(), 1u);
  const MeasureMark& mark = overlay.measures.front();
  ASSERT_TRUE(mark.note);
  EXPECT_FALSE(measuredArea(mark.shape).intersects(mark.note->plate));
  EXPECT_TRUE(overlay.view.contains(mark.note->plate));
  for (const Note& note : overlay.notes)
    EXPECT_FALSE(note.plate.intersects(mark.note->plate)) << note.text.toStdString();
}

TEST_F(PlaneViewTest, whatIsShortenedIsToldInFullByAToolTip) {
  view.setTool(PlaneTool::distance);
  drag(view, {130, 110}, {170, 150});
  host.content.measured.front().measurement.name =
      "a vessel <that> is called by more letters than have room beside it";
  const auto tipAt = [&](const QSize& size, const auto& placeOf) {
    const PlaneFrame frame = planeFrame(seenGrid(host.content), PatientPlane::axial,
                                        crosshairOf(host.content), size, 1.0, std::nullopt);
    const PlaneOverlay overlay = planeOverlay(host.content, PatientPlane::axial, frame, size, view.font());
    return planeToolTip(overlay, host.content, placeOf(overlay));
  };
  const auto title = [](const PlaneOverlay& overlay) { return overlay.notes.front().plate.center(); };
  EXPECT_EQ(tipAt({400, 300}, title), QString()) << "it is seen";
  EXPECT_TRUE(tipAt({90, 60}, title).contains(QStringLiteral("Axial")))
      << tipAt({90, 60}, title).toStdString();
  const auto measure = [](const PlaneOverlay& overlay) {
    return overlay.measures.at(0).note->plate.center();
  };
  EXPECT_TRUE(tipAt(view.size(), measure)
                  .contains(QStringLiteral(
                      "vessel &lt;that&gt; is called by more letters than have room beside it")));
}

TEST_F(PlaneViewTest, whoRestsOnTheLineAroundWhatIsKeptIsToldWhatItIs) {
  std::vector<std::uint8_t> places(60 * 50 * 20, 0);
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = i % 60 >= 40;
  host.content.keep = bodyRegion({60, 50, 20}, places);
  view.setContent(host.content);
  view.grab(); // the line is where it was painted
  const auto restAt = [&](double x) {
    const QPoint place = pointAt({x, 30.0, crosshair().z});
    QHelpEvent rests(QEvent::ToolTip, place, view.mapToGlobal(place));
    QCoreApplication::sendEvent(&view, &rests);
  };
  const auto isToldNothing = [] { return test::waitUntil([] { return QToolTip::text().isEmpty(); }); };
  restAt(39.6);
  EXPECT_TRUE(QToolTip::text().contains(QStringLiteral("The orange line is the edge of what is kept")))
      << QToolTip::text().toStdString();
  restAt(50.0);
  EXPECT_TRUE(isToldNothing()) << "within it";
  host.content.settings.outlinesRegion = false;
  view.setContent(host.content);
  view.grab();
  restAt(39.6);
  EXPECT_TRUE(isToldNothing()) << "none is there";
}

TEST_F(PlaneViewTest, keysWalkVoxelByVoxelAndSliceBySlice) {
  QTest::keyClick(&view, Qt::Key_Right);
  QTest::keyClick(&view, Qt::Key_Down);
  EXPECT_EQ(crosshair(), glm::dvec3(30.0, 25.0, 18.0));
  QTest::keyClick(&view, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(crosshair().x, 20.0) << "ten at a time";
  QTest::keyClick(&view, Qt::Key_Up);
  QTest::keyClick(&view, Qt::Key_PageUp);
  EXPECT_EQ(crosshair(), glm::dvec3(20.0, 24.0, 20.0));
  QTest::keyClick(&view, Qt::Key_PageDown, Qt::ShiftModifier);
  EXPECT_EQ(crosshair().z, 0.0);
  QTest::keyClick(&view, Qt::Key_Home);
  EXPECT_EQ(crosshair(), glm::dvec3(29.0, 24.0, 18.0));
}

TEST_F(PlaneViewTest, numbersChooseWindows) {
  QTest::keyClick(&view, Qt::Key_0);
  EXPECT_EQ(host.settings().window, fullWindow(volume->range()));
  QTest::keyClick(&view, Qt::Key_2);
  EXPECT_EQ(host.settings().window, fullWindow(volume->range())) << "no Hounsfield units, no lung";
  test::PlaneHost<PlaneView> ct(test::contentOf(phantomVolume({.spacingMm = 16.0})), PatientPlane::axial);
  QTest::keyClick(&ct.widget, Qt::Key_2);
  EXPECT_EQ(ct.settings().window, windowOf(TissueWindow::lung));
  QTest::keyClick(&ct.widget, Qt::Key_4);
  EXPECT_EQ(ct.settings().window, windowOf(TissueWindow::brain));
}

TEST_F(PlaneViewTest, aDoubleClickMakesItLargeAndBack) {
  QTest::mouseDClick(&view, Qt::LeftButton, {}, {150, 130});
  EXPECT_EQ(host.settings().layout, PlaneLayout::oneLarge);
  EXPECT_EQ(host.settings().large, PatientPlane::axial);
  QTest::mouseDClick(&view, Qt::LeftButton, {}, {150, 130});
  EXPECT_EQ(host.settings().layout, PlaneLayout::pictureAndThree);
}

TEST_F(PlaneViewTest, itsPixelsAreTheGreysOfTheVolume) {
  PlaneSettings settings;
  settings.interpolation = PlaneInterpolation::nearest;
  settings.window = GreyWindow{180000.0 + 2500.0, 6000.0};
  host.show(settings);
  const QImage picture = view.grab().toImage();
  // Away from crosshair, texts and letters, at centres of voxels.
  for (const glm::dvec3& place : {glm::dvec3(15, 35, 18), glm::dvec3(45, 15, 18), glm::dvec3(40, 38, 18)}) {
    const double value = place.x + 100 * place.y + 10000 * 9;
    const int grey = static_cast<int>(255.0 * greyOf(*settings.window, value) + 0.5);
    EXPECT_EQ(picture.pixelColor(pointAt(place)), QColor(grey, grey, grey)) << place.x;
  }
}

TEST_F(PlaneViewTest, aCrosshairOutsideTheVolumeIsToldAndLedBack) {
  PlaneSettings settings;
  settings.crosshairMm = glm::dvec3(1000.0, -1000.0, 1000.0);
  host.show(settings);
  EXPECT_FALSE(valueUnderCrosshair(host.content));
  EXPECT_FALSE(view.grab().isNull());
  EXPECT_FALSE(view.accessibleDescription().contains(QStringLiteral("crosshair")));
  turnWheel(view, {150, 130}, 120);
  EXPECT_EQ(crosshair(), glm::dvec3(59.0, 0.0, 38.0)) << "the nearest voxel";
}

TEST_F(PlaneViewTest, volumesOfOneAndTwoSlicesAndObliqueOnesCanBeWalked) {
  for (const int slices : {1, 2}) {
    test::PlaneHost<PlaneView> thin(test::contentOf(test::countingVolume({8, 8, slices}, {0.5, 2.0, 4.0})),
                                    PatientPlane::coronal);
    thin.widget.resize(120, 90);
    turnWheel(thin.widget, {60, 45}, 1200);
    QTest::mouseClick(&thin.widget, Qt::LeftButton, {}, {60, 2});
    EXPECT_TRUE(valueUnderCrosshair(thin.content)) << slices;
    EXPECT_EQ(crosshairOf(thin.content).z, 4.0 * (slices - 1)) << "above is the last slice";
  }
  Grid grid = volume->grid();
  const double root = std::sqrt(0.5);
  grid.direction = glm::dmat3(root, root, 0.0, -root, root, 0.0, 0.0, 0.0, 1.0); // 45° about z
  PlaneContent content =
      test::contentOf(std::make_shared<const Volume>(volume->placed(grid, volume->info())));
  test::PlaneHost<PlaneView> oblique(content, PatientPlane::sagittal);
  oblique.widget.resize(200, 200);
  EXPECT_FALSE(oblique.widget.grab().isNull());
  turnWheel(oblique.widget, {100, 100}, 12000);
  turnWheel(oblique.widget, {100, 100}, -120000);
  EXPECT_FALSE(oblique.widget.grab().isNull());
}

// A slab through a volume that lies askew is coarse while slices change, and then read beside the event loop.
TEST_F(PlaneViewTest, whatTakesTooLongIsReadAtEveryPixelBesideTheEventLoop) {
  Grid grid = test::countingVolume({90, 90, 90}, glm::dvec3(1.0))->grid();
  const double root = std::sqrt(0.5);
  grid.direction = glm::dmat3(root, root, 0.0, -root, root, 0.0, 0.0, 0.0, 1.0);
  const auto plain = test::countingVolume({90, 90, 90}, glm::dvec3(1.0));
  PlaneContent content = test::contentOf(std::make_shared<const Volume>(plain->placed(grid, plain->info())));
  content.settings.slab.thicknessMm = 100.0;
  test::PlaneHost<PlaneView> slow(content, PatientPlane::coronal);
  PlaneView& slowView = slow.widget;
  slowView.resize(700, 600);
  slowView.grab(); // tells how long it takes
  turnWheel(slowView, {350, 300}, 120);
  const QImage coarse = slowView.grab().toImage();
  const int readings = slowView.readings();
  ASSERT_TRUE(test::waitUntil([&] { return slowView.readings() > readings; }))
      << "it was not slow enough to be coarse";
  EXPECT_EQ(slowView.readings(), readings + 1);
  QElapsedTimer clock;
  clock.start();
  const QImage fine = slowView.grab().toImage();
  const qint64 paintingMs = clock.restart();
  PlanePictures direct;
  const QImage& expected = direct.picture(slow.content, slowView.frame().grid);
  const qint64 readingMs = clock.elapsed();
  std::printf("time: read in %lld ms, painted in %lld\n", readingMs, paintingMs);
  EXPECT_LT(2 * paintingMs, readingMs);
  EXPECT_EQ(slowView.readings(), readings + 1) << "nothing is read as it is painted";
  EXPECT_NE(fine, coarse);
  for (int x = 110; x < 600; x += 50) // below the texts, beside the crosshair
    EXPECT_EQ(fine.pixelColor(x, 400), expected.pixelColor(x, 400)) << x;
}

TEST_F(PlaneViewTest, aVeryLargeSliceWithOblongPixelsCanBeWalked) {
  Grid grid;
  grid.dims = {4096, 4096, 1};
  grid.spacingMm = {0.1, 0.2, 3.0};
  std::vector<std::uint8_t> stored(std::size_t{4096} * 4096);
  for (std::size_t i = 0; i < stored.size(); ++i)
    stored[i] = static_cast<std::uint8_t>(i % 251);
  const PlaneContent content = test::contentOf(
      std::make_shared<const Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{}));
  for (const PatientPlane plane : patientPlanes) {
    test::PlaneHost<PlaneView> large(content, plane);
    large.widget.resize(400, 300);
    turnWheel(large.widget, {200, 150}, 1200);
    QTest::mouseClick(&large.widget, Qt::LeftButton, {}, {200, 151});
    EXPECT_TRUE(valueUnderCrosshair(large.content));
    EXPECT_FALSE(large.widget.grab().isNull());
    const double ratio = mmPerLogicalPixel(large.widget.frame());
    const double widthMm = plane == PatientPlane::sagittal ? 819.2 : 409.6;
    EXPECT_NEAR(std::max(widthMm / ratio / 400.0, plane == PatientPlane::axial ? 819.2 / ratio / 300.0 : 0.0),
                1.0, 0.15)
        << "all of it is seen";
  }
}

TEST_F(PlaneViewTest, assistiveTechnologyReadsAndMovesTheSlice) {
  EXPECT_EQ(view.accessibleName(), QStringLiteral("Axial slice"));
  EXPECT_EQ(view.accessibleDescription().replace(QChar(0xa0), ' '),
            QStringLiteral("S 18 mm · 10/20, 92429 under the crosshair"));
  QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(&view);
  ASSERT_NE(interface, nullptr);
  ASSERT_NE(interface->valueInterface(), nullptr);
  EXPECT_EQ(interface->role(), QAccessible::Slider);
  EXPECT_EQ(interface->valueInterface()->currentValue().toDouble(), 18.0);
  EXPECT_EQ(interface->valueInterface()->minimumValue().toDouble(), -1.0);
  EXPECT_EQ(interface->valueInterface()->maximumValue().toDouble(), 39.0);
  EXPECT_EQ(interface->valueInterface()->minimumStepSize().toDouble(), 2.0);
  interface->valueInterface()->setCurrentValue(24.5);
  EXPECT_EQ(crosshair().z, 24.0);
}

TEST(PlaneViewEmpty, withoutAVolumeNothingHappens) {
  test::PlaneHost<PlaneView> host({}, PatientPlane::axial);
  host.widget.resize(100, 80);
  drag(host.widget, {10, 10}, {50, 50});
  turnWheel(host.widget, {50, 40}, 120);
  QTest::keyClick(&host.widget, Qt::Key_PageUp);
  EXPECT_EQ(host.edits, 0);
  EXPECT_EQ(host.widget.grab().toImage().pixelColor(50, 40), QColor(Qt::black));
}

} // namespace
} // namespace limn
