// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/panels/presets/NameDialog.h"
#include "io/dicom/SyntheticSeries.h"
#include "support/FileBytes.h"
#include "widgets/PresetNames.h"
#include "widgets/presets/PresetBrowser.h"

#include <QDialogButtonBox>
#include <QInputDialog>
#include <QMenu>
#include <QPushButton>
#include <QTreeView>

#include <algorithm>

// What the window writes: presets, scenes, pictures, settings; and that nobody is named in them.

namespace limn {
namespace {

using MainWindowFiles = test::WindowHarness;

// Clicks a preset of the list by name.
void clickPreset(PresetBrowser& browser, const QString& name) {
  QTreeView& list = *browser.findChild<QTreeView*>();
  const QModelIndexList found = list.model()->match(list.model()->index(0, 0), Qt::DisplayRole, name, 1,
                                                    Qt::MatchExactly | Qt::MatchRecursive);
  ASSERT_EQ(found.size(), 1) << name.toStdString();
  list.scrollTo(found.front());
  QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(found.front()).center());
}

// Right clicks a preset of the list, which opens its menu.
void rightClickPreset(PresetBrowser& browser, const QString& name) {
  QWidget* viewport = browser.findChild<QTreeView*>()->viewport();
  const QPoint at = viewport->mapTo(browser.window(), rowOf(browser, name).center());
  QTest::mouseClick(browser.window()->windowHandle(), Qt::RightButton, {}, at);
}

void chooseInMenu(PresetBrowser& browser, const QString& text) {
  auto* menu = browser.findChild<QMenu*>();
  ASSERT_NE(menu, nullptr);
  for (QAction* action : menu->actions())
    if (action->text() == text) {
      action->trigger();
      menu->close();
      ASSERT_TRUE(test::waitUntil([&] { return !browser.findChild<QMenu*>(); }));
      return;
    }
  FAIL() << "no entry " << text.toStdString();
}

TEST_F(MainWindowFiles, choosingAPresetIsOneUndoStep) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  auto& browser = *window->findChild<PresetBrowser*>();
  const TransferFunction before = scene().transferFunction;
  const QStringList names = presetNames(browser);
  const QString current = shownPreset(browser);
  const auto other = std::find_if(names.begin(), names.end(), [&](const QString& n) { return n != current; });
  ASSERT_NE(other, names.end());
  clickPreset(browser, *other);
  EXPECT_NE(scene().transferFunction, before);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_EQ(undo().undoText(), QStringLiteral("use preset %1").arg(*other));
}

TEST_F(MainWindowFiles, thePresetShownIsMarkedAndSaysWhenItIsChanged) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  auto& browser = *window->findChild<PresetBrowser*>();
  clickPreset(browser, QStringLiteral("CT bone"));
  const TransferFunction bone = scene().transferFunction;
  EXPECT_EQ(shownPreset(browser), QStringLiteral("CT bone"));
  dragAPoint();
  ASSERT_NE(scene().transferFunction, bone);
  EXPECT_EQ(shownPreset(browser), QStringLiteral("CT bone*"));
  rightClickPreset(browser, QStringLiteral("CT bone"));
  chooseInMenu(browser, QStringLiteral("Reset to this preset"));
  EXPECT_EQ(scene().transferFunction, bone);
  EXPECT_EQ(shownPreset(browser), QStringLiteral("CT bone"));
  undo().undo();
  EXPECT_EQ(shownPreset(browser), QStringLiteral("CT bone*"));
}

TEST_F(MainWindowFiles, ownPresetsAreDuplicatedAndRenamedFromTheMenu) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  auto& browser = *window->findChild<PresetBrowser*>();
  const auto answer = [this](const QString& name) {
    auto* dialog = window->findChild<QInputDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->setTextValue(name);
    dialog->accept();
    ASSERT_TRUE(test::waitUntil([this] { return !window->findChild<QInputDialog*>(); }));
  };
  rightClickPreset(browser, QStringLiteral("CT lung"));
  chooseInMenu(browser, QStringLiteral("Duplicate…"));
  EXPECT_EQ(window->findChild<QInputDialog*>()->textValue(), QStringLiteral("CT lung copy"));
  answer(QStringLiteral("Lung of mine"));
  ASSERT_TRUE(presetNames(browser).contains(QStringLiteral("Lung of mine")));
  clickPreset(browser, QStringLiteral("Lung of mine"));
  rightClickPreset(browser, QStringLiteral("Lung of mine"));
  chooseInMenu(browser, QStringLiteral("Rename…"));
  auto& asking = *window->findChild<NameDialog*>();
  asking.setTextValue(QStringLiteral("CT bone")); // taken
  asking.accept();
  EXPECT_TRUE(asking.isVisible()) << "what was typed can be corrected";
  EXPECT_TRUE(asking.said().contains(QStringLiteral("built-in"))) << asking.said().toStdString();
  EXPECT_TRUE(presetNames(browser).contains(QStringLiteral("Lung of mine")));
  answer(QStringLiteral("Airways"));
  EXPECT_FALSE(presetNames(browser).contains(QStringLiteral("Lung of mine")));
  EXPECT_EQ(shownPreset(browser), QStringLiteral("Airways"));
}

TEST_F(MainWindowFiles, aSavedPresetAppearsAsAFileAndInTheListUntilDeleted) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  auto& browser = *window->findChild<PresetBrowser*>();
  emit browser.saveRequested();
  auto* dialog = window->findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->textValue().startsWith(QStringLiteral("My "))) << "a name that is free is proposed";
  const auto* save = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  dialog->setTextValue(QStringLiteral(" "));
  EXPECT_FALSE(save->isEnabled()) << "without a name there is nothing to save";
  dialog->setTextValue(QStringLiteral("My head"));
  EXPECT_TRUE(save->isEnabled());
  dialog->accept();
  ASSERT_TRUE(presetNames(browser).contains(QStringLiteral("My head")));
  EXPECT_EQ(test::entriesOf(folder.path() / "presets"), 1u);
  clickPreset(browser, QStringLiteral("My head"));
  QTest::keyClick(browser.findChild<QTreeView*>(), Qt::Key_Delete);
  EXPECT_FALSE(presetNames(browser).contains(QStringLiteral("My head")));
  EXPECT_EQ(test::entriesOf(folder.path() / "presets"), 0u);
}

// Four slices of a marked patient.
void writeSeries(const std::filesystem::path& folder) {
  for (int i = 1; i <= 4; ++i)
    test::slice(i, i)
        .text(0x00100010, "PN", "ZEBEDEE^QUILLON")
        .text(0x00100020, "LO", "PID774411")
        .text(0x00080020, "DA", "19870615")
        .text(0x0020000D, "UI", "1.2.826.99.55501")
        .text(0x0020000E, "UI", "1.2.826.99.55502")
        .text(0x00080018, "UI", "1.2.826.99.55503." + std::to_string(i))
        .write(folder / ("slice" + std::to_string(i)));
}

TEST_F(MainWindowFiles, thePatientIsInTheTitleWhereThatIsChosenAndInNoFile) {
  writeSeries(folder.path() / "series");
  ASSERT_TRUE(open(pathTo("series")));
  ASSERT_NE(scene().volume, nullptr) << messages().sentence().toStdString();
  QAction* patient = action(QStringLiteral("Show the patient's &name in the title bar"));
  ASSERT_NE(patient, nullptr);
  for (const bool isNamed : {false, true, false}) {
    if (isNamed != patient->isChecked())
      patient->trigger();
    for (const char* part : {"ZEBEDEE", "PID774411", "1987"})
      EXPECT_EQ(window->windowTitle().contains(QLatin1String(part)), isNamed)
          << window->windowTitle().toStdString();
  }

  ASSERT_TRUE(rest());
  emit window->findChild<PresetBrowser*>()->saveRequested();
  auto* dialog = window->findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  dialog->setTextValue(QStringLiteral("Marked"));
  dialog->accept();
  saving().writeScene(pathTo("scene.json"));
  saving().writePicture(pathTo("picture.png"));
  window->close();
  window.reset();
  std::filesystem::remove_all(folder.path() / "series");
  EXPECT_EQ(test::entriesOf(folder.path() / "settings"), 2u); // and their lock
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    if (!entry.is_regular_file())
      continue;
    ++files;
    const std::string bytes = test::bytesOfFile(entry.path());
    for (const char* mark : {"ZEBEDEE", "QUILLON", "PID774411", "19870615", "1987-06-15", "1.2.826.99"})
      EXPECT_EQ(bytes.find(mark), std::string::npos) << mark << " in " << entry.path();
  }
  EXPECT_GE(files, 4u); // settings, preset, scene, picture
}

} // namespace
} // namespace limn
