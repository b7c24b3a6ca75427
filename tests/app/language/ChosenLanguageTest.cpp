// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/SpokenWindow.h"
#include "app/document/recovery/SessionKeeper.h"
#include "app/frame/dialogs/DialogController.h"
#include "app/language/Language.h"
#include "support/TemporaryFolder.h"
#include "support/Waiting.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/view/CompareView.h"

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QMenuBar>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <fstream>

// Another language is chosen while something is open.
namespace limn::test {
namespace {

class ChosenLanguage : public testing::Test {
protected:
  ChosenLanguage() {
    QCoreApplication::setOrganizationName(QStringLiteral("limn"));
    QCoreApplication::setApplicationName(QStringLiteral("limn"));
    Settings settings(folders.settings);
    settings.setEngine(Engine::cpu);
    settings.setLanguage(QStringLiteral("en"));
    useLanguage(*QCoreApplication::instance(), QStringLiteral("en"));
    spoken = std::make_unique<SpokenWindow>(folders, std::nullopt, QStringLiteral("en"));
    window().resize(1000, 700);
    window().show();
    window().keepSessions();
  }

  ~ChosenLanguage() override {
    spoken.reset();
    useLanguage(*QCoreApplication::instance(), QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }

  MainWindow& window() { return spoken->window(); }
  Session& session() { return *window().findChild<Session*>(); }
  QAction& named(const char* name) { return *window().findChild<QAction*>(QLatin1String(name)); }
  QString firstMenu() { return window().menuBar()->actions().front()->text(); }

  [[nodiscard]] bool open(const QString& source) {
    window().openSource(source);
    return waitUntil([this] { return !window().loader().isLoading(); }) && session().scene().volume;
  }

  /// Chooses the language of the next line, down or up, as the settings offer it, named `label` there.
  void choose(const char* label, Qt::Key key) {
    if (!window().findChild<SettingsDialog*>())
      named("settings").trigger();
    auto* box = widgetNamed<QComboBox>(*window().findChild<SettingsDialog*>(), label);
    ASSERT_NE(box, nullptr);
    box->setFocus();
    QTest::keyClick(box, key);
  }

  [[nodiscard]] bool isReplaced(const QSignalSpy& replaced) {
    return waitUntil([&] { return replaced.count() > 0; });
  }

  /// Moves the first point of the curve that is neither transparent nor opaque 20 pixels down.
  void dragAPoint() {
    TransferFunctionCanvas& canvas = *window().findChild<CurvePanel*>()->valueEditor()->canvas();
    const PlotTransform plot = canvas.transform();
    for (const ControlPoint& point : canvas.transferFunction().points) {
      if (point.opacity < 0.2 || point.value < plot.visible.lowest || point.value > plot.visible.highest)
        continue;
      const QPoint from = QPointF(xOfValue(plot, point.value), yOfOpacity(plot, point.opacity)).toPoint();
      QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
      for (int step = 1; step <= 4; ++step)
        QTest::mouseEvent(QTest::MouseMove, &canvas, Qt::NoButton, {}, from + QPoint(0, 5 * step));
      QTest::mouseRelease(&canvas, Qt::LeftButton, {}, from + QPoint(0, 20));
      return;
    }
    FAIL() << "no point to drag";
  }

  void expectNothingSaidOrAsked() {
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    for (const MessageBar* bar : window().findChildren<MessageBar*>())
      EXPECT_TRUE(bar->isHidden()) << bar->objectName().toStdString() << ": "
                                   << bar->sentence().toStdString();
    EXPECT_TRUE(UnsavedSessions(folders.sessions).kept().empty());
  }

  TemporaryFolder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  std::unique_ptr<SpokenWindow> spoken;
};

TEST_F(ChosenLanguage, comesAtOnceWithAllThatIsOpenAndGoesBack) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  const TransferFunction opened = session().scene().transferFunction;
  dragAPoint();
  const TransferFunction once = session().scene().transferFunction;
  dragAPoint();
  const Scene scene = session().scene();
  ASSERT_EQ(session().undoStack().count(), 2);
  const QStringList steps{session().undoStack().text(0), session().undoStack().text(1)};
  for (MessageBar* bar : window().findChildren<MessageBar*>())
    bar->hide(); // what was said of opening
  const SessionDocument shown = window().sessionDocument();
  const QSize size = window().size();
  const QString english = window().windowTitle();

  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_EQ(firstMenu(), QStringLiteral("&Datei"));
  EXPECT_EQ(QLocale().language(), QLocale::German);
  EXPECT_TRUE(window().isVisible() && window().isWindowModified());
  EXPECT_EQ(window().size(), size);
  EXPECT_FALSE(window().loader().isLoading());
  EXPECT_EQ(session().scene().volume, scene.volume) << "not read again";
  EXPECT_EQ(session().scene(), scene);
  EXPECT_EQ(window().view().scene().transferFunction, scene.transferFunction);
  EXPECT_EQ(window().sessionDocument(), shown);
  ASSERT_EQ(session().undoStack().count(), 2);
  EXPECT_EQ(QStringList({session().undoStack().text(0), session().undoStack().text(1)}), steps);
  expectNothingSaidOrAsked();
  const auto* settings = window().findChild<SettingsDialog*>();
  ASSERT_TRUE(settings && settings->isVisible()) << "where the language was chosen";
  EXPECT_EQ(settings->windowTitle(), QStringLiteral("Einstellungen"));

  named("undo").trigger();
  EXPECT_EQ(session().scene().transferFunction, once);
  choose("Sprache", Qt::Key_Up);
  replaced.clear();
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_EQ(firstMenu(), QStringLiteral("&File"));
  EXPECT_EQ(window().windowTitle(), english);
  EXPECT_EQ(session().undoStack().index(), 1);
  named("redo").trigger();
  EXPECT_EQ(session().scene(), scene);
  named("undo").trigger();
  named("undo").trigger();
  EXPECT_EQ(session().scene().transferFunction, opened);
  EXPECT_FALSE(window().isWindowModified());
  expectNothingSaidOrAsked();
}

TEST_F(ChosenLanguage, keepsSlicesPanelsComparisonAndItsUndoSteps) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  auto* comparison = window().findChild<ComparisonController*>();
  comparison->setLayout(CompareLayout::sideBySide);
  const ShadingModel before = window().view().sceneOfSide(0).shading.model;
  comparison->setSideModel(0, ShadingModel::robust);
  named("planes-picture_and_three").trigger();
  comparison->setLayout(CompareLayout::wipe);
  window().view().setWipePosition(0.3);
  window().findChild<QDockWidget*>(QStringLiteral("effectsDock"))->raise();
  QCoreApplication::processEvents();
  const SessionDocument shown = window().sessionDocument();
  ASSERT_NE(shown.planes.layout, PlaneLayout::pictureOnly);

  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_EQ(window().sessionDocument(), shown);
  EXPECT_EQ(window().view().sceneOfSide(0).shading.model, ShadingModel::robust);
  named("undo").trigger();
  EXPECT_EQ(window().view().sceneOfSide(0).shading.model, before);
  named("redo").trigger();
  EXPECT_EQ(window().view().sceneOfSide(0).shading.model, ShadingModel::robust);
}

TEST_F(ChosenLanguage, leavesTwoPicturesTwoThoughItsWordsTakeMoreRoom) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  const auto areTwo = [this] { return window().view().compareLayout() == CompareLayout::sideBySide; };
  int width = 1390;
  const auto resize = [&] {
    window().resize(width, 700);
    QCoreApplication::processEvents();
    QCoreApplication::processEvents(); // the layout follows the size
  };
  resize();
  ASSERT_TRUE(waitUntil(areTwo));
  for (; areTwo(); width -= 4)
    resize();
  width += 8; // the narrowest window that shows two
  resize();
  ASSERT_TRUE(waitUntil(areTwo));
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  ASSERT_TRUE(isReplaced(replaced));
  QCoreApplication::processEvents();
  QCoreApplication::processEvents();
  EXPECT_TRUE(areTwo());
}

TEST_F(ChosenLanguage, leavesTheUnsavedSessionOnTheDiskForACrash) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  dragAPoint();
  const auto sessionsOnDisk = [this] {
    std::size_t sessions = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folders.sessions))
      sessions += entry.path().filename() == "session.json" ? 1 : 0;
    return sessions;
  };
  ASSERT_TRUE(waitUntil([&] { return sessionsOnDisk() == 1; }));
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_EQ(sessionsOnDisk(), 1U);
  named("undo").trigger();
  EXPECT_TRUE(waitUntil([&] { return sessionsOnDisk() == 0; })) << "this window keeps it";
}

TEST_F(ChosenLanguage, waitsForADialogThatIsOpenAndComesWithoutAVolume) {
  named("shortcuts").trigger();
  const MainWindow* english = &window();
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  QCoreApplication::processEvents();
  ASSERT_EQ(&window(), english);
  for (QDialog* dialog : window().findChildren<QDialog*>())
    if (dialog->isVisible() && !qobject_cast<SettingsDialog*>(dialog))
      dialog->close();
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_EQ(firstMenu(), QStringLiteral("&Datei"));
  EXPECT_EQ(session().scene().volume, nullptr);
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
}

TEST_F(ChosenLanguage, saysAnewWhatCanBeSetRight) {
  const auto file = folder.path() / "unknown.nrrd";
  std::ofstream(file) << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 8 8 8\nencoding: raw\n\n"
                      << std::string(256, '\1') << std::string(256, '\2');
  ASSERT_TRUE(open(QString::fromStdString(file.string())));
  auto* bar = window().findChild<MessageBar*>(QStringLiteral("messageBar"));
  ASSERT_TRUE(bar->isVisible());
  const QString english = bar->sentence();
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  ASSERT_TRUE(isReplaced(replaced));
  bar = window().findChild<MessageBar*>(QStringLiteral("messageBar"));
  EXPECT_TRUE(bar->isVisible());
  EXPECT_FALSE(bar->sentence().isEmpty());
  EXPECT_NE(bar->sentence(), english);
}

TEST_F(ChosenLanguage, waitsForAVolumeThatIsBeingRead) {
  window().openSource(QStringLiteral("phantom:4"));
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_NE(session().scene().volume, nullptr);
  EXPECT_EQ(firstMenu(), QStringLiteral("&Datei"));
}

} // namespace
} // namespace limn::test
