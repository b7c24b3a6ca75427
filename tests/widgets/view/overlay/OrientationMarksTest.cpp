// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/OrientationMarks.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

const QRectF wished(85.0, 12.0, 30.0, 20.0); // at the upper edge of a picture 200 wide
const QRectF lane(4.0, 4.0, 192.0, 60.0);

TEST(OrientationMarks, stayWhereNothingIsInTheWay) {
  EXPECT_EQ(clearPlace(wished, lane, Qt::Horizontal, {{12.0, 12.0, 60.0, 30.0}}), wished);
  EXPECT_EQ(clearPlace(wished, lane, Qt::Vertical, {}), wished);
}

TEST(OrientationMarks, goAlongTheEdgeRatherThanInwards) {
  EXPECT_EQ(clearPlace(wished, lane, Qt::Horizontal, {{12.0, 12.0, 80.0, 30.0}}),
            QRectF(96.0, 12.0, 30.0, 20.0));
  const QRectF atTheLeft(12.0, 90.0, 30.0, 20.0);
  const QRectF column(4.0, 50.0, 60.0, 100.0);
  EXPECT_EQ(clearPlace(atTheLeft, column, Qt::Vertical, {{12.0, 80.0, 20.0, 20.0}}),
            QRectF(12.0, 104.0, 30.0, 20.0));
}

TEST(OrientationMarks, goInwardsWhereTheEdgeIsTaken) {
  const std::vector<QRectF> stacked{{6.0, 25.0, 180.0, 10.0}, {6.0, 6.0, 180.0, 15.0}};
  EXPECT_EQ(clearPlace(wished, lane, Qt::Horizontal, stacked), QRectF(85.0, 39.0, 30.0, 20.0));
}

TEST(OrientationMarks, areLeftOutWhereTheLaneIsFull) {
  EXPECT_EQ(clearPlace(wished, lane, Qt::Horizontal, {{6.0, 6.0, 180.0, 50.0}}), std::nullopt);
}

TEST(OrientationMarks, neverLieOnPlatesNorDeepInThePicture) {
  const OrientationLetters letters{"R", "L", "S", "I"};
  const QFont font;
  for (double width = 60.0; width < 900.0; width *= 1.5)
    for (double height = 60.0; height < 900.0; height *= 1.5) {
      const QRectF right(width, 0.0, width, height); // of two
      const std::vector<QRectF> plates{{width + 12.0, 12.0, 0.7 * width, 30.0},
                                       {width + 12.0, 46.0, 0.5 * width, 18.0},
                                       {width + 12.0, height - 42.0, 90.0, 30.0}};
      const LetterMarks marks = letterMarks(letters, {right, 1.5 * width, height / 2.0}, font, plates);
      const QSizeF size = letterSize(font);
      for (std::size_t i = 0; i < marks.places.size(); ++i) {
        if (!marks.places[i])
          continue;
        const QRectF& place = *marks.places[i];
        for (const QRectF& plate : plates)
          EXPECT_FALSE(place.intersects(plate)) << width << " " << height << " " << i;
        const double depth = std::max(0.2 * height, size.height() + 12.0); // or what the edge itself asks
        EXPECT_TRUE(i != 2 || place.bottom() <= depth + 1e-9) << place.bottom();
        EXPECT_TRUE(i != 3 || place.top() >= height - depth - 1e-9) << place.top();
      }
    }
}

} // namespace
} // namespace limn
