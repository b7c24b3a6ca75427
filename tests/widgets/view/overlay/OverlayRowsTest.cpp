// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/OverlayParts.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

// Two sides of 200 pixels with texts of 30 × 20 in their middles; plates keep 4 pixels around them.
const QSizeF letter(30.0, 20.0);
const std::vector<double> columns{100.0, 300.0};

TEST(OverlayRows, stayWhereNothingIsInTheWay) {
  EXPECT_EQ(clearRowBelow(12.0, letter, columns, {{12.0, 12.0, 60.0, 30.0}}), 12.0);
  EXPECT_EQ(clearRowAbove(388.0, letter, columns, {{12.0, 358.0, 60.0, 30.0}}), 388.0);
}

TEST(OverlayRows, yieldOnEverySideToAPlateThatIsInTheWayOnOne) {
  const std::vector<QRectF> wideOnTheRight{{12.0, 12.0, 60.0, 30.0}, {212.0, 12.0, 120.0, 30.0}};
  EXPECT_EQ(clearRowBelow(12.0, letter, columns, wideOnTheRight), 42.0 + 4.0);
  const std::vector<QRectF> wideOnTheLeft{{12.0, 358.0, 120.0, 30.0}};
  EXPECT_EQ(clearRowAbove(388.0, letter, columns, wideOnTheLeft), 358.0 - 4.0);
}

TEST(OverlayRows, yieldToEveryPlateInTurnWhateverTheirOrder) {
  const std::vector<QRectF> stacked{{50.0, 50.0, 100.0, 30.0}, {50.0, 12.0, 100.0, 30.0}};
  EXPECT_EQ(clearRowBelow(12.0, letter, columns, stacked), 80.0 + 4.0);
  const std::vector<QRectF> risen{{50.0, 320.0, 100.0, 30.0}, {50.0, 358.0, 100.0, 30.0}};
  EXPECT_EQ(clearRowAbove(388.0, letter, columns, risen), 320.0 - 4.0);
}

} // namespace
} // namespace limn
