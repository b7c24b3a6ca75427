// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/AccuracySamples.h"
#include "widgets/accuracy/ChartPicture.h"

#include <QPainter>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace limn {
namespace {

// A chart as a picture shows it.
struct ShownChart {
  explicit ShownChart(const AccuracyReport& report) {
    picture.report = report;
    picture.curves = chartCurves(report, ErrorMeasure::p99_9);
    picture.size = drawn.size();
    picture.legendAtRight = true;
    drawn.fill(chartColors(picture.style).background);
    QPainter painter(&drawn);
    paintChart(painter, picture);
  }

  ChartPicture picture;
  QImage drawn{600, 400, QImage::Format_RGB32};
};

TEST(AccuracyChart, showsOneCurveAndOneNamePerFamily) {
  const AccuracyReport report = sampleReport(usualPoints());
  std::set<QString> families;
  for (const MeasuredPoint& point : report.points)
    families.insert(QString::fromStdString(familyOf(point.point)));
  const ShownChart shown(report);
  EXPECT_EQ(shown.picture.curves.size(), families.size());
  QStringList legend;
  for (const LegendEntry& entry : legendEntries(shown.picture))
    legend << entry.name;
  EXPECT_EQ(legend.removeAll(QStringLiteral("best trade-offs")), 1);
  EXPECT_EQ(std::set<QString>(legend.begin(), legend.end()), families);
  EXPECT_EQ(legend.size(), static_cast<int>(families.size())) << "no family is named twice";
}

// Both axes are logarithmic: between two points pixels are as the logarithms of time and error.
TEST(AccuracyChart, placesAndPaintsItsMarksByTheLogarithmsOfTimeAndError) {
  const AccuracyReport report = sampleReport(fewPoints());
  const ShownChart shown(report);
  const auto logarithms = [&](std::size_t i) {
    return QPointF(std::log(report.points[i].ms.median), std::log(report.points[i].error.p99_9));
  };
  const PlotTransform plot = chartPlot(shown.picture);
  const QPointF first = *positionOf(shown.picture, 0);
  const QPointF second = *positionOf(shown.picture, 1);
  const double perTime = (second.x() - first.x()) / (logarithms(1).x() - logarithms(0).x());
  const double perError = (second.y() - first.y()) / (logarithms(1).y() - logarithms(0).y());
  EXPECT_GT(perTime, 0.0) << "slow is right";
  EXPECT_LT(perError, 0.0) << "a large error is on top";
  for (const ChartCurve& curve : shown.picture.curves)
    for (const ChartMark& mark : curve.marks) {
      const QPointF place = *positionOf(shown.picture, mark.index);
      const QPointF away = logarithms(mark.index) - logarithms(0);
      EXPECT_NEAR(place.x(), first.x() + perTime * away.x(), 1e-6);
      EXPECT_NEAR(place.y(), first.y() + perError * away.y(), 1e-6);
      EXPECT_TRUE(plot.plot.contains(place));
    }
  // Of the curve on top the middle of every mark has its colour.
  const CurveLook look = curveLook(shown.picture.style, static_cast<int>(shown.picture.curves.size()) - 1);
  for (const ChartMark& mark : shown.picture.curves.back().marks)
    EXPECT_EQ(shown.drawn.pixel(positionOf(shown.picture, mark.index)->toPoint()), look.color.rgb());
}

// In narrow panels the number at the end of the axis stood half outside.
TEST(AccuracyChart, theLastNumberOfItsTimesIsWhole) {
  AccuracyReport report = sampleReport(fewPoints());
  for (const double factor : {1.0, 3.0, 5.0, 10.0, 30.0, 50.0}) {
    AccuracyReport slower = report;
    for (MeasuredPoint& point : slower.points)
      for (double* ms : {&point.ms.median, &point.ms.least, &point.ms.most})
        *ms *= factor;
    for (int width = 240; width < 320; width += 7) {
      const ChartPicture picture{.report = slower,
                                 .curves = chartCurves(slower, ErrorMeasure::p99_9),
                                 .style = ChartStyle::print,
                                 .size = QSize(width, 260),
                                 .textSize = 11.0};
      QImage drawn(width + 60, 260, QImage::Format_RGB32);
      drawn.fill(chartColors(picture.style).background);
      QPainter painter(&drawn);
      paintChart(painter, picture);
      painter.end();
      for (int x = width; x < drawn.width(); ++x)
        for (int y = 0; y < drawn.height(); ++y)
          ASSERT_EQ(drawn.pixelColor(x, y), chartColors(picture.style).background)
              << width << " pixels, times ×" << factor << " at " << x << ", " << y;
    }
  }
}

TEST(AccuracyChart, findsThePointUnderThePointer) {
  const ShownChart shown(sampleReport(fewPoints()));
  const QPointF place = *positionOf(shown.picture, 2);
  EXPECT_EQ(pointNear(shown.picture, place + QPointF(3.0, -4.0), 10.0), 2u);
  EXPECT_EQ(pointNear(shown.picture, place + QPointF(30.0, -40.0), 10.0), std::nullopt);
}

TEST(AccuracyChart, showsErrorsThatCannotBeToldFromNoneAtTheFloor) {
  AccuracyReport report = sampleReport(fewPoints());
  // Three times the last change is the least that counts: 0.06. At 1/16 the law of the sample gives 0.04.
  report.reference.lastChangeLevels = 0.02;
  const std::vector<ChartCurve> curves = chartCurves(report, ErrorMeasure::p99_9);
  ASSERT_FALSE(curves.empty());
  EXPECT_DOUBLE_EQ(curves[0].marks.back().error, 0.06);
  EXPECT_TRUE(curves[0].marks.back().isBelowFloor);
  EXPECT_FALSE(curves[0].marks.front().isBelowFloor);
}

TEST(AccuracyChart, writesABoundToTheLeftOfItsArrowWhereThePlotEnds) {
  AccuracyReport report = sampleReport(fewPoints());
  report.reference.lastChangeLevels = 0.02;
  const ShownChart shown(report);
  const ChartMark last = chartCurves(report, ErrorMeasure::p99_9)[0].marks.back();
  ASSERT_TRUE(last.isBelowFloor);
  const QPoint mark = positionOf(shown.picture, last.index)->toPoint();
  ASSERT_GT(mark.x() + 40, chartPlot(shown.picture).plot.right()) << "the bound fits to the right";
  // Beside the arrow, under the curve.
  std::set<QRgb> left;
  for (int x = mark.x() - 40; x < mark.x() - 6; ++x)
    for (int y = mark.y() + 10; y < mark.y() + 18; ++y)
      left.insert(shown.drawn.pixel(x, y));
  EXPECT_GT(left.size(), 4u) << "no letters, only the grid";
}

// From 128 paths in 6.4 s: a quarter of the error takes 16 times as many and as long.
TEST(AccuracyChart, drawsTheLawOfChanceOfPathsToAQuarterOfTheError) {
  const AccuracyReport report = samplePathReport();
  const ShownChart shown(report);
  const std::optional<QuarterError> quarter = quarterError(shown.picture);
  ASSERT_TRUE(quarter);
  EXPECT_EQ(quarter->paths, 2048);
  EXPECT_DOUBLE_EQ(quarter->ms, 102400.0);
  EXPECT_DOUBLE_EQ(quarter->error, report.points.back().error.p99_9 / 4.0);
  const PlotTransform plot = chartPlot(shown.picture);
  const QPointF end(xOfValue(plot, quarter->ms), yOfOpacity(plot, quarter->error));
  EXPECT_TRUE(plot.plot.contains(end));
  // Both axes are logarithmic: the line is straight through the point of most paths, and of one more colour
  // than ground and grid all the way.
  const QPointF last = *positionOf(shown.picture, report.points.size() - 1);
  const QPointF middle = 0.4 * last + 0.6 * end;
  const ChartColors colors = chartColors(shown.picture.style);
  const int ground = qGray(colors.background.rgb());
  const int contrast = std::abs(qGray(colors.secondaryText.rgb()) - ground);
  // A line one pixel wide shares two rows at most; the grid is fainter.
  const auto isLine = [&](const QImage& drawn, const QPointF& place) {
    for (int dy = -1; dy <= 1; ++dy)
      if (10 * std::abs(qGray(drawn.pixel(place.toPoint() + QPoint(0, dy))) - ground) > 4 * contrast)
        return true;
    return false;
  };
  for (const double part : {0.3, 0.5, 0.7, 0.8})
    EXPECT_TRUE(isLine(shown.drawn, (1.0 - part) * last + part * end)) << part;
  EXPECT_FALSE(isLine(shown.drawn, middle + QPointF(0.0, -20.0))) << "above it is nothing";
  // By the mean it leads to a quarter of that.
  ChartPicture byMean = shown.picture;
  byMean.measure = ErrorMeasure::mean;
  byMean.curves = chartCurves(report, ErrorMeasure::mean);
  EXPECT_DOUBLE_EQ(quarterError(byMean)->error, report.points.back().error.mean / 4.0);
  // Steps have no such law.
  EXPECT_FALSE(quarterError(ShownChart(sampleReport(fewPoints())).picture));
}

TEST(AccuracyChart, showsNoErrorsWhereTheExactPictureHasNotConverged) {
  AccuracyReport report = sampleReport(usualPoints());
  report.reference.converged = false;
  const ShownChart shown(report);
  EXPECT_TRUE(shown.picture.curves.empty());
  EXPECT_TRUE(legendEntries(shown.picture).empty());
  EXPECT_EQ(positionOf(shown.picture, 0), std::nullopt);
}

TEST(AccuracyChart, curvesRunFromCoarseToFine) {
  AccuracyReport report = sampleReport(fewPoints());
  std::swap(report.points[0], report.points[3]);
  const std::vector<ChartCurve> curves = chartCurves(report, ErrorMeasure::p99_9);
  for (std::size_t i = 1; i < curves[0].marks.size(); ++i)
    EXPECT_LT(report.points[curves[0].marks[i].index].point.stepVoxels,
              report.points[curves[0].marks[i - 1].index].point.stepVoxels);
}

TEST(CurveLook, tellsEightCurvesApartByColourAndFurtherOnesByMarkAndDashes) {
  for (const ChartStyle style : {ChartStyle::dark, ChartStyle::light, ChartStyle::print}) {
    std::set<std::tuple<QRgb, int, bool>> looks;
    for (int curve = 0; curve < 16; ++curve) {
      const CurveLook look = curveLook(style, curve);
      looks.insert({look.color.rgb(), static_cast<int>(look.shape), look.isDashed});
    }
    EXPECT_EQ(looks.size(), 16u);
  }
}

TEST(LegendBelow, breaksRowsBeforeNamesLeaveItsWidth) {
  const QFont font;
  const std::vector<LegendEntry> entries(5, {QStringLiteral("a family of points"), Qt::red});
  const double needed = legendLayout({entries[0], entries[1]}, font, 1e4).places[1].x();
  const LegendLayout one = legendLayout(entries, font, 5.0 * needed);
  const LegendLayout two = legendLayout(entries, font, 3.0 * needed);
  EXPECT_EQ(one.places.back().y(), 0.0);
  EXPECT_EQ(two.places[2].y(), 0.0);
  EXPECT_GT(two.places[3].y(), 0.0);
  EXPECT_EQ(two.places[3].x(), 0.0);
  EXPECT_NEAR(two.height, 2.0 * one.height, 1e-9);
}

TEST(AccuracyChartPicture, hasItsSizeAndMoreThanOneColour) {
  const QImage picture = accuracyChartPicture(sampleReport(usualPoints()), {640, 480}, ChartStyle::print);
  EXPECT_EQ(picture.size(), QSize(640, 480));
  std::set<QRgb> colors;
  for (int y = 0; y < 480; ++y)
    for (int x = 0; x < 640; ++x)
      colors.insert(picture.pixel(x, y));
  for (int curve = 0; curve < 8; ++curve)
    EXPECT_TRUE(colors.count(curveLook(ChartStyle::print, curve).color.rgb())) << "curve " << curve;
}

} // namespace
} // namespace limn
