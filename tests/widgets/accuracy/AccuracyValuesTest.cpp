// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Phantom.h"
#include "widgets/ContrastRatio.h"
#include "widgets/ValueText.h"
#include "widgets/accuracy/AccuracySamples.h"
#include "widgets/accuracy/ErrorMapOverlay.h"
#include "widgets/accuracy/PointUse.h"

#include <QLocale>

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(PromisedLevels, promisesNoLessThanWasMeasured) {
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(promisedLevels(0.651), QStringLiteral("0.66"));
  EXPECT_EQ(promisedLevels(0.65), QStringLiteral("0.65"));
  EXPECT_EQ(promisedLevels(41.6), QStringLiteral("42"));
  EXPECT_EQ(promisedLevels(0.99901), QStringLiteral("1"));
  EXPECT_EQ(promisedLevels(0.0123), QStringLiteral("0.013"));
  EXPECT_EQ(promisedLevels(0.0), QStringLiteral("0"));
}

TEST(PointText, saysLessThanWhatCannotBeToldFromNone) {
  QLocale::setDefault(QLocale::c());
  AccuracyReport report = sampleReport(fewPoints());
  report.reference.lastChangeLevels = 0.02; // three times that is the least that counts
  EXPECT_EQ(pointErrorText(report.points[5], report.reference), QStringLiteral("less than 0.06 levels"));
  EXPECT_TRUE(pointToolTip(report.points[5], report).contains(QStringLiteral("&lt; 0.06 levels")));
  EXPECT_TRUE(pointToolTip(report.points.front(), report).contains(QStringLiteral("2 voxels = 2 mm")));
}

TEST(PointUse, keepsWhatIsAutomaticWhereItLeadsToTheSame) {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 16.0});
  OperatingPoint point;
  point.stepVoxels = 0.25;
  EXPECT_EQ(qualityAt(point, scene, 0.0).preintegrated, Preintegration::automatic);
  scene.quality.preintegrated = Preintegration::always;
  scene.transferFunction.points = {{-1000.0, glm::dvec3(1.0), 0.0}, {500.0, glm::dvec3(1.0), 0.8}};
  EXPECT_EQ(qualityAt(point, scene, 0.0).preintegrated, Preintegration::never);
  EXPECT_EQ(pointOf(scene, 0.0)->preintegrated, true);
  scene.quality.jitter = true;
  EXPECT_EQ(pointOf(scene, 0.0), std::nullopt) << "no point is jittered";
  EXPECT_FALSE(qualityAt(point, scene, 0.0).jitter);
}

TEST(PointUse, measuresEveryPositionOfTheDial) {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 16.0});
  scene.transferFunction.points = {{-1000.0, glm::dvec3(1.0), 0.0}, {500.0, glm::dvec3(1.0), 0.8}};
  for (const Preintegration mode :
       {Preintegration::automatic, Preintegration::always, Preintegration::never}) {
    scene.quality.preintegrated = mode;
    const AccuracyReport report = sampleReport(pointsToMeasure(scene, 100.0));
    for (const OperatingPoint& point : dialPoints(scene, 100.0))
      EXPECT_TRUE(indexOf(point, report.points)) << point.stepVoxels;
  }
}

// Of physical light there is no dial, and a point says its paths.
TEST(PointUse, ofPhysicalLightIsTheNumberOfItsPaths) {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 16.0});
  scene.shading.model = ShadingModel::physical;
  scene.transferFunction.points = {{-1000.0, glm::dvec3(1.0), 0.0}, {500.0, glm::dvec3(1.0), 0.8}};
  EXPECT_TRUE(dialPoints(scene, 100.0).empty());
  EXPECT_EQ(pointOf(scene, 100.0)->paths, UntilPaths().paths);
  scene.quality.paths = 8;
  const OperatingPoint point = *pointOf(scene, 100.0);
  EXPECT_EQ(point.paths, 8);
  EXPECT_FALSE(isOfTheWindow(point)) << "paths go on by themselves";
  EXPECT_EQ(pointText(point), QStringLiteral("8 paths a pixel"));
  EXPECT_EQ(familyText(point), QStringLiteral("random paths"));
}

TEST(ErrorScale, hasItsTicksInOrderAndItsColoursByLightness) {
  for (std::size_t tick = 1; tick < errorScaleTicks.size(); ++tick)
    EXPECT_GT(errorScalePlace(errorScaleTicks[tick]), errorScalePlace(errorScaleTicks[tick - 1]));
  EXPECT_EQ(errorScalePlace(0.0), 0.0);
  EXPECT_EQ(errorScalePlace(10.0), 1.0);
  EXPECT_EQ(errorScalePlace(1e9), 1.0);
  for (int i = 1; i <= 20; ++i)
    EXPECT_GT(contrastRatio(errorScaleColor(i / 20.0), Qt::black),
              contrastRatio(errorScaleColor((i - 1) / 20.0), Qt::black))
        << "place " << i / 20.0;
}

TEST(ErrorMapOverlay, coloursWhatIsCoveredAndLeavesTheRest) {
  QWidget view;
  view.resize(400, 400);
  ErrorMapOverlay overlay(&view);
  EXPECT_FALSE(overlay.isVisibleTo(&view));
  // The left half is not covered, the right one is off by ten levels.
  overlay.showMap({{2, 1}, {-1.0f, 10.0f}}, {0.0, 0.0, 400.0, 400.0});
  QImage shown(400, 400, QImage::Format_ARGB32_Premultiplied);
  shown.fill(Qt::blue);
  overlay.render(&shown, {}, {}, QWidget::DrawChildren);
  EXPECT_EQ(shown.pixelColor(80, 390), QColor(Qt::blue));
  EXPECT_EQ(shown.pixelColor(210, 390).rgb(), errorScaleColor(1.0).rgb());
  EXPECT_TRUE(QRectF(0.0, 0.0, 400.0, 400.0).contains(overlay.legendRect()));
}

} // namespace
} // namespace limn
