// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/AccuracyPanel.h"
#include "scene/effects/EffectPlan.h"
#include "scene/light/LightPresets.h"
#include "scene/volume/Phantom.h"
#include "support/Waiting.h"
#include "widgets/FindWidget.h"
#include "widgets/accuracy/AccuracyChart.h"
#include "widgets/accuracy/AccuracySamples.h"
#include "widgets/accuracy/DialSection.h"
#include "widgets/accuracy/MapSection.h"
#include "widgets/accuracy/MeasuredSection.h"
#include "widgets/accuracy/StopSlider.h"
#include "widgets/accuracy/WishSection.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/WorkRow.h"

#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

// By the law of the sample rays err by 10.4 step² levels and take 12 + 9 / step ms: at the steps 2, 1, 1/2,
// 1/4, 1/8 and 1/16 by 41.6, 10.4, 2.6, 0.65, 0.1625 and 0.0406 levels in 16.5, 21, 30, 48, 84 and 156 ms.
class AccuracyPanelTest : public testing::Test {
protected:
  AccuracyPanelTest() {
    QLocale::setDefault(QLocale::c());
    scene.volume = phantomVolume({.spacingMm = 16.0});
    scene.transferFunction.points.resize(2);
    scene.transferFunction.points[0].value = -1000.0;
    scene.transferFunction.points[1].value = 500.0;
    scene.transferFunction.points[1].opacity = 0.8;
    scene.quality.preintegrated = Preintegration::never;
    panel.resize(320, 1300);
    panel.show();
    panel.setScene(scene);
    QObject::connect(&panel, &AccuracyPanel::qualityEdited,
                     [this](const Quality& quality, const Gesture& gesture) {
                       ++edits;
                       undoText = gesture.text;
                       scene.quality = quality;
                       panel.setScene(scene);
                     });
  }

  void measure() {
    panel.setMeasured({sampleReport(pointsToMeasure(scene, 0.0)), scene, 0.0, {}});
    for (int round = 0; round < 5; ++round) // layouts within layouts
      QCoreApplication::processEvents();
  }

  StopSlider& dial() { return *panel.findChild<StopSlider*>(); }
  template <class Section>
  QString textOf(const char* label) {
    return panel.findChild<Section*>()->template findChild<QLabel*>(QString::fromLatin1(label))->text();
  }
  QString answer() { return textOf<WishSection>("answer"); }
  QPushButton* useLevels() { return widgetNamed<QPushButton>(panel, "Use: Error at most, levels"); }
  QPushButton* useMs() { return widgetNamed<QPushButton>(panel, "Use: Time at most, ms"); }
  QCheckBox* mapCheck() { return panel.findChild<MapSection*>()->findChild<QCheckBox*>(); }
  WorkRow& work() { return *panel.findChild<MeasuredSection*>()->work(); }
  QString sentence() { return textOf<DialSection>("sentence"); }
  AccuracyChart& chart() { return *panel.findChild<AccuracyChart*>(); }

  void clickPoint(const OperatingPoint& point) {
    const std::optional<std::size_t> index = indexOf(point, panel.measured()->report.points);
    ASSERT_TRUE(index);
    QTest::mouseClick(&chart(), Qt::LeftButton, {}, chart().placeOf(*index)->toPoint());
  }

  Scene scene;
  AccuracyPanel panel;
  int edits = 0;
  QString undoText;
};

OperatingPoint raysAt(double step, bool preintegrated = false) {
  OperatingPoint point;
  point.stepVoxels = step;
  point.preintegrated = preintegrated;
  return point;
}

TEST_F(AccuracyPanelTest, theDialTellsErrorAndTimeOfItsPositionOnceMeasured) {
  EXPECT_EQ(sentence(), QStringLiteral("Step 1/2 voxel: not measured for this picture."));
  measure();
  EXPECT_EQ(sentence(), QStringLiteral("Step 1/2 voxel: within 2.6 levels, 30 ms."));
  QTest::mouseClick(&dial(), Qt::LeftButton, {}, dial().centreAt(3).toPoint());
  EXPECT_EQ(edits, 1);
  EXPECT_EQ(scene.quality.stepVoxels, 0.25);
  EXPECT_EQ(undoText, QStringLiteral("use step 1/4 voxel"));
  EXPECT_EQ(sentence(), QStringLiteral("Step 1/4 voxel: within 0.65 levels, 48 ms."));
}

// What is exact to more levels than the dial's end stands before that end, whose figures are not its own.
TEST_F(AccuracyPanelTest, theDialStandsBeforeItsEndWhereMoreLevelsAreAllowed) {
  scene.quality.toleranceLevels = 0.5;
  panel.setScene(scene);
  const double end = dial().place();
  scene.quality.toleranceLevels = 2.0;
  panel.setScene(scene);
  EXPECT_NEAR(dial().place(), end - 0.25, 1e-12);
  scene.quality.toleranceLevels = 200.0;
  panel.setScene(scene);
  EXPECT_NEAR(dial().place(), end - 0.5, 1e-12);
}

TEST_F(AccuracyPanelTest, theDialTellsWhatAPictureThatWasRefinedIsOnScreen) {
  measure();
  panel.setOnScreen(scene.quality);
  EXPECT_EQ(sentence(), QStringLiteral("Step 1/2 voxel: within 2.6 levels, 30 ms.")) << "as chosen";
  Quality refined = scene.quality;
  refined.stepVoxels = 0.125;
  panel.setOnScreen(refined);
  EXPECT_EQ(sentence(), QStringLiteral("Step 1/2 voxel: within 2.6 levels, 30 ms. Refined on screen to step "
                                       "1/8 voxel, within 0.17 levels."));
  Scene shown = scene;
  shown.quality = refined;
  EXPECT_NEAR(*levelsMeasuredOf(shown, *panel.measured()), 10.4 / 64.0, 1e-12) << "10.4 step²";
  shown.camera.position.x += 1.0;
  EXPECT_FALSE(levelsMeasuredOf(shown, *panel.measured())) << "of another direction";
  refined.stepVoxels = 0.3;
  panel.setOnScreen(refined);
  EXPECT_TRUE(sentence().endsWith(QStringLiteral("Refined on screen to step 0.3 voxels.")))
      << sentence().toStdString();
  panel.setOnScreen(std::nullopt);
  EXPECT_EQ(sentence(), QStringLiteral("Step 1/2 voxel: within 2.6 levels, 30 ms.")) << "being drawn";
}

// One picture has one error: where none was measured of what is on screen the status bar's stands here, too.
TEST_F(AccuracyPanelTest, theDialTellsWhatTheStatusBarTellsOfThePictureOnScreen) {
  const QString told = QStringLiteral("estimated within 0.7 of 255 levels");
  panel.setOnScreen(scene.quality, told);
  EXPECT_EQ(sentence(),
            QStringLiteral("Step 1/2 voxel: not measured for this picture. The picture on screen: "
                           "estimated within 0.7 of 255 levels."));
  measure();
  panel.setOnScreen(scene.quality);
  EXPECT_EQ(sentence(), QStringLiteral("Step 1/2 voxel: within 2.6 levels, 30 ms."))
      << "the status bar says what was measured";
  panel.setOnScreen(scene.quality, QStringLiteral("99.9 % of pixels within 2.7 of 255 levels (95 % sure)"));
  EXPECT_EQ(
      sentence(),
      QStringLiteral("Step 1/2 voxel: within 2.6 levels, 30 ms. The picture on screen: 99.9 % of pixels "
                     "within 2.7 of 255 levels (95 % sure)."))
      << "a smaller picture was measured";
  Quality refined = scene.quality;
  refined.stepVoxels = 0.3;
  panel.setOnScreen(refined, told);
  EXPECT_TRUE(sentence().endsWith(
      QStringLiteral("Refined on screen to step 0.3 voxels: estimated within 0.7 of 255 levels.")))
      << sentence().toStdString();
  scene.camera.position.x += 1.0;
  panel.setScene(scene);
  panel.setOnScreen(scene.quality, told);
  EXPECT_EQ(
      sentence(),
      QStringLiteral("Step 1/2 voxel: within 2.6 levels, 30 ms. It was measured from another direction. "
                     "The picture on screen: estimated within 0.7 of 255 levels."));
}

// What steps are meant for is said as that beside what came of them.
TEST_F(AccuracyPanelTest, ofAToleranceTheDialSaysThatItIsMeant) {
  scene.quality.toleranceLevels = 0.5;
  panel.setScene(scene);
  panel.setOnScreen(scene.quality, QStringLiteral("within 0.57 of 255 levels"));
  EXPECT_EQ(sentence(), QStringLiteral("Steps meant to be exact to half a level: not measured for this "
                                       "picture. The picture on screen: within 0.57 of 255 levels."));
  Quality asked = scene.quality;
  asked.toleranceLevels.reset();
  scene.quality.toleranceLevels.reset();
  panel.setScene(scene);
  asked.toleranceLevels = 0.5;
  panel.setOnScreen(asked, QStringLiteral("within 0.57 of 255 levels"));
  EXPECT_TRUE(
      sentence().endsWith(QStringLiteral("Refined on screen to steps by error: within 0.57 of 255 levels.")))
      << sentence().toStdString();
}

// Where it is automatic long steps average the curve, and the dial has them so.
TEST_F(AccuracyPanelTest, theDialSaysWhichStepsAverageTheCurveAndWhichAnotherBeatsInBoth) {
  const auto note = [this] { return textOf<DialSection>("note"); };
  EXPECT_FALSE(note().contains(QStringLiteral("average"))) << note().toStdString();
  scene.quality.preintegrated = Preintegration::always;
  panel.setScene(scene);
  EXPECT_TRUE(note().startsWith(QStringLiteral("Tissue that is thinner than a step is not missed (\"curve "
                                               "averaged\" in the chart). ")))
      << note().toStdString();
  scene.quality.preintegrated = Preintegration::automatic;
  panel.setScene(scene);
  double steepest = 1.0;
  while (!dialPoints(scene, steepest).front().preintegrated)
    steepest *= 1.1;
  ASSERT_FALSE(dialPoints(scene, steepest)[1].preintegrated) << "a tenth steeper than steps of 2 allow";
  AccuracyReport report = sampleReport(pointsToMeasure(scene, steepest));
  panel.setMeasured({report, scene, steepest, {}});
  EXPECT_TRUE(note().startsWith(QStringLiteral("Tissue that is thinner than a step is not missed with a step "
                                               "of 2 (\"curve averaged\" in the chart). ")))
      << note().toStdString();
  // Averaged steps take longer, so that the step of 1, which does not average, is there sooner.
  EXPECT_TRUE(note().contains(QStringLiteral("Rather than 2 choose a position that is ")))
      << note().toStdString();
  for (MeasuredPoint& measured : report.points)
    if (measured.point == raysAt(0.125)) { // slower than the exact end, and farther off
      measured.ms.median = 500.0;
      measured.error.p99_9 = 0.6;
    }
  panel.setMeasured({report, scene, steepest, {}});
  EXPECT_TRUE(note().contains(QStringLiteral("Rather than 2 or 1/8 choose a position that is both faster and "
                                             "closer to the exact picture.")))
      << note().toStdString();
}

// What is seen at rest is closer than the step that the dial stands at.
TEST_F(AccuracyPanelTest, theDialSaysThatItsFiguresAreOfThePictureBeforeItIsRefined) {
  const QString sentenceOfIt = QStringLiteral("are those of the picture before it is refined.");
  EXPECT_FALSE(textOf<DialSection>("note").contains(sentenceOfIt)) << "there are no figures yet";
  measure();
  EXPECT_TRUE(textOf<DialSection>("note").contains(sentenceOfIt));
}

TEST_F(AccuracyPanelTest, theDialSaysWhyShadowsKeepAPictureFromBeingExact) {
  const auto note = [this] { return textOf<DialSection>("note"); };
  EXPECT_TRUE(note().startsWith(QStringLiteral("From there it refines while nothing moves. ")));
  scene.shading.model = ShadingModel::classic;
  scene.shading = withLight(scene.shading, LightPreset::studio);
  ASSERT_TRUE(hasTravellingLight(scene));
  panel.setScene(scene);
  EXPECT_TRUE(note().contains(QStringLiteral("grid of light"))) << note().toStdString();
  EXPECT_TRUE(note().contains(QStringLiteral("With \"exact\" the processor follows more paths")));
  scene.quality.toleranceLevels = 0.5;
  panel.setScene(scene);
  EXPECT_FALSE(note().contains(QStringLiteral("grid of light"))) << "it is";
}

// Where a panel is narrower than its texts would like to be, they take more lines.
TEST_F(AccuracyPanelTest, whatStandsInASectionIsWholeWhereThePanelIsNarrow) {
  scene.shading.model = ShadingModel::classic; // of which the most is said
  scene.shading = withLight(scene.shading, LightPreset::studio);
  panel.setScene(scene);
  for (const int width : {280, 320, 400}) {
    panel.resize(width, 700);
    measure();
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->wordWrap() && label->isVisible()) {
        EXPECT_GE(label->height(), label->heightForWidth(label->width()))
            << width << ": " << label->text().toStdString();
      }
    EXPECT_GE(dial().height(), dial().sizeHint().height()) << width << ": the row of times";
  }
}

TEST_F(AccuracyPanelTest, theChartIsAsHighAsThePanelHasRoomForAndGoesIntoAWindowWhereAsked) {
  auto* apart = widgetNamed<QPushButton>(panel, "Chart in a window of its own");
  measure();
  EXPECT_EQ(chart().height(), 340) << "1300 pixels are enough";
  panel.resize(320, 380);
  measure();
  ASSERT_TRUE(test::waitUntil([&] { return chart().visibleRegion().boundingRect() == chart().rect(); }))
      << "all of it";
  EXPECT_LT(chart().height(), 340);
  EXPECT_EQ(chart().window(), &panel) << "no window comes up by itself";
  panel.ensureWidgetVisible(apart);
  QTest::mouseClick(apart, Qt::LeftButton);
  QWidget* window = chart().window();
  ASSERT_NE(window, &panel);
  EXPECT_TRUE(window->isVisible());
  clickPoint(raysAt(0.125));
  EXPECT_EQ(scene.quality.stepVoxels, 0.125) << "it works there, too";
  QTest::keyClick(window, Qt::Key_Escape);
  EXPECT_EQ(chart().window(), &panel);
  EXPECT_TRUE(chart().isVisibleTo(&panel));
  EXPECT_FALSE(apart->isChecked());
  QTest::mouseClick(apart, Qt::LeftButton);
  EXPECT_NE(chart().window(), &panel);
  QTest::mouseClick(apart, Qt::LeftButton);
  EXPECT_EQ(chart().window(), &panel);
}

TEST_F(AccuracyPanelTest, theDialObeysKeysAndStandsBetweenPositionsWhereTheStepIsNone) {
  dial().setFocus();
  QTest::keyClick(&dial(), Qt::Key_Left);
  EXPECT_EQ(scene.quality.stepVoxels, 1.0);
  for (int stop = 0; stop < 3; ++stop)
    QTest::keyClick(&dial(), Qt::Key_Right);
  EXPECT_EQ(scene.quality.stepVoxels, 0.125);
  scene.quality.stepVoxels = 0.4;
  panel.setScene(scene);
  EXPECT_NEAR(dial().place(), std::log2(2.0 / 0.4), 1e-12);
  edits = 0;
  QTest::mouseClick(&dial(), Qt::LeftButton, {}, dial().centreAt(2).toPoint());
  EXPECT_EQ(edits, 1) << "the nearest position is another step";
  EXPECT_EQ(scene.quality.stepVoxels, 0.5);
}

TEST_F(AccuracyPanelTest, theExactEndAsksForStepsWithinHalfALevelAndComesBackFromThere) {
  std::optional<Quality> wished;
  QObject::connect(&panel, &AccuracyPanel::toleranceWished,
                   [&](const Quality& quality, const Gesture&) { wished = quality; });
  measure();
  dial().setFocus();
  QTest::keyClick(&dial(), Qt::Key_End);
  EXPECT_EQ(edits, 0) << "the steps are still to be found";
  ASSERT_TRUE(wished);
  EXPECT_EQ(wished->toleranceLevels, 0.5);
  scene.quality = *wished;
  scene.quality.fineness = 7;
  scene.quality.earlyTermination = 0.9999; // as the tolerance needs it
  panel.setScene(scene);
  EXPECT_EQ(sentence(), QStringLiteral("Exact to half a level: within 0.4 levels, 70 ms."));
  EXPECT_EQ(dial().place(), 5.0);
  QTest::keyClick(&dial(), Qt::Key_Left);
  EXPECT_EQ(edits, 1);
  EXPECT_FALSE(scene.quality.toleranceLevels);
  EXPECT_FALSE(scene.quality.fineness);
  EXPECT_EQ(scene.quality.earlyTermination, Quality{}.earlyTermination);
  EXPECT_EQ(sentence(), QStringLiteral("Step 1/8 voxel: within 0.17 levels, 84 ms."));
}

TEST_F(AccuracyPanelTest, aClickOnAPointUsesItAsOneEdit) {
  measure();
  clickPoint(raysAt(0.125));
  EXPECT_EQ(edits, 1);
  EXPECT_EQ(scene.quality.stepVoxels, 0.125);
  EXPECT_EQ(scene.quality.preintegrated, Preintegration::never);
  clickPoint(raysAt(0.5, true));
  EXPECT_EQ(edits, 2);
  EXPECT_EQ(scene.quality.preintegrated, Preintegration::always);
  EXPECT_EQ(undoText, QStringLiteral("use step 1/2 voxel, curve averaged"));
}

TEST_F(AccuracyPanelTest, keysWalkThePointsInOrderOfTimeAndEnterUsesOne) {
  measure();
  chart().setFocus();
  QTest::keyClick(&chart(), Qt::Key_Right);
  QTest::keyClick(&chart(), Qt::Key_Return);
  EXPECT_EQ(scene.quality.stepVoxels, 2.0) << "the fastest";
  QTest::keyClick(&chart(), Qt::Key_Left); // from there on: no point is faster
  QTest::keyClick(&chart(), Qt::Key_Right);
  QTest::keyClick(&chart(), Qt::Key_Right);
  QTest::keyClick(&chart(), Qt::Key_Return);
  EXPECT_EQ(edits, 2);
}

TEST_F(AccuracyPanelTest, aWishTakesTheBestPointThatKeepsIt) {
  measure();
  QTest::mouseClick(useLevels(), Qt::LeftButton);
  EXPECT_EQ(scene.quality.stepVoxels, 0.25) << "the fastest within 1 level: 48 ms";
  EXPECT_TRUE(answer().contains(QStringLiteral("within 0.65 levels, 48 ms"))) << answer().toStdString();
  QTest::mouseClick(useMs(), Qt::LeftButton);
  EXPECT_EQ(scene.quality.stepVoxels, 0.5) << "the most exact within 33 ms: 30 ms";
  EXPECT_EQ(edits, 2);
}

TEST_F(AccuracyPanelTest, aWishOfWhatWasNotMeasuredHasItMeasuredFirst) {
  int asked = 0;
  QObject::connect(&panel, &AccuracyPanel::measureRequested, &panel, [&asked] { ++asked; });
  ASSERT_TRUE(useLevels()->isEnabled());
  QTest::mouseClick(useLevels(), Qt::LeftButton);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(edits, 0);
  EXPECT_TRUE(answer().startsWith(QStringLiteral("Measuring first"))) << answer().toStdString();
  measure();
  EXPECT_EQ(scene.quality.stepVoxels, 0.25)
      << "the fastest within 1 level, as if it had been measured before";
  EXPECT_EQ(edits, 1);
}

TEST_F(AccuracyPanelTest, aWishThatNoneKeepsSaysWhatComesClosest) {
  measure();
  widgetNamed<NumberField>(panel, "Error at most, levels")->setNumber(0.03);
  QTest::mouseClick(useLevels(), Qt::LeftButton);
  EXPECT_EQ(edits, 0);
  EXPECT_EQ(answer().toStdString(),
            "No measured picture is that close. Closest: Step 1/8 voxel, curve averaged: within 0.074 "
            "levels, 126 ms.");
  widgetNamed<NumberField>(panel, "Time at most, ms")->setNumber(5.0);
  QTest::mouseClick(useMs(), Qt::LeftButton);
  EXPECT_EQ(edits, 0);
  EXPECT_TRUE(answer().startsWith(QStringLiteral("No measured picture is that fast.")));
}

TEST_F(AccuracyPanelTest, numbersOfAnEarlierPictureAreSaidToBeThatAndNotUsed) {
  measure();
  scene.camera.position.x += 5.0;
  panel.setScene(scene);
  EXPECT_TRUE(textOf<MeasuredSection>("summary").startsWith(QStringLiteral("Measured in another view.")));
  scene.transferFunction.points[1].opacity = 0.4;
  panel.setScene(scene);
  EXPECT_TRUE(
      textOf<MeasuredSection>("summary").startsWith(QStringLiteral("Measured for an earlier picture")));
  EXPECT_EQ(sentence(), QStringLiteral("Step 1/2 voxel: not measured for this picture."));
  EXPECT_TRUE(useLevels()->toolTip().startsWith(QStringLiteral("Measures this picture first")));
  clickPoint(raysAt(0.125));
  EXPECT_EQ(edits, 0);
  scene.transferFunction.points[1].opacity = 0.8;
  panel.setScene(scene);
  clickPoint(raysAt(0.125));
  EXPECT_EQ(edits, 1) << "undo brought the measured picture back";
}

TEST_F(AccuracyPanelTest, withoutAConvergedPictureNoErrorIsTold) {
  AccuracyReport report = sampleReport(pointsToMeasure(scene, 0.0));
  report.reference.converged = false;
  panel.setMeasured({report, scene, 0.0, {}});
  EXPECT_TRUE(sentence().contains(QStringLiteral("not converged")));
  QTest::mouseClick(useLevels(), Qt::LeftButton);
  EXPECT_EQ(edits, 0);
  EXPECT_TRUE(answer().contains(QStringLiteral("not converged")));
  QTest::mouseClick(useMs(), Qt::LeftButton);
  EXPECT_EQ(edits, 1) << "a time can be kept without knowing the error";
}

TEST_F(AccuracyPanelTest, timesAreToldForThePictureOnScreenAndThatTheyWereScaled) {
  const MeasuredAccuracy measured{sampleReport(pointsToMeasure(scene, 0.0)), scene, 0.0, {}};
  const glm::ivec2 size = measured.report.size;
  const MeasuredAccuracy scaled = timedFor(measured, 2 * size);
  EXPECT_EQ(scaled.report.points[0].error, measured.report.points[0].error);
  EXPECT_DOUBLE_EQ(scaled.report.points[0].ms.median, 4.0 * measured.report.points[0].ms.median);
  panel.setMeasured(scaled);
  // At half a voxel 30 ms for the picture that was measured.
  EXPECT_TRUE(sentence().contains(QStringLiteral("120 ms"))) << sentence().toStdString();
  const QString summary = panel.findChild<QLabel*>(QStringLiteral("summary"))->text();
  EXPECT_TRUE(summary.contains(QStringLiteral("scaled"))) << summary.toStdString();
  panel.setMeasured(timedFor(measured, size));
  EXPECT_FALSE(
      panel.findChild<QLabel*>(QStringLiteral("summary"))->text().contains(QStringLiteral("scaled")));
}

TEST_F(AccuracyPanelTest, progressStandsInThePanelAndCanBeCancelled) {
  QSignalSpy asked(&panel, &AccuracyPanel::measureRequested);
  QSignalSpy cancelled(&panel, &AccuracyPanel::cancelRequested);
  QPushButton* button = widgetNamed<QPushButton>(panel, "Measure error and time");
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(asked.count(), 1);
  panel.setWork(AccuracyWork::measuring);
  panel.showProgress(0.5, QStringLiteral("Drawing the exact picture"));
  EXPECT_FALSE(button->isEnabled());
  EXPECT_TRUE(work().isVisible());
  EXPECT_FALSE(mapCheck()->isEnabled()) << "one piece of work at a time";
  QCoreApplication::processEvents();
  QTest::mouseClick(work().findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_EQ(cancelled.count(), 1);
  panel.setWork(AccuracyWork::none);
  EXPECT_FALSE(work().isVisible());
  EXPECT_TRUE(button->isEnabled());
}

TEST_F(AccuracyPanelTest, theMapSaysWhatItShowsAndLeavesWithThePicture) {
  ComparedPicture compared;
  compared.point.stepVoxels = 0.5;
  compared.reference = {true, 1.0 / 128.0, 0.01, 0.0001};
  compared.error.emplace();
  compared.error->p99_9 = 1.23;
  compared.error->shareOverOne = 0.034;
  compared.map = {{2, 1}, {0.0f, 1.5f}};
  panel.setCompared(compared);
  EXPECT_TRUE(mapCheck()->isChecked());
  EXPECT_TRUE(textOf<MapSection>("sentence").contains(QStringLiteral("within 1.3 levels")));
  EXPECT_TRUE(textOf<MapSection>("sentence").contains(QStringLiteral("3.4 % of the pixels")));
  scene.isovalue += 1.0;
  panel.setScene(scene);
  EXPECT_FALSE(mapCheck()->isChecked());
  EXPECT_TRUE(textOf<MapSection>("sentence").isEmpty());
  compared.reference.converged = false;
  compared.error.reset();
  panel.setCompared(compared);
  EXPECT_FALSE(mapCheck()->isChecked());
  EXPECT_TRUE(textOf<MapSection>("sentence").startsWith(QStringLiteral("Not converged")));
}

TEST_F(AccuracyPanelTest, aComparisonIsTickedWhileItRunsAndSaysThatItEnded) {
  panel.setWork(AccuracyWork::comparing);
  EXPECT_TRUE(mapCheck()->isChecked());
  panel.setWork(AccuracyWork::none);
  EXPECT_FALSE(mapCheck()->isChecked());
  panel.sayComparisonEnded(QStringLiteral("The picture changed."));
  EXPECT_EQ(textOf<MapSection>("sentence"), QStringLiteral("The picture changed."));
}

TEST_F(AccuracyPanelTest, aSinglePathTellsNoError) {
  ComparedPicture compared;
  compared.point.paths = 1;
  compared.reference.converged = compared.reference.isByChance = true;
  compared.map = {{2, 1}, {0.0f, 255.0f}};
  panel.setCompared(compared);
  EXPECT_FALSE(mapCheck()->isChecked()) << "there is nothing to show";
  const QString sentence = textOf<MapSection>("sentence");
  EXPECT_TRUE(sentence.startsWith(QStringLiteral("1 path a pixel: the error is not known")))
      << sentence.toStdString();
}

TEST_F(AccuracyPanelTest, theTimeWhileMovingIsChosenFromAFew) {
  QSignalSpy picked(&panel, &AccuracyPanel::movingMsPicked);
  QComboBox* box = widgetNamed<QComboBox>(panel, "While moving");
  EXPECT_EQ(box->currentText(), QStringLiteral("at most 40 ms"));
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Up);
  ASSERT_EQ(picked.count(), 1);
  EXPECT_EQ(picked[0][0].toDouble(), 33.0);
}

TEST_F(AccuracyPanelTest, theDialIsASliderForThoseWhoCannotSeeIt) {
  measure();
  QAccessibleInterface* slider = QAccessible::queryAccessibleInterface(&dial());
  EXPECT_EQ(slider->role(), QAccessible::Slider);
  EXPECT_EQ(slider->text(QAccessible::Name), QStringLiteral("Faster or closer to exact"));
  QAccessibleValueInterface* value = slider->valueInterface();
  ASSERT_NE(value, nullptr);
  EXPECT_EQ(value->minimumValue().toInt(), 0);
  EXPECT_EQ(value->maximumValue().toInt(), dial().maximum());
  EXPECT_EQ(value->currentValue().toInt(), dial().value());
  value->setCurrentValue(dial().value() + 1);
  EXPECT_EQ(edits, 1);
}

TEST_F(AccuracyPanelTest, everyControlHasANameForThoseWhoCannotSeeIt) {
  measure();
  for (const QWidget* control : panel.findChildren<QWidget*>()) {
    const bool isOurs = !control->objectName().startsWith(QStringLiteral("qt_"));
    if (isOurs && control->focusPolicy() != Qt::NoFocus && control->isVisibleTo(&panel)) {
      EXPECT_FALSE(control->accessibleName().isEmpty()) << control->metaObject()->className() << " in "
                                                        << control->parentWidget()->metaObject()->className();
    }
  }
}

} // namespace
} // namespace limn
