// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/core/sources/BuiltInPresets.h"
#include "app/figures/FigureMaker.h"
#include "app/figures/FigureOptions.h"
#include "app/files/figure/FigureDialog.h"
#include "app/files/figure/FigurePreview.h"
#include "app/files/figure/PanelList.h"
#include "app/panels/presets/PresetController.h"
#include "app/picture/ComparisonController.h"
#include "app/presets/PresetStore.h"
#include "io/ImageFile.h"
#include "widgets/controls/DialogRoom.h"
#include "widgets/figure/FigureText.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/overlay/OrientationMarks.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QProgressBar>
#include <QPushButton>
#include <QStyleOptionComboBox>

#include <algorithm>
#include <array>
#include <set>

// Figures, put together and saved in the program's window.

namespace limn {
namespace {

namespace fs = std::filesystem;

class FigureWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    ASSERT_TRUE(open(QStringLiteral("phantom:6")));
    ASSERT_TRUE(rest());
  }

  FigureDialog& dialog() const { return *window->findChild<FigureDialog*>(); }

  template <class Part>
  Part& part(const char* name) const {
    return *dialog().findChild<Part*>(QLatin1String(name));
  }

  void click(const char* name) const { QTest::mouseClick(&part<QPushButton>(name), Qt::LeftButton); }
  void check(const char* name) const {
    auto& box = part<QCheckBox>(name);
    QTest::mouseClick(&box, Qt::LeftButton, {}, QPoint(8, box.height() / 2));
  }

  /// Asks by the keyboard and waits until the preview shows its pictures.
  [[nodiscard]] bool ask() {
    QTest::keyClick(window.get(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    return test::waitUntil([this] { return window->findChild<FigureDialog*>() && isPreviewed(); });
  }

  bool isPreviewed() const {
    const std::optional<Figure> shown = dialog().preview().asShown();
    if (!shown)
      return false;
    const QSize size = figureLayout(*shown).pictureSize();
    const std::vector<QImage>& pictures = dialog().preview().pictures();
    return pictures.size() == shown->panels.size() &&
           std::ranges::all_of(pictures, [&](const QImage& picture) { return picture.size() == size; });
  }

  /// As large on paper, in a ninth of the pixels: what a test saves takes a moment.
  void makeCoarse() {
    auto& dots = part<QDoubleSpinBox>("figureDots");
    dots.setFocus();
    dots.selectAll();
    QTest::keyClicks(&dots, QStringLiteral("100\t"));
    ASSERT_EQ(dialog().askedFigure().settings.dotsPerInch, 100.0);
  }

  QString said() const { return part<QLabel>("figureSays").text(); }

  /// Saves as this file and waits until that is said.
  [[nodiscard]] bool saveAs(const char* name) {
    typeName(pathTo(name));
    click("figureSave");
    return test::waitUntil([this] { return !dialog().isWorking(); });
  }
};

TEST_F(FigureWindow, isNotDrawnForAPlaceThatTakesNoFile) {
  ASSERT_TRUE(ask());
  ASSERT_TRUE(saveAs("none/figure.png"));
  EXPECT_TRUE(said().contains(QStringLiteral("there is no folder"))) << said().toStdString();
  EXPECT_EQ(dialog().findChild<QProgressBar*>()->value(), 0) << "nothing was drawn";
}

TEST_F(FigureWindow, aFigureOfTheComparisonIsSavedAndOpensAsTheComparison) {
  setLayout(CompareLayout::sideBySide);
  ASSERT_TRUE(rest());
  ASSERT_TRUE(ask());
  EXPECT_EQ(dialog().askedFigure().panels.size(), 2u);
  check("figureExact"); // the window's own steps
  makeCoarse();
  EXPECT_FALSE(dialog().isExact());
  const std::vector<Scene> shown = view().scenesOfSides();
  ASSERT_TRUE(saveAs("figure.png"));
  EXPECT_TRUE(said().contains(QStringLiteral("Saved figure.png."))) << said().toStdString();
  const auto loaded = loadFigure((folder.path() / "figure.png").string(), {}, {});
  ASSERT_TRUE(loaded);
  ASSERT_EQ(loaded->panels.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    Scene scene = loaded->panels[i].scene.scene;
    scene.volume = shown[i].volume; // read again
    scene.image = shown[i].image;   // the panel's size
    EXPECT_EQ(scene, shown[i]);
  }
  click("figureClose");
  setLayout(CompareLayout::single);
  ASSERT_TRUE(open(QStringLiteral("phantom:16")));
  ASSERT_TRUE(open(pathTo("figure.png")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide);
  const std::vector<Scene> again = view().scenesOfSides();
  ASSERT_EQ(again.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again[i].shading, shown[i].shading);
    EXPECT_EQ(again[i].transferFunction, shown[i].transferFunction);
  }
}

TEST_F(FigureWindow, itsButtonsAreReachedOnASmallScreen) {
  ASSERT_TRUE(ask());
  fitInto(dialog(), {0, 0, 800, 560});
  EXPECT_LE(dialog().width(), 800);
  EXPECT_LE(dialog().height(), 560);
  const auto& save = part<QPushButton>("figureSave");
  EXPECT_TRUE(test::waitUntil(
      [&] { return dialog().rect().contains(QRect(save.mapTo(&dialog(), QPoint()), save.size())); }));
}

TEST_F(FigureWindow, theListOfPicturesHasRoomForTheNamesOfPresets) {
  ASSERT_TRUE(ask());
  const auto& list = part<QComboBox>("panelSource-a");
  QStyleOptionComboBox option;
  option.initFrom(&list);
  option.editable = false;
  const QRect field =
      list.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &list);
  const QString longName = QStringLiteral("Compared: CT soft tissue");
  EXPECT_GE(field.width(), list.fontMetrics().horizontalAdvance(longName));
  EXPECT_EQ(list.toolTip(), list.currentText());
  const auto& name = part<QLineEdit>("panelName-a");
  const QString ownName = QStringLiteral("Ivory veil · Enhanced");
  EXPECT_GE(name.width() - 18, name.fontMetrics().horizontalAdvance(ownName)) << "with its edge and margins";
}

TEST_F(FigureWindow, theScaleHoldsWhereThatOfTheWindowDoes) {
  ASSERT_EQ(scene().camera.projection, Camera::Projection::perspective);
  const glm::dvec3 target = scene().camera.target;
  const glm::dvec3 nearer = target - 40.0 * basisOf(scene().camera).forward;
  view().setTurnsAbout(nearer);
  ASSERT_TRUE(ask());
  check("figureExact");
  makeCoarse();
  const double onScreen = mmPerPixel(scene().camera, 200.0, nearer);
  // Rounding: sums of hundreds of millimetres, in double precision.
  const auto expectItsScale = [&](const FigurePanel& panel, const char* where) {
    EXPECT_NEAR(mmPerPixelOf(panel, {200, 200}), onScreen, 1e-9 * onScreen) << where;
    EXPECT_EQ(panel.scene.camera.position, scene().camera.position) << where;
    EXPECT_NEAR(glm::dot(basisOf(panel.scene.camera).forward, basisOf(scene().camera).forward), 1.0, 1e-12)
        << where;
  };
  ASSERT_LT(onScreen, 0.95 * mmPerPixel(scene().camera, 200.0)) << "which is not that of the middle";
  for (const FigurePanel& panel : dialog().askedFigure().panels)
    expectItsScale(panel, "in the preview");
  EXPECT_EQ(dialog().askedFigure().panels.size(), view().scenesOfSides().size()) << "what is on screen";
  ASSERT_TRUE(saveAs("turned.png"));
  const auto loaded = loadFigure((folder.path() / "turned.png").string(), {}, {});
  ASSERT_TRUE(loaded);
  for (const auto& read : loaded->panels) {
    FigurePanel again;
    again.scene = read.scene.scene;
    expectItsScale(again, "drawn anew from the file");
  }
}

TEST_F(FigureWindow, whatWasSavedStaysSaidUntilAnEditAndTheKeyboardReturns) {
  ASSERT_TRUE(ask());
  check("figureExact");
  makeCoarse();
  ASSERT_TRUE(saveAs("figure.png"));
  EXPECT_TRUE(part<QPushButton>("figureSave").hasFocus());
  dialog().resize(dialog().size() + QSize(40, 30)); // the preview is drawn anew
  QCoreApplication::processEvents();
  ASSERT_TRUE(test::waitUntil([this] { return isPreviewed(); }));
  EXPECT_TRUE(said().startsWith(QStringLiteral("Saved figure.png."))) << said().toStdString();
  EXPECT_TRUE(said().contains(QStringLiteral("pixels"))) << said().toStdString();
  check("figureMark-curve");
  EXPECT_FALSE(said().contains(QStringLiteral("Saved"))) << said().toStdString();
}

TEST_F(FigureWindow, aViewThatWasKeptCanStandInAPanel) {
  const Camera side = standardView(scene().camera, scene().volume->grid(), StandardView::left);
  session().setViews({{"the ear", side}, {std::string(500, 'x'), side}}, QStringLiteral("keep"));
  ASSERT_TRUE(ask());
  check("figureExact");
  auto& source = part<QComboBox>("panelSource-b");
  const int chosen = source.findText(QStringLiteral("View: the ear"));
  ASSERT_GE(chosen, 0);
  source.setFocus();
  QTest::keyClick(&source, Qt::Key_Home);
  for (int step = 0; step < chosen; ++step)
    QTest::keyClick(&source, Qt::Key_Down);
  ASSERT_TRUE(test::waitUntil([this] { return isPreviewed(); }));
  ASSERT_EQ(dialog().askedFigure().panels.size(), 2u);
  EXPECT_EQ(dialog().askedFigure().panels[1].scene.camera, side);
  EXPECT_EQ(dialog().askedFigure().panels[1].name, QStringLiteral("the ear"));
  EXPECT_NE(dialog().askedFigure().panels[0].scene.camera, side);
  QTest::keyClick(&source, Qt::Key_Down); // with a name of 500 letters
  ASSERT_TRUE(test::waitUntil([this] { return isPreviewed(); }));
  EXPECT_LE(dialog().width(), 1200);
}

// Four pictures of a head without a view that was kept for each.
TEST_F(FigureWindow, theSidesFromWhichRadiologistsLookAreOfferedInOneScale) {
  ASSERT_TRUE(ask());
  check("figureExact");
  auto& source = part<QComboBox>("panelSource-a");
  const Camera shown = scene().camera;
  for (const auto& [name, view] : {std::pair{"Anterior", StandardView::anterior},
                                   {"Left", StandardView::left},
                                   {"Posterior", StandardView::posterior},
                                   {"Superior", StandardView::superior}}) {
    const int chosen = source.findText(QStringLiteral("View: ") + QLatin1String(name));
    ASSERT_GE(chosen, 0) << name;
    source.setFocus();
    QTest::keyClick(&source, Qt::Key_Home);
    for (int step = 0; step < chosen; ++step)
      QTest::keyClick(&source, Qt::Key_Down);
    ASSERT_TRUE(test::waitUntil([this] { return isPreviewed(); }));
    const FigurePanel panel = dialog().askedFigure().panels[0];
    EXPECT_EQ(panel.name, QLatin1String(name));
    const CameraBasis basis = basisOf(panel.scene.camera);
    const CameraBasis wanted = basisOf(standardView(shown, scene().volume->grid(), view));
    EXPECT_GT(glm::dot(basis.forward, wanted.forward), 1.0 - 1e-12) << name; // rounding of one rotation
    EXPECT_GT(glm::dot(basis.up, wanted.up), 1.0 - 1e-12) << name;
    EXPECT_NEAR(mmPerPixel(panel.scene.camera, 200.0, panel.scene.camera.target),
                mmPerPixel(shown, 200.0, shown.target), 1e-9)
        << name;
  }
}

TEST_F(FigureWindow, aLookThatIsRememberedStandsBesideWhatBecameOfIt) {
  setLayout(CompareLayout::single);
  window->findChild<QAction*>(QStringLiteral("takeSnapshot"))->trigger();
  const TransferFunction before = scene().transferFunction;
  session().setTransferFunction(shifted(before, 100.0), {nextGestureId(), QStringLiteral("test")});
  ASSERT_TRUE(rest());
  ASSERT_TRUE(ask());
  auto& choice = part<QComboBox>("panelSource-a");
  const int remembered = choice.findText(QStringLiteral("Remembered: Before"));
  ASSERT_GE(remembered, 0);
  choice.setFocus();
  while (choice.currentIndex() != remembered && choice.currentIndex() + 1 < choice.count())
    QTest::keyClick(&choice, Qt::Key_Down);
  ASSERT_EQ(dialog().askedFigure().panels.size(), 1u);
  EXPECT_EQ(dialog().askedFigure().panels[0].scene.transferFunction, before);
  EXPECT_EQ(dialog().askedFigure().panels[0].name, QStringLiteral("Before"));
  click("figureClose");
  window->findChild<QAction*>(QStringLiteral("compareSnapshot"))->trigger();
  ASSERT_TRUE(rest());
  window->findChild<QAction*>(QStringLiteral("saveFigure"))
      ->trigger(); // without a window manager no key gets there
  ASSERT_TRUE(test::waitUntil([this] { return isPreviewed(); }));
  const Figure compared = dialog().askedFigure();
  ASSERT_EQ(compared.panels.size(), 2u);
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_EQ(compared.panels[side].scene.transferFunction, view().scenesOfSides()[side].transferFunction);
    EXPECT_EQ(compared.panels[side].name,
              side == 0 ? QStringLiteral("CT bone and veil") : QStringLiteral("CT bone and veil, modified"));
  }
}

TEST_F(FigureWindow, aPresetThatIsFittedToTheVolumeSaysSoInItsName) {
  Preset mine;
  mine.name = "mylook";
  mine.modality = "MR";
  mine.landmarks = Landmarks{0.0, 20000.0, 90000.0};
  mine.transferFunction = {1.0, {{0.0, glm::dvec3(0.5), 0.0}, {90000.0, glm::dvec3(1.0), 1.0}}};
  PresetStore(UserFolders::below(folder.path()).presets).save(mine);
  window->findChild<PresetController*>()->refresh();
  ASSERT_TRUE(ask());
  auto& choice = part<QComboBox>("panelSource-a");
  const int fitted = choice.findText(QStringLiteral("Preset: mylook, fitted"));
  ASSERT_GE(fitted, 0);
  choice.setFocus();
  while (choice.currentIndex() != fitted && choice.currentIndex() + 1 < choice.count())
    QTest::keyClick(&choice, Qt::Key_Down);
  EXPECT_EQ(dialog().askedFigure().panels[0].name, QStringLiteral("mylook, fitted"));
}

TEST_F(FigureWindow, twoPresetsWithAModelEachAreNamedByBothAsOnScreen) {
  const std::vector<Preset> presets = builtInPresets();
  const auto named = [&](const char* name) {
    return *std::ranges::find(presets, std::string(name), &Preset::name);
  };
  setLayout(CompareLayout::sideBySide);
  session().usePreset(named("CT bone"), {nextGestureId(), "preset"});
  window->findChild<ComparisonController*>()->compareWith(named("CT skin"));
  window->findChild<QAction*>(QStringLiteral("model-left-classic"))->trigger();
  window->findChild<QAction*>(QStringLiteral("model-right-enhanced"))->trigger();
  ASSERT_TRUE(rest());
  ASSERT_TRUE(ask());
  const Figure figure = dialog().askedFigure();
  ASSERT_EQ(figure.panels.size(), 2u);
  EXPECT_EQ(figure.panels[0].name, QStringLiteral("CT skin · Classic"));
  EXPECT_EQ(figure.panels[1].name, QStringLiteral("CT bone · Enhanced"));
  for (std::size_t side = 0; side < 2; ++side)
    EXPECT_EQ(figure.panels[side].scene.shading.model, view().scenesOfSides()[side].shading.model);
}

TEST_F(FigureWindow, pdfTiffAndExrAreWrittenByTheirEndings) {
  ASSERT_TRUE(ask());
  check("figureExact");
  makeCoarse();
  for (const char* name : {"figure.pdf", "figure.tif", "figure.exr"}) {
    ASSERT_TRUE(saveAs(name));
    EXPECT_TRUE(fs::exists(folder.path() / name)) << said().toStdString();
    EXPECT_TRUE(loadFigure((folder.path() / name).string(), {}, {})) << name;
  }
  ASSERT_TRUE(saveAs("figure.bmp"));
  EXPECT_TRUE(said().contains(QStringLiteral(".png, .tif, .exr or .pdf"))) << said().toStdString();
}

TEST_F(FigureWindow, slicesBesideOnePictureAreOfferedAsFourPanels) {
  setLayout(CompareLayout::single);
  window->findChild<QAction*>(QStringLiteral("planes-picture_and_three"))->trigger();
  ASSERT_TRUE(rest());
  ASSERT_TRUE(ask());
  const Figure figure = dialog().askedFigure();
  ASSERT_EQ(figure.panels.size(), 4u);
  EXPECT_FALSE(figure.panels[0].plane);
  EXPECT_EQ(figure.panels[1].plane, PatientPlane::axial);
  EXPECT_EQ(figure.panels[3].plane, PatientPlane::sagittal);
}

TEST_F(FigureWindow, panelsAreChosenNamedAndCountedByKeyboard) {
  setLayout(CompareLayout::single);
  ASSERT_TRUE(ask());
  ASSERT_EQ(dialog().askedFigure().panels.size(), 1u);
  auto& count = part<QComboBox>("panelCount");
  count.setFocus();
  QTest::keyClick(&count, Qt::Key_Down);
  ASSERT_EQ(dialog().askedFigure().panels.size(), 2u);
  auto& source = part<QComboBox>("panelSource-b");
  source.setFocus();
  for (int step = 0; step < source.count() && source.currentText() != QStringLiteral("Slice: Coronal");
       ++step)
    QTest::keyClick(&source, Qt::Key_Down);
  ASSERT_EQ(dialog().askedFigure().panels[1].plane, PatientPlane::coronal);
  auto& name = part<QLineEdit>("panelName-b");
  EXPECT_EQ(name.text(), QStringLiteral("Coronal"));
  name.selectAll();
  QTest::keyClicks(&name, QStringLiteral("Through the teeth"));
  EXPECT_EQ(dialog().askedFigure().panels[1].name, QStringLiteral("Through the teeth"));
  ASSERT_TRUE(test::waitUntil([this] { return isPreviewed(); }));
  EXPECT_EQ(undo().count(), 0) << "a figure is no edit";
}

TEST_F(FigureWindow, aFigureOfMoreThanTheWindowShowsIsSeenWholeByOneClick) {
  setLayout(CompareLayout::sideBySide);
  ASSERT_TRUE(rest());
  ASSERT_TRUE(ask());
  check("figureExact");
  makeCoarse();
  auto& count = part<QComboBox>("panelCount");
  count.setFocus();
  QTest::keyClick(&count, Qt::Key_Down);
  const auto chooseFor = [this](const char* list, const QString& text) {
    auto& source = part<QComboBox>(list);
    source.setFocus();
    QTest::keyClick(&source, Qt::Key_Home);
    for (int step = 0; step < source.count() && source.currentText() != text; ++step)
      QTest::keyClick(&source, Qt::Key_Down);
  };
  chooseFor("panelSource-c", QStringLiteral("Preset: CT skin"));
  auto& name = part<QLineEdit>("panelName-c");
  name.selectAll();
  QTest::keyClicks(&name, QStringLiteral("The face"));
  const Figure asked = dialog().askedFigure();
  ASSERT_EQ(asked.panels.size(), 3u);
  ASSERT_TRUE(saveAs("three.png"));
  click("figureClose");
  ASSERT_TRUE(open(QStringLiteral("phantom:16")));
  ASSERT_TRUE(open(pathTo("three.png")));
  EXPECT_EQ(messages().sentence(), QStringLiteral("The figure has 3 panels, of which the window shows 2."));
  const auto buttons = messages().findChildren<QToolButton*>();
  const auto show = std::ranges::find(buttons, QStringLiteral("Show the figure"), &QToolButton::text);
  ASSERT_NE(show, buttons.end());
  QTest::mouseClick(*show, Qt::LeftButton);
  EXPECT_FALSE(messages().sentence().contains(QStringLiteral("The figure has")) && messages().isVisible());
  ASSERT_TRUE(test::waitUntil([&] { return dialog().askedFigure().panels.size() == 3; }));
  const Figure again = dialog().askedFigure();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.panels[i].name, asked.panels[i].name);
    EXPECT_EQ(again.panels[i].scene.transferFunction, asked.panels[i].scene.transferFunction);
    EXPECT_EQ(again.panels[i].scene.shading, asked.panels[i].scene.shading);
    EXPECT_EQ(again.panels[i].scene.volume, scene().volume) << "it is not read once more";
  }
  EXPECT_EQ(again.settings.panelAspect, asked.settings.panelAspect);
  ASSERT_TRUE(test::waitUntil([this] { return isPreviewed(); }));
  session().setIsovalue(scene().isovalue + 1.0, {nextGestureId(), "other"}); // what is open goes on
  EXPECT_EQ(dialog().askedFigure().panels, again.panels);
}

// A dialog that is closed is kept for the next time, with nothing in it.
TEST_F(FigureWindow, aClosedDialogHoldsNoVolume) {
  ASSERT_TRUE(ask());
  click("figureClose");
  const std::weak_ptr<const Volume> before = scene().volume;
  ASSERT_TRUE(open(QStringLiteral("phantom:16")));
  EXPECT_TRUE(test::waitUntil([&] { return before.expired(); })) << "somebody holds it";
  window->findChild<QAction*>(QStringLiteral("saveFigure"))->trigger();
  ASSERT_TRUE(test::waitUntil([this] { return isPreviewed(); }));
  EXPECT_EQ(dialog().askedFigure().panels.front().scene.volume, scene().volume);
}

TEST_F(FigureWindow, panelsThatAreAddedShowWhatNoOtherDoes) {
  ASSERT_TRUE(ask());
  ASSERT_EQ(dialog().askedFigure().panels.size(), 2u);
  auto& count = part<QComboBox>("panelCount");
  count.setFocus();
  QTest::keyClick(&count, Qt::Key_End);
  std::set<QString> names;
  for (const FigurePanel& panel : dialog().askedFigure().panels)
    names.insert(panel.name);
  EXPECT_EQ(names.size(), 4u);
}

TEST_F(FigureWindow, marksAndPageAreRememberedForTheNextFigure) {
  ASSERT_TRUE(ask());
  check("figureMark-curve");
  auto& page = part<QComboBox>("figurePage");
  page.setFocus();
  QTest::keyClick(&page, Qt::Key_Down);
  EXPECT_FALSE(dialog().askedFigure().settings.shows(FigureMark::curve));
  const FigureSettings remembered = Settings(UserFolders::below(folder.path()).settings).figure();
  EXPECT_FALSE(remembered.shows(FigureMark::curve));
  EXPECT_EQ(remembered.page, FigureSettings::Page::black);
}

TEST_F(FigureWindow, theSizeIsSaidBeforeAndRefusedWhereThereIsNoMemory) {
  ASSERT_TRUE(ask());
  auto& width = part<QDoubleSpinBox>("figureWidth");
  const auto type = [&](const QString& text) {
    width.setFocus();
    width.selectAll();
    QTest::keyClicks(&width, text + QStringLiteral("\t"));
  };
  type(QStringLiteral("10"));
  EXPECT_TRUE(said().contains(QStringLiteral("1181 × "))) << said().toStdString(); // 10 / 2.54 · 300
  EXPECT_TRUE(part<QPushButton>("figureSave").isEnabled());
  type(QStringLiteral("2000"));
  EXPECT_TRUE(said().contains(QStringLiteral("pixels wide"))) << said().toStdString();
  EXPECT_FALSE(part<QPushButton>("figureSave").isEnabled());
  type(QStringLiteral("170")); // 20,079 pixels
  EXPECT_TRUE(said().contains(QStringLiteral("20079 × "))) << said().toStdString();
  EXPECT_TRUE(said().contains(QStringLiteral("of memory while it is made"))) << said().toStdString();
}

TEST_F(FigureWindow, itIsCopiedInFullSize) {
  ASSERT_TRUE(ask());
  check("figureExact");
  auto& width = part<QDoubleSpinBox>("figureWidth");
  width.setFocus();
  width.selectAll();
  QTest::keyClicks(&width, QStringLiteral("5\t"));
  click("figureCopy");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  EXPECT_EQ(QApplication::clipboard()->image().width(), 591) << "5 / 2.54 · 300";
}

TEST_F(FigureWindow, thePreviewAndTheSavingSayHowFarTheyAre) {
  QTest::keyClick(window.get(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  FigurePreview& preview = dialog().preview();
  ASSERT_TRUE(preview.pictures().empty());
  EXPECT_TRUE(preview.awaiting().startsWith(QStringLiteral("Drawing the preview")));
  EXPECT_EQ(preview.accessibleDescription(), preview.awaiting());
  const QImage waiting = preview.grab().toImage();
  preview.setAwaiting({});
  EXPECT_NE(preview.grab().toImage(), waiting) << "the words stand where the picture will";
  ASSERT_TRUE(test::waitUntil([this] { return isPreviewed(); }));
  EXPECT_TRUE(preview.awaiting().isEmpty());
  typeName(pathTo("figure.png"));
  click("figureSave");
  ASSERT_TRUE(dialog().isWorking());
  EXPECT_TRUE(said().startsWith(QStringLiteral("Drawing the figure: 0 %"))) << said().toStdString();
  QTest::keyClick(&dialog(), Qt::Key_Escape);
}

TEST_F(FigureWindow, nothingMovesWhileItIsDrawn) {
  ASSERT_TRUE(ask());
  const auto places = [this] {
    QCoreApplication::processEvents();
    return std::array{dialog().preview().geometry(), part<QPushButton>("figureCopy").geometry(),
                      part<QPushButton>("figureClose").geometry()};
  };
  const auto before = places();
  typeName(pathTo("figure.png"));
  click("figureSave");
  ASSERT_TRUE(dialog().isWorking());
  EXPECT_EQ(places(), before);
  QTest::keyClick(&dialog(), Qt::Key_Escape);
  EXPECT_EQ(places(), before);
}

TEST_F(FigureWindow, cancellingLeavesNoFileAndTheDialogOpen) {
  ASSERT_TRUE(ask());
  typeName(pathTo("figure.png"));
  click("figureSave");
  ASSERT_TRUE(dialog().isWorking());
  QTest::keyClick(&dialog(), Qt::Key_Escape);
  EXPECT_FALSE(dialog().isWorking());
  EXPECT_TRUE(dialog().isVisible());
  EXPECT_TRUE(said().startsWith(QStringLiteral("Cancelled"))) << said().toStdString();
  QTest::keyClick(&dialog(), Qt::Key_Escape);
  EXPECT_FALSE(dialog().isVisible());
  EXPECT_FALSE(fs::exists(folder.path() / "figure.png"));
}

// The key goes to whatever has the keyboard once what began the work cannot be used any more.
TEST_F(FigureWindow, escapeCancelsFromWhereTheKeyboardIs) {
  ASSERT_TRUE(ask());
  part<QPushButton>("figureSave").setFocus();
  typeName(pathTo("figure.png"));
  QTest::keyClick(dialog().windowHandle(), Qt::Key_Space);
  ASSERT_TRUE(dialog().isWorking());
  QTest::keyClick(dialog().windowHandle(), Qt::Key_Escape);
  EXPECT_FALSE(dialog().isWorking());
  EXPECT_TRUE(dialog().isVisible());
  EXPECT_TRUE(said().startsWith(QStringLiteral("Cancelled"))) << said().toStdString();
  EXPECT_FALSE(fs::exists(folder.path() / "figure.png"));
}

TEST_F(FigureWindow, aPanelThatShowsNothingIsSaidInThePreview) {
  setLayout(CompareLayout::single);
  ASSERT_TRUE(ask());
  session().setTransferFunction({1.0, {{0.0, {1, 1, 1}, 0.0}}}, {nextGestureId(), QStringLiteral("nothing")});
  EXPECT_TRUE(test::waitUntil([this] { return said().contains(QStringLiteral("Panel a shows nothing")); }))
      << said().toStdString();
}

TEST_F(FigureWindow, theFieldOfALongNameShowsItsBeginning) {
  PanelSource source;
  source.text = QStringLiteral("Compared look");
  source.panel.name = QStringLiteral("CT skin, modified · Enhanced, normals smoothed by hand");
  PanelList list;
  list.setSources({source});
  list.choose({0, 0});
  list.resize(list.minimumSizeHint());
  list.show();
  ASSERT_TRUE(test::waitUntilExposed(list));
  ASSERT_TRUE(test::waitUntil([&] {
    if (!list.isActiveWindow())
      list.activateWindow();
    return list.isActiveWindow();
  }));
  auto& name = *list.findChild<QLineEdit*>(QStringLiteral("panelName-a"));
  const auto firstSeen = [&] { return name.cursorPositionAt({1, name.height() / 2}); };
  ASSERT_LT(name.width(), name.fontMetrics().horizontalAdvance(source.panel.name));
  name.repaint();
  EXPECT_EQ(firstSeen(), 0);
  name.setFocus();
  QTest::keyClick(&name, Qt::Key_End);
  name.repaint();
  EXPECT_GT(firstSeen(), 0) << "where it is typed";
  QTest::keyClick(&name, Qt::Key_Tab);
  name.repaint();
  EXPECT_EQ(firstSeen(), 0) << "left";
}

} // namespace
} // namespace limn
