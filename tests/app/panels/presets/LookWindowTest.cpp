// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/panels/presets/LookController.h"
#include "io/ImageFile.h"
#include "io/looks/Look.h"
#include "io/scenefile/SceneFile.h"
#include "support/FileBytes.h"
#include "widgets/PresetNames.h"
#include "widgets/presets/PresetBrowser.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QDragEnterEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QStatusBar>
#include <QTextEdit>
#include <QTreeView>

#include <fstream>

// Looks of other programs in the program's window, by mouse and keys.

namespace limn {
namespace {

constexpr const char* bones =
    "[FLT]\nmin=100\nmax=900\n[INT]\nnumnodes=2\n[BYT]\nnodeintensity0=0\nnodeintensity1=255\n"
    "[RGBA255]\nnodergba0=51|0|0|0\nnodergba1=255|255|204|153\n";
constexpr const char* relative = R"({"R":[0,255],"G":[0,255],"B":[0,255],"A":[0,255],"I":[0,255]})";

class LookWindow : public test::WindowHarness {
protected:
  void write(const char* name, const char* text) { std::ofstream(folder.path() / name) << text; }
  LookController& controller() const { return *window->findChild<LookController*>(); }
  PresetBrowser& browser() const { return *window->findChild<PresetBrowser*>(); }
  QStringList own() const { return presetNames(browser()); }
  LookReport* report() const { return window->findChild<LookReport*>(); }

  // Events of a mouse that lets files go over a widget, as the window system sends them.
  void drop(QWidget& over, const std::vector<const char*>& names) {
    QMimeData data;
    QList<QUrl> urls;
    for (const char* name : names)
      urls << QUrl::fromLocalFile(pathTo(name));
    data.setUrls(urls);
    const QPoint at = over.mapTo(window.get(), over.rect().center());
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window->windowHandle(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window->windowHandle(), &event);
    ASSERT_TRUE(imported());
  }

  [[nodiscard]] bool imported() {
    return test::waitUntil([this] { return !controller().isBusy(); });
  }

  // Preset ▸ an entry, by its letter.
  void chooseFromMenu(Qt::Key letter) {
    QTest::keyClick(window->windowHandle(), Qt::Key_P, Qt::AltModifier);
    ASSERT_TRUE(test::waitUntil([] { return QApplication::activePopupWidget() != nullptr; }));
    QTest::keyClick(QApplication::activePopupWidget(), letter);
  }
};

TEST_F(LookWindow, theLookOfOneFileIsAPresetAndIsShown) {
  write("CT Bones.clut", bones);
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const TransferFunction before = scene().transferFunction;
  const int steps = undo().count();
  typeName(pathTo("CT Bones.clut"));
  chooseFromMenu(Qt::Key_I);
  ASSERT_TRUE(imported());
  EXPECT_TRUE(own().contains(QStringLiteral("CT Bones")));
  ASSERT_EQ(scene().transferFunction.points.size(), 2u);
  EXPECT_DOUBLE_EQ(scene().transferFunction.points[0].value, 100.0);
  EXPECT_DOUBLE_EQ(scene().transferFunction.points[1].opacity, 0.6);
  EXPECT_EQ(undo().count(), steps + 1);
  EXPECT_EQ(report(), nullptr) << "nothing was changed";
  EXPECT_TRUE(window->statusBar()->currentMessage().contains(QStringLiteral("CT Bones")));
  undo().undo();
  EXPECT_EQ(scene().transferFunction, before);
}

TEST_F(LookWindow, whatWasImportedIsListedThoughAnOldSearchWouldHideIt) {
  write("CT Bones.clut", bones);
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  auto* search = browser().findChild<QLineEdit*>();
  search->setText(QStringLiteral("skin"));
  ASSERT_FALSE(own().contains(QStringLiteral("CT Bones")));
  controller().importFiles({pathTo("CT Bones.clut")});
  ASSERT_TRUE(imported());
  EXPECT_TRUE(own().contains(QStringLiteral("CT Bones")));
  EXPECT_TRUE(search->text().isEmpty());
}

TEST_F(LookWindow, severalAtOnceAreToldOfFileByFile) {
  write("CT Bones.clut", bones);
  write("ramp.niivue.json", relative);
  write("broken.itf", "<InviwoWorkspace version=\"3\"><Points>");
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const Scene before = scene();
  typeName(QStringLiteral("\"%1\" \"%2\" \"%3\"")
               .arg(pathTo("CT Bones.clut"), pathTo("ramp.niivue.json"), pathTo("broken.itf")));
  chooseFromMenu(Qt::Key_I);
  ASSERT_TRUE(imported());
  EXPECT_TRUE(own().contains(QStringLiteral("CT Bones")));
  EXPECT_TRUE(own().contains(QStringLiteral("ramp")));
  EXPECT_EQ(scene(), before) << "which of several should be shown?";
  ASSERT_NE(report(), nullptr);
  ASSERT_TRUE(test::waitUntilExposed(*report()));
  EXPECT_FALSE(report()->isModal());
  const QString told = report()->plainText();
  for (const char* words : {"Presets imported: 2", "Files refused: 1", "CT Bones.clut", "stretched over",
                            "broken.itf", "not imported", "damaged or cut off"})
    EXPECT_TRUE(told.contains(QLatin1String(words))) << words << "\n" << told.toStdString();
  // All of it is copied by keys alone; Esc closes it.
  ASSERT_TRUE(test::waitUntil([this] {
    report()->activateWindow(); // which a window manager does for a new one
    return report()->isActiveWindow();
  }));
  QTest::keyClick(report()->focusWidget(), Qt::Key_Backtab, Qt::ShiftModifier);
  QTest::keyClick(report()->focusWidget(), Qt::Key_Space);
  EXPECT_EQ(QApplication::clipboard()->text().toStdString(), told.toStdString());
  auto* text = report()->findChild<QTextEdit*>();
  EXPECT_FALSE(text->accessibleName().isEmpty());
  text->setFocus();
  QTest::keyClick(text, Qt::Key_A, Qt::ControlModifier);
  EXPECT_TRUE(text->textCursor().hasSelection());
  QTest::keyClick(text, Qt::Key_Escape);
  EXPECT_TRUE(test::waitUntil([this] { return report() == nullptr; }));
}

TEST_F(LookWindow, aRelativeLookIsStretchedOverTheVolumeOrRefusedWithoutOne) {
  write("ramp.niivue.json", relative);
  drop(browser(), {"ramp.niivue.json"});
  EXPECT_FALSE(own().contains(QStringLiteral("ramp")));
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("open the volume")))
      << messages().sentence().toStdString();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  drop(browser(), {"ramp.niivue.json"});
  const ValueRange& range = scene().volume->range();
  EXPECT_TRUE(own().contains(QStringLiteral("ramp")));
  EXPECT_DOUBLE_EQ(scene().transferFunction.points.front().value, range.lowest);
  EXPECT_DOUBLE_EQ(scene().transferFunction.points.back().value, range.highest);
}

TEST_F(LookWindow, nothingThatIsThereIsReplacedOrKeptTwice) {
  write("CT Bones.clut", bones);
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  drop(browser(), {"CT Bones.clut"});
  const qsizetype count = own().size();
  drop(browser(), {"CT Bones.clut"});
  EXPECT_EQ(own().size(), count);
  std::string other = bones;
  other.replace(other.find("max=900"), 7, "max=800");
  write("CT Bones.clut", other.c_str());
  drop(browser(), {"CT Bones.clut"});
  EXPECT_EQ(own().size(), count + 1);
  EXPECT_TRUE(own().contains(QStringLiteral("CT Bones 2")));
  EXPECT_DOUBLE_EQ(scene().transferFunction.points[1].value, 800.0);
  ASSERT_NE(report(), nullptr);
  EXPECT_TRUE(report()->plainText().contains(QStringLiteral("\"CT Bones 2\"")));
}

TEST_F(LookWindow, aFileOfThePresetsThatCannotBeReadIsNotReplaced) {
  write("CT Bones.clut", bones);
  const std::filesystem::path presets = UserFolders::below(folder.path()).presets;
  std::filesystem::create_directories(presets);
  std::ofstream(presets / "CT Bones.json") << "{ half";
  drop(browser(), {"CT Bones.clut"});
  EXPECT_FALSE(own().contains(QStringLiteral("CT Bones")));
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("CT Bones.json")))
      << messages().sentence().toStdString();
  EXPECT_EQ(test::bytesOfFile(presets / "CT Bones.json"), "{ half");
}

TEST_F(LookWindow, filesNamedWhileOthersAreReadAreNext) {
  write("one.clut", bones);
  write("two.clut", bones);
  controller().importFiles({pathTo("one.clut")});
  controller().importFiles({pathTo("two.clut")});
  EXPECT_TRUE(window->isBusy());
  ASSERT_TRUE(test::waitUntil([this] { return own().contains(QStringLiteral("two")); }));
  EXPECT_TRUE(own().contains(QStringLiteral("one")));
}

TEST_F(LookWindow, looksAndAVolumeAreDroppedTogether) {
  write("CT Bones.clut", bones);
  write("volume.nrrd",
        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n0 1 2 3 4 5 6 7\n");
  drop(view(), {"CT Bones.clut", "volume.nrrd"});
  EXPECT_TRUE(own().contains(QStringLiteral("CT Bones")));
  ASSERT_TRUE(test::waitUntil([this] { return scene().volume != nullptr; }));
}

TEST_F(LookWindow, openingALookImportsIt) {
  write("CT Bones.clut", bones);
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const auto volume = scene().volume;
  typeName(pathTo("CT Bones.clut"));
  QTest::keyClick(window->windowHandle(), Qt::Key_O, Qt::ControlModifier);
  ASSERT_TRUE(imported());
  EXPECT_EQ(scene().volume, volume);
  EXPECT_TRUE(own().contains(QStringLiteral("CT Bones")));
  EXPECT_DOUBLE_EQ(scene().transferFunction.points[0].value, 100.0);
}

TEST_F(LookWindow, whatIsShownIsExportedAndReadsAgain) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  typeName(pathTo("mine.itf"));
  chooseFromMenu(Qt::Key_E);
  const std::vector<ReadLook> looks = readLooks(pathTo("mine.itf").toStdString());
  EXPECT_EQ(looks.front().preset.transferFunction.points, scene().transferFunction.points);
  ASSERT_NE(report(), nullptr) << "the light was lost";
  EXPECT_TRUE(report()->plainText().contains(QStringLiteral("Light and material")));
}

TEST_F(LookWindow, theModelOfThePictureIsExportedOrToldAsLost) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  setLayout(CompareLayout::sideBySide);
  window->findChild<ComparisonController*>()->setSideModel(1, ShadingModel::enhanced);
  ASSERT_EQ(scene().shading.model, ShadingModel::classic) << "the picture at the right has its own";
  typeName(pathTo("mine.json"));
  chooseFromMenu(Qt::Key_E);
  EXPECT_EQ(readLooks(pathTo("mine.json").toStdString()).front().preset.shading->model,
            ShadingModel::enhanced);
  typeName(pathTo("mine.vp"));
  chooseFromMenu(Qt::Key_E);
  ASSERT_NE(report(), nullptr);
  EXPECT_TRUE(report()->plainText().contains(QStringLiteral("The shading model enhanced was left out")))
      << report()->plainText().toStdString();
}

TEST_F(LookWindow, anExportThatLosesNothingIsOnlyConfirmed) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  typeName(pathTo("mine.json"));
  chooseFromMenu(Qt::Key_E);
  EXPECT_EQ(readLooks(pathTo("mine.json").toStdString()).front().preset.transferFunction,
            scene().transferFunction);
  EXPECT_EQ(report(), nullptr);
  EXPECT_TRUE(window->statusBar()->currentMessage().contains(QStringLiteral("mine.json")));
}

TEST_F(LookWindow, theKindThatWasExportedLastIsOfferedFirst) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  typeName(pathTo("mine.itf"));
  chooseFromMenu(Qt::Key_E);
  QString offered;
  onceAsked<QFileDialog>([&offered](QFileDialog& dialog) {
    offered = dialog.selectedNameFilter();
    dialog.reject();
  });
  chooseFromMenu(Qt::Key_E);
  EXPECT_TRUE(offered.contains(QStringLiteral("*.itf"))) << offered.toStdString();
}

TEST_F(LookWindow, anEndingThatNobodyKnowsIsRefusedInASentence) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  typeName(pathTo("mine.abc"));
  chooseFromMenu(Qt::Key_E);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "mine.abc"));
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral(".itf"))) << messages().sentence().toStdString();
}

TEST_F(LookWindow, aPresetOfTheListIsExportedFromItsMenu) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  QTreeView& list = *browser().findChild<QTreeView*>();
  const QPoint place = rowOf(browser(), QStringLiteral("CT lung")).center();
  QContextMenuEvent asked(QContextMenuEvent::Mouse, place, list.viewport()->mapToGlobal(place));
  QCoreApplication::sendEvent(list.viewport(), &asked);
  typeName(pathTo("lung.json"));
  QMenu& menu = *browser().findChild<QMenu*>();
  QAction* const entry = action(QStringLiteral("Export…"));
  ASSERT_TRUE(entry);
  QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(entry).center());
  EXPECT_EQ(readLooks(pathTo("lung.json").toStdString()).front().preset.name, "CT lung");
}

TEST_F(LookWindow, thatOfASavedPictureIsTakenForTheNextVolume) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  Scene other = scene();
  other.transferFunction.points = {{100, {1, 0, 0}, 0}, {900, {1, 1, 1}, 0.5}};
  other.camera.position.x = 700.0;
  writeImage(pathTo("look.png").toStdString(), Image({4, 3}), {}, sceneToJson(other, "head.nii.gz"));
  const Camera before = scene().camera;
  typeName(pathTo("look.png"));
  chooseFromMenu(Qt::Key_I);
  ASSERT_TRUE(imported());
  EXPECT_TRUE(own().contains(QStringLiteral("look")));
  EXPECT_EQ(scene().transferFunction, other.transferFunction);
  EXPECT_EQ(scene().camera, before);
  ASSERT_NE(report(), nullptr);
  EXPECT_TRUE(report()->plainText().contains(QStringLiteral("its view, quality and background were not")))
      << report()->plainText().toStdString();
}

TEST_F(LookWindow, aPictureThatLimnDidNotSaveIsRefusedAsOne) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  writeImage(pathTo("holiday.png").toStdString(), Image({4, 3}), {}, "a holiday");
  typeName(pathTo("holiday.png"));
  chooseFromMenu(Qt::Key_I);
  ASSERT_TRUE(imported());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("it is no picture that Limn saved")))
      << messages().sentence().toStdString();
  EXPECT_EQ(report(), nullptr);
}

TEST_F(LookWindow, aDamagedLookOpenedByItselfIsOneSentence) {
  write("broken.itf", "<InviwoWorkspace version=\"3\"><Points>");
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const Scene before = scene();
  drop(view(), {"broken.itf"});
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("broken.itf")));
  EXPECT_EQ(report(), nullptr);
  EXPECT_EQ(scene(), before);
}

} // namespace
} // namespace limn
