// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/DialogKeys.h"
#include "app/WindowHarness.h"
#include "app/picture/CutController.h"
#include "app/picture/PictureArea.h"
#include "app/picture/RegionController.h"
#include "io/ImageFile.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneOverlay.h"
#include "widgets/planes/PlanePictures.h"
#include "widgets/planes/PlaneView.h"
#include "widgets/planes/SlicePicture.h"
#include "widgets/view/gestures/ViewDrag.h"
#include "widgets/view/panels/CutBar.h"

#include <QClipboard>
#include <QColorSpace>
#include <QComboBox>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QStatusBar>
#include <QWheelEvent>

// What is cut by hand in the slices beside the picture, and the slices as pictures, in the program's window.

namespace limn {
namespace {

class SliceCutWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:4")));
    window->findChild<QAction*>(QStringLiteral("planes-picture_and_three"))->trigger();
    ASSERT_TRUE(rest());
  }

  PlaneView& plane(PatientPlane which) const { return *window->findChild<PlaneDeck*>()->view(which); }
  PlaneView& axial() const { return plane(PatientPlane::axial); }
  PlaneTool planeTool() const { return window->findChild<PlaneDeck*>()->tool(); }
  const Grid& grid() const { return scene().volume->grid(); }
  const std::vector<Cut>& cuts() const { return scene().keep.cuts; }
  CutController& cutting() const { return *window->findChild<CutController*>(); }
  [[nodiscard]] bool ready() const {
    const RegionController* regions = window->findChild<RegionController*>();
    return test::waitUntil([&] { return !regions->isBusy() && !cutting().isBusy(); });
  }
  QPoint at(const PlaneView& in, const glm::dvec3& worldMm) const {
    return in.mapTo(window.get(), pointOf(in.frame(), worldMm)).toPoint();
  }
  void press(QWidget& widget, Qt::Key key) {
    widget.setFocus();
    QTest::keyClick(&widget, key);
    QCoreApplication::processEvents();
  }
  void click(const PlaneView& in, const glm::dvec3& worldMm) {
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, at(in, worldMm));
    QCoreApplication::processEvents();
  }
  // Around a place, so many millimetres away from it.
  void drawAround(const PlaneView& in, const glm::dvec3& worldMm, double mm) {
    const PlaneAxes axes = axesOf(in.plane());
    const auto corner = [&](double right, double down) {
      return at(in, worldMm + mm * (right * axes.right + down * axes.down));
    };
    QWindow* handle = window->windowHandle();
    QTest::mousePress(handle, Qt::LeftButton, {}, corner(-1, -1));
    for (const QPoint& to : {corner(1, -1), corner(1, 1), corner(-1, 1)})
      QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, to);
    QTest::mouseRelease(handle, Qt::LeftButton, {}, corner(-1, 1));
    QCoreApplication::processEvents();
  }
  void clickBar(const QString& text) {
    for (QPushButton* button : view().findChild<CutBar*>()->findChildren<QPushButton*>())
      if (button->text() == text)
        return QTest::mouseClick(button, Qt::LeftButton);
    ADD_FAILURE() << "no button " << text.toStdString();
  }
  double weight(const glm::dvec3& worldMm) const {
    return weightAt(scene().keep, worldToIndex(grid(), worldMm));
  }
  QString said() const { return window->statusBar()->currentMessage(); }

  // The first voxel to the right in the middle row of the axial slice that the curve makes half opaque.
  glm::dvec3 seenPlace() const {
    const glm::dvec3 middle = crosshairOf(axial().content());
    const glm::ivec3 from(glm::round(worldToIndex(grid(), middle)));
    for (int i = 0; i < grid().dims.x; ++i) {
      const glm::dvec3 index(i, from.y, from.z);
      if (classify(scene().transferFunction, valueAt(*scene().volume, index)).opacity >= 0.3)
        return indexToWorld(grid(), index);
    }
    ADD_FAILURE() << "nothing is seen in the slice";
    return middle;
  }
};

TEST_F(SliceCutWindow, aReachIsForgottenOnceTheToolIsLaidAside) {
  press(axial(), Qt::Key_K);
  const CutBar& bar = *view().findChild<CutBar*>();
  for (const QPushButton* button : bar.findChildren<QPushButton*>())
    if (button->menu())
      button->menu()->actions().back()->trigger();
  ASSERT_TRUE(bar.reachMm());
  clickBar(QStringLiteral("Done"));
  ASSERT_EQ(view().tool(), ViewTool::rotate);
  press(axial(), Qt::Key_K);
  EXPECT_FALSE(bar.reachMm());
}

TEST_F(SliceCutWindow, aClickInASlicePicksThePieceThere) {
  press(axial(), Qt::Key_K);
  EXPECT_EQ(view().tool(), ViewTool::piece) << "one tool everywhere";
  const glm::dvec3 place = seenPlace();
  const PlaneSettings before = session().planes();
  click(axial(), place);
  ASSERT_TRUE(ready());
  ASSERT_TRUE(cutting().hasPiece());
  EXPECT_NE(view().scene().keep, scene().keep) << "it lights up in the picture";
  ASSERT_TRUE(axial().content().lit.map) << "and in the slices";
  const glm::ivec3 voxel(glm::round(worldToIndex(grid(), place)));
  const std::size_t label =
      axial().content().lit.map->placeAt(voxelOffset(grid().dims, voxel.x, voxel.y, voxel.z));
  EXPECT_TRUE(axial().content().lit.isLit.at(label));
  EXPECT_EQ(session().planes(), before) << "the crosshair stays";

  const PlaneLit first = axial().content().lit;
  const QPointF over = pointOf(axial().frame(), place);
  QWheelEvent wheel(over, axial().mapToGlobal(over), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase,
                    false);
  QCoreApplication::sendEvent(&axial(), &wheel);
  EXPECT_TRUE(window->isBusy()) << "the piece is being found";
  ASSERT_TRUE(ready());
  EXPECT_EQ(session().planes(), before) << "no other slice";
  EXPECT_NE(axial().content().lit, first);

  clickBar(QStringLiteral("Hide"));
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  const auto& piece = std::get<ConnectedPiece>(cuts().front().how);
  // The seed is the most opaque voxel within two (pieceAt).
  EXPECT_LE(glm::length(worldToIndex(grid(), piece.seedMm) - glm::dvec3(voxel)), 2.0 * std::sqrt(3.0) + 1e-9);
  EXPECT_FALSE(axial().content().lit.map);
  EXPECT_EQ(weight(piece.seedMm), 0.0);
  EXPECT_EQ(undo().count(), 1);
}

TEST_F(SliceCutWindow, aLineInASliceCutsAlongItsNormal) {
  for (const PatientPlane which : patientPlanes) {
    press(plane(which), Qt::Key_X);
    EXPECT_EQ(view().tool(), ViewTool::scissors);
    const glm::dvec3 middle = crosshairOf(axial().content());
    drawAround(plane(which), middle, 20.0);
    ASSERT_TRUE(ready());
    ASSERT_EQ(cuts().size(), 1u) << nameOf(which);
    const auto& scissors = std::get<Scissors>(cuts().front().how);
    const PlaneAxes axes = axesOf(which);
    EXPECT_EQ(scissors.camera.projection, Camera::Projection::orthographic);
    EXPECT_NEAR(glm::length(basisOf(scissors.camera).right - axes.right), 0.0, 1e-12) << "as it is seen";
    EXPECT_NEAR(glm::length(basisOf(scissors.camera).up + axes.down), 0.0, 1e-12);
    EXPECT_FALSE(scissors.depthMm);
    // Places a pixel inside and outside of the line, in slices far from the one it was drawn in.
    const double pixel = mmPerLogicalPixel(plane(which).frame());
    const double far = 0.35 * boxSizeMm(grid()).z;
    for (const double along : {-far, 0.0, far}) {
      const glm::dvec3 slice = middle + along * axes.forward;
      const double spacing = glm::length(grid().spacingMm); // weights run from voxel to voxel
      EXPECT_EQ(weight(slice), 0.0) << nameOf(which);
      EXPECT_EQ(weight(slice + (20.0 - pixel - spacing) * axes.right), 0.0);
      EXPECT_EQ(weight(slice + (20.0 + pixel + spacing) * axes.right), 1.0);
      EXPECT_EQ(weight(slice + (20.0 + pixel + spacing) * axes.down), 1.0);
    }
    undo().undo();
    press(plane(which), Qt::Key_Escape);
    EXPECT_EQ(view().tool(), ViewTool::rotate);
    EXPECT_EQ(planeTool(), PlaneTool::crosshair);
  }
}

TEST_F(SliceCutWindow, whatIsSeenInASliceIsItsSlab) {
  PlaneSettings settings = session().planes();
  settings.slab.thicknessMm = 20.0;
  session().setPlanes(settings);
  press(axial(), Qt::Key_X);
  clickBar(QStringLiteral("What is seen"));
  const glm::dvec3 middle = crosshairOf(axial().content());
  drawAround(axial(), middle, 20.0);
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  const auto& scissors = std::get<Scissors>(cuts().front().how);
  ASSERT_TRUE(scissors.depthMm);
  EXPECT_NEAR(scissors.depthMm->y - scissors.depthMm->x, 20.0, 1e-9);
  const glm::dvec3 forward = axesOf(PatientPlane::axial).forward;
  const double spacing = grid().spacingMm.z;
  EXPECT_EQ(weight(middle), 0.0);
  EXPECT_EQ(weight(middle + (10.0 + 2.0 * spacing) * forward), 1.0);
  EXPECT_EQ(weight(middle - (10.0 + 2.0 * spacing) * forward), 1.0);
}

TEST_F(SliceCutWindow, cornersAreClickedAndTheLineGoesWithItsSlice) {
  press(axial(), Qt::Key_X);
  const glm::dvec3 middle = crosshairOf(axial().content());
  for (const glm::dvec3& corner :
       {glm::dvec3(-20, -20, 0), glm::dvec3(20, -20, 0), glm::dvec3(20, 20, 0), glm::dvec3(0, 30, 0)})
    click(axial(), middle + corner);
  ASSERT_TRUE(axial().cutLine());
  EXPECT_EQ(axial().cutLine()->corners.size(), 4u);
  press(axial(), Qt::Key_Backspace);
  EXPECT_EQ(axial().cutLine()->corners.size(), 3u);
  press(axial(), Qt::Key_Return);
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  click(axial(), middle);
  ASSERT_TRUE(axial().cutLine());
  axial().goOn(1);
  EXPECT_FALSE(axial().cutLine()) << "it would go around other things";
  click(axial(), middle);
  press(axial(), Qt::Key_Escape);
  EXPECT_FALSE(axial().cutLine());
  EXPECT_EQ(planeTool(), PlaneTool::scissors) << "Esc takes the line, then the tool";
}

// A click in the other place would be lost.
TEST_F(SliceCutWindow, aToolThatCutsOrMeasuresIsInHandEverywhereOrNowhere) {
  const std::vector<std::tuple<Qt::Key, ViewTool, PlaneTool>> shared{
      {Qt::Key_X, ViewTool::scissors, PlaneTool::scissors},
      {Qt::Key_D, ViewTool::distance, PlaneTool::distance},
      {Qt::Key_K, ViewTool::piece, PlaneTool::piece},
      {Qt::Key_G, ViewTool::angle, PlaneTool::angle},
      {Qt::Key_E, ViewTool::ellipse, PlaneTool::ellipse},
      {Qt::Key_N, ViewTool::mark, PlaneTool::mark}};
  for (QWidget* place : {static_cast<QWidget*>(&view()), static_cast<QWidget*>(&axial())})
    for (const auto& [key, inPicture, inSlices] : shared) {
      press(*place, key);
      EXPECT_EQ(view().tool(), inPicture) << key;
      EXPECT_EQ(planeTool(), inSlices) << key;
    }
  press(view(), Qt::Key_M);
  EXPECT_EQ(view().tool(), ViewTool::pan);
  EXPECT_EQ(planeTool(), PlaneTool::crosshair);
  press(axial(), Qt::Key_W);
  EXPECT_EQ(planeTool(), PlaneTool::windowLevel);
  EXPECT_EQ(view().tool(), ViewTool::pan) << "what each place has for itself";
  press(axial(), Qt::Key_G);
  press(axial(), Qt::Key_Escape);
  EXPECT_EQ(view().tool(), ViewTool::rotate);
  EXPECT_EQ(planeTool(), PlaneTool::crosshair);
}

// C has no meaning of its own in the picture, and the row above the slices has none for letters.
TEST_F(SliceCutWindow, keysOfToolsNeedNotTheFocusOfASlice) {
  press(axial(), Qt::Key_D);
  press(view(), Qt::Key_C);
  EXPECT_EQ(planeTool(), PlaneTool::crosshair);
  EXPECT_EQ(view().tool(), ViewTool::rotate);
  auto* button = window->findChild<QToolButton*>(QStringLiteral("measureTool"));
  press(*button, Qt::Key_G);
  EXPECT_EQ(planeTool(), PlaneTool::angle);
  EXPECT_EQ(view().tool(), ViewTool::angle);
}

TEST_F(SliceCutWindow, theBarHasRoomForItsButtonsBesideALargeSlice) {
  window->findChild<QAction*>(QStringLiteral("planes-one_large"))->trigger();
  QCoreApplication::processEvents();
  press(axial(), Qt::Key_X);
  const CutBar& bar = *view().findChild<CutBar*>();
  ASSERT_TRUE(bar.isVisible());
  EXPECT_TRUE(view().rect().contains(bar.geometry()));
  // In one of four views of a usual window they stand in one row, at the lower edge and not over the face.
  window->resize(1440, 860);
  window->findChild<QAction*>(QStringLiteral("planes-picture_and_three"))->trigger();
  EXPECT_TRUE(test::waitUntil([&] { return view().width() > 400 && bar.height() < 50; }))
      << bar.width() << " of " << view().width();
  EXPECT_GT(bar.geometry().top(), view().height() / 2);
  window->resize(1280, 800);
  window->findChild<QAction*>(QStringLiteral("planes-one_large"))->trigger();
  QCoreApplication::processEvents();
  int seen = 0;
  for (const QPushButton* button : bar.findChildren<QPushButton*>())
    if (button->isVisible()) {
      ++seen;
      EXPECT_GE(button->width(), button->minimumSizeHint().width()) << button->text().toStdString();
    }
  EXPECT_EQ(seen, 5);
}

TEST_F(SliceCutWindow, theJawIsAwayInThreeGestures) {
  // Counted as a person does them: look from the left, take the scissors, draw around it.
  window->findChild<QAction*>(QStringLiteral("planes-picture"))->trigger(); // where there is room
  ASSERT_TRUE(rest());
  press(view(), Qt::Key_L);
  press(view(), Qt::Key_X);
  ASSERT_TRUE(rest());
  const QRectF picture = view().logicalRect(0);
  // In front (left in a picture from the left) and below: a third of the picture each way.
  const auto corner = [&](double x, double y) {
    return view().mapTo(window.get(), QPoint(static_cast<int>(picture.left() + x * picture.width()),
                                             static_cast<int>(picture.top() + y * picture.height())));
  };
  QWindow* handle = window->windowHandle();
  QTest::mousePress(handle, Qt::LeftButton, {}, corner(0.4, 0.6));
  for (const QPoint& to : {corner(0.4, 0.98), corner(0.05, 0.98), corner(0.05, 0.6)})
    QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, to);
  QTest::mouseRelease(handle, Qt::LeftButton, {}, corner(0.05, 0.6));
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  EXPECT_TRUE(isCutAway(scene().keep));
  EXPECT_EQ(undo().count(), 1);
}

TEST_F(SliceCutWindow, aSliceIsCopiedAndSavedWithItsMarksAndWithoutTheCrosshair) {
  const glm::dvec3 middle = crosshairOf(axial().content());
  session().setMeasurements({{Measurement::Kind::distance,
                              PatientPlane::axial,
                              {middle - glm::dvec3(80, 0, 0), middle + glm::dvec3(80, 0, 0)}}},
                            {nextGestureId(), QStringLiteral("measure")});
  const auto choose = [&](const char* entry) {
    QTest::mouseClick(window->windowHandle(), Qt::RightButton, {}, at(axial(), middle));
    QCoreApplication::processEvents();
    auto* menu = view().findChild<QMenu*>(QStringLiteral("sliceMenu"));
    ASSERT_NE(menu, nullptr);
    menu->findChild<QAction*>(QLatin1String(entry))->trigger();
    menu->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  choose("copySlice");
  const QImage copied = QApplication::clipboard()->image().convertToFormat(QImage::Format_RGB888);
  EXPECT_EQ(copied.size(), axial().size() * axial().devicePixelRatioF());
  EXPECT_TRUE(said().startsWith(QStringLiteral("Copied the slice"))) << said().toStdString();
  // The crosshair's column, far from its middle and the edges' marks, is as its neighbours are; the distance
  // is drawn in white.
  const QPointF cross = pointOf(axial().frame(), middle);
  const int x = static_cast<int>(cross.x()), y = static_cast<int>(cross.y());
  int blue = 0;
  for (int row = 0; row < copied.height(); ++row)
    blue += copied.pixelColor(x, row) == QColor(77, 163, 255);
  EXPECT_EQ(blue, 0);
  int white = 0;
  for (int column = 0; column < copied.width(); ++column) {
    const auto isWhite = [&](int row) { return copied.pixelColor(column, row).lightness() > 160; };
    white += isWhite(y - 1) || isWhite(y) || isWhite(y + 1); // it lies between rows
  }
  const double mm = mmPerLogicalPixel(axial().frame());
  EXPECT_GT(white, 0.5 * 160.0 / mm) << "a line of 160 mm, less what its number covers";

  onceAsked<PictureDialog>([](PictureDialog& dialog) { dialog.accept(); });
  typeName(pathTo("slice"));
  choose("saveSlice");
  EXPECT_TRUE(window->isBusy()) << "it is being written";
  ASSERT_TRUE(test::waitUntil([this] { return isWholePicture(folder.path() / "slice.png"); }));
  EXPECT_TRUE(test::waitUntil([this] { return !window->isBusy(); }));
  const BytePicture saved = readBytes(folder.path() / "slice.png");
  ASSERT_EQ(saved.size, glm::ivec2(copied.width(), copied.height()));
  int others = 0;
  for (int row = 0; row < copied.height(); ++row)
    for (int column = 0; column < 3 * copied.width(); ++column)
      others += saved.bytes[static_cast<std::size_t>(row) * 3 * copied.width() + column] !=
                copied.constScanLine(row)[column];
  EXPECT_EQ(others, 0);
}

TEST_F(SliceCutWindow, aSliceIsSavedAsLargeAsAskedForAndSaysThatItIsNotForDiagnosis) {
  const SeenSlice seen{axial().content(), PatientPlane::axial, axial().frame(), axial().size(),
                       axial().font()};
  SavedMarks bare;
  bare.warning = false;
  const QImage without = slicePicture(seen, bare), with = slicePicture(seen, {});
  QRect warning;
  for (int y = 0; y < with.height(); ++y)
    for (int x = 0; x < with.width(); ++x)
      if (with.pixel(x, y) != without.pixel(x, y))
        warning |= QRect(x, y, 1, 1);
  ASSERT_FALSE(warning.isEmpty());
  EXPECT_GT(warning.center().x(), with.width() / 2);
  EXPECT_GT(warning.center().y(), with.height() / 2);
  for (const Note& note : planeOverlay(seen.content, seen.plane, seen.frame, seen.size, seen.font).notes)
    EXPECT_TRUE(note.text == crosshairText(seen.content) || !note.plate.intersects(QRectF(warning)))
        << note.text.toStdString();
  EXPECT_EQ(slicePicture(seen, noMarks),
            PlanePictures().picture(seen.content, seen.frame.grid, 1).convertToFormat(QImage::Format_RGB32))
      << "no marks: the slice alone";

  // Twice as large, with twice as many pixels of the volume below the same marks.
  bool isAsked = false;
  onceAsked<PictureDialog>([&isAsked](PictureDialog& dialog) {
    isAsked = true;
    EXPECT_EQ(dialog.windowTitle(), QStringLiteral("Save the slice"));
    EXPECT_FALSE(dialog.findChild<QComboBox*>(QStringLiteral("pictureGround"))->isVisible());
    dialog.findChild<QComboBox*>(QStringLiteral("pictureSize"))->setCurrentIndex(1);
    dialog.accept();
  });
  typeName(pathTo("large"));
  window->findChild<PictureArea*>()->sliceSaveChosen(PatientPlane::axial);
  ASSERT_TRUE(test::waitUntil([this] { return isWholePicture(folder.path() / "large.png"); }));
  EXPECT_TRUE(isAsked);
  const QImage large(pathTo("large.png"));
  EXPECT_EQ(large.size(), 2 * with.size());
  const PlaneFrame twice = scaledBy(seen.frame, 2.0);
  EXPECT_NEAR(mmPerLogicalPixel(twice), mmPerLogicalPixel(seen.frame), 1e-12);
  const glm::dvec3 middle = crosshairOf(seen.content);
  EXPECT_NEAR(QLineF(pointOf(twice, middle), pointOf(seen.frame, middle)).length(), 0.0, 1e-9);
}

TEST_F(SliceCutWindow, aSliceIsSavedInAnotherShapeAboutTheSameMiddle) {
  const SeenSlice seen{axial().content(), PatientPlane::axial, axial().frame(), axial().size(),
                       axial().font()};
  onceAsked<PictureDialog>([](PictureDialog& dialog) {
    test::askForPixels(dialog, "300", "300");
    dialog.accept();
  });
  typeName(pathTo("square"));
  window->findChild<PictureArea*>()->sliceSaveChosen(PatientPlane::axial);
  ASSERT_TRUE(test::waitUntil([this] { return isWholePicture(folder.path() / "square.png"); }));
  SeenSlice square = seen;
  square.frame = shapedAs(seen.frame, {300, 300});
  square.size = QSizeF(300, 300) / square.frame.pixelRatio;
  QImage saved = QImage(pathTo("square.png")).convertToFormat(QImage::Format_RGB32);
  saved.setColorSpace({}); // which the file tells
  EXPECT_EQ(saved, slicePicture(square, {}).convertToFormat(QImage::Format_RGB32));
}

TEST_F(SliceCutWindow, aDistanceOfASliceStandsInThePictureAndIsLedInTheSlice) {
  const glm::dvec3 middle = crosshairOf(axial().content());
  session().setMeasurements({{Measurement::Kind::distance,
                              PatientPlane::axial,
                              {middle - glm::dvec3(80, 0, 0), middle + glm::dvec3(80, 0, 0)}},
                             {Measurement::Kind::ellipse,
                              PatientPlane::axial,
                              {middle - glm::dvec3(10, 10, 0), middle + glm::dvec3(10, 10, 0)}}},
                            {nextGestureId(), QStringLiteral("measure")});
  const std::vector<SeenMeasure>& seen = view().order().comparison.measures;
  ASSERT_EQ(seen.size(), 1u) << "an ellipse lies in what its slice shows";
  EXPECT_EQ(seen.front().kind, Measurement::Kind::distance);
  EXPECT_TRUE(seen.front().isOpen) << "what is seen along a ray lies elsewhere";
}

// The bar, which says it before, is out of the way then.
TEST_F(SliceCutWindow, cornersSayHowTheirLineIsClosed) {
  const auto isTold = [this] { return said().contains(QStringLiteral("double click closes the line")); };
  press(view(), Qt::Key_X);
  EXPECT_FALSE(isTold());
  const QPoint middle = view().logicalRect(0).center().toPoint();
  const auto clickPicture = [&](const QPoint& fromMiddle) {
    QTest::mouseClick(&view(), Qt::LeftButton, {}, middle + fromMiddle);
  };
  clickPicture({-30, -30});
  clickPicture({30, -30});
  EXPECT_TRUE(isTold());
  press(view(), Qt::Key_Escape);
  EXPECT_FALSE(isTold());
  clickPicture({-30, -30});
  clickPicture({30, -30});
  clickPicture({0, 30});
  EXPECT_TRUE(isTold());
  QTest::mouseDClick(&view(), Qt::LeftButton, {}, middle + QPoint(0, 30));
  QTest::mouseRelease(&view(), Qt::LeftButton, {}, middle + QPoint(0, 30));
  EXPECT_FALSE(isTold());
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);

  const glm::dvec3 place = crosshairOf(axial().content());
  const PlaneAxes axes = axesOf(PatientPlane::axial);
  const auto clickSlice = [&](double right, double down) {
    click(axial(), place + 20.0 * (right * axes.right + down * axes.down));
  };
  clickSlice(-1, -1);
  clickSlice(1, -1);
  EXPECT_TRUE(isTold());
  clickSlice(0, 1);
  press(axial(), Qt::Key_Return);
  EXPECT_FALSE(isTold());
  ASSERT_TRUE(ready());
  EXPECT_EQ(cuts().size(), 2u);
}

} // namespace
} // namespace limn
