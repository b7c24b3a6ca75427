// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/picture/CurveGeometry.h"
#include "widgets/ValueText.h"
#include "widgets/WidgetSamples.h"
#include "widgets/curve/picture/HistogramPicture.h"
#include "widgets/curve/picture/Tissue.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

const PlotTransform plot{QRectF(50.0, 20.0, 800.0, 200.0), {-1000.0, 3000.0}};

TEST(ValueText, keepsTheDigitsThatMatter) {
  EXPECT_EQ(valueText(-310.0, QStringLiteral("HU"), 0), QString::fromUtf8("\u2212310\u00a0HU"));
  EXPECT_EQ(plainNumber(0.2500, 4), QStringLiteral("0.25"));
  EXPECT_EQ(plainNumber(1200.0, 2), QStringLiteral("1200"));
  EXPECT_EQ(plainNumber(-0.0001, 2), QStringLiteral("0"));
  EXPECT_EQ(plainNumber(-12.5, 2), QStringLiteral("−12.5"));
  EXPECT_EQ(fixedNumber(-12.5, 2), QStringLiteral("−12.50"));
  EXPECT_EQ(digitsNumber(-12.53, 3), QStringLiteral("−12.5"));
  EXPECT_EQ(numbersTyped(QStringLiteral("−1.5; -2")), (std::vector{-1.5, -2.0})) << "both are read";
  EXPECT_EQ(opacityText(0.6302), QStringLiteral("0.63"));
  EXPECT_EQ(opacityText(0.63251), QStringLiteral("0.633"));
  EXPECT_EQ(opacityText(0.00042), QStringLiteral("0.00042"));
  EXPECT_EQ(opacityText(0.0), QStringLiteral("0"));
  EXPECT_EQ(opacityText(1.0), QStringLiteral("1"));
  EXPECT_EQ(decimalsFor(1.0), 0);
  EXPECT_EQ(decimalsFor(0.1), 1);
  EXPECT_EQ(decimalsFor(0.03), 2);
}

TEST(Tissue, namesFollowTheTablesAndLeaveGapsOpen) {
  EXPECT_EQ(tissueAt(-1000.0)->name, QStringLiteral("air"));
  EXPECT_EQ(tissueAt(-870.0)->name, QStringLiteral("lung"));
  EXPECT_EQ(tissueAt(-80.0)->name, QStringLiteral("fat"));
  EXPECT_EQ(tissueAt(0.0)->name, QStringLiteral("water"));
  EXPECT_EQ(tissueAt(50.0)->name, QStringLiteral("soft tissue, blood"));
  EXPECT_EQ(tissueAt(1200.0)->name, QStringLiteral("compact bone, dentine"));
  EXPECT_EQ(tissueAt(-300.0), std::nullopt);
}

TEST(CurveGeometry, pointsComeBeforeTheCurve) {
  const TransferFunction function = sampleFunction();
  const QPointF at = positionOf(plot, function.points[2]);
  // A hit area at least 18 pixels wide: 9 to every side.
  for (const QPointF& offset :
       {QPointF(9.0, 0.0), QPointF(-9.0, 0.0), QPointF(0.0, 9.0), QPointF(0.0, -9.0)}) {
    const CurveHit hit = hitAt(plot, function, at + offset);
    EXPECT_EQ(hit.part, CurveHit::Part::point);
    EXPECT_EQ(hit.index, 2u);
  }
  EXPECT_EQ(hitAt(plot, function, {xOfValue(plot, 750.0), yOfOpacity(plot, 0.65) + 3.0}).part,
            CurveHit::Part::curve);
  EXPECT_EQ(hitAt(plot, function, {xOfValue(plot, 750.0), yOfOpacity(plot, 0.2)}).part,
            CurveHit::Part::nothing);
}

TEST(CurveGeometry, theBarStaysAboveThePlotWhereTheCurveReachesBeyondIt) {
  PlotTransform transform = plot;
  transform.visible = {-1000.0, 792.0};
  const TransferFunction wide{1.0, {{-300.0, {1, 1, 1}, 0.0}, {3000.0, {1, 1, 1}, 1.0}}};
  const CurveBar bar = *curveBar(transform, wide);
  EXPECT_EQ(bar.start.x(), xOfValue(transform, -300.0));
  EXPECT_EQ(bar.end.x(), 850.0);
  EXPECT_LE(bar.grip.x() + 14.0, 850.0); // the grip is 28 pixels wide
  EXPECT_TRUE(bar.startVisible);
  EXPECT_FALSE(bar.endVisible);
  EXPECT_EQ(hitAt(transform, wide, bar.grip).part, CurveHit::Part::barGrip);
  // Widening about a middle beyond the view would run against the pointer.
  EXPECT_EQ(hitAt(transform, wide, bar.end).part, CurveHit::Part::nothing);

  transform.visible = {3100.0, 3200.0}; // all of the curve lies to the left
  const CurveBar gone = *curveBar(transform, wide);
  EXPECT_EQ(gone.start.x(), 50.0);
  EXPECT_EQ(gone.end.x(), 50.0);
  EXPECT_GE(gone.grip.x() - 14.0, 50.0);
}

TEST(CurveGeometry, theCurveStartsAndEndsAtThePlotsEdgesAndKeepsSteps) {
  TransferFunction step{1.0, {{0.0, {1, 1, 1}, 0.0}, {0.0, {1, 1, 1}, 1.0}}};
  const QPolygonF line = curvePolygon(plot, step);
  EXPECT_EQ(line.front(), QPointF(50.0, 220.0));
  EXPECT_EQ(line.back(), QPointF(850.0, 20.0));
  const double x = xOfValue(plot, 0.0);
  EXPECT_TRUE(line.contains(QPointF(x, 220.0)));
  EXPECT_TRUE(line.contains(QPointF(x, 20.0)));
}

TEST(CurveEdits, movedGroupsStopAtPointsThatStayButKeepTheirShape) {
  const TransferFunction moved = withPointsMoved(sampleFunction(), {1, 2}, 1000.0, 0.0);
  EXPECT_DOUBLE_EQ(moved.points[2].value, 300.0); // stopped by the point at 300
  EXPECT_DOUBLE_EQ(moved.points[1].value, 180.0); // -60 + 240
}

TEST(HistogramHeights, areLogarithmicAndReachOneAtTheFullestBin) {
  const Histogram histogram{{0.0, 4.0}, {0, 9, 99, 0}};
  // Four columns of one bin each: log1p(9)/log1p(99) = ln 10 / ln 100 = 0.5.
  const std::vector<double> heights = histogramHeights(histogram, {0.0, 4.0}, 4);
  EXPECT_NEAR(heights[1], 0.5, 1e-12);
  EXPECT_NEAR(heights[2], 1.0, 1e-12);
  // Two columns: each shows its fullest bin.
  EXPECT_NEAR(histogramHeights(histogram, {0.0, 4.0}, 2)[0], 0.5, 1e-12);
}

} // namespace
} // namespace limn
