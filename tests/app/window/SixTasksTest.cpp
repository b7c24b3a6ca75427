// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/files/figure/FigureDialog.h"
#include "app/files/figure/FigurePreview.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Phantom.h"
#include "support/DicomBuilder.h"
#include "widgets/FindWidget.h"
#include "widgets/PresetNames.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/view/panels/PictureStatus.h"

#include <QPushButton>
#include <QStatusBar>
#include <QTreeView>

#include <cmath>

// The six tasks that the window is judged by, each done by mouse and keys, and the gestures counted: a click,
// a drag, a key with its modifiers, a name typed with the Enter behind it. On Hounsfield units, and on values
// in another scale.

namespace limn {
namespace {

/// Values without a known scale: air near 40, bone beyond 300.
double otherScale(double hounsfield) {
  return 40.0 + 0.2 * std::max(0.0, hounsfield + 1000.0);
}

/// The phantom as a series of a patient, CT in Hounsfield units or MR in another scale.
void writeSeries(const std::filesystem::path& folder, bool isHounsfield, double spacingMm) {
  const auto volume = phantomVolume({.spacingMm = spacingMm});
  const Grid& grid = volume->grid();
  const auto& voxels = std::get<StoredVoxels<std::int16_t>>(volume->stored());
  const auto slice = static_cast<std::size_t>(grid.dims.x) * grid.dims.y;
  const std::string uid =
      "1.2.3." + std::to_string(static_cast<int>(100.0 * spacingMm)) + (isHounsfield ? ".1" : ".2");
  const auto place = [](const glm::dvec3& mm) {
    return std::to_string(mm.x) + "\\" + std::to_string(mm.y) + "\\" + std::to_string(mm.z);
  };
  for (int k = 0; k < grid.dims.z; ++k) {
    std::vector<std::uint16_t> pixels;
    for (std::size_t i = 0; i < slice; ++i) {
      const double value = voxels[k * slice + i];
      pixels.push_back(
          static_cast<std::uint16_t>(isHounsfield ? value + 1024.0 : std::lround(otherScale(value))));
    }
    test::DicomBuilder()
        .text(0x00080016, "UI", isHounsfield ? "1.2.840.10008.5.1.4.1.1.2" : "1.2.840.10008.5.1.4.1.1.4")
        .text(0x00080018, "UI", uid + "." + std::to_string(k + 1))
        .text(0x00080060, "CS", isHounsfield ? "CT" : "MR")
        .text(0x0020000D, "UI", uid + ".1000")
        .text(0x0020000E, "UI", uid + ".1001")
        .text(0x00200013, "IS", std::to_string(k + 1))
        .text(0x00200032, "DS", place(indexToWorld(grid, {0, 0, k})))
        .text(0x00200037, "DS", "1\\0\\0\\0\\1\\0")
        .text(0x00280004, "CS", "MONOCHROME2")
        .text(0x00280030, "DS", std::to_string(spacingMm) + "\\" + std::to_string(spacingMm))
        .text(0x00281052, "DS", isHounsfield ? "-1024" : "0")
        .text(0x00281053, "DS", "1")
        .us(0x00280002, {1})
        .us(0x00280010, {static_cast<std::uint16_t>(grid.dims.y)})
        .us(0x00280011, {static_cast<std::uint16_t>(grid.dims.x)})
        .us(0x00280100, {16})
        .us(0x00280101, {16})
        .us(0x00280102, {15})
        .us(0x00280103, {0})
        .pixels(pixels)
        .write(folder / ("slice" + std::to_string(k)));
  }
}

class SixTasks : public test::OpenGlWindow, public testing::WithParamInterface<bool> {
protected:
  void SetUp() override {
    OpenGlWindow::SetUp();
    window->resize(1280, 800);
    writeSeries(folder.path() / "first", GetParam(), 6.0);
    writeSeries(folder.path() / "next", GetParam(), 5.0);
  }

  void click(QWidget& widget, const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
    ++m_gestures;
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, modifiers, widget.mapTo(window.get(), at));
  }
  void click(QWidget& widget) { click(widget, widget.rect().center()); }
  void clickInDialog(QPushButton& button) {
    ++m_gestures;
    QTest::mouseClick(&button, Qt::LeftButton);
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    ++m_gestures;
    QTest::keyClick(window.get(), key, modifiers);
  }
  /// A name, and Enter, in the dialog for files that the next gesture opens.
  void typeNext(const char* name) {
    ++m_gestures;
    typeName(pathTo(name));
  }
  /// The gestures since the last call.
  int counted() { return std::exchange(m_gestures, 0); }

  [[nodiscard]] bool openByHand(const char* name) {
    const auto before = scene().volume;
    typeNext(name);
    press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
    return test::waitUntil([&] { return scene().volume && scene().volume != before; }) && rest();
  }

  // The value that lies where this one of Hounsfield's does.
  double valueOf(double hounsfield) const { return GetParam() ? hounsfield : otherScale(hounsfield); }
  double opacityAt(double hounsfield) const {
    return classify(scene().transferFunction, valueOf(hounsfield)).opacity;
  }

private:
  int m_gestures = 0;
};

TEST_P(SixTasks, aFolderBecomesAPictureByTwoGestures) {
  ASSERT_TRUE(openByHand("first"));
  EXPECT_LE(counted(), 3);
  EXPECT_EQ(looksLikeHounsfield(*scene().volume), GetParam());
}

TEST_P(SixTasks, boneByOneGesture) {
  ASSERT_TRUE(openByHand("first"));
  counted();
  PresetBrowser& browser = *window->findChild<PresetBrowser*>();
  QTreeView& list = *browser.findChild<QTreeView*>();
  const QRect row = rowOf(browser, QStringLiteral("CT bone"));
  ASSERT_TRUE(list.viewport()->rect().contains(row.center())) << "it is seen without scrolling";
  click(*list.viewport(), row.center());
  EXPECT_LE(counted(), 1);
  EXPECT_GT(opacityAt(1000.0), 0.5) << "bone shows";
  EXPECT_LT(opacityAt(50.0), 0.1 * opacityAt(1000.0)) << "and muscle hardly, or not at all";
}

TEST_P(SixTasks, aTissueIsMadeTransparentByTwo) {
  ASSERT_TRUE(openByHand("first"));
  counted();
  click(view(), QPoint(view().width() / 4, view().height() / 2), Qt::ShiftModifier);
  ASSERT_TRUE(test::waitUntil([&] { return curves().valueEditor()->canvas()->pinnedValue().has_value(); }));
  const double value = *curves().valueEditor()->canvas()->pinnedValue();
  const double before = classify(scene().transferFunction, value).opacity;
  ASSERT_GT(before, 0.0);
  click(*widgetNamed<QToolButton>(*curves().valueEditor(), "Less of the pinned tissue"));
  EXPECT_LE(counted(), 2);
  EXPECT_LE(classify(scene().transferFunction, value).opacity, 0.51 * before);
}

TEST_P(SixTasks, twoModelsAreComparedAndSavedWithALegendByFour) {
  setLayout(CompareLayout::single);
  ASSERT_TRUE(openByHand("first"));
  counted();
  QAction* sideBySide = window->findChild<QAction*>(QStringLiteral("layout-") +
                                                    QLatin1String(nameOf(CompareLayout::sideBySide)));
  ASSERT_NE(sideBySide, nullptr);
  for (QToolButton* button : window->findChild<QToolBar*>()->findChildren<QToolButton*>())
    if (button->defaultAction() == sideBySide)
      click(*button);
  ASSERT_EQ(view().compareLayout(), CompareLayout::sideBySide);
  ASSERT_TRUE(rest());
  press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(test::waitUntil([this] { return window->findChild<FigureDialog*>() != nullptr; }));
  auto& dialog = *window->findChild<FigureDialog*>();
  dialog.setExact(false); // how long it draws is not the question here
  typeNext("compared.png");
  auto& save = *dialog.findChild<QPushButton*>(QStringLiteral("figureSave"));
  clickInDialog(save);
  ASSERT_TRUE(test::waitUntil([&] { return !dialog.isWorking(); }));
  EXPECT_LE(counted(), 4);
  const Figure figure = dialog.askedFigure();
  EXPECT_EQ(figure.panels.size(), 2u);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "compared.png"));
}

TEST_P(SixTasks, theErrorOfThePictureIsThereWithoutAny) {
  window->resize(1280, 560);     // fewer pixels to refine
  view().setRefinesAtRest(true); // as people have it
  ASSERT_TRUE(openByHand("first"));
  counted();
  // What chance says of it, once the picture is as exact as it becomes.
  const auto says = [this] {
    for (const QWidget* part : window->statusBar()->findChildren<QWidget*>())
      for (const char* text : {"text", "accessibleName"})
        if (const QString said = part->property(text).toString();
            part->isVisible() && (said.contains(QStringLiteral("exact to the screen")) ||
                                  said.contains(QStringLiteral("nearly exact"))))
          return view().pictureState().sides[0].chance.has_value();
    return false;
  };
  EXPECT_TRUE(test::waitUntil(says)) << window->findChild<PictureStatus*>()->text().line().toStdString();
  EXPECT_EQ(counted(), 0);
}

TEST_P(SixTasks, theSameLookOnTheNextPatientByThree) {
  ASSERT_TRUE(openByHand("first"));
  PresetBrowser& browser = *window->findChild<PresetBrowser*>();
  click(*browser.findChild<QTreeView*>()->viewport(), rowOf(browser, QStringLiteral("CT bone")).center());
  session().setTransferFunction(withOpacityScaled(scene().transferFunction, 0.5),
                                {nextGestureId(), QStringLiteral("shaped by hand")});
  const TransferFunction shaped = scene().transferFunction;
  const double bone = opacityAt(1000.0);
  counted();
  ASSERT_TRUE(openByHand("next"));
  EXPECT_NE(scene().transferFunction, shaped) << "a look of its own at first";
  press(Qt::Key_L, Qt::ControlModifier);
  EXPECT_LE(counted(), 3);
  EXPECT_NEAR(opacityAt(1000.0), bone, 0.1) << "the phantom's sampling moves its quantiles";
  if (GetParam()) {
    EXPECT_EQ(scene().transferFunction, shaped);
  }
  undo().undo();
  EXPECT_EQ(undo().count(), 1) << "one step of the history";
}

INSTANTIATE_TEST_SUITE_P(, SixTasks, testing::Bool(), [](const auto& test) {
  return test.param ? std::string("inHounsfieldUnits") : std::string("inAnotherScale");
});

} // namespace
} // namespace limn
