// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/picture/HistogramPicture.h"
#include "widgets/curve/HistogramButton.h"

#include <QAction>
#include <QMenu>

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

// Four bins of width 1, each a column.
const Histogram counted{{0.0, 4.0}, {10, 0, 30, 60}};

std::vector<double> heights(HistogramScale scale) {
  return histogramHeights(counted, {0.0, 4.0}, 4, scale);
}

TEST(HistogramPicture, standsAsHighAsItsScaleSays) {
  const std::vector<double> linear = heights(HistogramScale::linear);
  EXPECT_NEAR(linear[0], 10.0 / 60.0, 1e-12);
  EXPECT_EQ(linear[1], 0.0);
  EXPECT_NEAR(linear[2], 0.5, 1e-12);
  EXPECT_EQ(linear[3], 1.0);
  EXPECT_NEAR(heights(HistogramScale::logarithmic)[2], std::log(31.0) / std::log(61.0), 1e-12);
  // Up to the middle of each bin of 100 voxels.
  const std::vector<double> percentile = heights(HistogramScale::percentile);
  EXPECT_NEAR(percentile[0], 0.05, 1e-12);
  EXPECT_NEAR(percentile[1], 0.10, 1e-12);
  EXPECT_NEAR(percentile[2], 0.25, 1e-12);
  EXPECT_NEAR(percentile[3], 0.70, 1e-12);
}

TEST(HistogramPicture, hasAllBelowItBeyondTheLastValueByPercentile) {
  const std::vector<double> beyond = histogramHeights(counted, {3.0, 9.0}, 6, HistogramScale::percentile);
  EXPECT_EQ(beyond.back(), 1.0);
  EXPECT_EQ(histogramHeights(counted, {-5.0, 0.0}, 5, HistogramScale::percentile).front(), 0.0);
  EXPECT_EQ(histogramHeights(counted, {3.0, 9.0}, 6, HistogramScale::linear).back(), 0.0);
}

TEST(HistogramPicture, ofNothingIsFlat) {
  for (const HistogramScale scale :
       {HistogramScale::linear, HistogramScale::logarithmic, HistogramScale::percentile})
    EXPECT_EQ(histogramHeights({{0.0, 2.0}, {0, 0}}, {0.0, 2.0}, 2, scale), (std::vector<double>{0.0, 0.0}));
}

TEST(HistogramButton, offersHeightsAndPartsAndTellsWhatIsChosen) {
  HistogramButton button;
  HistogramView chosen;
  QObject::connect(&button, &HistogramButton::viewChosen, [&](const HistogramView& view) { chosen = view; });
  button.findChild<QAction*>(QStringLiteral("histogram-percentile"))->trigger();
  EXPECT_EQ(chosen, (HistogramView{HistogramScale::percentile, HistogramPart::whole}));
  button.findChild<QAction*>(QStringLiteral("histogram-visible"))->trigger();
  EXPECT_EQ(chosen, (HistogramView{HistogramScale::percentile, HistogramPart::visible}));
  EXPECT_EQ(button.accessibleName(), QStringLiteral("Histogram: Percentile, What is visible"));
  int checked = 0;
  for (const QAction* action : button.menu()->actions()) {
    checked += action->isChecked() ? 1 : 0;
    EXPECT_TRUE(action->isSeparator() || !action->toolTip().isEmpty());
  }
  EXPECT_EQ(checked, 2);
}

} // namespace
} // namespace limn
