// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/RegionController.h"
#include "scene/LabelLooks.h"
#include "support/ShortVolume.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/ColorPicker.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/LabelSection.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/theme/Theme.h"

#include <QComboBox>
#include <QDockWidget>
#include <QScrollBar>
#include <QTreeView>

#include <fstream>
#include <utility>

// A segmentation comes into sight and a label gets its colour, by real events in the program's window.

namespace limn {
namespace {

constexpr int colouredSize = 32;

class LabelColorWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    // Two boxes side by side; the right one of the picture is a label.
    test::writeShorts(folder.path() / "two.nrrd", colouredSize,
                      [](const glm::ivec3& v) { return isInBoxes(v) ? 300 : -1000; });
    test::writeShorts(folder.path() / "label_Vessels.nrrd", colouredSize,
                      [](const glm::ivec3& v) { return isInBoxes(v) && v.x >= 16 ? 1 : 0; });
    writeRibs();
    ASSERT_TRUE(openAlone(pathTo("two.nrrd")));
  }

  static bool isInBoxes(const glm::ivec3& v) {
    return glm::all(glm::greaterThan(v, glm::ivec3(5))) && glm::all(glm::lessThan(v, glm::ivec3(26)));
  }

  // A label for each plane of voxels across x, with names as TotalSegmentator has them.
  void writeRibs() {
    std::ofstream file(folder.path() / "many.seg.nrrd", std::ios::binary);
    file << "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 32 32 32\n"
            "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n";
    for (int n = 0; n < colouredSize - 1; ++n)
      file << "Segment" << n << "_ID:=" << n << "\nSegment" << n << "_LabelValue:=" << n + 1 << "\nSegment"
           << n << "_Name:=" << (n < 24 ? "rib_" : "organ") << n << "\nSegment" << n << "_Color:=0.1 0.2 "
           << 0.2 + 0.02 * n << '\n';
    file << '\n';
    for (int voxel = 0; voxel < colouredSize * colouredSize * colouredSize; ++voxel)
      file.put(static_cast<char>(voxel % colouredSize));
  }

  void openLabels(const char* name) {
    auto& regions = *window->findChild<RegionController*>();
    regions.openLabels(pathTo(name));
    ASSERT_TRUE(test::waitUntil([&] { return !regions.isBusy(); }));
    ASSERT_EQ(scene().keep.kind, Region::Kind::labels);
    QCoreApplication::processEvents(); // it comes into sight once its rows have their place
  }

  LabelSection& section() { return *window->findChild<LabelSection*>(); }
  QTreeView& table() { return *section().findChild<QTreeView*>(); }
  PropertiesPanel& panel() { return *window->findChild<PropertiesPanel*>(); }
  QComboBox& whose() { return *widgetNamed<QComboBox>(curves(), "Whose curve"); }
  QModelIndex row(const char* name) {
    const QAbstractItemModel& model = *table().model();
    const QModelIndexList found = model.match(model.index(0, 0), Qt::DisplayRole, QString::fromLatin1(name),
                                              1, Qt::MatchExactly | Qt::MatchRecursive);
    return found.isEmpty() ? QModelIndex() : found.front();
  }
  static QColor squareOf(const QModelIndex& label) {
    const QImage square = label.data(Qt::DecorationRole).value<QPixmap>().toImage();
    return square.pixelColor(square.rect().center());
  }
  // The square before the name of the label in hand, in the title of the curve.
  QColor squareOfTitle() {
    const QImage square = whose().itemIcon(whose().currentIndex()).pixmap(12).toImage();
    return square.isNull() ? QColor() : square.pixelColor(square.rect().center());
  }

  void click(QWidget& widget, const QPoint& at) {
    ++m_gestures;
    QWidget* top = widget.window();
    QTest::mouseClick(top->windowHandle(), Qt::LeftButton, {}, widget.mapTo(top, at));
    QCoreApplication::processEvents();
  }
  void clickSquare(const QModelIndex& label) {
    ASSERT_TRUE(label.isValid());
    const QRect cell = table().visualRect(label);
    ASSERT_TRUE(table().viewport()->rect().contains(cell)) << "it is seen without scrolling";
    const auto place = placeOfColor(*table().viewport(), cell, squareOf(label));
    ASSERT_TRUE(place);
    click(*table().viewport(), *place);
  }
  // The red of vessels among the colours that the picker offers.
  void clickRed() {
    auto* picker = section().findChild<ColorPicker*>();
    ASSERT_TRUE(picker && test::waitUntilExposed(*picker->window()));
    const auto place = placeOfColor(*picker, {0, 148, picker->width(), 26}, red());
    ASSERT_TRUE(place);
    click(*picker, *place);
  }
  void closePicker() {
    if (auto* picker = section().findChild<ColorPicker*>())
      picker->window()->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  static QColor red() { return {0xd8, 0x26, 0x1c}; }
  /// The gestures since the last call.
  int counted() { return std::exchange(m_gestures, 0); }

  // How much redder than blue the picture is at a place right of its middle.
  int rednessAt(double share) {
    const QImage picture = view().grab().toImage();
    const QRectF place = view().logicalRect(0);
    const QColor color = picture.pixelColor(
        ((place.center() + QPointF(share * place.height(), 0.0)) * view().devicePixelRatioF()).toPoint());
    return color.red() - color.blue();
  }

private:
  int m_gestures = 0;
};

TEST_F(LabelColorWindow, theVesselsOfALabelAreRedByTwoClicks) {
  openLabels("label_Vessels.nrrd");
  ASSERT_TRUE(rest());
  const TransferFunction ofAll = scene().transferFunction;
  const int left = rednessAt(-0.2);
  const int steps = undo().count();
  counted();
  clickSquare(row("Vessels"));
  clickRed();
  EXPECT_LE(counted(), 3) << "as is asked for";
  ASSERT_EQ(lookOfLabel(scene().keep, 1), 1u);
  EXPECT_EQ(scene().keep.looks[0], inOneColor(ofAll, toSceneColor(red())));
  EXPECT_EQ(scene().transferFunction, ofAll);
  EXPECT_EQ(undo().count(), steps + 1);
  EXPECT_EQ(undo().undoText(), QStringLiteral("colour of Vessels"));
  EXPECT_EQ(squareOf(row("Vessels")), red());
  // Its curve is in hand.
  EXPECT_EQ(curves().valueEditor()->canvas()->transferFunction(), scene().keep.looks[0]);
  EXPECT_EQ(whose().currentText(), QStringLiteral("Vessels"));
  EXPECT_EQ(squareOfTitle(), red());
  closePicker();
  ASSERT_TRUE(rest());
  // The patient's left, where x is large, is at the right of the picture.
  EXPECT_GT(rednessAt(0.2), 80);
  EXPECT_NEAR(rednessAt(-0.2), left, 12) << "the rest stays, but for its own light and shadow";
  undo().undo();
  EXPECT_EQ(lookOfLabel(scene().keep, 1), 0u);
}

TEST_F(LabelColorWindow, escInThePickerLeavesNoStep) {
  openLabels("label_Vessels.nrrd");
  const Region before = scene().keep;
  const int steps = undo().count();
  clickSquare(row("Vessels"));
  clickRed();
  ASSERT_NE(scene().keep, before);
  auto* picker = section().findChild<ColorPicker*>();
  ASSERT_NE(picker, nullptr);
  QTest::keyClick(picker->window()->windowHandle(), Qt::Key_Escape);
  EXPECT_EQ(scene().keep, before);
  EXPECT_EQ(undo().count(), steps);
  EXPECT_FALSE(whose().isVisible());
}

TEST_F(LabelColorWindow, theSquareOfTheTitleFollowsWhatTheCurveShows) {
  openLabels("label_Vessels.nrrd");
  clickSquare(row("Vessels"));
  clickRed();
  closePicker();
  ASSERT_EQ(squareOfTitle(), red());
  emit window->findChild<PresetBrowser*>()->presetChosen(QStringLiteral("CT bone"));
  ASSERT_EQ(lookOfLabel(scene().keep, 1), 1u);
  EXPECT_NE(squareOfTitle(), red());
  EXPECT_EQ(squareOfTitle(), squareOf(row("Vessels"))) << "as in the list, and in the picture";
  // A colour keeps the opacities of the preset.
  const TransferFunction bone = scene().keep.looks[0];
  clickSquare(row("Vessels"));
  clickRed();
  closePicker();
  EXPECT_EQ(scene().keep.looks[0], inOneColor(bone, toSceneColor(red())));
  EXPECT_EQ(squareOfTitle(), red());
  undo().undo();
  EXPECT_EQ(squareOfTitle(), squareOf(row("Vessels")));
  EXPECT_NE(squareOfTitle(), red());
}

TEST_F(LabelColorWindow, aSegmentationComesIntoSightAndLeavesTheKeyboardInThePicture) {
  // Behind another panel, scrolled to its top, and folded.
  window->resize(1280, 640);
  window->findChild<QDockWidget*>(QStringLiteral("effectsDock"))->raise();
  section().setFolded(true);
  view().setFocus();
  QCoreApplication::processEvents();
  QWidget* const keyboard = QApplication::focusWidget();
  ASSERT_TRUE(keyboard && (keyboard == &view() || view().isAncestorOf(keyboard)));
  ASSERT_FALSE(panel().isVisible());
  openLabels("many.seg.nrrd");
  EXPECT_TRUE(panel().isVisible());
  EXPECT_FALSE(section().isFolded());
  const QScrollBar& bar = *panel().verticalScrollBar();
  const int top = section().mapTo(panel().viewport(), QPoint()).y();
  ASSERT_GT(bar.maximum(), bar.minimum()) << "there is something to scroll";
  EXPECT_TRUE(top == 0 || bar.value() == bar.maximum()) << top;
  EXPECT_GT(bar.value(), 0);
  EXPECT_GE(top, 0);
  EXPECT_LE(top + section().height(), panel().viewport()->height()) << "whole";
  EXPECT_EQ(QApplication::focusWidget(), keyboard);
  // What is done with it scrolls nothing.
  panel().verticalScrollBar()->setValue(0);
  Region hidden = scene().keep;
  hidden.weights[3] = 0.0;
  session().setKeep(hidden, {nextGestureId(), QStringLiteral("hide")});
  QCoreApplication::processEvents();
  EXPECT_EQ(bar.value(), 0);
}

TEST_F(LabelColorWindow, panelsThatAreFoldedAwayStaySo) {
  window->findChild<QAction*>(QStringLiteral("panels-right"))->trigger();
  QCoreApplication::processEvents();
  ASSERT_FALSE(panel().isVisible());
  openLabels("label_Vessels.nrrd");
  EXPECT_FALSE(panel().isVisible());
}

TEST_F(LabelColorWindow, aGroupOpensByItsArrowIsHiddenByItsMarkAndOneOfItIsRedByThreeClicks) {
  openLabels("many.seg.nrrd");
  const QModelIndex ribs = row("rib (24)");
  ASSERT_TRUE(ribs.isValid());
  EXPECT_EQ(table().model()->rowCount(), 1 + 7 + 1) << "the background, the organs, and the ribs as one";
  const QRect cell = table().visualRect(ribs);
  counted();
  click(*table().viewport(), {cell.left() - table().indentation() / 2, cell.center().y()});
  ASSERT_TRUE(table().isExpanded(ribs));
  clickSquare(table().model()->index(1, 0, ribs));
  clickRed();
  EXPECT_LE(counted(), 3);
  closePicker();
  EXPECT_EQ(undo().undoText(), QStringLiteral("colour of rib_1"));
  const int steps = undo().count();
  click(*table().viewport(), {cell.left() + 12, cell.center().y()});
  EXPECT_EQ(undo().count(), steps + 1);
  EXPECT_EQ(undo().undoText(), QStringLiteral("hide rib"));
  for (std::size_t place = 0; place < static_cast<std::size_t>(colouredSize); ++place)
    EXPECT_EQ(scene().keep.weights[place], place >= 1 && place <= 24 ? 0.0 : 1.0) << place;
  click(*table().viewport(), {cell.left() + 12, cell.center().y()});
  EXPECT_EQ(undo().undoText(), QStringLiteral("show rib"));
}

} // namespace
} // namespace limn
