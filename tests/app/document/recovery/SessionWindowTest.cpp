// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/EndSignals.h"
#include "app/asking/FileDialogs.h"
#include "app/document/recovery/KeepingWindow.h"
#include "support/FileBytes.h"
#include "support/ShortVolume.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/presets/PresetBrowser.h"

#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>
#include <QTimer>

#include <csignal>
#include <fstream>

// The session as a file, and that none is lost, in the window.

namespace limn {
namespace {

namespace fs = std::filesystem;

class SessionWindow : public test::KeepingWindow {
protected:
  // The button of the bar that offers a lost session; null where none is offered.
  static QToolButton* offer(const MainWindow& of, const QString& text) {
    for (const MessageBar* bar : of.findChildren<MessageBar*>())
      for (QToolButton* button : bar->findChildren<QToolButton*>())
        if (bar->isVisible() && button->isVisible() && button->text() == text)
          return button;
    return nullptr;
  }

  [[nodiscard]] static bool restore(MainWindow& in) {
    QToolButton* button = offer(in, QStringLiteral("Restore"));
    if (!button)
      return false;
    QTest::mouseClick(button, Qt::LeftButton);
    return test::waitUntil([&] { return !in.loader().isLoading(); });
  }

  void save() { action(QStringLiteral("&Save session"))->trigger(); }

  // Answers, once it is asked, what becomes of a session file that another window has changed.
  void answerChanged(QMessageBox::ButtonRole role) {
    onceAsked<QMessageBox>([role](QMessageBox& box) {
      EXPECT_EQ(box.objectName(), QStringLiteral("changedSession"));
      EXPECT_TRUE(box.text().contains(QStringLiteral("mine.json"))) << box.text().toStdString();
      for (QAbstractButton* button : box.buttons())
        if (box.buttonRole(button) == role)
          return QTest::mouseClick(button, Qt::LeftButton);
      ADD_FAILURE() << "no such button";
    });
  }

  // Edits by mouse, and leaves the window in an unusual arrangement.
  void workALittle() {
    dragAPoint();
    clickTool(QStringLiteral("Wipe"));
    window->view().setWipePosition(0.25);
    emit window->view().modelChosen(1, ShadingModel::robust);
    action(QStringLiteral("&Crop box"))->trigger();
    window->findChild<QDockWidget*>(QStringLiteral("effectsDock"))->raise();
    QTest::keyClick(&view(), Qt::Key_L);
    QCoreApplication::processEvents();
  }
};

TEST_F(SessionWindow, aSavedSessionComesBackAsItWas) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  workALittle();
  EXPECT_TRUE(window->isWindowModified());
  const SessionDocument before = window->sessionDocument();
  EXPECT_EQ(before.layout, CompareLayout::wipe);
  EXPECT_EQ(before.rightModel, ShadingModel::robust);
  EXPECT_EQ(before.panel, SessionDocument::Panel::effects);
  EXPECT_TRUE(before.cropBoxIsShown);
  saving().writeSession(pathTo("mine.json"));
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_TRUE(window->windowTitle().startsWith(QStringLiteral("mine.json")));

  window = newWindow();
  ASSERT_TRUE(open(pathTo("mine.json")));
  EXPECT_EQ(window->sessionDocument(), before);
  EXPECT_TRUE(window->windowTitle().startsWith(QStringLiteral("mine.json")));
  EXPECT_FALSE(window->isWindowModified());
  // An edit marks it, taking it back unmarks it.
  dragAPoint();
  EXPECT_TRUE(window->isWindowModified());
  undo().undo();
  EXPECT_FALSE(window->isWindowModified());
}

// What was brought back is unsaved until it is saved; what is opened after it has no edit.
TEST_F(SessionWindow, whatIsOpenedAfterAnUnsavedSessionIsUnmarked) {
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  workALittle();
  ASSERT_TRUE(waitForAutosave());
  die();
  window = newWindow();
  window->keepSessions();
  ASSERT_TRUE(restore(*window));
  ASSERT_TRUE(window->isWindowModified());
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  EXPECT_FALSE(window->isWindowModified());
}

// What Ctrl+S will write to is named before it is restored, and while it is open.
TEST_F(SessionWindow, whatADeadWindowLeftNamesTheFileThatItWasSavedTo) {
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  saving().writeSession(pathTo("mine.json"));
  const std::string saved = test::bytesOfFile(folder.path() / "mine.json");
  const QString title = window->windowTitle();
  workALittle();
  ASSERT_TRUE(waitForAutosave());
  die();
  window = newWindow();
  window->keepSessions();
  const QToolButton* button = offer(*window, QStringLiteral("Restore"));
  ASSERT_NE(button, nullptr);
  QStringList said;
  for (const QLabel* label : button->parentWidget()->findChildren<QLabel*>())
    said << label->text();
  EXPECT_TRUE(said.join(QLatin1Char(' ')).contains(QStringLiteral("mine.json")))
      << said.join(QLatin1Char(' ')).toStdString();
  ASSERT_TRUE(restore(*window));
  EXPECT_EQ(window->windowTitle(), title);
  EXPECT_TRUE(title.startsWith(QStringLiteral("mine.json"))) << title.toStdString();
  EXPECT_TRUE(window->isWindowModified());
  EXPECT_EQ(test::bytesOfFile(folder.path() / "mine.json"), saved) << "restoring writes nothing there";
}

TEST_F(SessionWindow, savingAgainAsksForNoName) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  saving().writeSession(pathTo("mine.json"));
  const std::string first = test::bytesOfFile(folder.path() / "mine.json");
  dragAPoint();
  action(QStringLiteral("&Save session"))->trigger();
  EXPECT_NE(test::bytesOfFile(folder.path() / "mine.json"), first);
  EXPECT_FALSE(window->isWindowModified());
}

// Of two windows with one session the second to save would take away what the first one saved.
TEST_F(SessionWindow, aSessionThatAnotherWindowSavedMeanwhileIsReplacedOnlyWhereTheUserSaysSo) {
  const fs::path file = folder.path() / "mine.json";
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  saving().writeSession(pathTo("mine.json"));
  std::unique_ptr<MainWindow> other = newWindow();
  std::swap(window, other);
  ASSERT_TRUE(open(pathTo("mine.json")));
  std::swap(window, other);
  dragAPoint();
  save(); // asks nothing: nobody has changed it
  const std::string ofTheFirst = test::bytesOfFile(file);

  std::swap(window, other);
  action(QStringLiteral("&Crop box"))->trigger();
  answerChanged(QMessageBox::RejectRole);
  save();
  EXPECT_EQ(test::bytesOfFile(file), ofTheFirst) << "cancelled";
  answerChanged(QMessageBox::AcceptRole);
  typeName(pathTo("another.json"));
  save();
  EXPECT_EQ(test::bytesOfFile(file), ofTheFirst) << "saved under another name";
  EXPECT_TRUE(fs::exists(folder.path() / "another.json"));
  EXPECT_TRUE(window->windowTitle().startsWith(QStringLiteral("another.json")));

  ASSERT_TRUE(open(pathTo("mine.json")));
  std::swap(window, other);
  action(QStringLiteral("&Crop box"))->trigger();
  save();
  const std::string again = test::bytesOfFile(file);
  std::swap(window, other);
  answerChanged(QMessageBox::DestructiveRole);
  save();
  EXPECT_NE(test::bytesOfFile(file), again) << "replaced";
  const std::string replaced = test::bytesOfFile(file);
  save(); // what this window wrote is no change of another
  EXPECT_EQ(test::bytesOfFile(file), replaced);
  fs::remove(file);
  save(); // nothing there is lost
  EXPECT_TRUE(fs::exists(file));
}

// Of what is saved beside it the name is another, or it would be asked whether to replace it once more.
TEST_F(SessionWindow, besideASessionThatChangedMeanwhileAFreeNameIsSuggested) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  saving().writeSession(pathTo("mine.json"));
  const fs::path file = folder.path() / "mine.json";
  test::writeBytes(file, test::bytesOfFile(file) + "\n");
  const auto suggested = [this] {
    QString name;
    answerChanged(QMessageBox::AcceptRole);
    onceAsked<QFileDialog>([&name](QFileDialog& dialog) {
      name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->text();
      dialog.reject();
    });
    save();
    return name;
  };
  EXPECT_EQ(suggested(), QStringLiteral("mine 2.json"));
  test::writeBytes(folder.path() / "mine 2.json", "taken");
  EXPECT_EQ(suggested(), QStringLiteral("mine 3.json"));
  EXPECT_EQ(freePathBeside(pathTo("mine 2.json")), pathTo("mine 3.json"));
  EXPECT_EQ(freePathBeside(pathTo("head.limn.json")), pathTo("head 2.limn.json"));
  EXPECT_EQ(freePathBeside(pathTo("head 2024.json")), pathTo("head 2024 2.json"));
}

// What a crash left knows which state of its file it came from.
TEST_F(SessionWindow, whatIsRestoredAsksBeforeItReplacesAFileThatWasSavedMeanwhile) {
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  saving().writeSession(pathTo("mine.json"));
  workALittle();
  ASSERT_TRUE(waitForAutosave());
  die();
  const fs::path file = folder.path() / "mine.json";
  const std::string meanwhile = test::bytesOfFile(file) + "\n";
  test::writeBytes(file, meanwhile);
  window = newWindow();
  window->keepSessions();
  ASSERT_TRUE(restore(*window));
  answerChanged(QMessageBox::RejectRole);
  save();
  EXPECT_EQ(test::bytesOfFile(file), meanwhile);
}

TEST_F(SessionWindow, whatADeadWindowLeftIsOfferedOnceAndComesBackAsItWas) {
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  workALittle();
  ASSERT_TRUE(waitForAutosave());
  const SessionDocument before = window->sessionDocument();
  // A second window beside it is offered nothing: the first lives.
  auto second = newWindow();
  second->keepSessions();
  EXPECT_EQ(offer(*second, QStringLiteral("Restore")), nullptr);
  die();
  window = newWindow();
  window->keepSessions();
  ASSERT_NE(offer(*window, QStringLiteral("Restore")), nullptr);
  auto third = newWindow();
  third->keepSessions();
  EXPECT_EQ(offer(*third, QStringLiteral("Restore")), nullptr);

  ASSERT_TRUE(restore(*window));
  EXPECT_EQ(window->sessionDocument(), before);
  EXPECT_TRUE(window->isWindowModified());
  EXPECT_EQ(offer(*window, QStringLiteral("Restore")), nullptr);
  EXPECT_EQ(autosaved().size(), 1u); // now this window's own
  die();
  window = newWindow();
  window->keepSessions();
  EXPECT_NE(offer(*window, QStringLiteral("Restore")), nullptr);
}

TEST_F(SessionWindow, anOfferThatNobodyAnswersIsMadeAgainAndADiscardedOneIsNot) {
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  ASSERT_TRUE(waitForAutosave());
  die();
  window = newWindow();
  window->keepSessions();
  ASSERT_NE(offer(*window, QStringLiteral("Discard")), nullptr);
  window->close();
  window = newWindow();
  window->keepSessions();
  QToolButton* discard = offer(*window, QStringLiteral("Discard"));
  ASSERT_NE(discard, nullptr);
  QTest::mouseClick(discard, Qt::LeftButton);
  EXPECT_EQ(offer(*window, QStringLiteral("Discard")), nullptr);
  EXPECT_TRUE(autosaved().empty());
}

TEST_F(SessionWindow, lookingAtAVolumeLeavesNothingToRestore) {
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(rest());
  window->close();
  EXPECT_TRUE(autosaved().empty());
  EXPECT_FALSE(fs::exists(sessions() / "closed"));
}

TEST_F(SessionWindow, aSignalToEndKeepsWhatIsUnsavedAsClosingDoes) {
  const EndSignals ends;
  QObject::connect(&ends, &EndSignals::endAsked, &ends, [this] { window->endUnasked(); });
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  ASSERT_TRUE(waitForAutosave());
  std::raise(SIGTERM);
  ASSERT_TRUE(test::waitUntil([this] { return !window->isVisible(); }));
  EXPECT_TRUE(autosaved().empty());
  window = newWindow();
  window->keepSessions();
  EXPECT_EQ(offer(*window, QStringLiteral("Restore")), nullptr) << "it did not crash";
  EXPECT_EQ(UnsavedSessions(sessions()).kept().size(), 1u);
}

TEST_F(SessionWindow, aSignalToEndLeavesNothingWhereNothingIsUnsaved) {
  const EndSignals ends;
  QObject::connect(&ends, &EndSignals::endAsked, &ends, [this] { window->endUnasked(); });
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  std::raise(SIGTERM);
  ASSERT_TRUE(test::waitUntil([this] { return !window->isVisible(); }));
  window = newWindow();
  window->keepSessions();
  EXPECT_EQ(offer(*window, QStringLiteral("Restore")), nullptr);
  EXPECT_TRUE(UnsavedSessions(sessions()).kept().empty());
}

// Closing asks about a picture that is in no file; nobody is there to answer once the system ends.
TEST_F(SessionWindow, aSignalToEndWhileClosingAsksKeepsAllThatClosingDoes) {
  const auto isArrangementKept = [this] {
    return !Settings(UserFolders::below(folder.path()).settings).windowGeometry().isEmpty();
  };
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")) && rest());
  dragAPoint();
  PictureOptions options;
  options.size = PictureOptions::Size::twice;
  ASSERT_TRUE(rest());
  saving().writePicture(pathTo("gone/picture.png"), options);
  ASSERT_TRUE(test::waitUntil([this] { return !saving().unwritten().isEmpty(); }));
  ASSERT_FALSE(isArrangementKept());
  bool isAsked = false;
  onceAsked<QMessageBox>([&](QMessageBox& box) {
    isAsked = box.objectName() == QStringLiteral("stillDrawing");
    window->endUnasked();
    box.reject(); // as the end of the event loop does
  });
  window->close();
  EXPECT_TRUE(isAsked);
  EXPECT_FALSE(window->isVisible());
  EXPECT_TRUE(isArrangementKept());
  window = newWindow();
  window->keepSessions();
  EXPECT_EQ(offer(*window, QStringLiteral("Restore")), nullptr) << "it did not crash";
  EXPECT_EQ(UnsavedSessions(sessions()).kept().size(), 1u);
}

TEST_F(SessionWindow, closingWithUnsavedChangesAsksNothingAndLosesNothing) {
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  const TransferFunction edited = scene().transferFunction;
  EXPECT_TRUE(window->close());
  EXPECT_TRUE(autosaved().empty());
  window = newWindow();
  window->keepSessions();
  EXPECT_EQ(offer(*window, QStringLiteral("Restore")), nullptr); // nothing ended unexpectedly
  auto* menu = window->findChild<QMenu*>(QStringLiteral("unsavedSessions"));
  ASSERT_NE(menu, nullptr);
  emit static_cast<QMenu*>(menu->parent())->aboutToShow();
  ASSERT_EQ(menu->actions().size(), 1);
  menu->actions().front()->trigger();
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  EXPECT_EQ(scene().transferFunction, edited);
  EXPECT_TRUE(window->isWindowModified());
}

TEST_F(SessionWindow, whatWasLeftUnsavedIsOneKeyAwayOnTheEmptyPage) {
  window->keepSessions();
  auto* offered = window->findChild<QPushButton*>(QStringLiteral("continue"));
  EXPECT_FALSE(offered->isVisible());
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  workALittle();
  const SessionDocument before = window->sessionDocument();
  window->close();
  window = newWindow();
  window->keepSessions();
  window->activateWindow();
  offered = window->findChild<QPushButton*>(QStringLiteral("continue"));
  ASSERT_TRUE(offered->isVisible());
  EXPECT_TRUE(offered->text().startsWith(QStringLiteral("Unsaved work:\n"))) << offered->text().toStdString();
  ASSERT_TRUE(test::waitUntil([&] { return offered->hasFocus(); }));
  QTest::keyClick(offered, Qt::Key_Return);
  ASSERT_TRUE(test::waitUntil([&] { return scene().volume != nullptr; }));
  EXPECT_EQ(window->sessionDocument(), before);
  // A volume that is closed with changes is on offer at once, and one without is not.
  action(QStringLiteral("&Close volume"))->trigger();
  EXPECT_TRUE(offered->isVisible());
  QTest::mouseClick(offered, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([&] { return scene().volume != nullptr; }));
  saving().writeSession(pathTo("mine.json"));
  action(QStringLiteral("&Close volume"))->trigger();
  EXPECT_TRUE(window->findChild<QPushButton*>(QStringLiteral("openFolder"))->isVisible());
  EXPECT_FALSE(offered->isVisible());
}

// It alone has the labels then.
TEST_F(SessionWindow, whatWasLeftUnsavedStaysKeptWhereItOpensInPartAlone) {
  const fs::path labels = folder.path() / "parts.nrrd", away = folder.path() / "away.nrrd";
  test::writeShorts(folder.path() / "box.nrrd", 12,
                    [](const glm::ivec3& v) { return v.x < 6 ? -1000 : 900; });
  test::writeShorts(labels, 12, [](const glm::ivec3& v) { return v.x < 6 ? 0 : 1; });
  const auto isLabelled = [this] { return scene().keep.kind == Region::Kind::labels; };
  const auto kept = [this] {
    auto* menu = window->findChild<QMenu*>(QStringLiteral("unsavedSessions"));
    emit static_cast<QMenu*>(menu->parent())->aboutToShow();
    return menu->actions();
  };
  window->keepSessions();
  ASSERT_TRUE(open(pathTo("box.nrrd")));
  typeName(pathTo("parts.nrrd"));
  window->findChild<QAction*>(QStringLiteral("openLabels"))->trigger();
  ASSERT_TRUE(test::waitUntil(isLabelled));
  EXPECT_TRUE(window->close());
  fs::rename(labels, away);
  window = newWindow();
  window->keepSessions();
  ASSERT_EQ(kept().size(), 1);
  kept().front()->trigger();
  QToolButton* without = nullptr;
  ASSERT_TRUE(test::waitUntil(
      [&] { return (without = offer(*window, QStringLiteral("Open without labels"))) != nullptr; }));
  QTest::mouseClick(without, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] { return scene().volume != nullptr; }));
  EXPECT_FALSE(isLabelled());
  ASSERT_EQ(kept().size(), 1);
  fs::rename(away, labels);
  kept().front()->trigger();
  EXPECT_TRUE(test::waitUntil(isLabelled));
}

// The page that offers it is not seen where a volume is named on the command line.
TEST_F(SessionWindow, whatWasLeftUnsavedIsOfferedBesideAVolumeThatIsNamedAtTheStart) {
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  const TransferFunction edited = scene().transferFunction;
  ASSERT_TRUE(open(QStringLiteral("phantom:6"))); // kept later, of another volume
  dragAPoint();
  window->close();
  window = newWindow();
  window->keepSessions();
  window->openNamed(QStringLiteral("phantom:4"));
  ASSERT_TRUE(test::waitUntil([this] { return scene().volume && !window->loader().isLoading(); }));
  EXPECT_NE(scene().transferFunction, edited);
  auto* bar = window->findChild<MessageBar*>(QStringLiteral("keptBar"));
  ASSERT_TRUE(bar->isWanted());
  for (MessageBar* other : window->findChildren<MessageBar*>())
    if (other != bar)
      other->hide();
  ASSERT_TRUE(test::waitUntil([&] { return bar->isVisible(); }));
  EXPECT_TRUE(bar->sentence().startsWith(QStringLiteral("Your earlier work on this volume (")))
      << bar->sentence().toStdString();
  QTest::mouseClick(bar->findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  EXPECT_TRUE(test::waitUntil([&] { return scene().transferFunction == edited; })) << "that of this volume";
}

TEST_F(SessionWindow, openingAnotherVolumeKeepsTheUnsavedSession) {
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  ASSERT_TRUE(open(QStringLiteral("phantom:5")));
  EXPECT_EQ(test::entriesOf(sessions() / "closed"), 1u);
}

// Each time, in one sentence that goes by itself, with the way back.
TEST_F(SessionWindow, whatAnotherVolumeReplacesIsSaidToBeKeptAndComesBack) {
  window->keepSessions();
  const auto bar = [this] { return window->findChild<MessageBar*>(QStringLiteral("keptBar")); };
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  EXPECT_FALSE(bar()->isWanted()) << "nothing was changed";
  dragAPoint();
  const TransferFunction edited = scene().transferFunction;
  const auto volume = scene().volume->grid().dims;
  ASSERT_TRUE(open(QStringLiteral("phantom:5")));
  ASSERT_TRUE(bar()->isVisible());
  EXPECT_TRUE(bar()->sentence().startsWith(QStringLiteral("Your work on ")) &&
              bar()->sentence().endsWith(QStringLiteral(" is kept.")))
      << bar()->sentence().toStdString();
  EXPECT_TRUE(bar()->sentence().contains(QStringLiteral("%1×").arg(volume.x)))
      << bar()->sentence().toStdString();
  EXPECT_TRUE(bar()->findChild<QTimer*>()->isActive()) << "it goes by itself";
  dragAPoint();
  const TransferFunction other = scene().transferFunction;
  for (const TransferFunction& expected : {edited, other}) {
    QTest::mouseClick(bar()->findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
    ASSERT_TRUE(test::waitUntil([&] { return scene().transferFunction == expected; }));
    EXPECT_TRUE(window->isWindowModified());
    ASSERT_TRUE(bar()->isVisible()) << "what was left for it is kept in its turn";
  }
  saving().writeSession(pathTo("mine.json"));
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  EXPECT_FALSE(bar()->isWanted()) << "it is saved";
}

TEST_F(SessionWindow, whatIsSaidOfTheOpenedVolumeComesBeforeWhatIsKept) {
  test::writeBytes(folder.path() / "plain.nrrd",
                   "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n\n" +
                       std::string(63, '\0') + '\x50');
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  ASSERT_TRUE(open(pathTo("plain.nrrd")));
  EXPECT_NE(offer(*window, QStringLiteral("Set spacing…")), nullptr) << messages().sentence().toStdString();
  EXPECT_EQ(offer(*window, QStringLiteral("Bring back")), nullptr);
  messages().hide();
  EXPECT_NE(offer(*window, QStringLiteral("Bring back")), nullptr) << "it follows";
}

TEST_F(SessionWindow, beforeAVolumeIsReadTheSessionIsOnTheDisk) {
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  // The last edit: the event loop does not turn between it and the opening, so no autosave can have seen it.
  TransferFunction edited = scene().transferFunction;
  edited.unitDistanceMm *= 2.0;
  SessionDocument onDisk;
  const auto look = [&] {
    if (const std::vector<fs::path> files = autosaved(); !files.empty())
      onDisk = readSessionFile(files.front());
  };
  QMetaObject::Connection once = QObject::connect(&window->loader(), &VolumeLoader::progressed, window.get(),
                                                  [&](double, const QString&) { look(); });
  session().setTransferFunction(edited, {nextGestureId(), QStringLiteral("last")});
  window->openSource(QStringLiteral("phantom:5"));
  ASSERT_TRUE(test::waitUntil([&] { return onDisk.isUnsaved || !window->loader().isLoading(); }));
  QObject::disconnect(once);
  EXPECT_EQ(onDisk.scene.scene.transferFunction, edited);
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
}

TEST_F(SessionWindow, whereNothingCanBeKeptItIsSaidAndAskedBeforeAnythingIsLost) {
  test::writeBytes(sessions(), "a file where the folder should be");
  window->keepSessions();
  EXPECT_TRUE(labelSays(QStringLiteral("not safe")));
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  EXPECT_TRUE(window->close()); // nothing to lose
  window->show();
  dragAPoint();
  int asked = 0;
  const auto answer = [&](QMessageBox::ButtonRole role) {
    QTimer::singleShot(0, window.get(), [&asked, role, this] {
      auto* box = window->findChild<QMessageBox*>(QStringLiteral("unsavedChanges"));
      ASSERT_NE(box, nullptr);
      ++asked;
      for (QAbstractButton* button : box->buttons())
        if (box->buttonRole(button) == role)
          return QTest::mouseClick(button, Qt::LeftButton);
    });
  };
  answer(QMessageBox::RejectRole);
  EXPECT_FALSE(window->close());
  EXPECT_TRUE(window->isVisible());
  answer(QMessageBox::DestructiveRole);
  EXPECT_TRUE(window->close());
  EXPECT_EQ(asked, 2);
}

} // namespace
} // namespace limn
