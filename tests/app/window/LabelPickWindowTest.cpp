// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/RegionController.h"
#include "io/NiftiBytes.h"
#include "scene/LabelLooks.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"
#include "widgets/properties/LabelSection.h"
#include "widgets/view/overlay/Overlay.h"

#include <QClipboard>
#include <QComboBox>
#include <QDropEvent>
#include <QMenu>
#include <QMimeData>
#include <QStatusBar>
#include <QTreeView>

#include <fstream>

// Labels in slices and under the pointer, in the program's window, from NIfTI files as segmentation programs
// write them.

namespace limn {
namespace {

constexpr int side = 32;

class LabelPickWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    std::filesystem::create_directory(folder.path() / "segmentations");
    write<std::int16_t>("two.nii.gz", [](const glm::ivec3& v) { return isInBoxes(v) ? 300 : -1000; });
    write<std::uint8_t>("segmentations/kidney.nii.gz",
                        [](const glm::ivec3& v) { return isInBoxes(v) && v.x < 16; });
    write<std::uint8_t>("segmentations/spleen & co.nii.gz",
                        [](const glm::ivec3& v) { return isInBoxes(v) && v.x >= 16; });
    write<std::uint8_t>("segmentations/tail.nii.gz", [](const glm::ivec3&) { return 0; });
    ASSERT_TRUE(openAlone(pathTo("two.nii.gz")));
  }

  static bool isInBoxes(const glm::ivec3& v) {
    return glm::all(glm::greaterThan(v, glm::ivec3(5))) && glm::all(glm::lessThan(v, glm::ivec3(26)));
  }

  // Cubes of 1 mm whose columns run to the patient's left, as the world's x does.
  template <class T, class Value>
  void write(const char* name, Value value) {
    test::NiftiFields fields;
    fields.dim = {3, side, side, side, 1, 1, 1, 1};
    fields.pixdim = {1, 1, 1, 1, 0, 0, 0, 0};
    fields.datatype = sizeof(T) == 1 ? 2 : 4;
    fields.sformCode = 1;
    fields.rows = {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0};
    std::vector<T> voxels;
    for (int z = 0; z < side; ++z)
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          voxels.push_back(static_cast<T>(value(glm::ivec3(x, y, z))));
    std::ofstream(folder.path() / name, std::ios::binary)
        << test::deflated(test::niftiFile(fields, test::bytesOf(voxels)));
  }

  void openMasks() {
    regions().openLabels(pathTo("segmentations"));
    ASSERT_TRUE(test::waitUntil([this] { return !regions().isBusy(); }));
    ASSERT_EQ(scene().keep.kind, Region::Kind::labels);
    ASSERT_EQ(scene().keep.labels->labels().size(), 3u) << "an empty mask is no label";
  }

  void giveCurve(std::size_t place, const glm::dvec3& color) {
    const TransferFunction look{1.0, {{200.0, color, 0.0}, {300.0, color, 0.9}}};
    session().setKeep(withLookOf(scene().keep, place, look), {nextGestureId(), QStringLiteral("look")});
    QCoreApplication::processEvents();
  }

  void showSlices() {
    window->findChild<QAction*>(QStringLiteral("planes-picture_and_three"))->trigger();
    PlaneSettings settings = session().planes();
    settings.isTinted = true;
    settings.interpolation = PlaneInterpolation::nearest;
    session().setPlanes(settings);
    ASSERT_TRUE(rest());
  }

  RegionController& regions() { return *window->findChild<RegionController*>(); }
  PlaneView& axial() { return *window->findChild<PlaneDeck*>()->view(PatientPlane::axial); }
  QTreeView& table() { return *window->findChild<LabelSection*>()->findChild<QTreeView*>(); }
  const TransferFunction& curveShown() { return curves().valueEditor()->canvas()->transferFunction(); }

  QMenu* menu(const char* name) { return window->findChild<QMenu*>(QLatin1String(name)); }
  QAction& entry(const char* menuName) {
    return *menu(menuName)->findChild<QAction*>(QStringLiteral("takeLabel"));
  }
  void close(const char* menuName) {
    menu(menuName)->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }

  QPoint inSlice(const glm::dvec3& worldMm) {
    return axial().mapTo(window.get(), pointOf(axial().frame(), worldMm)).toPoint();
  }
  void rightClick(const QPoint& at) {
    QTest::mouseClick(window->windowHandle(), Qt::RightButton, {}, at);
    QCoreApplication::processEvents();
  }
  QColor sliceColor(const glm::dvec3& worldMm) {
    const QImage picture = axial().grab().toImage();
    return picture.pixelColor((pointOf(axial().frame(), worldMm) * axial().devicePixelRatioF()).toPoint());
  }
};

// In the middle of the left box, of the right one, and beside both; the crosshair's lines lie elsewhere.
const glm::dvec3 inKidney(9.0, 10.0, 16.0);
const glm::dvec3 inSpleen(22.0, 10.0, 16.0);
const glm::dvec3 inAir(2.0, 10.0, 16.0);

TEST_F(LabelPickWindow, theSlicesTintEachLabelByItsOwnCurve) {
  openMasks();
  giveCurve(1, {1.0, 0.0, 0.0});
  giveCurve(2, {0.0, 0.0, 1.0});
  showSlices();
  const QColor kidney = sliceColor(inKidney), spleen = sliceColor(inSpleen);
  // Opaque over a centimetre: 0.7 of the colour above at most 0.3 of white.
  EXPECT_GE(kidney.red(), 178);
  EXPECT_LE(kidney.blue(), 77);
  EXPECT_GE(spleen.blue(), 178);
  EXPECT_LE(spleen.red(), 77);
  // A label that is hidden has no tint, and its grey stays.
  Region hidden = scene().keep;
  hidden.weights[1] = 0.0;
  session().setKeep(hidden, {nextGestureId(), QStringLiteral("hide")});
  QCoreApplication::processEvents();
  const QColor grey = sliceColor(inKidney);
  EXPECT_EQ(grey.red(), grey.blue());
  EXPECT_EQ(sliceColor(inSpleen), spleen);
}

TEST_F(LabelPickWindow, aRightClickOnASliceTakesTheLabelThereInHand) {
  openMasks();
  giveCurve(2, {0.0, 0.0, 1.0});
  showSlices();
  const TransferFunction ofAll = scene().transferFunction;
  const PlaneSettings before = session().planes();
  rightClick(inSlice(inSpleen));
  ASSERT_NE(menu("sliceMenu"), nullptr);
  EXPECT_EQ(session().planes(), before) << "a click drags no window";
  EXPECT_EQ(entry("sliceMenu").text(), QStringLiteral("Take spleen && co in hand"));
  entry("sliceMenu").trigger();
  close("sliceMenu");
  EXPECT_EQ(table().currentIndex().row(), 2);
  EXPECT_TRUE(table().isVisible());
  EXPECT_EQ(curveShown(), scene().keep.looks.front());
  rightClick(inSlice(inKidney));
  ASSERT_NE(menu("sliceMenu"), nullptr);
  entry("sliceMenu").trigger();
  close("sliceMenu");
  EXPECT_EQ(table().currentIndex().row(), 1);
  EXPECT_EQ(curveShown(), ofAll) << "by which the kidney is shown";
  EXPECT_EQ(undo().undoText(), QStringLiteral("look")) << "nothing was edited";
  // The key for menus asks at the crosshair.
  session().setPlanes(withCrosshair(axial().content(), inSpleen));
  QContextMenuEvent key(QContextMenuEvent::Keyboard, {}, {});
  QCoreApplication::sendEvent(&axial(), &key);
  ASSERT_NE(menu("sliceMenu"), nullptr);
  EXPECT_EQ(entry("sliceMenu").text(), QStringLiteral("Take spleen && co in hand"));
  auto* copy = menu("sliceMenu")->findChild<QAction*>(QStringLiteral("copyValue"));
  copy->trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), readingText(300.0, *scene().volume));
  close("sliceMenu");
}

TEST_F(LabelPickWindow, aRightClickInThePictureTakesTheLabelThatIsSeenThereInHand) {
  openMasks();
  giveCurve(2, {0.0, 0.0, 1.0});
  giveCurve(1, {1.0, 0.0, 0.0});
  ASSERT_TRUE(rest());
  // The patient's left, where x is large, is at the right of the picture.
  const QRectF place = view().logicalRect(0);
  const auto at = [&](double share) {
    return view().mapTo(window.get(), (place.center() + QPointF(share * place.height(), 0.0)).toPoint());
  };
  rightClick(at(0.2));
  ASSERT_NE(menu("pictureMenu"), nullptr);
  EXPECT_EQ(entry("pictureMenu").text(), QStringLiteral("Take spleen && co in hand"));
  entry("pictureMenu").trigger();
  close("pictureMenu");
  EXPECT_EQ(table().currentIndex().row(), 2);
  EXPECT_EQ(curveShown().points.back().color, glm::dvec3(0.0, 0.0, 1.0));
  rightClick(at(-0.2));
  ASSERT_NE(menu("pictureMenu"), nullptr);
  entry("pictureMenu").trigger();
  close("pictureMenu");
  EXPECT_EQ(table().currentIndex().row(), 1);
  EXPECT_EQ(curveShown().points.back().color, glm::dvec3(1.0, 0.0, 0.0));
}

TEST_F(LabelPickWindow, aRightClickInTheListShowsOneLabelAloneAndUndoBringsTheOthersBack) {
  openMasks();
  ASSERT_TRUE(rest());
  const std::vector<double> before = scene().keep.weights;
  const auto rightClickRow = [this](int row) {
    const QRect cell = table().visualRect(table().model()->index(row, 0));
    rightClick(table().viewport()->mapTo(window.get(), cell.center()));
    return menu("labelMenu");
  };
  ASSERT_NE(rightClickRow(1), nullptr);
  EXPECT_EQ(table().currentIndex().row(), 1);
  ASSERT_EQ(menu("labelMenu")->actions().front()->text(), QStringLiteral("Show only this"));
  menu("labelMenu")->actions().front()->trigger();
  close("labelMenu");
  EXPECT_EQ(scene().keep.weights, (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(undo().undoText(), QStringLiteral("show only kidney"));
  undo().undo();
  EXPECT_EQ(scene().keep.weights, before);
}

TEST_F(LabelPickWindow, withoutASegmentationTheEntrySaysWhatToOpen) {
  ASSERT_TRUE(rest());
  rightClick(view().mapTo(window.get(), view().logicalRect(0).center().toPoint()));
  ASSERT_NE(menu("pictureMenu"), nullptr);
  EXPECT_FALSE(entry("pictureMenu").isEnabled());
  EXPECT_TRUE(entry("pictureMenu").toolTip().contains(QStringLiteral("Open labels")));
  close("pictureMenu");
}

TEST_F(LabelPickWindow, readingsNameTheLabelAndReadItsCurve) {
  openMasks();
  giveCurve(1, {1.0, 0.0, 0.0});
  Scene clear = scene();
  for (ControlPoint& point : clear.transferFunction.points)
    point.opacity *= 0.5;
  session().edit(clear, {nextGestureId(), QStringLiteral("half")});
  showSlices();
  session().setPlanes(withCrosshair(axial().content(), inKidney));
  // 300 lies at the end of the kidney's own curve.
  EXPECT_TRUE(axial().accessibleDescription().contains(QStringLiteral("kidney · opacity 0.9")))
      << axial().accessibleDescription().toStdString();
  session().setPlanes(withCrosshair(axial().content(), inAir));
  EXPECT_FALSE(axial().accessibleDescription().contains(QStringLiteral("opacity")));
  const QRectF place = view().logicalRect(0);
  const QPoint left =
      view().mapTo(window.get(), (place.center() - QPointF(0.2 * place.height(), 0.0)).toPoint());
  QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, Qt::ShiftModifier, left);
  ASSERT_TRUE(test::waitUntil([this] { return labelSays(QStringLiteral("· kidney · opacity")); }));
  const Overlay overlay = overlayOf({view().order(), view().pictureState()});
  ASSERT_TRUE(overlay.reading);
  EXPECT_TRUE(overlay.reading->text.contains(QStringLiteral("· kidney · opacity")))
      << overlay.reading->text.toStdString();
}

TEST_F(LabelPickWindow, aPointOfALabelsCurveLightsUpInThatLabelOfTheSlices) {
  openMasks();
  giveCurve(2, {0.0, 0.0, 1.0});
  showSlices();
  rightClick(inSlice(inSpleen));
  ASSERT_NE(menu("sliceMenu"), nullptr);
  entry("sliceMenu").trigger();
  close("sliceMenu");
  const TransferFunctionCanvas& plot = *curves().valueEditor()->canvas();
  const ControlPoint& point = plot.transferFunction().points[1]; // 300
  const QPoint at = plot.mapTo(window.get(), QPointF(xOfValue(plot.transform(), point.value),
                                                     yOfOpacity(plot.transform(), point.opacity)))
                        .toPoint();
  QTest::mouseMove(window->windowHandle(), at - QPoint(3, 0));
  QTest::mouseMove(window->windowHandle(), at);
  ASSERT_TRUE(test::waitUntil([this] { return axial().content().emphasisedPoint == 1u; }));
  const QColor spleen = sliceColor(inSpleen), kidney = sliceColor(inKidney);
  EXPECT_GT(spleen.green(), spleen.blue() + 40);
  EXPECT_EQ(kidney.green(), kidney.blue()) << "which has another curve";
}

TEST_F(LabelPickWindow, aFolderOfMasksThatIsDroppedBecomesTheLabels) {
  write<std::int16_t>("segmentations/ct.nii.gz", [](const glm::ivec3& v) { return v.x; });
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(pathTo("segmentations"))});
  QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(window.get(), &enter);
  QDropEvent event({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(window.get(), &event);
  ASSERT_TRUE(test::waitUntil([this] { return scene().keep.kind == Region::Kind::labels; }));
  EXPECT_EQ(scene().keep.source, (folder.path() / "segmentations").string());
  EXPECT_EQ(messages().sentence(), QStringLiteral("ct.nii.gz is no mask and was left out."));
  EXPECT_EQ(table().model()->rowCount(), 3);
  EXPECT_EQ(table().model()->index(1, 0).data().toString(), QStringLiteral("kidney"));
  EXPECT_EQ(undo().undoText(), QStringLiteral("open labels segmentations"));
  // A session comes back to it.
  giveCurve(1, {1.0, 0.0, 0.0});
  std::ofstream(folder.path() / "session.json") << sessionToJson(window->sessionDocument());
  undo().undo();
  undo().undo();
  ASSERT_TRUE(open(pathTo("session.json")));
  ASSERT_EQ(scene().keep.kind, Region::Kind::labels);
  EXPECT_EQ(scene().keep.labels->labels()[2].name, "spleen & co");
  EXPECT_EQ(lookOfLabel(scene().keep, 1), 1u);
}

TEST_F(LabelPickWindow, theMenuOpensAFolderOfMasksAndSaysWhatIsNone) {
  std::filesystem::create_directory(folder.path() / "images");
  write<std::int16_t>("images/ct.nii.gz", [](const glm::ivec3& v) { return v.x; });
  onceAsked<QFileDialog>([this](QFileDialog& dialog) {
    auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    ASSERT_NE(name, nullptr);
    EXPECT_TRUE(name->placeholderText().contains(QStringLiteral("files are not listed")));
    name->setText(pathTo("images"));
    QTest::keyClick(name, Qt::Key_Return);
  });
  window->findChild<QAction*>(QStringLiteral("openLabelFolder"))->trigger();
  ASSERT_TRUE(test::waitUntil([this] { return !messages().isHidden() && !regions().isBusy(); }));
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("no file in it is the mask of a structure")))
      << messages().sentence().toStdString();
  EXPECT_NE(scene().keep.kind, Region::Kind::labels);
  typeName(pathTo("segmentations"));
  window->findChild<QAction*>(QStringLiteral("openLabelFolder"))->trigger();
  ASSERT_TRUE(test::waitUntil([this] { return scene().keep.kind == Region::Kind::labels; }));
}

} // namespace
} // namespace limn
