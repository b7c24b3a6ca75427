// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/chart/AccuracyChart.h"
#include "widgets/accuracy/AccuracySamples.h"
#include "widgets/accuracy/chart/AccuracyChartPicture.h"

#include <QGraphicsScene>
#include <QLegendMarker>
#include <QPainter>
#include <QScatterSeries>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace limn {
namespace {

// A chart laid out in a scene, as a view or a picture shows it.
struct ShownChart {
  explicit ShownChart(const AccuracyReport& report) {
    scene.addItem(chart);
    chart->setLegendAtRight(true);
    chart->setReport(report);
    chart->resize(600.0, 400.0);
    QPainter painter(&drawn);
    scene.render(&painter, drawn.rect(), drawn.rect());
  }

  QStringList legend() const {
    QStringList names;
    for (const QLegendMarker* marker : chart->legend()->markers())
      if (marker->isVisible())
        names << marker->label();
    return names;
  }

  QGraphicsScene scene;
  AccuracyChart* chart = new AccuracyChart;
  QImage drawn{600, 400, QImage::Format_RGB32};
};

TEST(AccuracyChart, showsOneSeriesAndOneNamePerFamily) {
  const AccuracyReport report = sampleReport(usualPoints());
  std::set<QString> families;
  for (const MeasuredPoint& point : report.points)
    families.insert(QString::fromStdString(familyOf(point.point)));
  const ShownChart shown(report);
  EXPECT_EQ(shown.chart->curves().size(), families.size());
  QStringList legend = shown.legend();
  EXPECT_EQ(legend.removeAll(QStringLiteral("best trade-offs")), 1);
  EXPECT_EQ(std::set<QString>(legend.begin(), legend.end()), families);
  EXPECT_EQ(legend.size(), static_cast<int>(families.size())) << "no family is named twice";
}

TEST(AccuracyChart, placesItsNotesWhereQtPlacesTheMarks) {
  const AccuracyReport report = sampleReport(fewPoints());
  const ShownChart shown(report);
  QAbstractSeries* series = shown.chart->series().front();
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const MeasuredPoint& point = report.points[i];
    const QPointF qt =
        shown.chart->mapToPosition({std::log10(point.ms.median), std::log10(point.error.p99_9)}, series);
    const std::optional<QPointF> ours = shown.chart->positionOf(i);
    ASSERT_TRUE(ours);
    EXPECT_NEAR(ours->x(), qt.x(), 0.5) << "half a pixel";
    EXPECT_NEAR(ours->y(), qt.y(), 0.5);
    EXPECT_TRUE(shown.chart->plotArea().contains(*ours));
  }
}

TEST(AccuracyChart, findsThePointUnderThePointer) {
  const ShownChart shown(sampleReport(fewPoints()));
  const QPointF place = *shown.chart->positionOf(2);
  EXPECT_EQ(shown.chart->pointNear(place + QPointF(3.0, -4.0), 10.0), 2u);
  EXPECT_EQ(shown.chart->pointNear(place + QPointF(30.0, -40.0), 10.0), std::nullopt);
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
  const QPoint mark = shown.chart->positionOf(last.index)->toPoint();
  ASSERT_GT(mark.x() + 40, shown.chart->plotArea().right()) << "the bound fits to the right";
  // Beside the arrow, under the curve.
  std::set<QRgb> left;
  for (int x = mark.x() - 40; x < mark.x() - 6; ++x)
    for (int y = mark.y() + 10; y < mark.y() + 18; ++y)
      left.insert(shown.drawn.pixel(x, y));
  EXPECT_GT(left.size(), 4u) << "no letters, only the grid";
}

TEST(AccuracyChart, showsNoErrorsWhereTheExactPictureHasNotConverged) {
  AccuracyReport report = sampleReport(usualPoints());
  report.reference.converged = false;
  const ShownChart shown(report);
  EXPECT_TRUE(shown.chart->series().isEmpty());
  EXPECT_EQ(shown.chart->positionOf(0), std::nullopt);
}

TEST(AccuracyChart, curvesRunFromCoarseToFine) {
  AccuracyReport report = sampleReport(fewPoints());
  std::swap(report.points[0], report.points[3]);
  const std::vector<ChartCurve> curves = chartCurves(report, ErrorMeasure::p99_9);
  for (std::size_t i = 1; i < curves[0].marks.size(); ++i)
    EXPECT_LT(report.points[curves[0].marks[i].index].point.stepVoxels,
              report.points[curves[0].marks[i - 1].index].point.stepVoxels);
}

TEST(LogAxis, hasRoundTicksWithinItsRangeAndNotTooMany) {
  const LogAxis fine = logAxisAround(3.0, 70.0, 10);
  // 6 % of 1.37 decades of room at each end: 2.5 .. 85.
  ASSERT_EQ(fine.ticks.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_DOUBLE_EQ(fine.ticks[i], (std::array{5.0, 10.0, 20.0, 50.0})[i]);
  EXPECT_LT(fine.lowest, 3.0);
  EXPECT_GT(fine.highest, 70.0);
  const LogAxis wide = logAxisAround(1e-3, 1e4, 5);
  EXPECT_LE(wide.ticks.size(), 5u);
  EXPECT_GE(wide.ticks.size(), 2u);
  const LogAxis point = logAxisAround(10.0, 10.0, 8);
  EXPECT_LT(point.lowest, 10.0) << "a single place has room at both sides";
  EXPECT_GT(point.highest, 10.0);
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
