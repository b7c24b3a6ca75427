// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/SpokenWindow.h"
#include "app/document/recovery/SessionKeeper.h"
#include "app/frame/dialogs/DialogController.h"
#include "app/language/Language.h"
#include "support/TemporaryFolder.h"
#include "support/Waiting.h"
#include "widgets/FindWidget.h"
#include "widgets/accuracy/AccuracyChart.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/accuracy/ErrorMapOverlay.h"
#include "widgets/accuracy/MapSection.h"
#include "widgets/controls/FoldingSection.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/controls/NumberField.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

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

  void showSettings() {
    if (!window().findChild<SettingsDialog*>())
      named("settings").trigger();
    const auto* settings = window().findChild<SettingsDialog*>();
    ASSERT_TRUE(waitUntil([&] { return settings->isActiveWindow(); })) << "they take the keyboard";
  }

  /// Chooses the language of the next line, down or up, as the settings offer it, named `label` there.
  void choose(const char* label, Qt::Key key) {
    showSettings();
    auto* box = widgetNamed<QComboBox>(*window().findChild<SettingsDialog*>(), label);
    ASSERT_NE(box, nullptr);
    box->setFocus();
    QTest::keyClick(box, key);
  }

  [[nodiscard]] bool isReplaced(const QSignalSpy& replaced) {
    return waitUntil([&] { return replaced.count() > 0; });
  }

  /// Moves the first point of the curve that is neither transparent nor opaque 20 pixels down; `midway`
  /// happens while it is held.
  void dragAPoint(const std::function<void()>& midway = [] {}) {
    TransferFunctionCanvas& canvas = *window().findChild<CurvePanel*>()->valueEditor()->canvas();
    const PlotTransform plot = canvas.transform();
    for (const ControlPoint& point : canvas.transferFunction().points) {
      if (point.opacity < 0.2 || point.value < plot.visible.lowest || point.value > plot.visible.highest)
        continue;
      const QPoint from = QPointF(xOfValue(plot, point.value), yOfOpacity(plot, point.opacity)).toPoint();
      QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
      for (int step = 1; step <= 4; ++step) {
        QTest::mouseEvent(QTest::MouseMove, &canvas, Qt::NoButton, {}, from + QPoint(0, 5 * step));
        if (step == 2)
          midway();
      }
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
  EXPECT_TRUE(waitUntil([&] { return settings->isActiveWindow(); }));
  EXPECT_EQ(settings->focusWidget(), widgetNamed<QComboBox>(*settings, "Sprache")) << "the keys go on there";

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
  window().findChild<QualitySection*>()->findChild<FoldingHeader*>()->click();
  const std::vector<bool> folded = window().findChild<PropertiesPanel*>()->folded();
  window().findChild<QDockWidget*>(QStringLiteral("effectsDock"))->raise();
  QCoreApplication::processEvents();
  const SessionDocument shown = window().sessionDocument();
  ASSERT_NE(shown.planes.layout, PlaneLayout::pictureOnly);

  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_EQ(window().sessionDocument(), shown);
  EXPECT_EQ(window().findChild<PropertiesPanel*>()->folded(), folded);
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

// What was drawn for minutes must not go with the window.
TEST_F(ChosenLanguage, waitsWhileAPictureIsOfferedToBeSavedElsewhere) {
  ASSERT_TRUE(open(QStringLiteral("phantom:16")));
  session().setCamera(zoomed(session().scene().camera, 0.1)); // drawn at once
  ASSERT_TRUE(waitUntil([this] { return window().view().pictureState().resting; }));
  auto& saving = *window().findChild<SavingController*>();
  const auto file = QString::fromStdString((folder.path() / "gone" / "twice.png").string());
  PictureOptions options;
  options.size = PictureOptions::Size::twice;
  saving.writePicture(file, options);
  ASSERT_TRUE(waitUntil([&] { return !saving.unwritten().isEmpty(); }));
  const MainWindow* english = &window();
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  QCoreApplication::processEvents();
  ASSERT_EQ(&window(), english);
  const auto* offer = window().findChild<MessageBar*>(QStringLiteral("unwrittenBar"));
  window().findChild<MessageBar*>(QStringLiteral("messageBar"))->hide(); // one is seen at a time
  ASSERT_TRUE(offer->isVisible());
  for (QToolButton* button : offer->findChildren<QToolButton*>())
    if (button->text() == QStringLiteral("Dismiss")) {
      QTest::mouseClick(button, Qt::LeftButton);
      break;
    }
  ASSERT_TRUE(saving.unwritten().isEmpty());
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_EQ(firstMenu(), QStringLiteral("&Datei"));
}

// What is half drawn would be gone with the window.
TEST_F(ChosenLanguage, waitsUntilAMeasurementOrALineIsFinishedOrGivenUp) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(waitUntil([this] { return window().view().pictureState().resting; }));
  const auto click = [this](const QPoint& fromMiddle) {
    CompareView& view = window().view();
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.logicalRect(0).center().toPoint() + fromMiddle);
  };
  window().view().setTool(ViewTool::distance);
  click({-20, 0});
  ASSERT_EQ(window().view().order().comparison.measures.size(), 1U);
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  QCoreApplication::processEvents();
  ASSERT_EQ(replaced.count(), 0);
  click({25, 10});
  ASSERT_TRUE(isReplaced(replaced));
  ASSERT_EQ(session().measurements().size(), 1U);
  EXPECT_EQ(session().measurements().front().placesMm.size(), 2U);

  window().view().setTool(ViewTool::scissors);
  for (const QPoint& corner : {QPoint(-30, 0), QPoint(0, 30), QPoint(30, 0)})
    click(corner);
  ASSERT_TRUE(window().view().input().cutLine());
  choose("Sprache", Qt::Key_Up);
  replaced.clear();
  QCoreApplication::processEvents();
  ASSERT_EQ(replaced.count(), 0);
  QTest::keyClick(&window().view(), Qt::Key_Escape);
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_EQ(firstMenu(), QStringLiteral("&File"));
  EXPECT_EQ(window().view().tool(), ViewTool::scissors);
}

TEST_F(ChosenLanguage, keepsWhatWasSaidAsLongAsItIsTrue) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  const auto save = [this](const std::filesystem::path& file) {
    window().findChild<SavingController*>()->writeSession(QString::fromStdString(file.string()));
  };
  const auto bar = [this] { return window().findChild<MessageBar*>(QStringLiteral("messageBar")); };
  save(folder.path() / "gone" / "mine.limn.json");
  ASSERT_TRUE(bar()->isError());
  const QString said = bar()->sentence();
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_TRUE(bar()->isError() && bar()->isVisible());
  EXPECT_EQ(bar()->sentence(), said);
  save(folder.path() / "mine.limn.json");
  EXPECT_FALSE(bar()->isWanted());
}

// With what can be done about it, in the language of now.
TEST_F(ChosenLanguage, offersAnewWhatIsKept) {
  const auto bar = [this] { return window().findChild<MessageBar*>(QStringLiteral("keptBar")); };
  const auto action = [&] { return bar()->findChild<QToolButton*>(QStringLiteral("messageAction")); };
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  const TransferFunction worked = session().scene().transferFunction;
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  ASSERT_TRUE(bar()->isVisible());
  EXPECT_EQ(action()->text(), QStringLiteral("Bring back"));
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  ASSERT_TRUE(isReplaced(replaced));
  ASSERT_TRUE(bar()->isVisible() && bar()->isNote());
  EXPECT_TRUE(bar()->sentence().startsWith(QStringLiteral("Ihre Arbeit an ")))
      << bar()->sentence().toStdString();
  EXPECT_TRUE(action()->isVisible());
  EXPECT_EQ(action()->text(), QStringLiteral("Zurückholen"));
  QTest::mouseClick(action(), Qt::LeftButton);
  EXPECT_TRUE(waitUntil([&] { return session().scene().transferFunction == worked; }));
  EXPECT_FALSE(bar()->isWanted());
}

TEST_F(ChosenLanguage, comesOnceADragHasEnded) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  const MainWindow* english = &window();
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  showSettings(); // the drag begins with the settings beside it
  bool stays = false;
  dragAPoint([&] {
    choose("Language", Qt::Key_Down);
    QCoreApplication::processEvents();
    stays = &window() == english;
  });
  ASSERT_TRUE(stays);
  const TransferFunction dragged = session().scene().transferFunction;
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_EQ(firstMenu(), QStringLiteral("&Datei"));
  EXPECT_EQ(session().scene().transferFunction, dragged);
  EXPECT_EQ(session().undoStack().count(), 1);
}

TEST_F(ChosenLanguage, entersWhatIsBeingTyped) {
  ASSERT_TRUE(open(QStringLiteral("phantom:16")));
  window().findChild<QDockWidget*>(QStringLiteral("shadingDock"))->raise();
  QCoreApplication::processEvents();
  auto* panel = window().findChild<PropertiesPanel*>();
  auto* field = widgetNamed<NumberField>(*panel, "Step");
  ASSERT_NE(field, nullptr);
  const double before = session().scene().quality.stepVoxels;
  ASSERT_NE(before, 2.0);
  const MainWindow* english = &window();
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  // A pressed button holds the language back until the number is half typed.
  const QPoint besideMenus = window().menuBar()->rect().topRight() + QPoint(-3, 3);
  QTest::mousePress(window().menuBar(), Qt::LeftButton, {}, besideMenus);
  choose("Language", Qt::Key_Down);
  QCoreApplication::processEvents();
  ASSERT_EQ(&window(), english);
  ASSERT_TRUE(waitUntil([this] {
    if (!window().isActiveWindow())
      window().activateWindow();
    return window().isActiveWindow();
  }));
  panel->ensureWidgetVisible(field);
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, QStringLiteral("2"));
  ASSERT_EQ(session().scene().quality.stepVoxels, before);
  QTest::mouseRelease(window().menuBar(), Qt::LeftButton, {}, besideMenus);
  ASSERT_TRUE(isReplaced(replaced));
  EXPECT_EQ(session().scene().quality.stepVoxels, 2.0);
}

TEST_F(ChosenLanguage, waitsUntilAccuracyIsMeasuredAndKeepsWhatWas) {
  ASSERT_TRUE(open(QStringLiteral("phantom:16")));
  window().resize(800, 560);
  window().findChild<ComparisonController*>()->setLayout(CompareLayout::single);
  window().findChild<QDockWidget*>(QStringLiteral("accuracyDock"))->raise();
  QCoreApplication::processEvents();
  const auto panel = [this]() -> AccuracyPanel& { return *window().findChild<AccuracyPanel*>(); };
  auto* measure = widgetNamed<QPushButton>(panel(), "Measure error and time");
  panel().ensureWidgetVisible(measure);
  QCoreApplication::processEvents();
  QTest::mouseClick(measure, Qt::LeftButton);
  ASSERT_EQ(panel().work(), AccuracyWork::measuring);
  const MainWindow* english = &window();
  QSignalSpy replaced(spoken.get(), &SpokenWindow::replaced);
  choose("Language", Qt::Key_Down);
  QCoreApplication::processEvents();
  ASSERT_EQ(&window(), english);
  ASSERT_TRUE(waitUntil([&] { return panel().measured().has_value(); }));
  const std::size_t points = panel().measured()->report.points.size();
  ASSERT_TRUE(isReplaced(replaced));
  ASSERT_TRUE(panel().measured());
  EXPECT_EQ(panel().measured()->report.points.size(), points);
  EXPECT_EQ(panel().measured()->scene.volume, session().scene().volume);
  EXPECT_FALSE(panel().findChild<AccuracyChart*>()->curves().empty());
  const std::filesystem::path table = folder.path() / "table.csv";
  window().findChild<AccuracyController*>()->write(QString::fromStdString(table.string()));
  EXPECT_TRUE(std::filesystem::exists(table));

  // The map stays where the picture is as large as before, and never without its tick.
  auto* check = panel().findChild<MapSection*>()->findChild<QCheckBox*>();
  panel().ensureWidgetVisible(check);
  QCoreApplication::processEvents();
  QTest::mouseClick(check, Qt::LeftButton);
  choose("Sprache", Qt::Key_Up);
  replaced.clear();
  ASSERT_TRUE(isReplaced(replaced));
  QCoreApplication::processEvents();
  EXPECT_EQ(panel().work(), AccuracyWork::none);
  EXPECT_EQ(panel().findChild<MapSection*>()->findChild<QCheckBox*>()->isChecked(),
            window().findChild<ErrorMapOverlay*>()->isVisible());
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
