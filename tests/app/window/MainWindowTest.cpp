// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/core/drawing/PictureMaker.h"
#include "support/Heart.h"
#include "widgets/presets/PresetBrowser.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QRegularExpression>

#include <fstream>

// The program's window with real mouse and key events.

namespace limn {
namespace {

using MainWindowTest = test::OpenGlWindow;

const QString phantom = QStringLiteral("phantom:4");

TEST_F(MainWindowTest, openingThePhantomShowsItAndItsSize) {
  ASSERT_TRUE(open(phantom));
  ASSERT_TRUE(rest());
  EXPECT_EQ(view().pictureState().sides.size(), 2u);
  EXPECT_TRUE(window->windowTitle().contains(QStringLiteral("not for diagnosis")));
  const glm::ivec3 dims = scene().volume->grid().dims;
  EXPECT_TRUE(labelSays(QStringLiteral("%1×%2×%3").arg(dims.x).arg(dims.y).arg(dims.z)));
  EXPECT_FALSE(isLoadingShown());
}

TEST_F(MainWindowTest, keysGoToThePictureUnderThePointerUnlessSomeoneTypes) {
  ASSERT_TRUE(open(phantom));
  ASSERT_TRUE(rest());
  QWindow* handle = window->windowHandle();
  const QPoint inView = view().mapTo(window.get(), view().rect().center());
  const auto enterFrom = [&](QWidget& field) {
    const QPoint outside = field.mapTo(window.get(), field.rect().center());
    QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, outside);
    field.setFocus();
    QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, inView);
    QCoreApplication::processEvents();
  };
  QComboBox* list = nullptr;
  for (QComboBox* one : window->findChildren<QComboBox*>())
    if (one->isVisible() && one->isEnabled())
      list = one;
  ASSERT_TRUE(list);
  enterFrom(*list);
  EXPECT_EQ(QApplication::focusWidget(), &view());
  QLineEdit* search = window->findChild<PresetBrowser*>()->findChild<QLineEdit*>();
  ASSERT_TRUE(search);
  enterFrom(*search);
  EXPECT_EQ(QApplication::focusWidget(), search);
}

TEST_F(MainWindowTest, draggingAPointIsOneUndoStepWithItsPictureAndCompilesNothing) {
  ASSERT_TRUE(open(phantom));
  ASSERT_TRUE(rest());
  const Scene before = scene();
  const auto picture = view().restingImage(0);
  ASSERT_TRUE(picture);
  ASSERT_TRUE(idle());
  const int programs = compiledPrograms();
  dragAPoint();
  EXPECT_EQ(compiledPrograms(), programs);
  EXPECT_NE(scene(), before);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_TRUE(undo().undoText().contains(QRegularExpression(QStringLiteral("(point|opacity at).*\\d"))))
      << undo().undoText().toStdString();
  ASSERT_TRUE(rest());
  EXPECT_FALSE(view().restingImage(0) == picture);
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene(), before);
  ASSERT_TRUE(rest());
  EXPECT_TRUE(view().restingImage(0) == picture);
}

TEST_F(MainWindowTest, enhancedWithEqualRangesShowsTheClassicPicture) {
  ASSERT_TRUE(open(phantom));
  Shading shading = scene().shading;
  // DEFINITION section 5: the ranges then give the exponent and the opacity factor of classic everywhere.
  shading.exponentRange = {shading.exponent, shading.exponent};
  shading.opacityRange = {1.0, 1.0};
  session().setShading(shading, {nextGestureId(), QStringLiteral("equal ranges")});
  ASSERT_TRUE(rest());
  ASSERT_EQ(view().sceneOfSide(0).shading.model, ShadingModel::classic);
  ASSERT_EQ(view().sceneOfSide(1).shading.model, ShadingModel::enhanced);
  EXPECT_TRUE(view().restingImage(0) == view().restingImage(1));
}

TEST_F(MainWindowTest, theRestingPictureIsThatOfTheSavedScene) {
  ASSERT_TRUE(open(phantom));
  ASSERT_TRUE(rest());
  const auto shown = view().restingImage(0);
  ASSERT_TRUE(shown);
  saving().writeScene(pathTo("scene.json"));
  LoadedScene saved = loadScene((folder.path() / "scene.json").string(), {}, {});
  saved.scene.shading.model = view().sceneOfSide(0).shading.model;
  canvas().doneCurrent(); // makes room for the command line's context
  const auto made = makePictures({saved.scene}, shown->size, Engine::rayCaster, 1);
  EXPECT_TRUE(made.front().image == *shown);
}

TEST_F(MainWindowTest, aFileThatCannotBeReadLeavesTheFormerVolume) {
  ASSERT_TRUE(open(phantom));
  const Scene before = scene();
  const QString title = window->windowTitle();
  ASSERT_TRUE(open(pathTo("missing.nii")));
  Scene shown = scene();
  shown.camera = before.camera; // the sentence takes room from the picture, which stays framed
  EXPECT_EQ(shown, before);
  EXPECT_TRUE(messages().isVisible());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("missing.nii")));
  EXPECT_FALSE(isLoadingShown());
  EXPECT_EQ(window->windowTitle(), title);
}

TEST_F(MainWindowTest, cancellingALoadLeavesTheFormerVolume) {
  ASSERT_TRUE(open(phantom));
  const Scene before = scene();
  window->openSource(QStringLiteral("phantom:1"));
  EXPECT_TRUE(isLoadingShown());
  QTest::mouseClick(window->findChild<QWidget*>(QStringLiteral("cancel")), Qt::LeftButton);
  EXPECT_FALSE(window->loader().isLoading());
  EXPECT_FALSE(isLoadingShown());
  ASSERT_TRUE(rest());
  EXPECT_EQ(scene().volume, before.volume);
}

TEST_F(MainWindowTest, aCancelledLoadLeavesNoTraceInTheTitle) {
  ASSERT_TRUE(open(phantom));
  const QString title = window->windowTitle();
  window->openSource(QStringLiteral("sample"));
  QTest::mouseClick(window->findChild<QWidget*>(QStringLiteral("cancel")), Qt::LeftButton);
  ASSERT_EQ(session().volumePath(), "phantom:4");
  QAction* patient = action(QStringLiteral("Show the patient's &name in the title bar"));
  ASSERT_NE(patient, nullptr);
  patient->trigger(); // writes the title anew
  EXPECT_EQ(window->windowTitle(), title);
}

TEST_F(MainWindowTest, refinementLeavesTheEventLoopFree) {
  ASSERT_TRUE(open(QStringLiteral("phantom:2")));
  ASSERT_TRUE(test::waitUntil([&] { return !view().pictureState().sides.empty(); }));
  ASSERT_FALSE(view().pictureState().resting);
  const test::Heart heart;
  ASSERT_TRUE(rest());
  // The bound of the view's own test: a turn aims at 30 ms of drawing.
  test::expectShortTurns(heart, "while the window draws a phantom", 250.0);
}

TEST_F(MainWindowTest, theCurvesAxisHasTheRangeOfTheVolumeThatIsOpenedLast) {
  ASSERT_TRUE(open(phantom));
  std::ofstream file(folder.path() / "small.nrrd", std::ios::binary);
  file << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 8 8 8\nspacings: 1 1 1\nencoding: raw\n\n";
  for (int i = 0; i < 512; ++i)
    file.put(static_cast<char>(i % 200));
  file.close();
  ASSERT_TRUE(open(pathTo("small.nrrd")));
  // The bins of 0 to 199, each one wide, and the margin of three hundredths at either side.
  const ValueRange visible = curves().valueEditor()->canvas()->transform().visible;
  EXPECT_NEAR(visible.lowest, -0.5 - 0.03 * 200.0, 1e-9);
  EXPECT_NEAR(visible.highest, 199.5 + 0.03 * 200.0, 1e-9);
}

TEST_F(MainWindowTest, openingASecondVolumeWhileOneLoadsShowsOnlyTheSecond) {
  QSignalSpy scenes(&session(), &Session::sceneChanged);
  window->openSource(QStringLiteral("phantom:2"));
  ASSERT_TRUE(open(phantom));
  EXPECT_EQ(session().volumePath(), "phantom:4");
  EXPECT_TRUE(rest());
  EXPECT_EQ(scenes.count(), 1);
  EXPECT_FALSE(isLoadingShown());
}

TEST_F(MainWindowTest, buttonsChooseLayouts) {
  ASSERT_TRUE(open(phantom));
  const std::pair<const char*, CompareLayout> layouts[] = {{"Single", CompareLayout::single},
                                                           {"Wipe", CompareLayout::wipe},
                                                           {"Difference", CompareLayout::difference},
                                                           {"Side by side", CompareLayout::sideBySide}};
  window->resize(1380, 640); // every button fits
  QCoreApplication::processEvents();
  for (const auto& [text, layout] : layouts) {
    clickTool(QString::fromLatin1(text));
    EXPECT_EQ(view().compareLayout(), layout) << text;
  }
  EXPECT_TRUE(rest());
}

} // namespace
} // namespace limn
