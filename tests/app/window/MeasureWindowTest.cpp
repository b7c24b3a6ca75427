// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/CameraController.h"
#include "app/picture/MeasureController.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"
#include "widgets/properties/MeasureSection.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/panels/HintBar.h"

#include <QPainterPath>
#include <QPushButton>
#include <QStatusBar>
#include <QTreeWidget>

#include <numbers>

// What is measured in slices and in the picture, in the program's window, with the pointer and the keys that
// people have.

namespace limn {
namespace {

using Kind = Measurement::Kind;

class MeasureWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:4")));
    choose("one_large");
    ASSERT_TRUE(rest());
  }

  void choose(const char* layout) {
    window->findChild<QAction*>(QStringLiteral("planes-") + QLatin1String(layout))->trigger();
    QCoreApplication::processEvents();
  }
  const std::vector<Measurement>& measurements() const { return session().measurements(); }
  PlaneView& axial() const { return *window->findChild<PlaneDeck*>()->view(PatientPlane::axial); }
  QTreeWidget& list() const {
    return *window->findChild<MeasureSection*>()->findChild<QTreeWidget*>(QStringLiteral("measurements"));
  }

  // In the axial slice and in the picture, logical pixels from the middle.
  QPoint inSlice(const QPoint& fromMiddle) const {
    return axial().mapTo(window.get(), axial().rect().center()) + fromMiddle;
  }
  QPoint inPicture(const QPoint& fromMiddle) {
    return view().mapTo(window.get(), view().logicalRect(0).center().toPoint()) + fromMiddle;
  }
  void moveTo(const QPoint& at) {
    QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, {}, at);
  }
  void drag(const QPoint& from, const QPoint& to) {
    QWindow* handle = window->windowHandle();
    QTest::mousePress(handle, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 5; ++step)
      moveTo(from + (to - from) * step / 5);
    QTest::mouseRelease(handle, Qt::LeftButton, {}, to);
    QCoreApplication::processEvents();
  }
  void click(const QPoint& at) {
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, at);
    QCoreApplication::processEvents();
  }
  void press(QWidget& widget, Qt::Key key) {
    widget.setFocus();
    QTest::keyClick(&widget, key);
    QCoreApplication::processEvents();
  }
  double mmPerPixelOfSlice() const { return mmPerLogicalPixel(axial().frame()); }
  QString undoText() { return undo().undoText().replace(QChar(0xa0), QLatin1Char(' ')); }
  HintBar& measureBar() {
    const QList<HintBar*> bars = view().findChildren<HintBar*>();
    return **std::ranges::find(bars, QStringLiteral("Measuring"), &QWidget::accessibleName);
  }
  QString said() const { return window->statusBar()->currentMessage(); }
};

TEST_F(MeasureWindow, aDistanceIsOneDragOnceItsToolIsChosen) {
  press(axial(), Qt::Key_D);
  drag(inSlice({-40, 0}), inSlice({60, 0}));
  ASSERT_EQ(measurements().size(), 1u);
  const double mm = lengthMm(measurements().front());
  EXPECT_NEAR(mm, 100.0 * mmPerPixelOfSlice(), 1e-9);
  EXPECT_EQ(undoText(), QStringLiteral("Distance %1 mm").arg(QString::number(mm, 'f', 1)));
  EXPECT_EQ(undo().count(), 1) << "one step, however it was dragged";
  EXPECT_TRUE(test::waitUntil([&] { return !list().visibleRegion().isEmpty(); }))
      << "the panel shows the list of what was measured";
}

// As the tools that cut do: what to click, and how to end it.
TEST_F(MeasureWindow, aBarSaysWhatToDoAndEndsIt) {
  HintBar* bar = &measureBar();
  EXPECT_FALSE(bar->isVisible());
  // Beside a large slice the picture has no room for it.
  press(axial(), Qt::Key_E);
  EXPECT_FALSE(bar->isVisible());
  EXPECT_EQ(said(), QStringLiteral("In a slice, drag from corner to corner or click both"));
  choose("picture_and_three");
  EXPECT_FALSE(bar->isVisible()) << "above what is written it would lie on the face";
  press(axial(), Qt::Key_Escape);
  EXPECT_FALSE(bar->isVisible());
  EXPECT_EQ(said(), QString()) << "the tool is laid aside";
  choose("picture");
  ASSERT_TRUE(rest());
  press(view(), Qt::Key_D);
  EXPECT_TRUE(bar->isVisible());
  EXPECT_EQ(bar->hint(), QStringLiteral("Click both ends"));
  const auto isClear = [&] {
    const std::vector<QRectF> written = writtenPlaces(overlayOf({view().order(), view().pictureState()}));
    return std::ranges::none_of(written, [&](const QRectF& one) { return one.intersects(bar->geometry()); });
  };
  for (const CompareLayout layout : {CompareLayout::single, CompareLayout::sideBySide, CompareLayout::wipe}) {
    setLayout(layout);
    EXPECT_TRUE(test::waitUntil([&] {
      bar->lookAgain();
      return bar->isVisible() && isClear();
    })) << static_cast<int>(layout);
    EXPECT_LT(view().height() - bar->geometry().top(), 48) << "in the row that messages leave free";
  }
  setLayout(CompareLayout::single);
  // Out of the way as long as one end is missing: the other may lie below it.
  click(inPicture({-20, 0}));
  EXPECT_TRUE(test::waitUntil([&] { return !bar->isVisible(); }));
  click(inPicture({20, 0}));
  EXPECT_TRUE(test::waitUntil([&] { return bar->isVisible(); }));
  EXPECT_EQ(measurements().size(), 1u);
  for (QPushButton* button : bar->findChildren<QPushButton*>())
    if (button->isVisible())
      QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(view().tool(), ViewTool::rotate);
  EXPECT_FALSE(bar->isVisible());
  EXPECT_TRUE(view().hasFocus());
  window->findChild<MeasureController*>()->useTool(Kind::angle);
  EXPECT_EQ(bar->hint(), QStringLiteral("Click end, corner and end"));
  EXPECT_TRUE(bar->isVisible());
}

// In slices and in the picture alike: what comes next and how it ends, as long as it is being drawn.
TEST_F(MeasureWindow, whileSomethingIsDrawnTheNextStepIsSaid) {
  const QString corner = QStringLiteral("Now the corner of the angle. Esc takes it back.");
  const QString end = QStringLiteral("Now the other end, which ends it. Esc takes it back.");
  const QString opposite = QStringLiteral("Now the opposite corner, which ends it. Esc takes it back.");
  press(axial(), Qt::Key_G);
  click(inSlice({0, -80}));
  EXPECT_EQ(said(), corner);
  moveTo(inSlice({0, -20}));
  EXPECT_EQ(said(), corner);
  click(inSlice({0, 0}));
  EXPECT_EQ(said(), end);
  moveTo(inSlice({60, 20}));
  EXPECT_EQ(said(), end);
  click(inSlice({80, 80}));
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_NEAR(*angleDegrees(measurements().front()), 135.0, 1e-9);
  EXPECT_EQ(said(), QString()) << "it is there";
  press(axial(), Qt::Key_E);
  click(inSlice({-30, -20}));
  EXPECT_EQ(said(), opposite);
  moveTo(inSlice({10, 5}));
  click(inSlice({30, 20}));
  ASSERT_EQ(measurements().size(), 2u);
  EXPECT_EQ(said(), QString());
  QTest::mousePress(window->windowHandle(), Qt::LeftButton, {}, inSlice({-60, -60}));
  moveTo(inSlice({-50, -50}));
  EXPECT_EQ(said(), opposite) << "of a drag, too";
  press(axial(), Qt::Key_Escape);
  EXPECT_EQ(said(), QString());
  EXPECT_EQ(measurements().size(), 2u);
  QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, inSlice({-50, -50}));
  click(inSlice({-60, -60}));
  undo().undo();
  EXPECT_EQ(said(), QString()) << "undone while it was drawn";
  press(axial(), Qt::Key_Escape);
  press(view(), Qt::Key_G);
  click(inPicture({-30, 0}));
  EXPECT_EQ(said(), corner);
  click(inPicture({0, 0}));
  EXPECT_EQ(said(), end);
  click(inPicture({0, -30}));
  EXPECT_EQ(said(), QString());
  EXPECT_EQ(measurements().size(), 3u);
  press(view(), Qt::Key_D);
  click(inPicture({20, 20})); // clear of its handles
  EXPECT_EQ(said(), end);
  press(view(), Qt::Key_Escape);
  EXPECT_EQ(said(), QString());
}

TEST_F(MeasureWindow, twoClicksInASliceMeasureAndTheToolEndsWithItsVolume) {
  press(axial(), Qt::Key_D);
  click(inSlice({-40, 0}));
  moveTo(inSlice({60, 0}));
  click(inSlice({60, 0}));
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_NEAR(lengthMm(measurements().front()), 100.0 * mmPerPixelOfSlice(), 1e-9);
  EXPECT_EQ(undo().count(), 1);
  click(inSlice({-40, 40})); // begun in the volume that goes
  ASSERT_TRUE(open(QStringLiteral("phantom:12")));
  EXPECT_EQ(window->findChild<PlaneDeck*>()->tool(), PlaneTool::crosshair);
  EXPECT_EQ(view().tool(), ViewTool::rotate);
  EXPECT_TRUE(measurements().empty());
}

TEST_F(MeasureWindow, threeDistancesStayAndUndoTakesThemBackOneByOne) {
  press(axial(), Qt::Key_D);
  for (const int y : {-60, 0, 60})
    drag(inSlice({-50, y}), inSlice({50, y}));
  ASSERT_EQ(measurements().size(), 3u);
  const std::vector<Measurement> three = measurements();
  EXPECT_EQ(undo().count(), 3);
  EXPECT_EQ(list().topLevelItemCount(), 3);
  for (std::size_t left = 3; left-- > 0;) {
    QTest::keyClick(window->windowHandle(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(measurements(),
              std::vector<Measurement>(three.begin(), three.begin() + static_cast<int>(left)));
  }
  for (int step = 0; step < 3; ++step)
    undo().redo();
  EXPECT_EQ(measurements(), three);
  EXPECT_EQ(list().topLevelItemCount(), 3);
}

TEST_F(MeasureWindow, anEndIsDraggedLaterAndEscPutsItBack) {
  press(axial(), Qt::Key_D);
  drag(inSlice({-40, 0}), inSlice({60, 0}));
  press(axial(), Qt::Key_Escape);
  const std::vector<Measurement> before = measurements();
  drag(inSlice({60, 0}), inSlice({20, 50}));
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_EQ(measurements().front().placesMm[0], before.front().placesMm[0]);
  EXPECT_NE(measurements().front().placesMm[1], before.front().placesMm[1]);
  EXPECT_FALSE(session().planes().crosshairMm) << "the crosshair stays where it was";
  EXPECT_EQ(undo().count(), 2);
  const std::vector<Measurement> led = measurements();
  QTest::mousePress(window->windowHandle(), Qt::LeftButton, {}, inSlice({20, 50}));
  moveTo(inSlice({30, 60}));
  moveTo(inSlice({60, 90}));
  QCoreApplication::processEvents();
  EXPECT_NE(measurements(), led);
  press(axial(), Qt::Key_Escape);
  EXPECT_EQ(measurements(), led);
  EXPECT_EQ(undo().count(), 2) << "what was put back is no step";
  QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, inSlice({60, 90}));
}

TEST_F(MeasureWindow, aToolDrawsWhereAnotherKindHasAnEnd) {
  press(axial(), Qt::Key_D);
  drag(inSlice({-40, 0}), inSlice({60, 0}));
  ASSERT_EQ(measurements().size(), 1u);
  const Measurement distance = measurements().front();
  press(axial(), Qt::Key_E);
  drag(inSlice({-40, 0}), inSlice({20, 40}));
  ASSERT_EQ(measurements().size(), 2u) << "the box around a lesion begins where it was measured";
  EXPECT_EQ(measurements().front(), distance);
  EXPECT_EQ(measurements().back().kind, Kind::ellipse);
}

TEST_F(MeasureWindow, theOneInHandIsHighlightedAndDeleted) {
  press(axial(), Qt::Key_D);
  drag(inSlice({-50, -60}), inSlice({50, -60}));
  drag(inSlice({-50, 60}), inSlice({50, 60}));
  const std::vector<Measurement> both = measurements();
  EXPECT_EQ(axial().content().inHand, 1u);
  click(inSlice({50, -60}));
  EXPECT_EQ(axial().content().inHand, 0u);
  EXPECT_EQ(list().currentItem(), list().topLevelItem(0));
  // In the slice the one in hand is amber, the other white.
  const QImage seen = axial().grab().toImage();
  const double ratio = seen.devicePixelRatio();
  const auto colorAt = [&](const QPoint& fromMiddle) {
    return seen.pixelColor(((axial().rect().center() + fromMiddle) * ratio));
  };
  EXPECT_LT(colorAt({50, -60}).blue(), 120);
  EXPECT_GT(colorAt({50, 60}).blue(), 200);
  press(axial(), Qt::Key_Delete);
  EXPECT_EQ(measurements(), std::vector{both[1]});
  EXPECT_TRUE(undoText().startsWith(QStringLiteral("delete: Distance"))) << undoText().toStdString();
  QTest::keyClick(window->windowHandle(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(measurements(), both);
}

TEST_F(MeasureWindow, anAngleIsADragAndAClick) {
  press(axial(), Qt::Key_G);
  drag(inSlice({0, -80}), inSlice({0, 0}));
  const auto note = [this] {
    return measureNoteText(axial().content().measured.front(), *axial().content().volume);
  };
  EXPECT_EQ(note(), QString()) << "it has one leg";
  moveTo(inSlice({40, 10}));
  EXPECT_TRUE(note().endsWith(QChar(0x00b0))) << note().toStdString();
  moveTo(inSlice({80, 80}));
  click(inSlice({80, 80}));
  moveTo(inSlice({-80, -20}));
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_NEAR(*angleDegrees(measurements().front()), 135.0, 1e-9) << "from up to right and down";
  EXPECT_EQ(undo().count(), 1);
  EXPECT_EQ(undoText(), QStringLiteral("Angle 135.0°"));
}

TEST_F(MeasureWindow, anEllipseTellsMeanDeviationAndArea) {
  press(axial(), Qt::Key_E);
  drag(inSlice({-30, -20}), inSlice({30, 20}));
  ASSERT_EQ(measurements().size(), 1u);
  const Measured& measured = axial().content().measured.front();
  const double mm = mmPerPixelOfSlice();
  EXPECT_NEAR(measured.ellipse.areaMm2, std::numbers::pi * 30.0 * mm * 20.0 * mm, 1e-6);
  EXPECT_GT(measured.ellipse.voxels, 0u);
  const QString row = list().topLevelItem(0)->text(1);
  EXPECT_TRUE(row.contains(QStringLiteral("HU")) && row.contains(QStringLiteral("±")) &&
              row.contains(QStringLiteral("mm²")))
      << row.toStdString();
  // Where there is nothing it says so.
  std::vector<Measurement> far = measurements();
  for (glm::dvec3& place : far.front().placesMm)
    place.x += 1e5;
  session().setMeasurements(far, {nextGestureId(), "away"});
  EXPECT_TRUE(list().topLevelItem(0)->text(1).startsWith(QStringLiteral("no voxels")));
}

TEST_F(MeasureWindow, aMarkIsAClickInASliceAndIsRenamedInTheList) {
  press(axial(), Qt::Key_N);
  click(inSlice({-30, 10}));
  click(inSlice({30, 10}));
  ASSERT_EQ(measurements().size(), 2u);
  EXPECT_EQ(measurements()[0].kind, Kind::mark);
  EXPECT_EQ(measurements()[0].name, "1");
  EXPECT_EQ(measurements()[1].name, "2");
  list().topLevelItem(1)->setText(0, QStringLiteral("lesion"));
  EXPECT_EQ(measurements()[1].name, "lesion");
  EXPECT_EQ(undoText(), QStringLiteral("rename: Mark lesion"));
  list().topLevelItem(0)->setCheckState(0, Qt::Unchecked);
  EXPECT_FALSE(measurements()[0].isShown);
  EXPECT_EQ(undoText(), QStringLiteral("hide: Mark 1"));
  EXPECT_EQ(view().order().comparison.measures.size(), 1u) << "the picture marks the other";
  const QString longName(500, QLatin1Char('W'));
  list().topLevelItem(1)->setText(0, longName);
  EXPECT_EQ(measurements()[1].name, longName.toStdString());
  EXPECT_LT(undoText().size(), 80);
  EXPECT_FALSE(axial().grab().isNull());
}

TEST_F(MeasureWindow, aClickInTheListGoesThereAndDeleteTakesItAway) {
  press(axial(), Qt::Key_D);
  drag(inSlice({-60, 0}), inSlice({-20, 0}));
  drag(inSlice({20, 30}), inSlice({60, 30}));
  const glm::dvec3 middle = middleMm(measurements()[0]);
  PlaneSettings elsewhere = session().planes();
  elsewhere.crosshairMm = middle + glm::dvec3(30.0, 20.0, 40.0);
  session().setPlanes(elsewhere);
  ASSERT_TRUE(test::waitUntil([&] { return list().isVisible(); }));
  const QPoint row = list().visualItemRect(list().topLevelItem(0)).center();
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, row);
  ASSERT_TRUE(session().planes().crosshairMm);
  EXPECT_LT(glm::length(*session().planes().crosshairMm - middle), 1e-9);
  EXPECT_EQ(axial().content().inHand, 0u);
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Delete);
  EXPECT_EQ(measurements().size(), 1u);
  EXPECT_EQ(list().topLevelItemCount(), 1);
}

TEST_F(MeasureWindow, inThePictureTwoClicksMeasureBetweenWhatIsSeen) {
  press(view(), Qt::Key_D);
  EXPECT_EQ(view().tool(), ViewTool::distance);
  const Camera camera = scene().camera;
  const auto placeSeen = [&](const QPoint& fromMiddle) {
    const QPointF at = view().logicalRect(0).center().toPoint() + fromMiddle;
    const auto ray = rayUnder(view().order().geometry, scene().camera, at);
    return *turnCentreAlong(view(), *ray, 0).placeMm;
  };
  const glm::dvec3 first = placeSeen({-20, 0}), second = placeSeen({25, 10});
  click(inPicture({-20, 0}));
  EXPECT_TRUE(measurements().empty());
  ASSERT_EQ(view().order().comparison.measures.size(), 1u) << "the first end is shown";
  click(inPicture({25, 10}));
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_EQ(measurements().front().kind, Kind::distance);
  EXPECT_FALSE(measurements().front().plane);
  EXPECT_LT(glm::length(measurements().front().placesMm[0] - first), 1e-9);
  EXPECT_LT(glm::length(measurements().front().placesMm[1] - second), 1e-9);
  EXPECT_EQ(scene().camera, camera) << "a click turns nothing";
  EXPECT_EQ(undo().count(), 1);
  EXPECT_TRUE(undoText().startsWith(QStringLiteral("Distance "))) << undoText().toStdString();
  // It is drawn over the picture with its length, beside what was measured.
  const Overlay overlay = overlayOf({view().order(), view().pictureState()});
  ASSERT_EQ(overlay.measures.size(), 1u);
  const MeasureMark& mark = overlay.measures.front().marks.front();
  ASSERT_TRUE(mark.note);
  EXPECT_TRUE(mark.note->text.contains(QStringLiteral("mm")));
  EXPECT_FALSE(measuredArea(mark.shape).intersects(mark.note->plate));
  // An end is led to what is seen elsewhere.
  const auto end = pixelOf(viewProjection(scene().camera, view().logicalRect(0)), second);
  ASSERT_TRUE(end);
  const QPoint at = view().mapTo(window.get(), end->toPoint());
  drag(at, at + QPoint(0, 20));
  EXPECT_LT(glm::length(measurements().front().placesMm[0] - first), 1e-9);
  EXPECT_GT(glm::length(measurements().front().placesMm[1] - second), 1.0);
  EXPECT_EQ(undo().count(), 2);
  press(view(), Qt::Key_Delete);
  EXPECT_TRUE(measurements().empty());
  press(view(), Qt::Key_Escape);
  EXPECT_EQ(view().tool(), ViewTool::rotate);
}

// What was measured in front is drawn faintly from behind.
TEST_F(MeasureWindow, whatLiesBehindWhatIsSeenIsDrawnFaintly) {
  press(view(), Qt::Key_D);
  const QPoint middle = view().mapTo(window.get(), view().logicalRect(0).center().toPoint());
  click(middle - QPoint(20, 0));
  click(middle + QPoint(20, 0));
  ASSERT_EQ(measurements().size(), 1u);
  const auto isFaint = [this] { return view().order().comparison.measures.front().isHidden[0]; };
  ASSERT_TRUE(rest());
  EXPECT_FALSE(isFaint());
  view().lookFrom(StandardView::posterior);
  EXPECT_TRUE(test::waitUntil([&] { return isFaint(); }));
  view().lookFrom(StandardView::anterior);
  EXPECT_TRUE(test::waitUntil([&] { return !isFaint(); }));
}

// What one look of two hides lies open in the other.
TEST_F(MeasureWindow, whatOneSideOfAComparisonHidesIsFaintThereAlone) {
  TransferFunction skin = scene().transferFunction, nothing = skin;
  skin.points = {{-300, {1, 1, 1}, 0.0}, {-100, {1, 1, 1}, 0.9}};
  nothing.points = {{-300, {1, 1, 1}, 0.0}, {4000, {1, 1, 1}, 0.0}};
  session().setTransferFunction(skin, {nextGestureId(), QStringLiteral("skin")});
  window->findChild<QAction*>(QStringLiteral("takeSnapshot"))->trigger();
  session().setTransferFunction(nothing, {nextGestureId(), QStringLiteral("nothing")});
  choose("picture");
  window->findChild<QAction*>(QStringLiteral("compareSnapshot"))->trigger();
  const glm::dvec3 middle = boxCentreMm(scene().volume->grid());
  session().setMeasurements({{Kind::distance, std::nullopt, {middle, middle + glm::dvec3(20, 0, 0)}}},
                            {nextGestureId(), QStringLiteral("measure")});
  ASSERT_EQ(view().order().comparison.measures.size(), 1u);
  const auto faint = [this] { return view().order().comparison.measures.front().isHidden; };
  EXPECT_TRUE(test::waitUntil([&] { return faint() == std::array<bool, 2>{true, false}; }));
}

TEST_F(MeasureWindow, inThePictureBothEndsMayLieClose) {
  press(view(), Qt::Key_D);
  click(inPicture({0, 0}));
  click(inPicture({5, 0}));
  ASSERT_EQ(measurements().size(), 1u) << "the first end is no handle yet";
  EXPECT_GT(lengthMm(measurements().front()), 0.0);
}

TEST_F(MeasureWindow, inThePictureAnAngleIsThreeClicksAndAMarkOne) {
  press(view(), Qt::Key_G);
  for (const QPoint& at : {QPoint(-30, 0), QPoint(0, 0), QPoint(0, -30)})
    click(inPicture(at));
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_EQ(measurements().front().kind, Kind::angle);
  EXPECT_TRUE(angleDegrees(measurements().front()));
  press(view(), Qt::Key_N);
  click(inPicture({20, 20}));
  ASSERT_EQ(measurements().size(), 2u);
  EXPECT_EQ(measurements()[1].name, "1");
  // What has not all of its places goes with its tool.
  press(view(), Qt::Key_D);
  click(inPicture({10, 0}));
  EXPECT_EQ(view().order().comparison.measures.size(), 3u);
  press(view(), Qt::Key_Escape);
  EXPECT_EQ(view().order().comparison.measures.size(), 2u);
  EXPECT_EQ(measurements().size(), 2u);
}

TEST_F(MeasureWindow, deleteTakesBackWhatIsBegunBeforeWhatIsFinished) {
  press(view(), Qt::Key_G);
  for (const QPoint& at : {QPoint(-30, 0), QPoint(0, 0), QPoint(0, -30)})
    click(inPicture(at));
  ASSERT_EQ(measurements().size(), 1u);
  for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace}) {
    click(inPicture({20, 20}));
    EXPECT_EQ(view().order().comparison.measures.size(), 2u) << "it is begun";
    press(axial(), Qt::Key_Delete);
    EXPECT_EQ(measurements().size(), 1u) << "a slice takes nothing that is finished either";
    press(view(), key);
    EXPECT_EQ(measurements().size(), 1u);
    EXPECT_EQ(view().order().comparison.measures.size(), 1u) << "nor is a lone place left";
    EXPECT_EQ(view().tool(), ViewTool::angle);
  }
  press(view(), Qt::Key_Delete);
  EXPECT_TRUE(measurements().empty());
}

TEST_F(MeasureWindow, whereNothingIsSeenNothingIsMeasured) {
  press(view(), Qt::Key_D);
  click(inPicture({-static_cast<int>(view().logicalRect(0).width() / 2) + 4, 0}));
  EXPECT_EQ(said(), noPlaceText());
  EXPECT_TRUE(view().order().comparison.measures.empty());
  Scene average = scene();
  average.projection = Projection::average;
  session().edit(average, {nextGestureId(), "average"});
  click(inPicture({0, 0}));
  EXPECT_TRUE(said().contains(QStringLiteral("every depth counts alike"))) << said().toStdString();
  EXPECT_TRUE(measurements().empty());
}

TEST_F(MeasureWindow, buttonsBesideTheListChooseTheTools) {
  auto* section = window->findChild<MeasureSection*>();
  section->findChild<QToolButton*>(QStringLiteral("measure-angle"))->click();
  EXPECT_EQ(view().tool(), ViewTool::angle);
  auto* inSlices = window->findChild<QToolButton*>(QStringLiteral("measureTool"));
  EXPECT_EQ(inSlices->accessibleName(), QStringLiteral("Angle (G)"));
  EXPECT_TRUE(inSlices->isChecked());
  choose("picture");
  section->findChild<QToolButton*>(QStringLiteral("measure-ellipse"))->click();
  EXPECT_TRUE(measureBar().hint().contains(QStringLiteral("View ▸ Slices")));
  EXPECT_TRUE(measureBar().isVisible());
}

// A tool that was taken for a slice measures in the picture, too, and the other way round; where it cannot a
// click says so.
TEST_F(MeasureWindow, aToolIsInHandInSlicesAndInThePictureAlike) {
  press(axial(), Qt::Key_G);
  for (const QPoint& at : {QPoint(-30, 0), QPoint(0, 0), QPoint(0, -30)})
    click(inPicture(at));
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_FALSE(measurements().front().plane);
  press(view(), Qt::Key_D);
  drag(inSlice({-40, 0}), inSlice({60, 0}));
  ASSERT_EQ(measurements().size(), 2u);
  EXPECT_EQ(measurements().back().plane, PatientPlane::axial);
  // What was begun in the one place ends where the other is clicked.
  click(inPicture({20, 20}));
  EXPECT_EQ(view().order().comparison.measures.size(), 3u);
  drag(inSlice({-40, 50}), inSlice({60, 50}));
  EXPECT_EQ(measurements().size(), 3u);
  EXPECT_EQ(view().order().comparison.measures.size(), 3u);
  press(view(), Qt::Key_G);
  drag(inSlice({-60, -90}), inSlice({-60, -60})); // one leg
  EXPECT_EQ(measurements().size(), 4u);
  click(inPicture({10, -20}));
  EXPECT_EQ(measurements().size(), 3u);
  press(view(), Qt::Key_E);
  const Camera camera = scene().camera;
  click(inPicture({0, 20}));
  EXPECT_EQ(said(), QStringLiteral("In a slice, drag from corner to corner or click both"));
  EXPECT_EQ(scene().camera, camera);
  EXPECT_EQ(measurements().size(), 3u);
}

TEST_F(MeasureWindow, sessionsScenesAndPicturesKeepWhatWasMeasured) {
  press(axial(), Qt::Key_D);
  drag(inSlice({-40, 0}), inSlice({60, 0}));
  press(view(), Qt::Key_N);
  click(inPicture({0, 0}));
  ASSERT_EQ(measurements().size(), 2u);
  const std::vector<Measurement> measured = measurements();
  ASSERT_TRUE(rest());
  for (const auto& [action, file] :
       {std::pair("saveSession", "kept-session.json"), std::pair("saveScene", "kept-scene.json")}) {
    typeName(pathTo(file));
    window->findChild<QAction*>(QLatin1String(action))->trigger();
    ASSERT_TRUE(test::waitUntil([&] { return QFile::exists(pathTo(file)); })) << file;
  }
  saving().writePicture(pathTo("kept.png"));
  ASSERT_TRUE(open(QStringLiteral("phantom:5")));
  EXPECT_TRUE(measurements().empty()) << "of another volume nothing was measured";
  EXPECT_EQ(list().topLevelItemCount(), 0);
  for (const char* file : {"kept-session.json", "kept-scene.json", "kept.png"}) {
    ASSERT_TRUE(open(pathTo(file))) << file;
    EXPECT_EQ(measurements(), measured) << file;
    EXPECT_EQ(undo().count(), 0);
    EXPECT_EQ(list().topLevelItemCount(), 2);
    window->findChild<QAction*>(QStringLiteral("closeVolume"))->trigger();
    EXPECT_TRUE(measurements().empty());
  }
}

TEST_F(MeasureWindow, hundredsAreDrawnAndListed) {
  std::vector<Measurement> many;
  const glm::dvec3 middle = crosshairOf(axial().content());
  for (int n = 0; n < 300; ++n) {
    const glm::dvec3 at = middle + glm::dvec3((n % 20) * 4.0 - 40.0, (n / 20) * 5.0 - 40.0, 0.0);
    many.push_back({n % 2 ? Kind::mark : Kind::distance, PatientPlane::axial, {at}, std::to_string(n)});
    if (n % 2 == 0)
      many.back().placesMm.push_back(at + glm::dvec3(3.0, 2.0, 0.0));
  }
  session().setMeasurements(many, {nextGestureId(), "many"});
  EXPECT_EQ(list().topLevelItemCount(), 300);
  EXPECT_FALSE(axial().grab().isNull());
  ASSERT_TRUE(rest());
  EXPECT_EQ(view().order().comparison.measures.size(), 300u) << "of slices, too";
  undo().undo();
  EXPECT_EQ(list().topLevelItemCount(), 0);
}

} // namespace
} // namespace limn
