// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/frame/dialogs/DialogController.h"
#include "support/Places.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/properties/PropertiesPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QToolBar>
#include <QUndoView>

#include <algorithm>

// Settings, history, stability checks and panels in windows of their own, in the program's window.

namespace limn {
namespace {

class DialogsWindow : public test::OpenGlWindow {
protected:
  QAction* named(const char* name) const { return window->findChild<QAction*>(QLatin1String(name)); }
  Settings settings() const { return Settings(UserFolders::below(folder.path()).settings); }
};

TEST_F(DialogsWindow, theSettingsShowAndChangeWhatStays) {
  QTest::keyClick(window.get(), Qt::Key_Comma, Qt::ControlModifier);
  auto* dialog = window->findChild<SettingsDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  auto* engine = widgetNamed<QComboBox>(*dialog, "Draw with");
  EXPECT_EQ(engine->currentText(), QStringLiteral("OpenGL")) << "what the harness chose";
  engine->setFocus();
  QTest::keyClick(engine, Qt::Key_Down);
  EXPECT_EQ(settings().engine(), Engine::cpu);
  EXPECT_TRUE(named("engine-cpu")->isChecked());
  named("engine-gl")->trigger(); // by whatever else
  EXPECT_EQ(engine->currentText(), QStringLiteral("OpenGL"));
  for (QCheckBox* box : dialog->findChildren<QCheckBox*>())
    if (box->text() == QStringLiteral("Show the patient's name in the title bar"))
      QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
  EXPECT_EQ(settings().patientIsShown(), true);
  EXPECT_TRUE(named("patientInTitle")->isChecked());
}

TEST_F(DialogsWindow, thatALanguageMayHaveToWaitIsSaidBesideTheChoice) {
  named("settings")->trigger();
  auto* dialog = window->findChild<SettingsDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  const auto said = [&]() -> const QLabel* {
    for (const QLabel* label : dialog->findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QStringLiteral("as soon as")))
        return label;
    return nullptr;
  };
  EXPECT_EQ(said(), nullptr);
  auto* language = widgetNamed<QComboBox>(*dialog, "Language");
  language->setFocus();
  QTest::keyClick(language, Qt::Key_Down);
  ASSERT_NE(said(), nullptr);
  QCoreApplication::processEvents(); // lays it out
  EXPECT_LT(said()->y() - language->geometry().bottom(), 30) << "right below";
  EXPECT_GE(said()->height(), said()->heightForWidth(said()->width()));
  for (const QPushButton* button : dialog->findChildren<QPushButton*>()) {
    const QRect place(button->mapTo(dialog, QPoint()), button->size());
    EXPECT_TRUE(dialog->rect().contains(place)) << button->text().toStdString();
    EXPECT_GE(button->height(), button->sizeHint().height()) << button->text().toStdString();
  }
}

TEST_F(DialogsWindow, whatWasOpenedBeforeIsForgottenFromTheSettings) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_FALSE(settings().recentSources().isEmpty());
  named("settings")->trigger();
  auto* dialog = window->findChild<SettingsDialog*>();
  QTest::mouseClick(dialog->findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_TRUE(settings().recentSources().isEmpty());
  EXPECT_FALSE(window->findChild<QMenu*>(QStringLiteral("recentSources"))->isEnabled());
}

TEST_F(DialogsWindow, theHistoryListsEveryStepAndAClickGoesThere) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  auto* history = window->findChild<QUndoView*>();
  ASSERT_NE(history, nullptr);
  const TransferFunction before = scene().transferFunction;
  dragAPoint();
  const TransferFunction dragged = scene().transferFunction;
  dragAPoint();
  ASSERT_EQ(history->model()->rowCount(), 3);
  EXPECT_EQ(history->model()->index(0, 0).data().toString(), QStringLiteral("As opened"));
  EXPECT_TRUE(history->model()->index(1, 0).data().toString().contains(QStringLiteral(" → ")));
  window->findChild<QDockWidget*>(QStringLiteral("historyDock"))->raise();
  QCoreApplication::processEvents();
  for (int row = 0; row < 3; ++row) { // the whole of it, without scrolling to the side
    const QRect place = history->visualRect(history->model()->index(row, 0));
    EXPECT_TRUE(place.left() >= 0 && place.right() < history->viewport()->width()) << row;
  }
  EXPECT_EQ(history->horizontalScrollBar()->maximum(), 0);
  const auto clickRow = [history](int row) {
    const QRect place = history->visualRect(history->model()->index(row, 0));
    QTest::mouseClick(history->viewport(), Qt::LeftButton, {}, place.center());
  };
  clickRow(0);
  EXPECT_EQ(scene().transferFunction, before);
  clickRow(1);
  EXPECT_EQ(scene().transferFunction, dragged);
}

TEST_F(DialogsWindow, stepsThatAreUndoneStepBackInTheHistory) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  dragAPoint();
  dragAPoint();
  auto& history = *window->findChild<QUndoView*>();
  window->findChild<QDockWidget*>(QStringLiteral("historyDock"))->raise();
  // How far the darkest of a row's pixels is from its brightest: its letters from their ground.
  const auto contrastOf = [&history](int row) {
    QCoreApplication::processEvents();
    const QImage picture =
        history.viewport()->grab(history.visualRect(history.model()->index(row, 0))).toImage();
    int lowest = 255, highest = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const int level = qGray(picture.pixel(x, y));
        lowest = std::min(lowest, level);
        highest = std::max(highest, level);
      }
    return highest - lowest;
  };
  const int done = contrastOf(1);
  undo().setIndex(0);
  EXPECT_LT(contrastOf(1), done);
  EXPECT_GT(contrastOf(1), 0) << "still there to be read";
  undo().setIndex(2);
  EXPECT_EQ(contrastOf(1), done);
}

TEST_F(DialogsWindow, theHistoryBreaksLinesBeforeTheyAreCut) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  auto& history = *window->findChild<QUndoView*>();
  window->findChild<QDockWidget*>(QStringLiteral("historyDock"))->raise();
  for (int letters = 15; letters < 40; ++letters) { // from one line to two
    Shading shading = scene().shading;
    shading.twoSided = !shading.twoSided;
    session().setShading(
        shading, {nextGestureId(),
                  QStringLiteral("of ") + QString(letters, QLatin1Char('n')).insert(8, QLatin1Char(' '))});
  }
  QCoreApplication::processEvents();
  const int beside = 2 * (9 + history.style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1); // theme.qss: 9
  for (int row = 1; row < history.model()->rowCount(); ++row) {
    const QModelIndex index = history.model()->index(row, 0);
    const QRect place = history.visualRect(index);
    const QRect room(0, 0, place.width() - beside, 1000);
    const QString text = index.data().toString();
    EXPECT_GE(place.height(), history.fontMetrics().boundingRect(room, Qt::TextWordWrap, text).height())
        << text.toStdString();
  }
}

TEST_F(DialogsWindow, theHistoryTellsWhatWasChosenAndSwitched) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  auto& properties = *window->findChild<PropertiesPanel*>();
  QComboBox* shows = widgetNamed<QComboBox>(properties, "Shows");
  shows->setFocus();
  QTest::keyClick(shows, Qt::Key_Down);
  EXPECT_EQ(undo().undoText(), QStringLiteral("projection: Tissue (composite) → Maximum (MIP)"));
  QTest::keyClick(shows, Qt::Key_Up);
  widgetNamed<QCheckBox>(properties, "Light both sides")->click();
  EXPECT_EQ(undo().undoText(), QStringLiteral("light both sides: on"));
  widgetNamed<QCheckBox>(properties, "Shift the samples (jitter)")->click();
  EXPECT_EQ(undo().undoText(), QStringLiteral("shift the samples (jitter): on"));
  Shading dull = scene().shading;
  dull.specular = 0.0;
  session().setShading(dull, switchGesture(QStringLiteral("Highlights"), false));
  EXPECT_EQ(undo().undoText(), QStringLiteral("highlights: off")) << "no number follows";
  Quality quality = scene().quality;
  quality.stepVoxels = 0.25;
  session().setQuality(quality, {nextGestureId(), QStringLiteral("change step between samples")});
  EXPECT_TRUE(undo().undoText().endsWith(QStringLiteral("→ 0.25"))) << undo().undoText().toStdString();
}

TEST_F(DialogsWindow, theHistoryTellsNumbersWithTheirUnits) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  auto& properties = *window->findChild<PropertiesPanel*>();
  ASSERT_EQ(scene().shading.gradientSmoothing, 0.0);
  QTest::keyClick(rowNamed<ValueSlider>(properties, "Smooth normals")->findChild<TrackSlider*>(),
                  Qt::Key_End);
  EXPECT_EQ(undo().undoText(), QStringLiteral("change smoothing of normals 0 → 6\u00a0mm"));
  auto* step = rowNamed<ValueSlider>(properties, "Step")->findChild<NumberField*>();
  const auto type = [step](const char* keys) {
    step->selectAll();
    QTest::keyClicks(step, QString::fromLatin1(keys));
    QTest::keyClick(step, Qt::Key_Return);
  };
  type("2");
  type("1");
  EXPECT_EQ(undo().undoText(), QStringLiteral("change step between samples 2 → 1\u00a0voxel"));
  type("4");
  EXPECT_EQ(undo().undoText(), QStringLiteral("change step between samples 1 → 4\u00a0voxels"));
  QTest::keyClick(rowNamed<ValueSlider>(properties, "Dark hollows")->findChild<TrackSlider*>(), Qt::Key_End);
  EXPECT_EQ(undo().undoText(), QStringLiteral("change dark hollows 0 → 100\u00a0%"));
}

TEST_F(DialogsWindow, aPanelGoesIntoAWindowOfItsOwnAndBack) {
  auto* curve = window->findChild<QDockWidget*>(QStringLiteral("curveDock"));
  EXPECT_LE(curve->widget()->y(), 1) << "no row for a name that its contents tell"; // a frame at most
  named("float-curveDock")->trigger();
  EXPECT_TRUE(curve->isFloating() && curve->isVisible());
  EXPECT_EQ(curve->titleBarWidget(), nullptr);
  named("float-curveDock")->trigger();
  EXPECT_FALSE(curve->isFloating());
  EXPECT_NE(curve->titleBarWidget(), nullptr);
}

TEST_F(DialogsWindow, thePictureAloneAndBackOpensNothingThatWasClosed) {
  const auto isOpen = [this](const char* name) {
    return !window->findChild<QWidget*>(QLatin1String(name))->isHidden();
  };
  window->findChild<QDockWidget*>(QStringLiteral("historyDock"))->close();
  window->findChild<QDockWidget*>(QStringLiteral("shadingDock"))->close();
  window->findChild<QDockWidget*>(QStringLiteral("accuracyDock"))->raise();
  window->findChild<QToolBar*>()->hide();
  QCoreApplication::processEvents();
  QTest::keyClick(window.get(), Qt::Key_F11);
  for (const char* name :
       {"presetDock", "historyDock", "shadingDock", "effectsDock", "accuracyDock", "curveDock", "toolBar"})
    EXPECT_FALSE(isOpen(name)) << name;
  QTest::keyClick(window.get(), Qt::Key_F11);
  for (const char* name : {"historyDock", "shadingDock", "toolBar"})
    EXPECT_FALSE(isOpen(name)) << name;
  for (const char* name : {"presetDock", "effectsDock", "accuracyDock", "curveDock"})
    EXPECT_TRUE(isOpen(name)) << name;
  QCoreApplication::processEvents();
  EXPECT_FALSE(
      window->findChild<QDockWidget*>(QStringLiteral("accuracyDock"))->widget()->visibleRegion().isEmpty())
      << "it lay on top";
}

TEST_F(DialogsWindow, checksThatCannotStartOrAreStoppedSaySo) {
  const QString reports = pathTo("reports");
  StabilityDialog missing(pathTo("no such program"), reports, window.get());
  missing.show();
  const auto button = [](const StabilityDialog& dialog, const char* text) {
    for (QPushButton* one : dialog.findChildren<QPushButton*>())
      if (one->text() == QLatin1String(text))
        return one;
    return static_cast<QPushButton*>(nullptr);
  };
  const auto says = [](const StabilityDialog& dialog, const char* words) {
    return dialog.findChild<QLabel*>()->text().contains(QLatin1String(words));
  };
  QTest::mouseClick(button(missing, "Check"), Qt::LeftButton);
  EXPECT_TRUE(test::waitUntil([&] { return says(missing, "could not be started"); }));
  EXPECT_TRUE(button(missing, "Check")->isVisible());

  StabilityDialog stopped(QString::fromStdString(test::programPath()), reports, window.get());
  stopped.show();
  QTest::mouseClick(button(stopped, "Check"), Qt::LeftButton);
  ASSERT_TRUE(button(stopped, "Stop")->isVisible());
  QTest::mouseClick(button(stopped, "Stop"), Qt::LeftButton);
  EXPECT_TRUE(test::waitUntil([&] { return says(stopped, "before they were complete"); }));
  EXPECT_FALSE(button(stopped, "Open the report")->isVisible());
}

} // namespace
} // namespace limn
