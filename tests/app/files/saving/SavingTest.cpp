// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/asking/FileDialogs.h"
#include "io/ImageFile.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "support/FileBytes.h"

#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <utility>

// What is asked and said when something is saved, in the window.

namespace limn {
namespace {

namespace fs = std::filesystem;

class Saving : public test::WindowHarness {
protected:
  QToolButton& stop() const { return *window->findChild<QToolButton*>(QStringLiteral("stopWaiting")); }

  MessageBar& bar(const char* name) const {
    return *window->findChild<MessageBar*>(QString::fromLatin1(name));
  }
};

TEST(SaveNames, getTheChosenKindsEndingUnlessOneIsTyped) {
  const QStringList session{QStringLiteral("Limn session (*.json)")};
  EXPECT_EQ(withEnding("/a/mine", session, session[0]), "/a/mine.json");
  EXPECT_EQ(withEnding("/a/mine.", session, session[0]), "/a/mine.json");
  EXPECT_EQ(withEnding("/a.b/mine.v2", session, session[0]), "/a.b/mine.v2.json");
  EXPECT_EQ(withEnding("/a/mine.JSON", session, session[0]), "/a/mine.JSON");
  const QStringList pictures{QStringLiteral("Pictures (*.png *.tif)"), QStringLiteral("Table (*.csv)")};
  EXPECT_EQ(withEnding("/a/head 1.5", pictures, pictures[0]), "/a/head 1.5.png");
  EXPECT_EQ(withEnding("/a/head", pictures, pictures[1]), "/a/head.csv");
  EXPECT_EQ(withEnding("/a/head.tif", pictures, pictures[1]), "/a/head.tif");
  EXPECT_EQ(withEnding("/a/head.bmp", pictures, pictures[0]), "/a/head.bmp"); // refused by whoever writes
  EXPECT_EQ(withEnding("", session, session[0]), "");
  const QStringList own{QStringLiteral("Limn session (*.limn.json)"),
                        QStringLiteral("Any JSON file (*.json)")};
  EXPECT_EQ(withEnding("/a/mine", own, own[0]), "/a/mine.limn.json");
  EXPECT_EQ(withEnding("/a/mine.limn.json", own, own[0]), "/a/mine.limn.json");
  EXPECT_EQ(withEnding("/a/mine.json", own, own[0]), "/a/mine.json"); // as earlier versions named them
}

TEST_F(Saving, aSessionNamedWithoutEndingOpensAgain) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  const SessionDocument before = window->sessionDocument();
  typeName(pathTo("mysession"));
  QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_FALSE(fs::exists(folder.path() / "mysession"));
  ASSERT_TRUE(fs::exists(folder.path() / "mysession.limn.json"));
  const QList<RecentSource> recent = Settings(UserFolders::below(folder.path()).settings).recentSources();
  ASSERT_FALSE(recent.isEmpty());
  EXPECT_EQ(recent.front().path, pathTo("mysession.limn.json")) << "listed as soon as it is saved";
  EXPECT_TRUE(recent.front().label.startsWith(QStringLiteral("mysession.limn.json · ")))
      << recent.front().label.toStdString();
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(open(pathTo("mysession.limn.json")));
  EXPECT_EQ(window->sessionDocument(), before);
  // One that an earlier version wrote without.
  fs::rename(folder.path() / "mysession.limn.json", folder.path() / "mysession");
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(open(pathTo("mysession")));
  EXPECT_EQ(window->sessionDocument(), before);
}

TEST_F(Saving, theFileOfTheWholeNameIsReplacedOnlyWhereTheUserSaysSo) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  test::writeBytes(folder.path() / "mine.limn.json", "old");
  typeName(pathTo("mine"));
  bool isAsked = false;
  onceAsked<QMessageBox>([&](QMessageBox& box) {
    isAsked = true;
    onceAsked<QFileDialog>([](QFileDialog& again) { again.reject(); }); // for another name
    box.reject();
  });
  action(QStringLiteral("Save session &as…"))->trigger();
  EXPECT_TRUE(isAsked);
  EXPECT_EQ(test::bytesOfFile(folder.path() / "mine.limn.json"), "old");
  typeName(pathTo("mine"));
  onceAsked<QMessageBox>([](QMessageBox& box) {
    for (QAbstractButton* button : box.buttons())
      if (box.buttonRole(button) == QMessageBox::AcceptRole)
        return QTest::mouseClick(button, Qt::LeftButton);
  });
  action(QStringLiteral("Save session &as…"))->trigger();
  EXPECT_NE(test::bytesOfFile(folder.path() / "mine.limn.json"), "old");
}

TEST_F(Saving, theKeysOfOtherProgramsSaveTheSessionUnderAnotherName) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(rest());
  typeName(pathTo("another"));
  QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(fs::exists(folder.path() / "another.limn.json"));
  EXPECT_FALSE(fs::exists(folder.path() / "another.png"));
}

TEST_F(Saving, aPictureIsAskedForAtOnceAndSavedOnceItIsComplete) {
  ASSERT_TRUE(open(QStringLiteral("phantom:2")));
  ASSERT_FALSE(view().pictureState().resting);
  onceAsked<PictureDialog>([](PictureDialog& dialog) { dialog.accept(); });
  typeName(pathTo("mypicture"));
  QTest::keyClick(window.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(test::waitUntil([this] { return fs::exists(folder.path() / "mypicture.png"); }));
  EXPECT_TRUE(view().pictureState().resting);
  EXPECT_FALSE(stop().isVisible());
  EXPECT_FALSE(readImageDescription(folder.path() / "mypicture.png").empty());
}

TEST_F(Saving, aPictureKnowsItsSizeSoThatItIsDrawnAgainAsLarge) {
  setLayout(CompareLayout::single); // of two each has its own size
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(rest());
  for (const auto& [name, size] : {std::pair("shown.png", PictureOptions::Size::screen),
                                   std::pair("twice.png", PictureOptions::Size::twice)}) {
    PictureOptions options;
    options.size = size;
    saving().writePicture(pathTo(name), options);
    ASSERT_TRUE(test::waitUntil([&] { return !stop().isVisible() && isWholePicture(folder.path() / name); }));
    const ImageSettings image = parseScene(readImageDescription(folder.path() / name), name).scene.image;
    EXPECT_EQ(QSize(image.width, image.height), QImage(pathTo(name)).size()) << name;
  }
}

TEST_F(Saving, whoeverNoLongerWantsThePictureCancels) {
  ASSERT_TRUE(open(QStringLiteral("phantom:2")));
  ASSERT_FALSE(view().pictureState().resting);
  onceAsked<PictureDialog>([](PictureDialog& dialog) { dialog.accept(); });
  typeName(pathTo("mypicture"));
  action(QStringLiteral("Save &picture…"))->trigger();
  if (view().pictureState().resting)
    GTEST_SKIP() << "the picture was complete before its name was typed";
  ASSERT_TRUE(stop().isVisible());
  QTest::mouseClick(&stop(), Qt::LeftButton);
  ASSERT_TRUE(rest());
  EXPECT_FALSE(stop().isVisible());
  EXPECT_FALSE(fs::exists(folder.path() / "mypicture.png"));
}

// It is waited for no picture that has no place.
TEST_F(Saving, whatCannotBeWrittenIsRefusedBeforeItIsDrawn) {
  ASSERT_TRUE(open(QStringLiteral("phantom:2")));
  for (const auto& [name, sentence] :
       {std::pair("none/mypicture.png", "there is no folder"), std::pair("mypicture.bmp", "ending")}) {
    messages().hide();
    onceAsked<PictureDialog>([](PictureDialog& dialog) { dialog.accept(); });
    typeName(pathTo(name));
    action(QStringLiteral("Save &picture…"))->trigger();
    EXPECT_FALSE(stop().isVisible()) << name;
    ASSERT_TRUE(messages().isVisible()) << name;
    EXPECT_TRUE(messages().sentence().contains(QString::fromLatin1(sentence)))
        << messages().sentence().toStdString();
  }
}

// /proc takes no files of anybody, whatever its rights say.
TEST_F(Saving, aFolderThatRefusesIsNotWhereTheNextDialogBegins) {
  Settings settings(UserFolders::below(folder.path()).settings);
  const SaveQuestion question{.title = QStringLiteral("Save"),
                              .suggested = QStringLiteral("mine"),
                              .filters = {QStringLiteral("Table (*.csv)")}};
  for (const QString& chosen : {pathTo("mine"), QStringLiteral("/proc/mine")}) {
    typeName(chosen);
    EXPECT_EQ(askWhereToSave(window.get(), question, settings), chosen + QStringLiteral(".csv"));
  }
  QString begins;
  onceAsked<QFileDialog>([&begins](QFileDialog& dialog) {
    begins = dialog.directory().absolutePath();
    dialog.reject();
  });
  askWhereToSave(window.get(), question, settings);
  EXPECT_EQ(begins, QString::fromStdString(folder.path().string()));
}

TEST_F(Saving, aFailureIsForgottenOnceSomethingIsSaved) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  saving().writeSession(pathTo("none/mine.json"));
  ASSERT_TRUE(messages().isVisible());
  saving().writeSession(pathTo("mine.limn.json"));
  EXPECT_FALSE(messages().isVisible());
  // Another message stays.
  saving().writeSession(pathTo("none/mine.json"));
  ASSERT_TRUE(open(pathTo("missing.nii")));
  saving().writeSession(pathTo("mine.limn.json"));
  EXPECT_TRUE(messages().isVisible());
}

TEST_F(Saving, thatWorkIsNotSafeIsSaidAsLongAsItIsTrue) {
  window->keepSessions();
  const fs::path places = folder.path() / "sessions" / "windows";
  const fs::path place = fs::directory_iterator(places)->path();
  fs::rename(places, folder.path() / "elsewhere");
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  MessageBar& unsafe = bar("unsafeBar");
  ASSERT_TRUE(test::waitUntil([&] { return unsafe.isVisible(); }));
  saving().writeScene(pathTo("none/scene.json"));
  EXPECT_TRUE(unsafe.isVisible()) << "one at a time: what may lose work goes first";
  EXPECT_TRUE(messages().isWanted());
  EXPECT_FALSE(messages().isVisible());
  saving().writeScene(pathTo("scene.json"));
  EXPECT_FALSE(messages().isWanted());
  // There is room again, although nothing changes.
  fs::rename(folder.path() / "elsewhere", places);
  EXPECT_TRUE(test::waitUntil([&] { return !unsafe.isVisible(); }));
  EXPECT_TRUE(fs::exists(place / "session.json"));
}

TEST_F(Saving, aRelativePathIsRememberedWhole) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  saving().writeScene(pathTo("scene.json"));
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  const bool opened = open(QStringLiteral("scene.json"));
  fs::current_path(before);
  ASSERT_TRUE(opened);
  ASSERT_TRUE(open(pathTo("scene.json")));
  QStringList paths;
  for (const RecentSource& source : Settings(UserFolders::below(folder.path()).settings).recentSources())
    paths << source.path;
  EXPECT_EQ(paths, QStringList({pathTo("scene.json"), QStringLiteral("phantom:4")}));
}

TEST_F(Saving, aMovedVolumeIsMissedByWhereItShouldBeWithoutWordsOfTheCommandLine) {
  test::writeBytes(folder.path() / "scene.json", R"({"limn_scene": 1, "volume": "data/head.nii"})");
  ASSERT_TRUE(open(pathTo("scene.json")));
  EXPECT_TRUE(messages().sentence().contains(pathTo("data/head.nii"))) << messages().sentence().toStdString();
  EXPECT_FALSE(messages().sentence().contains(QStringLiteral("--volume")));
}

} // namespace
} // namespace limn
