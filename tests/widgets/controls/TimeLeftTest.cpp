// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/TimeLeft.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(TimeLeft, followsFromHowFarWorkCameOnceThatTellsSomething) {
  EXPECT_EQ(secondsLeft(0.25, 10.0), 30.0) << "three times what a quarter took";
  EXPECT_EQ(secondsLeft(1.0, 10.0), 0.0);
  EXPECT_FALSE(secondsLeft(0.25, 1.9)) << "too soon";
  EXPECT_FALSE(secondsLeft(0.009, 10.0)) << "too little";
}

TEST(TimeLeft, isToldNoFinerThanItIsKnown) {
  EXPECT_EQ(aboutText(0.1), QStringLiteral("about 1 s"));
  EXPECT_EQ(aboutText(7.4), QStringLiteral("about 7 s"));
  EXPECT_EQ(aboutText(43.0), QStringLiteral("about 45 s"));
  EXPECT_EQ(aboutText(100.0), QStringLiteral("about 2 min"));
  EXPECT_EQ(aboutText(27.0 * 60.0), QStringLiteral("about 25 min"));
  EXPECT_EQ(aboutText(2.52 * 3600.0), QStringLiteral("about 2.5 h"));
  EXPECT_EQ(aboutText(30.0 * 3600.0), QStringLiteral("about 30 h"));
}

TEST(TimeLeft, followsFromThePaceSinceWorkWasSeenToComeOn) {
  TimeLeft one;
  one.begin();
  EXPECT_FALSE(one.left(0.0, 0.0));
  EXPECT_FALSE(one.left(0.25, 50.0)) << "what was prepared before is no pace";
  EXPECT_NEAR(one.left(0.5, 60.0).value_or(0.0), 20.0, 1e-12) << "a quarter in ten seconds"; // rounding
  EXPECT_EQ(one.left(1.0, 80.0), 0.0);
}

TEST(TimeLeft, ofSeveralPicturesIsKnownInTheLastByItsOwnPace) {
  TimeLeft two;
  two.begin(2);
  EXPECT_FALSE(two.left(0.25, 10.0)) << "the second may take longer";
  EXPECT_FALSE(two.left(0.5, 20.0)) << "it begins";
  EXPECT_FALSE(two.left(0.625, 30.0)) << "a quarter of it was there as it was first seen";
  EXPECT_NEAR(two.left(0.75, 40.0).value_or(0.0), 20.0, 1e-12) << "half in twice the time of a quarter";
}

TEST(TimeLeft, ofManyFramesIsKnownOnceOneIsThere) {
  TimeLeft film;
  film.begin(1, 1.0 / 500.0);
  EXPECT_FALSE(film.left(0.002, 30.0)) << "the first, with what is set up for all";
  EXPECT_NEAR(film.left(0.004, 40.0).value_or(0.0), 4980.0, 1e-6) << "498 at ten seconds each";
}

TEST(TimeLeft, isEmptyBeforeWorkBegins) {
  TimeLeft left;
  EXPECT_TRUE(left.text(0.5).isEmpty());
}

} // namespace
} // namespace limn
