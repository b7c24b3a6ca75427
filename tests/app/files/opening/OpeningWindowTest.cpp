// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/asking/FileDialogs.h"
#include "app/core/sources/SceneSource.h"
#include "app/files/opening/SeriesDialog.h"
#include "app/files/saving/PictureDialog.h"
#include "io/dicom/SyntheticSeries.h"
#include "scene/framing/Framing.h"
#include "support/FileBytes.h"
#include "support/ShortVolume.h"

#include <QDir>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QTreeView>
#include <QTreeWidget>

// What the window remembers of what was opened, and where it looks and asks for it, in the window.

namespace limn {
namespace {

namespace fs = std::filesystem;

class OpeningWindow : public test::WindowHarness {
protected:
  // A small volume in a folder of its own; returns its path.
  QString smallVolume(const char* inFolder, const char* voxels = "0 100 200 300 400 500 600 700") {
    const fs::path place = folder.path() / inFolder;
    fs::create_directories(place);
    test::writeBytes(
        place / "small.nrrd",
        "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\nspace "
        "directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: ascii\n\n" +
            std::string(voxels) + "\n");
    return QString::fromStdString((place / "small.nrrd").string());
  }

  void saveSessionWith(const QString& labels, const QString& file) {
    ASSERT_TRUE(open(smallVolume("a")));
    typeName(labels);
    window->findChild<QAction*>(QStringLiteral("openLabels"))->trigger();
    ASSERT_TRUE(test::waitUntil([this] { return scene().keep.kind == Region::Kind::labels; }));
    saving().writeSession(file);
  }

  /// Clicks what the message offers.
  void choose(const char* answer) {
    for (QToolButton* button : messages().findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == QString::fromUtf8(answer))
        return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << "no button " << answer << " beside: " << messages().sentence().toStdString();
  }

  QString savedPicture() {
    EXPECT_TRUE(rest());
    const QString path = pathTo("elsewhere/picture.png");
    fs::create_directories(folder.path() / "elsewhere");
    saving().writePicture(path);
    return path;
  }

  QString folderOfNextDialog() {
    auto asked = std::make_shared<QString>();
    onceAsked<QFileDialog>([asked](QFileDialog& dialog) {
      *asked = dialog.directory().absolutePath();
      dialog.reject();
    });
    // Without a window manager nobody gives the keys back when the dialog before this one ends.
    window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
    QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
    return *asked;
  }
};

TEST_F(OpeningWindow, aPictureFindsTheVolumeThatWasOpenedBefore) {
  ASSERT_TRUE(open(smallVolume("a")));
  const auto volume = scene().volume;
  const QString picture = savedPicture();
  for (int other = 0; other < 12; ++other) // more than the list of recent files holds
    ASSERT_TRUE(open(QStringLiteral("phantom:%1").arg(20 + other)));
  ASSERT_TRUE(open(picture));
  EXPECT_FALSE(messages().isVisible()) << messages().sentence().toStdString();
  EXPECT_EQ(scene().volume->range().highest, volume->range().highest);
}

// Once it is read nobody needs it again; of another volume it is news.
TEST_F(OpeningWindow, whatWasDismissedOfAVolumeIsNotSaidAgain) {
  const auto ball = [](const glm::ivec3& v) { return glm::length(glm::dvec3(v) - 6.0) < 5.0 ? 900 : 0; };
  for (const char* name : {"thick.nrrd", "other.nrrd"})
    test::writeShorts(folder.path() / name, 12, ball, 4.0);
  const auto isSaid = [this] {
    return messages().isVisible() && messages().sentence().contains(QStringLiteral("mm apart"));
  };
  ASSERT_TRUE(open(pathTo("thick.nrrd")));
  ASSERT_TRUE(test::waitUntil(isSaid));
  for (QToolButton* button : messages().findChildren<QToolButton*>())
    if (button->isVisible() && button->text() == QStringLiteral("Dismiss"))
      QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_FALSE(messages().isVisible());
  ASSERT_TRUE(open(pathTo("thick.nrrd")));
  ASSERT_TRUE(rest());
  EXPECT_FALSE(isSaid());
  ASSERT_TRUE(open(pathTo("other.nrrd")));
  EXPECT_TRUE(test::waitUntil(isSaid));
  // Where something can be set right it is said each time.
  const QString unknown = smallVolume("unknown");
  test::writeBytes(folder.path() / "unknown" / "small.nrrd",
                   "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n0 1 2 3 4 5 6 7\n");
  for (int opening = 0; opening < 2; ++opening) {
    ASSERT_TRUE(open(unknown));
    ASSERT_TRUE(messages().isVisible());
    for (QToolButton* button : messages().findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == QStringLiteral("Dismiss"))
        QTest::mouseClick(button, Qt::LeftButton);
  }
}

// Its slices lie far apart, too, which is said second.
TEST_F(OpeningWindow, aTiltedGantryIsSaidBeforeAllElseAndOnce) {
  fs::create_directories(folder.path() / "tilted");
  for (int number = 1; number <= 3; ++number)
    test::slantingSlice(number).write(folder.path() / "tilted" / std::to_string(number));
  const auto isSaid = [this] {
    return messages().isVisible() && messages().sentence().startsWith(QStringLiteral("The slices slant by"));
  };
  ASSERT_TRUE(open(pathTo("tilted")));
  ASSERT_TRUE(test::waitUntil(isSaid)) << messages().sentence().toStdString();
  choose("Dismiss");
  ASSERT_TRUE(open(pathTo("tilted")));
  ASSERT_TRUE(rest());
  EXPECT_FALSE(isSaid());
}

TEST_F(OpeningWindow, thePictureOfOnePatientOpensOnAnotherWhoLiesElsewhere) {
  ASSERT_TRUE(openAlone(QStringLiteral("phantom:8")));
  const TransferFunction look = scene().transferFunction;
  const QString picture = savedPicture();
  test::writeBytes(folder.path() / "far.nrrd",
                   "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\n"
                   "space directions: (9,0,0) (0,9,0) (0,0,9)\nspace origin: (5000,0,0)\nencoding: ascii\n\n"
                   "0 900 900 900 900 900 900 900\n");
  SourceOptions options;
  options.volume = (folder.path() / "far.nrrd").string();
  window->openSource(picture, options);
  ASSERT_TRUE(rest());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("looks past this volume")))
      << messages().sentence().toStdString();
  EXPECT_EQ(scene().transferFunction, look);
  EXPECT_TRUE(
      seesAny(scene().camera, scene().volume->grid(), visibleVoxels(scene()), view().pictureAspect()));
}

TEST_F(OpeningWindow, ofTwoVolumesOfOneNameNoneIsTakenUnasked) {
  ASSERT_TRUE(open(smallVolume("a")));
  const QString picture = savedPicture();
  ASSERT_TRUE(open(smallVolume("b", "0 1 2 3 4 5 6 7"))); // of another patient
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(open(picture));
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("not where the picture expects it")))
      << messages().sentence().toStdString();
}

TEST_F(OpeningWindow, aPictureOfTheSampleHeadReopens) {
  if (!installedSampleHead())
    GTEST_SKIP() << "invesalius-examples is not installed";
  ASSERT_TRUE(openAlone(QStringLiteral("sample")));
  const QString picture = savedPicture();
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(open(picture));
  EXPECT_FALSE(messages().isVisible()) << messages().sentence().toStdString();
  EXPECT_EQ(window->sessionDocument().scene.volume, installedSampleHead()->string());
}

TEST_F(OpeningWindow, theSessionOfAVolumeIsNotSavedOverWithAnotherInItsPlace) {
  const QString volume = smallVolume("a");
  ASSERT_TRUE(open(volume));
  session().setMeasurements({{Measurement::Kind::mark, std::nullopt, {{1, 1, 1}}, "1"}}, {});
  const QString file = pathTo("own.limn.json");
  saving().writeSession(file);
  const std::string saved = readTextFile(file.toStdString());
  fs::remove(volume.toStdString());
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(open(file));
  EXPECT_TRUE(
      messages().sentence().startsWith(QStringLiteral("The session's volume is not where the session")))
      << messages().sentence().toStdString();
  const QString other = pathTo("other.nrrd");
  test::writeBytes(other.toStdString(),
                   "NRRD0004\ntype: short\ndimension: 3\nsizes: 3 2 2\nspace: left-posterior-superior\n"
                   "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: ascii\n\n"
                   "0 1 2 3 4 5 6 7 8 9 10 11\n");
  SourceOptions options;
  options.volume = other.toStdString();
  window->openSource(file, options);
  ASSERT_TRUE(rest());
  EXPECT_TRUE(messages().sentence().startsWith(QStringLiteral("This is another volume than the session's: "
                                                              "3 × 2 × 2 voxels in place of 2 × 2 × 2")))
      << messages().sentence().toStdString();
  QString suggested;
  onceAsked<QFileDialog>([&suggested](QFileDialog& dialog) {
    suggested = dialog.selectedFiles().value(0);
    QTest::keyClick(dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit")), Qt::Key_Return);
  });
  QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(suggested, pathTo("own 2.limn.json"));
  EXPECT_EQ(readTextFile(file.toStdString()), saved);
  ASSERT_TRUE(fs::exists(suggested.toStdString()));
  // From then on that one is the session's own file.
  QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(readTextFile(file.toStdString()), saved);
}

TEST_F(OpeningWindow, aSessionWhoseLabelsAreElsewhereOpensOnceTheyAreLocatedOrWithoutThem) {
  const QString labels = smallVolume("labels", "0 1 0 1 0 1 0 1");
  const QString file = pathTo("labelled.limn.json");
  saveSessionWith(labels, file);
  const std::string saved = readTextFile(file.toStdString());
  fs::create_directories(folder.path() / "moved");
  fs::rename(labels.toStdString(), folder.path() / "moved" / "renamed.nrrd");
  const auto isLoaded = [this] { return !window->loader().isLoading(); };
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(open(file));
  EXPECT_TRUE(messages().sentence().contains(labels)) << messages().sentence().toStdString();
  typeName(pathTo("moved/renamed.nrrd"));
  choose("Locate labels…");
  ASSERT_TRUE(test::waitUntil(isLoaded));
  EXPECT_EQ(scene().keep.kind, Region::Kind::labels);
  EXPECT_EQ(scene().volume->grid().dims, glm::ivec3(2));
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(open(file));
  choose("Open without labels");
  ASSERT_TRUE(test::waitUntil(isLoaded));
  EXPECT_EQ(scene().volume->grid().dims, glm::ivec3(2));
  EXPECT_EQ(scene().keep.kind, Region::Kind::all);
  QString suggested;
  onceAsked<QFileDialog>([&suggested](QFileDialog& dialog) {
    suggested = dialog.selectedFiles().value(0);
    dialog.reject();
  });
  QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(suggested, pathTo("labelled 2.limn.json"));
  EXPECT_EQ(readTextFile(file.toStdString()), saved);
}

TEST_F(OpeningWindow, labelsThatDoNotFitAreAskedForAgain) {
  const QString labels = smallVolume("labels", "0 1 0 1 0 1 0 1");
  const QString file = pathTo("labelled.limn.json");
  saveSessionWith(labels, file);
  fs::rename(labels.toStdString(), folder.path() / "renamed.nrrd");
  test::writeBytes(folder.path() / "far.nrrd",
                   "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\n"
                   "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (5000,0,0)\nencoding: ascii\n\n"
                   "0 1 0 1 0 1 0 1\n");
  const auto isLoaded = [this] { return !window->loader().isLoading(); };
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const auto shown = scene().volume;
  ASSERT_TRUE(open(file));
  choose("Dismiss");
  EXPECT_FALSE(messages().isVisible());
  EXPECT_EQ(scene().volume, shown) << "what was open stays";
  ASSERT_TRUE(open(file));
  for (int wrong = 0; wrong < 2; ++wrong) {
    typeName(pathTo("far.nrrd"));
    choose("Locate labels…");
    ASSERT_TRUE(test::waitUntil(isLoaded));
    EXPECT_EQ(scene().volume, shown);
    EXPECT_TRUE(messages().sentence().contains(QStringLiteral("far.nrrd")))
        << messages().sentence().toStdString();
  }
  typeName(pathTo("renamed.nrrd"));
  choose("Locate labels…");
  ASSERT_TRUE(test::waitUntil(isLoaded));
  EXPECT_EQ(scene().volume->grid().dims, glm::ivec3(2));
  EXPECT_EQ(scene().keep.kind, Region::Kind::labels);
}

TEST_F(OpeningWindow, dialogsOpenWhereTheLastOneEnded) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const QString volume = smallVolume("a");
  typeName(volume);
  QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  EXPECT_EQ(scene().volume->grid().dims, glm::ivec3(2));
  EXPECT_EQ(folderOfNextDialog(), pathTo("a"));
  fs::create_directories(folder.path() / "b");
  typeName(pathTo("b/mine"));
  QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(fs::exists(folder.path() / "b" / "mine.limn.json"));
  EXPECT_EQ(folderOfNextDialog(), pathTo("a")) << "what is opened lies elsewhere than what is saved";
  // Pictures go elsewhere than a session, which may lie beside the patient's files.
  QString ofPictures;
  onceAsked<PictureDialog>([&, this](PictureDialog& dialog) {
    onceAsked<QFileDialog>([&ofPictures](QFileDialog& where) {
      ofPictures = where.directory().absolutePath();
      where.reject();
    });
    dialog.accept();
  });
  window->findChild<QAction*>(QStringLiteral("savePicture"))->trigger();
  EXPECT_FALSE(ofPictures.isEmpty());
  EXPECT_NE(ofPictures, pathTo("a"));
  EXPECT_NE(ofPictures, pathTo("b"));
  const Settings inTheNextRun(UserFolders::below(folder.path()).settings);
  EXPECT_EQ(inTheNextRun.dialogFolder(), pathTo("a"));
  EXPECT_EQ(inTheNextRun.saveFolder(), pathTo("b"));
}

TEST_F(OpeningWindow, aFolderOfWhatIsRefusedIsNotWhereTheNextDialogOpens) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  typeName(smallVolume("a"));
  QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  fs::create_directories(folder.path() / "b");
  const auto refused = [this](const char* name, const char* action) {
    messages().hide();
    test::writeBytes(folder.path() / name, "NRRD0004\n");
    typeName(pathTo(name));
    window->findChild<QAction*>(QLatin1String(action))->trigger();
    return test::waitUntil([this] { return messages().isVisible(); });
  };
  for (const char* action : {"openFile", "openLabels"}) {
    ASSERT_TRUE(refused("b/damaged.nrrd", action)) << action;
    EXPECT_EQ(folderOfNextDialog(), pathTo("a")) << action;
  }
  ASSERT_TRUE(refused("b/damaged.clut", "importLooks"));
  EXPECT_EQ(folderOfNextDialog(), pathTo("a")) << "of looks";
  // What came in otherwise changes nothing either.
  ASSERT_TRUE(open(smallVolume("c")));
  EXPECT_EQ(folderOfNextDialog(), pathTo("a"));
}

TEST_F(OpeningWindow, theDialogForLabelsOpensWhereTheLastOneEndedToo) {
  ASSERT_TRUE(open(smallVolume("a")));
  const QString labels = smallVolume("labels", "0 1 0 1 0 1 0 1");
  typeName(labels);
  window->findChild<QAction*>(QStringLiteral("openLabels"))->trigger();
  ASSERT_TRUE(test::waitUntil([this] { return scene().keep.kind == Region::Kind::labels; }));
  EXPECT_EQ(folderOfNextDialog(), pathTo("labels"));
  QString asked;
  onceAsked<QFileDialog>([&asked](QFileDialog& dialog) {
    asked = dialog.directory().absolutePath();
    dialog.reject();
  });
  window->findChild<QAction*>(QStringLiteral("openLabels"))->trigger();
  EXPECT_EQ(asked, pathTo("labels"));
}

// In folders where each is the first of its folder, which is where Qt alone opens the one before the last.
TEST_F(OpeningWindow, aPathThatIsTypedIsWhatIsOpened) {
  const QString volume = smallVolume("0/0");
  const QString inner = pathTo("0/0/0");
  fs::create_directories(inner.toStdString());
  Settings settings(UserFolders::below(folder.path()).settings);
  const auto answer = [&](const OpenQuestion& question, const QString& path, const QString& from) {
    settings.setDialogFolder(from);
    onceAsked<QFileDialog>([&path](QFileDialog& dialog) {
      auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
      ASSERT_TRUE(name && test::waitUntilExposed(dialog));
      ASSERT_TRUE(test::waitUntil([&] {
        if (!dialog.isActiveWindow())
          dialog.activateWindow();
        return dialog.isActiveWindow();
      }));
      name->setFocus();
      name->selectAll();
      const auto press = [&dialog](auto key) { // goes to the list of what fits once that is open
        const QWidget* popup = QApplication::activePopupWidget();
        QTest::keyClick(popup ? popup->windowHandle() : dialog.windowHandle(), key);
      };
      for (const QChar letter : path)
        press(letter.toLatin1());
      EXPECT_EQ(name->text(), path);
      EXPECT_TRUE(test::waitUntil([] { return QApplication::activePopupWidget() != nullptr; }));
      press(Qt::Key_Return);
      if (dialog.isVisible())
        dialog.reject();
    });
    return askWhatToOpen(window.get(), question, settings);
  };
  for (const QString& from : {pathTo("0/0"), pathTo("0"), pathTo("")}) {
    EXPECT_EQ(answer({QStringLiteral("a file")}, volume, from), volume);
    EXPECT_EQ(answer({QStringLiteral("a folder"), true}, inner, from), inner);
  }
}

TEST_F(OpeningWindow, theDialogShowsFilesOfScannersWhichHaveNoEnding) {
  ASSERT_TRUE(open(smallVolume("scans")));
  for (const char* name : {"IM000001", "I10A", "1.2.840.113619.2.134", "notes.txt"})
    test::writeBytes(folder.path() / "scans" / name, "anything");
  QStringList shown;
  onceAsked<QFileDialog>([&shown, this](QFileDialog& dialog) {
    dialog.setDirectory(pathTo("scans"));
    const auto* files = dialog.findChild<QTreeView*>(QStringLiteral("treeView"));
    const auto names = [files] {
      QStringList listed;
      for (int row = 0; row < files->model()->rowCount(files->rootIndex()); ++row)
        listed << files->model()->index(row, 0, files->rootIndex()).data().toString();
      listed.sort();
      return listed;
    };
    EXPECT_TRUE(test::waitUntil([&] { return names().size() >= 4; }));
    shown = names();
    dialog.reject();
  });
  window->findChild<QAction*>(QStringLiteral("openFile"))->trigger();
  EXPECT_EQ(shown, (QStringList{QStringLiteral("1.2.840.113619.2.134"), QStringLiteral("I10A"),
                                QStringLiteral("IM000001"), QStringLiteral("small.nrrd")}));
}

TEST_F(OpeningWindow, theEmptyPageOffersWhatWasOpenedBefore) {
  ASSERT_TRUE(open(smallVolume("a")));
  QTest::keyClick(window.get(), Qt::Key_W, Qt::ControlModifier);
  ASSERT_FALSE(scene().volume);
  auto* recent = window->findChild<QPushButton*>(QStringLiteral("recent"));
  ASSERT_TRUE(recent && recent->isVisible());
  EXPECT_TRUE(recent->text().startsWith(QStringLiteral("small.nrrd"))) << recent->text().toStdString();
  QTest::mouseClick(recent, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  ASSERT_TRUE(scene().volume);
  EXPECT_EQ(scene().volume->grid().dims, glm::ivec3(2));
}

// A CT and an MR, which is smaller, in one folder; later perhaps another CT, the largest.
void writeSlices(const fs::path& folder, const char* modality, const std::string& series, int count) {
  fs::create_directories(folder);
  for (int i = 1; i <= count; ++i)
    test::slice(i, i)
        .text(0x00080018, "UI", series + "." + std::to_string(i))
        .text(0x0020000E, "UI", series)
        .text(0x00080060, "CS", modality)
        .write(folder / (series + "." + std::to_string(i)));
}

TEST_F(OpeningWindow, ofAFolderOfTwoTheSeriesIsOpenedAgainThatWasOpenedBefore) {
  const fs::path both = folder.path() / "both";
  writeSlices(both, "CT", "1.2.3.5", 4);
  writeSlices(both, "MR", "1.2.3.6", 3);
  const auto asked = [this]() -> SeriesDialog* {
    auto* dialog = window->findChild<SeriesDialog*>();
    return dialog && dialog->isVisible() ? dialog : nullptr;
  };
  const auto modality = [this] { return scene().volume ? scene().volume->info().modality : std::string(); };
  const auto openAgain = [this] {
    QTest::keyClick(window.get(), Qt::Key_W, Qt::ControlModifier);
    ASSERT_FALSE(scene().volume);
    auto* recent = window->findChild<QPushButton*>(QStringLiteral("recent"));
    ASSERT_TRUE(recent && recent->isVisible());
    EXPECT_TRUE(recent->text().contains(QStringLiteral("MR 3×2×3"))) << recent->text().toStdString();
    QTest::mouseClick(recent, Qt::LeftButton);
  };
  window->openSource(pathTo("both"));
  ASSERT_TRUE(test::waitUntil([&] { return asked(); }));
  QTest::keyClick(asked()->findChild<QTreeWidget*>(), Qt::Key_Down);
  for (QPushButton* button : asked()->findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Open"))
      QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([&] { return modality() == "MR"; }));
  openAgain();
  ASSERT_TRUE(test::waitUntil([&] { return scene().volume || asked(); }));
  EXPECT_FALSE(asked());
  EXPECT_EQ(modality(), "MR");
  // Its number is another's now.
  writeSlices(both, "CT", "1.2.3.7", 5);
  openAgain();
  ASSERT_TRUE(test::waitUntil([&] { return scene().volume || asked(); }));
  EXPECT_TRUE(asked());
}

TEST_F(OpeningWindow, olderUnsavedWorkStandsBehindWhatWasSavedLast) {
  const auto button = [this](const char* name) {
    return window->findChild<QPushButton*>(QLatin1String(name));
  };
  const auto startAgain = [this] {
    window->close();
    window = std::make_unique<MainWindow>(UserFolders::below(folder.path()));
    window->resize(1280, 800);
    window->show();
    window->keepSessions();
    QCoreApplication::processEvents();
  };
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  ASSERT_TRUE(open(QStringLiteral("phantom:6"))); // the one before is kept
  dragAPoint();
  saving().writeSession(pathTo("mine.limn.json"));
  startAgain();
  const QPushButton* unsaved = button("continue");
  const QPushButton* recent = button("recent");
  ASSERT_TRUE(unsaved->isVisible() && recent && recent->isVisible());
  static const QRegularExpression dated(QStringLiteral(R"(^Unsaved work:\n.+, \d+ \S+ \d{4}, \d\d:\d\d$)"));
  EXPECT_TRUE(unsaved->text().contains(dated)) << unsaved->text().toStdString();
  EXPECT_FALSE(unsaved->isDefault());
  EXPECT_TRUE(button("openFolder")->isDefault());
  EXPECT_TRUE(recent->text().startsWith(QStringLiteral("mine.limn.json"))) << recent->text().toStdString();
  EXPECT_GT(unsaved->mapTo(window.get(), QPoint()).y(), recent->mapTo(window.get(), QPoint()).y());
  // Opened and left again, it is the latest.
  QTest::mouseClick(button("continue"), Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] { return scene().volume && !window->loader().isLoading(); }));
  startAgain();
  ASSERT_TRUE(button("continue")->isVisible());
  EXPECT_TRUE(button("continue")->isDefault());
  EXPECT_FALSE(button("openFolder")->isDefault());
}

// An offer to restore what a crash left waits until that is read.
TEST_F(OpeningWindow, whatIsNoLongerThereIsSaidThoughARestoreIsOffered) {
  const QString file = smallVolume("a");
  ASSERT_TRUE(open(file));
  QTest::keyClick(window.get(), Qt::Key_W, Qt::ControlModifier);
  std::filesystem::remove(file.toStdString());
  auto& offer = *window->findChild<MessageBar*>(QStringLiteral("recoveryBar"));
  offer.show(MessageBar::Kind::question, QStringLiteral("Restore the last session?"));
  auto* recent = window->findChild<QPushButton*>(QStringLiteral("recent"));
  ASSERT_TRUE(recent && recent->isVisible());
  QTest::mouseClick(recent, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  EXPECT_TRUE(messages().isVisible());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("small.nrrd")))
      << messages().sentence().toStdString();
  messages().hide();
  EXPECT_TRUE(offer.isVisible()) << "the offer stands";
}

// Its drive may only be missing just now.
TEST_F(OpeningWindow, whatIsNoLongerThereStaysInTheListUntilItIsTakenOut) {
  const QString file = smallVolume("a");
  ASSERT_TRUE(open(file));
  ASSERT_TRUE(open(smallVolume("b")));
  const auto count = [this] {
    return Settings(UserFolders::below(folder.path()).settings).recentSources().size();
  };
  std::filesystem::rename(file.toStdString(), folder.path() / "unplugged");
  auto& menu = *window->findChild<QMenu*>(QStringLiteral("recentSources"));
  const auto openSecond = [&] {
    menu.popup(window->mapToGlobal(QPoint(20, 20)));
    menu.setActiveAction(menu.actions()[1]);
    QTest::keyClick(&menu, Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  };
  openSecond();
  ASSERT_TRUE(messages().isVisible());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("is not where it was")))
      << messages().sentence().toStdString();
  EXPECT_EQ(count(), 2);
  std::filesystem::rename(folder.path() / "unplugged", file.toStdString());
  openSecond();
  EXPECT_FALSE(messages().isVisible());
  std::filesystem::remove(file.toStdString());
  ASSERT_TRUE(open(file));
  choose("Remove from recent files");
  EXPECT_EQ(count(), 1);
  EXPECT_FALSE(messages().isVisible());
}

TEST_F(OpeningWindow, oneOfTheRecentFilesIsTakenOutByDelOrARightClick) {
  for (const char* place : {"a", "b", "c", "d"})
    ASSERT_TRUE(open(smallVolume(place)));
  const auto paths = [this] {
    QStringList found;
    for (const RecentSource& source : Settings(UserFolders::below(folder.path()).settings).recentSources())
      found << QFileInfo(source.path).dir().dirName();
    return found.join(QLatin1Char(' '));
  };
  ASSERT_EQ(paths(), QStringLiteral("d c b a"));
  auto& menu = *window->findChild<QMenu*>(QStringLiteral("recentSources"));
  menu.popup(window->mapToGlobal(QPoint(20, 20)));
  menu.setActiveAction(menu.actions()[1]);
  QTest::keyClick(&menu, Qt::Key_Delete);
  EXPECT_EQ(paths(), QStringLiteral("d b a"));
  EXPECT_TRUE(menu.isVisible());
  EXPECT_EQ(menu.activeAction(), menu.actions()[1]) << "the next one";
  QTest::mouseClick(&menu, Qt::RightButton, {}, menu.actionGeometry(menu.actions()[0]).center());
  auto* offer = menu.findChild<QMenu*>(QStringLiteral("removalOffer"));
  ASSERT_TRUE(offer && offer->isVisible());
  QTest::mouseClick(offer, Qt::LeftButton, {}, offer->actionGeometry(offer->actions()[0]).center());
  EXPECT_EQ(paths(), QStringLiteral("b a"));
  menu.close();
  EXPECT_FALSE(window->loader().isLoading()) << "a right click opens nothing";
  // On the page without a volume.
  QTest::keyClick(window.get(), Qt::Key_W, Qt::ControlModifier);
  auto* recent = window->findChild<QPushButton*>(QStringLiteral("recent"));
  ASSERT_TRUE(recent && recent->isVisible());
  recent->setFocus();
  QTest::keyClick(recent, Qt::Key_Delete);
  EXPECT_TRUE(test::waitUntil([&] { return paths() == QStringLiteral("a"); })) << paths().toStdString();
}

TEST_F(OpeningWindow, aForeignFileIsRefusedAndTheSentenceGoesWithTheNextStep) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  test::writeBytes(
      folder.path() / "vr.json",
      R"({"@schema": "https://raw.githubusercontent.com/Slicer/Slicer/markups-schema.json#", "markups": []})");
  ASSERT_TRUE(open(pathTo("vr.json")));
  EXPECT_TRUE(messages().isVisible());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("3D Slicer")))
      << messages().sentence().toStdString();
  window->resize(1380, 640); // every button fits
  QCoreApplication::processEvents();
  EXPECT_TRUE(messages().isVisible()) << "the camera that follows the window is no step";
  clickTool(QStringLiteral("Single"));
  EXPECT_FALSE(messages().isVisible());
  ASSERT_TRUE(open(pathTo("vr.json")));
  EXPECT_TRUE(messages().isVisible());
  dragAPoint();
  EXPECT_FALSE(messages().isVisible());
}

} // namespace
} // namespace limn
