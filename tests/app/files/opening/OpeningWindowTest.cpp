// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/opening/OpeningWindow.h"
#include "app/asking/FileDialogs.h"
#include "app/files/saving/PictureDialog.h"
#include "io/dicom/SyntheticSeries.h"
#include "scene/framing/Framing.h"
#include "support/ShortVolume.h"

#include <QTreeView>

#include <sys/inotify.h>
#include <unistd.h>

// What the window remembers of what was opened, and where it looks and asks for it, in the window.

namespace limn {
namespace {

namespace fs = std::filesystem;

using OpeningWindow = test::OpeningWindow;

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
}

// One on a share that does not answer would block the window. Without an ending only its bytes say what it
// is.
TEST_F(OpeningWindow, aDialogOpensNoFileThatItLists) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const fs::path listed = folder.path() / "IM0001";
  test::writeBytes(listed, "DICM");
  const int watch = ::inotify_init1(IN_NONBLOCK);
  ASSERT_GE(::inotify_add_watch(watch, listed.c_str(), IN_OPEN), 0);
  char event[4096];
  const auto wasOpened = [&] { return ::read(watch, event, sizeof event) > 0; };
  test::bytesOfFile(listed);
  ASSERT_TRUE(wasOpened()) << "the watch tells";
  Settings settings(UserFolders::below(folder.path()).settings);
  settings.setDialogFolder(QString::fromStdString(folder.path().string()));
  bool isListed = false;
  onceAsked<QFileDialog>([&](QFileDialog& dialog) {
    auto* files = dialog.findChild<QTreeView*>(QStringLiteral("treeView")); // as Qt calls it
    const auto rowOfIt = [files] {
      const QAbstractItemModel& model = *files->model();
      for (int row = 0; row < model.rowCount(files->rootIndex()); ++row)
        if (const QModelIndex one = model.index(row, 0, files->rootIndex());
            one.data().toString() == QStringLiteral("IM0001"))
          return one;
      return QModelIndex();
    };
    isListed = test::waitUntil([&] { return rowOfIt().isValid(); });
    // All that is shown of it: icon, size, kind and date.
    for (int column = 0; isListed && column < files->model()->columnCount(files->rootIndex()); ++column) {
      const QModelIndex shown = rowOfIt().siblingAtColumn(column);
      shown.data(Qt::DecorationRole);
      shown.data();
    }
    files->grab();
    dialog.reject();
  });
  askForPaths(window.get(), {.title = QStringLiteral("Open")}, settings);
  EXPECT_TRUE(isListed);
  EXPECT_FALSE(wasOpened());
  ::close(watch);
}

// Somebody who drops a volume into the window looks for its labels beside it.
TEST_F(OpeningWindow, dialogsOpenBesideWhatWasOpenedWithoutThem) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  typeName(smallVolume("a"));
  QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  ASSERT_TRUE(open(smallVolume("c")));
  EXPECT_EQ(folderOfNextDialog(), pathTo("c"));
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  EXPECT_EQ(folderOfNextDialog(), pathTo("c")) << "the sample lies nowhere";
}

TEST_F(OpeningWindow, theDialogForLabelsOpensWhereTheLastOneEndedToo) {
  ASSERT_TRUE(open(smallVolume("a")));
  const QString labels = smallVolume("labels", "0 1 0 1 0 1 0 1");
  onceAsked<QFileDialog>([&labels](QFileDialog& dialog) {
    QLineEdit* name = nameIn(dialog);
    ASSERT_NE(name, nullptr);
    name->setText(labels);
    QTest::keyClick(name, Qt::Key_Return);
  });
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
      QLineEdit* name = nameIn(dialog);
      ASSERT_NE(name, nullptr);
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
