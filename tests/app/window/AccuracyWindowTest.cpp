// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/core/drawing/RealRenderers.h"
#include "support/Heart.h"
#include "support/JudgedTime.h"
#include "support/TestData.h"
#include "widgets/FindWidget.h"
#include "widgets/ValueText.h"
#include "widgets/accuracy/AccuracyChart.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/accuracy/AccuracySamples.h"
#include "widgets/accuracy/DialSection.h"
#include "widgets/accuracy/ErrorMapOverlay.h"
#include "widgets/accuracy/MapSection.h"
#include "widgets/accuracy/MeasuredSection.h"
#include "widgets/accuracy/StopSlider.h"
#include "widgets/accuracy/WishSection.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/WorkRow.h"
#include "widgets/view/gestures/ViewDrag.h"
#include "widgets/view/panels/PictureStatus.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <future>
#include <set>

// Accuracy in the program's window, with real renderers and real mouse events.

namespace limn {
namespace {

// The error of a scene's picture with renderers of its own, on a thread where the window has no context.
std::pair<ReferenceFacts, ImageError> measuredAgain(const Scene& scene, const glm::ivec2& size) {
  return std::async(std::launch::async,
                    [&] {
                      RealRenderers renderers;
                      const ConvergedPicture exact = convergedPicture(scene, size, renderers.precisely());
                      return std::pair(exact.facts, imageError(renderers.render(scene, size), exact.pixels));
                    })
      .get();
}

class AccuracyWindowTest : public test::OpenGlWindow {
protected:
  void SetUp() override {
    OpenGlWindow::SetUp();
    window->resize(800, 560); // small pictures converge soon
    window->findChild<QDockWidget*>(QStringLiteral("accuracyDock"))->raise();
    ASSERT_TRUE(open(QStringLiteral("phantom:16")));
    session().setCamera(zoomed(scene().camera, 0.5)); // and pixels that see nothing at once
    ASSERT_TRUE(rest());
  }

  AccuracyPanel& panel() { return *window->findChild<AccuracyPanel*>(); }
  QPushButton* measureButton() { return widgetNamed<QPushButton>(panel(), "Measure error and time"); }
  QCheckBox* mapCheck() { return panel().findChild<MapSection*>()->findChild<QCheckBox*>(); }
  template <class Section>
  QString textOf(const char* label) {
    return panel().findChild<Section*>()->template findChild<QLabel*>(QString::fromLatin1(label))->text();
  }
  std::size_t shownCurves() { return panel().findChild<AccuracyChart*>()->curves().size(); }
  ErrorMapOverlay& map() { return *window->findChild<ErrorMapOverlay*>(); }

  void click(QWidget* control) {
    panel().ensureWidgetVisible(control);
    QCoreApplication::processEvents();
    QTest::mouseClick(control, Qt::LeftButton);
  }

  void click(const OperatingPoint& point) {
    AccuracyChart& chart = *panel().findChild<AccuracyChart*>();
    const std::optional<std::size_t> index = indexOf(point, panel().measured()->report.points);
    ASSERT_TRUE(index);
    panel().ensureWidgetVisible(&chart);
    QCoreApplication::processEvents();
    QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.placeOf(*index)->toPoint());
  }

  [[nodiscard]] bool workEnds() {
    return test::waitUntil([this] { return panel().work() == AccuracyWork::none; });
  }

  [[nodiscard]] bool measure() {
    click(measureButton());
    return panel().work() == AccuracyWork::measuring && workEnds() && panel().measured().has_value();
  }
};

// In a window as large as people use.
TEST_F(AccuracyWindowTest, measuringTheCtHeadTakesSeconds) {
  const char* const head = "data/ct_head_cranium/ct_head_cranium.nii.gz";
  LIMN_NEEDS_SHARED(head);
  window->resize(1400, 900);
  ASSERT_TRUE(open(QString::fromStdString((test::sharedFolder() / head).string())));
  for (const Engine engine : {Engine::rayCaster, Engine::cpu}) {
    view().setEngine(engine, {});
    ASSERT_TRUE(rest());
    QElapsedTimer clock;
    clock.start();
    ASSERT_TRUE(measure());
    const char* const by = engine == Engine::rayCaster ? "OpenGL" : "the processor";
    test::judgeMs(std::string("measuring the CT head by ") + by, static_cast<double>(clock.elapsed()),
                  15000.0);
    EXPECT_TRUE(panel().measured()->report.reference.converged);
    // The exact picture of the next engine is not to be the one that was drawn.
    Scene moved = scene();
    moved.camera = orbited(moved.camera, 0.01, 0.0);
    session().setCamera(moved.camera);
  }
}

TEST_F(AccuracyWindowTest, measuringGivesPointsOfEveryPositionWithoutBlockingTheWindow) {
  click(measureButton());
  ASSERT_EQ(panel().work(), AccuracyWork::measuring);
  const test::Heart heart;
  ASSERT_TRUE(workEnds());
  // The reference uses every core, but the window goes on.
  test::expectShortTurns(heart, "while accuracy is measured", 1000.0);
  ASSERT_TRUE(panel().measured());
  const MeasuredAccuracy& measured = *panel().measured();
  EXPECT_TRUE(measured.report.reference.converged);
  for (const OperatingPoint& point : dialPoints(measured.scene, measured.steepestPerMm))
    EXPECT_TRUE(indexOf(point, measured.report.points)) << point.stepVoxels;
  EXPECT_TRUE(textOf<DialSection>("sentence").contains(QStringLiteral("within")));
  std::set<std::string> families;
  for (const MeasuredPoint& point : measured.report.points)
    families.insert(familyOf(point.point));
  EXPECT_EQ(shownCurves(), families.size());
}

TEST_F(AccuracyWindowTest, aPointOfTheChartIsUsedAsOneUndoStepAndKeepsItsError) {
  ASSERT_TRUE(measure());
  OperatingPoint point = *pointOf(panel().measured()->scene, panel().measured()->steepestPerMm);
  const double before = scene().quality.stepVoxels;
  point.stepVoxels = 0.125;
  point.preintegrated = false;
  const int steps = undo().count();
  click(point);
  EXPECT_EQ(undo().count(), steps + 1);
  EXPECT_EQ(scene().quality.stepVoxels, 0.125);
  EXPECT_EQ(undo().undoText(), QStringLiteral("use step 1/8 voxel"));

  // Measured again from scratch, the scene as it stands keeps the error that the point promised.
  const MeasuredAccuracy& measured = *panel().measured();
  const double promised = measured.report.points[*indexOf(point, measured.report.points)].error.p99_9;
  Scene used = measured.scene;
  used.quality = scene().quality;
  const auto [exact, error] = measuredAgain(used, measured.report.size);
  ASSERT_TRUE(exact.converged);
  EXPECT_NEAR(error.p99_9, promised, 0.05 * promised + leastP99_9(exact))
      << "as close as two exact pictures are certain";

  undo().undo();
  EXPECT_EQ(scene().quality.stepVoxels, before);
}

// What is stated of the picture on screen goes before what was measured in a smaller one.
TEST_F(AccuracyWindowTest, afterUseDialChartSentenceAndStatusBarTellOneNumber) {
  setLayout(CompareLayout::single);
  ASSERT_TRUE(rest());
  ASSERT_TRUE(measure());
  const auto status = [this] { return window->findChild<PictureStatus*>()->text().estimate; };
  QAction& refine = *window->findChild<QAction*>(QStringLiteral("refineAtRest"));
  for (const bool refines : {false, true}) {
    refine.setChecked(refines);
    click(widgetNamed<QPushButton>(panel(), "Use: Error at most, levels")); // 1
    ASSERT_TRUE(workEnds() && idle());
    const Scene shown = view().sceneOfRestingImage(0);
    const MeasuredAccuracy& measured = *panel().measured();
    const std::optional<std::size_t> index =
        indexOf(*pointOf(shown, measured.steepestPerMm), measured.report.points);
    ASSERT_TRUE(index) << "the picture on screen is a measured one";
    const QString levels = promisedLevels(
        std::max(measured.report.points[*index].error.p99_9, leastP99_9(measured.report.reference)));
    const bool isStated = view().pictureState().sides.front().chance.has_value();
    EXPECT_EQ(status().contains(QStringLiteral("95 % sure")), isStated);
    if (!isStated) {
      EXPECT_EQ(status(),
                QStringLiteral("within %1 of 255 levels, measured in a smaller picture").arg(levels));
    }
    EXPECT_TRUE(
        textOf<DialSection>("sentence").contains(isStated ? status() : levels + QStringLiteral(" level")))
        << textOf<DialSection>("sentence").toStdString() << " where the status bar says "
        << status().toStdString();
    Scene turned = scene();
    turned.camera = orbited(turned.camera, 0.2, 0.1);
    session().setCamera(turned.camera);
    ASSERT_TRUE(idle());
    EXPECT_FALSE(status().contains(QStringLiteral("measured"))) << "another direction was not measured";
    session().setCamera(measured.scene.camera);
  }
}

// The status bar tells the worse of two.
TEST_F(AccuracyWindowTest, besideAnotherPictureThePanelSaysThatItTellsTheRightOnes) {
  const auto sentence = [this] { return textOf<DialSection>("sentence"); };
  setLayout(CompareLayout::sideBySide);
  ASSERT_TRUE(rest() && idle());
  EXPECT_TRUE(sentence().contains(QStringLiteral(": at the right "))) << sentence().toStdString();
  setLayout(CompareLayout::single);
  ASSERT_TRUE(rest() && idle());
  EXPECT_FALSE(sentence().contains(QStringLiteral("at the right"))) << sentence().toStdString();
}

TEST_F(AccuracyWindowTest, theChartIsOnScreenIn1280By800) {
  window->resize(1280, 800);
  QCoreApplication::processEvents();
  panel().setMeasured({sampleReport(pointsToMeasure(scene(), 0.0)), scene(), 0.0, {}});
  const AccuracyChart& chart = *panel().findChild<AccuracyChart*>();
  ASSERT_TRUE(test::waitUntil([&] { return chart.visibleRegion().boundingRect() == chart.rect(); }));
  const QRect place(chart.mapToGlobal(QPoint(0, 0)), chart.size());
  EXPECT_TRUE(chart.screen()->availableGeometry().contains(place));
  EXPECT_EQ(chart.window(), window.get()) << "in its panel: no window comes up by itself";
  auto* enlarge = widgetNamed<QPushButton>(panel(), "Chart in a window of its own");
  QTest::mouseClick(enlarge, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntilExposed(*chart.window()));
  EXPECT_NE(chart.window(), window.get());
  chart.window()->close();
  EXPECT_EQ(chart.window(), window.get());
  EXPECT_FALSE(enlarge->isChecked());
}

TEST_F(AccuracyWindowTest, aWishChoosesOrSaysThatNothingKeepsIt) {
  ASSERT_TRUE(measure());
  auto* useLevels = widgetNamed<QPushButton>(panel(), "Use: Error at most, levels");
  auto* levels = widgetNamed<NumberField>(panel(), "Error at most, levels");
  // What the finest equal steps keep with a hundredth to spare, some point keeps; nothing is promised below
  // what the exact picture is certain to.
  const std::vector<MeasuredPoint>& points = panel().measured()->report.points;
  OperatingPoint finest = *pointOf(panel().measured()->scene, 0.0);
  finest.stepVoxels = 1.0 / 8.0; // of the dial
  finest.preintegrated = false;
  const double limit = 1.01 * std::max(points[*indexOf(finest, points)].error.p99_9,
                                       leastP99_9(panel().measured()->report.reference));
  levels->setNumber(limit);
  const MeasuredPoint* fastest = fastestWithin(points, limit);
  ASSERT_TRUE(fastest);
  const OperatingPoint wished = fastest->point;
  click(useLevels);
  ASSERT_TRUE(workEnds()) << "a tolerance has its steps found first";
  EXPECT_EQ(pointOf(scene(), panel().measured()->steepestPerMm), wished);
  EXPECT_TRUE(textOf<WishSection>("answer").startsWith(QStringLiteral("Chosen: ")))
      << textOf<WishSection>("answer").toStdString();
  const Quality used = scene().quality;
  widgetNamed<NumberField>(panel(), "Time at most, ms")->setNumber(0.001);
  levels->setNumber(1e-6);
  click(useLevels);
  EXPECT_EQ(scene().quality, used);
  EXPECT_TRUE(textOf<WishSection>("answer").contains(QStringLiteral("Closest:")))
      << textOf<WishSection>("answer").toStdString();
}

TEST_F(AccuracyWindowTest, cancellingLeavesNothingHalf) {
  click(measureButton());
  QSignalSpy progress(&panel(), &AccuracyPanel::cancelRequested);
  ASSERT_EQ(panel().work(), AccuracyWork::measuring);
  click(panel().findChild<MeasuredSection*>()->work()->findChild<QPushButton*>());
  EXPECT_EQ(panel().work(), AccuracyWork::none);
  EXPECT_FALSE(panel().measured());
  EXPECT_TRUE(measureButton()->isEnabled());
  ASSERT_TRUE(measure()) << "and it can be measured anew";
  EXPECT_FALSE(panel().measured()->report.points.empty());
}

TEST_F(AccuracyWindowTest, theMapOfErrorsLiesOverThePictureUntilTheSceneChanges) {
  click(mapCheck());
  ASSERT_EQ(panel().work(), AccuracyWork::comparing);
  ASSERT_TRUE(workEnds());
  EXPECT_TRUE(map().isVisible());
  EXPECT_TRUE(textOf<MapSection>("sentence").contains(QStringLiteral("999 of 1000")));
  EXPECT_TRUE(QRectF(view().rect()).contains(map().legendRect()));
  const QPoint centre = view().rect().center();
  QTest::mousePress(&view(), Qt::LeftButton, {}, centre);
  QTest::mouseMove(&view(), centre + QPoint(30, 10));
  QTest::mouseRelease(&view(), Qt::LeftButton, {}, centre + QPoint(30, 10));
  EXPECT_FALSE(map().isVisible());
  EXPECT_FALSE(mapCheck()->isChecked());
  clickTool(QStringLiteral("Wipe"));
  EXPECT_FALSE(mapCheck()->isEnabled()) << "two pictures lie over each other";
}

TEST_F(AccuracyWindowTest, aComparisonThatAnotherLayoutEndsSaysSo) {
  click(mapCheck());
  ASSERT_EQ(panel().work(), AccuracyWork::comparing);
  EXPECT_TRUE(mapCheck()->isChecked());
  setLayout(CompareLayout::single);
  EXPECT_EQ(panel().work(), AccuracyWork::none);
  EXPECT_FALSE(mapCheck()->isChecked());
  EXPECT_TRUE(textOf<MapSection>("sentence").contains(QStringLiteral("tick the box to begin again")))
      << textOf<MapSection>("sentence").toStdString();
}

TEST_F(AccuracyWindowTest, lookingForStepsEndsAComparisonOfAPictureThatHasNotChanged) {
  click(mapCheck());
  ASSERT_EQ(panel().work(), AccuracyWork::comparing);
  Quality wished = scene().quality;
  wished.toleranceLevels = 4.0;
  emit panel().toleranceWished(wished, {nextGestureId(), QStringLiteral("wish")});
  EXPECT_EQ(panel().work(), AccuracyWork::findingSteps);
  EXPECT_FALSE(mapCheck()->isChecked());
  EXPECT_EQ(textOf<MapSection>("sentence"), QString());
  EXPECT_TRUE(workEnds());
}

TEST_F(AccuracyWindowTest, whatWasMeasuredIsWrittenAsChartTableAndPage) {
  ASSERT_TRUE(measure());
  window->findChild<AccuracyController*>()->write(pathTo("chart.png"));
  EXPECT_EQ(QImage(pathTo("chart.png")).size(), QSize(1200, 750));
  window->findChild<AccuracyController*>()->write(pathTo("table.csv"));
  QFile table(pathTo("table.csv"));
  ASSERT_TRUE(table.open(QIODevice::ReadOnly));
  const auto lines = QString::fromUtf8(table.readAll()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  EXPECT_EQ(lines.size(), 1 + static_cast<int>(panel().measured()->report.points.size()));
  window->findChild<AccuracyController*>()->write(pathTo("page.html"));
  QFile page(pathTo("page.html"));
  ASSERT_TRUE(page.open(QIODevice::ReadOnly));
  const QByteArray text = page.readAll();
  const QByteArray start = "data:image/png;base64,";
  const auto from = text.indexOf(start) + start.size();
  const QByteArray chart = QByteArray::fromBase64(text.mid(from, text.indexOf('"', from) - from));
  EXPECT_EQ(QImage::fromData(chart).size(), QSize(1200, 750)) << "the page carries its chart";
}

TEST_F(AccuracyWindowTest, theTimeWhileMovingIsKeptForTheNextRun) {
  EXPECT_EQ(loop().order().movingMs, 40.0);
  QComboBox* box = widgetNamed<QComboBox>(panel(), "While moving");
  panel().ensureWidgetVisible(box);
  box->setFocus();
  QTest::keyClick(box, Qt::Key_End);
  EXPECT_EQ(loop().order().movingMs, 100.0);
  EXPECT_EQ(Settings(UserFolders::below(folder.path()).settings).movingMs(), 100.0);
}

} // namespace
} // namespace limn
