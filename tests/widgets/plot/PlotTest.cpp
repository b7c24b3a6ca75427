// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/Axes.h"

#include <QLocale>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace limn {
namespace {

const PlotTransform plotted{QRectF(50.0, 20.0, 800.0, 200.0), {-1000.0, 3000.0}};

TEST(PlotTransform, pixelsAndValuesAreInverse) {
  for (const AxisScale scale : {AxisScale::linear, AxisScale::cubeRoot}) {
    PlotTransform transform = plot;
    transform.upScale = scale;
    for (const double value : {-1000.0, -310.5, 0.0, 2999.9})
      EXPECT_NEAR(valueAtX(transform, xOfValue(transform, value)), value, 1e-9);
    for (const double opacity : {0.0, 1e-4, 0.01, 0.5, 1.0})
      EXPECT_NEAR(opacityAtY(transform, yOfOpacity(transform, opacity)), opacity, 1e-12);
  }
}

TEST(PlotTransform, theFineScaleGivesAThousandthATenthOfTheHeight) {
  PlotTransform fine = plot;
  fine.upScale = AxisScale::cubeRoot;
  EXPECT_NEAR(yOfOpacity(fine, 0.001), 220.0 - 20.0, 1e-9);
}

TEST(PlotTransform, aLogarithmicAxisGivesEveryDecadeTheSameLength) {
  PlotTransform log = plot;
  log.visible = {0.1, 1000.0};
  log.acrossScale = AxisScale::logarithmic;
  log.up = {0.01, 100.0};
  log.upScale = AxisScale::logarithmic;
  // Four decades over 800 and 200 pixels.
  for (int decade = -1; decade <= 3; ++decade) {
    EXPECT_NEAR(xOfValue(log, std::pow(10.0, decade)), 50.0 + 200.0 * (decade + 1), 1e-9);
    EXPECT_NEAR(yOfOpacity(log, std::pow(10.0, decade - 1)), 220.0 - 50.0 * (decade + 1), 1e-9);
  }
  EXPECT_NEAR(valueAtX(log, xOfValue(log, 3.0)), 3.0, 1e-12);
  EXPECT_NEAR(opacityAtY(log, yOfOpacity(log, 0.3)), 0.3, 1e-12);
}

TEST(PlotTransform, zoomAndPanStayWithinTheFullRange) {
  const ValueRange full{-1000.0, 3000.0};
  EXPECT_EQ(zoomedAtX(plotted, 300.0, 0.5, full), full);
  PlotTransform zoomed = plot;
  zoomed.visible = zoomedAtX(plotted, 450.0, 4.0, full);
  EXPECT_NEAR(zoomed.visible.highest - zoomed.visible.lowest, 1000.0, 1e-9);
  EXPECT_DOUBLE_EQ(pannedBy(zoomed, 1e6, full).highest, 3000.0);
  EXPECT_DOUBLE_EQ(pannedBy(zoomed, -1e6, full).lowest, -1000.0);
}

TEST(LinearTicks, areRoundAndNoMoreThanAsked) {
  QLocale::setDefault(QLocale::c());
  const std::vector<AxisTick> ticks = linearTicks({-1024.0, 3071.0}, 9);
  ASSERT_EQ(ticks.size(), 9u); // 4095 / 9 = 455, the next of 1, 2, 5 times a power of ten: 500
  for (std::size_t i = 0; i < ticks.size(); ++i)
    EXPECT_DOUBLE_EQ(ticks[i].value, -1000.0 + 500.0 * static_cast<double>(i));
  EXPECT_EQ(ticks.front().text, QString::fromUtf8("\u22121000"));
  EXPECT_DOUBLE_EQ(linearTicks({0.0, 1.0}, 10)[1].value, 0.1);
  EXPECT_EQ(linearTicks({0.0, 1.0}, 10)[1].text, QStringLiteral("0.1"));
  EXPECT_DOUBLE_EQ(linearTicks({0.0, 0.003}, 5)[1].value, 0.001);
}

TEST(LogarithmicTicks, areRoundWithinTheirRangeAndNotTooMany) {
  QLocale::setDefault(QLocale::c());
  const ValueRange fine = logarithmicRange(3.0, 70.0);
  // 6 % of 1.37 decades of room at each end: 2.5 .. 85.
  const std::vector<AxisTick> ticks = logarithmicTicks(fine, 10);
  ASSERT_EQ(ticks.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_DOUBLE_EQ(ticks[i].value, (std::array{5.0, 10.0, 20.0, 50.0})[i]);
  EXPECT_LT(fine.lowest, 3.0);
  EXPECT_GT(fine.highest, 70.0);
  const std::vector<AxisTick> wide = logarithmicTicks(logarithmicRange(1e-3, 1e4), 5);
  EXPECT_LE(wide.size(), 5u);
  EXPECT_GE(wide.size(), 2u);
  EXPECT_EQ(logarithmicTicks({1e-4, 1e-2}, 8)[1].text, QStringLiteral("0.0002"));
  const ValueRange point = logarithmicRange(10.0, 10.0);
  EXPECT_LT(point.lowest, 10.0) << "a single place has room at both sides";
  EXPECT_GT(point.highest, 10.0);
}

TEST(NearestPlace, isWithinTheRadiusAndOfPlacesOnOneSpotTheLast) {
  const std::vector<QPointF> places{{0.0, 0.0}, {20.0, 0.0}, {20.0, 0.0}};
  EXPECT_EQ(nearestPlace(places, {3.0, 4.0}, 5.0), 0u); // 3-4-5
  EXPECT_EQ(nearestPlace(places, {3.0, 4.0}, 4.9), std::nullopt);
  EXPECT_EQ(nearestPlace(places, {19.0, 0.0}, 5.0), 2u);
}

TEST(Lines, areFarFromWhatTheyPassAndRunThroughWhatTheyCross) {
  const QPolygonF line{QPointF(0.0, 0.0), QPointF(100.0, 0.0), QPointF(100.0, 50.0)};
  EXPECT_DOUBLE_EQ(distanceToLine(line, {50.0, 7.0}), 7.0);
  EXPECT_DOUBLE_EQ(distanceToLine(line, {103.0, -4.0}), 5.0); // 3-4-5 from the corner
  EXPECT_TRUE(runsThrough(line, QRectF(40.0, -5.0, 10.0, 10.0)));
  EXPECT_TRUE(runsThrough(line, QRectF(99.0, 10.0, 2.0, 2.0)));
  EXPECT_FALSE(runsThrough(line, QRectF(40.0, 5.0, 10.0, 10.0)));
}

} // namespace
} // namespace limn
