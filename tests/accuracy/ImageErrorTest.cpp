// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/ErrorEstimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace limn {
namespace {

// A row of covered grey pixels.
Image row(int pixels, float value) {
  Image image(glm::ivec2(pixels, 1));
  for (glm::vec4& pixel : image.pixels)
    pixel = glm::vec4(value, value, value, 1.0f);
  return image;
}

ImageError difference(double p99_9) {
  ImageError error;
  error.p99_9 = p99_9;
  error.mean = p99_9 / 10;
  return error;
}

TEST(ImageError, ofAPictureWithItselfIsNothing) {
  EXPECT_EQ(imageError(row(10, 0.5f), row(10, 0.5f)), ImageError{});
}

TEST(ImageError, countsTheFourChannelsOfCoveredPixelsInLevels) {
  Image picture = row(4, 0.5f);
  picture.pixels[2].r += 2.0f / 255.0f;
  const ImageError error = imageError(picture, row(4, 0.5f));
  // One of 16 channels is off by two levels. Floats of 0.5 hold 255ths to 1.5e-5 of a level.
  EXPECT_NEAR(error.largest, 2.0, 2e-5);
  EXPECT_NEAR(error.mean, 2.0 / 16.0, 2e-5);
  EXPECT_NEAR(error.rms, std::sqrt(4.0 / 16.0), 2e-5);
  EXPECT_DOUBLE_EQ(error.shareOverOne, 0.25);
  // Rank 0.999 · 15 = 14.985 lies between the channel ranked 14 (0) and the one ranked 15 (2).
  EXPECT_NEAR(error.p99_9, 2.0 * 0.985, 2e-5);
}

TEST(ImageError, leavesOutWhatNeitherPictureCovers) {
  Image picture = row(2, 0.0f), other = row(2, 0.0f);
  picture.pixels[0] = glm::vec4(0.5f, 0.0f, 0.0f, 0.0019f); // below 1/510
  other.pixels[0] = glm::vec4(0.0f);
  EXPECT_EQ(imageError(picture, other), ImageError{});
  other.pixels[0].a = 0.01f; // one of them covers
  EXPECT_NEAR(imageError(picture, other).largest, 127.5, 1e-3);
}

TEST(ImageError, takesWhatIsNotANumberForInfinitelyWrong) {
  Image picture = row(2, 0.5f);
  picture.pixels[1] = glm::vec4(std::numeric_limits<float>::quiet_NaN());
  const ImageError error = imageError(picture, row(2, 0.5f));
  EXPECT_TRUE(std::isinf(error.largest));
  EXPECT_DOUBLE_EQ(error.shareOverOne, 0.5);
}

// Of many channels only the largest are kept: in any order, and where many are the same, their percentile is
// that of all of them sorted.
TEST(ImageError, tellsThePercentileOfAllChannels) {
  std::mt19937 random(5);
  for (const int pixels : {1, 2, 3, 250, 251, 4000, 30000})
    for (const int values : {1, 3, 1 << 20}) {
      Image picture = row(pixels, 0.0f);
      std::uniform_int_distribution<int> off(0, values - 1);
      std::vector<double> sorted;
      for (glm::vec4& pixel : picture.pixels) {
        pixel = glm::vec4(off(random), off(random), off(random), values) / static_cast<float>(values);
        for (int channel = 0; channel < 4; ++channel)
          sorted.push_back(channel == 3 ? 0.0 : 255.0 * static_cast<double>(pixel[channel]));
      }
      std::sort(sorted.begin(), sorted.end());
      const double place = 0.999 * static_cast<double>(sorted.size() - 1);
      const auto below = static_cast<std::size_t>(place);
      const double expected =
          std::lerp(sorted[below], sorted[std::min(below + 1, sorted.size() - 1)], place - double(below));
      const Image exact = row(pixels, 0.0f);
      EXPECT_DOUBLE_EQ(imageError(picture, exact).p99_9, expected) << pixels << " " << values;
      std::sort(picture.pixels.begin(), picture.pixels.end(),
                [](const glm::vec4& a, const glm::vec4& b) { return a.r < b.r; });
      EXPECT_DOUBLE_EQ(imageError(picture, exact).p99_9, expected) << "rising, " << pixels << " " << values;
      std::reverse(picture.pixels.begin(), picture.pixels.end());
      EXPECT_DOUBLE_EQ(imageError(picture, exact).p99_9, expected) << "falling, " << pixels << " " << values;
    }
}

// What falls off exponentially with 1.5 levels: all channels but alpha, at the places of as many even shares.
Image offExponentially(int pixels, int every) {
  Image image(glm::ivec2(pixels / every, 1));
  for (int n = 0; n < pixels / every; ++n) {
    const double share = (n * every + every / 2 + 0.5) / pixels;
    const auto off = static_cast<float>(-1.5 * std::log(share) / 255.0);
    image.pixels[static_cast<std::size_t>(n)] = glm::vec4(off, off, off, 1.0f);
  }
  return image;
}

TEST(ImageError, byItsTailIsThatOfManyPixelsFromFew) {
  const Image exact = row(100, 0.0f);
  // Three channels of four are off: one in a thousand of all is one in 750 of those.
  const double expected = 1.5 * std::log(750.0);
  const Image many = offExponentially(100000, 1);
  EXPECT_NEAR(imageError(many, row(100000, 0.0f)).p99_9, expected, 0.01 * expected);
  const Image few = offExponentially(100000, 50);
  const ImageError byTail = errorByTail(few, precise(row(2000, 0.0f)), 0.01);
  EXPECT_NEAR(byTail.p99_9, expected, 0.05 * expected); // 60 channels in the tail
  const ImageError plain = imageError(few, row(2000, 0.0f));
  EXPECT_EQ(byTail.mean, plain.mean);
  EXPECT_EQ(byTail.largest, plain.largest);
  EXPECT_EQ(errorByTail(exact, precise(exact), 0.01), ImageError{});
  EXPECT_EQ(errorByTail(Image(glm::ivec2(4, 1)), precise(Image(glm::ivec2(4, 1))), 0.01), ImageError{});
}

TEST(ErrorEstimate, ofLightOnAGridIsThatOfWhatKnowsNothingOfEachOther) {
  const ImageError ofLight = difference(4.0);
  const ErrorEstimate both = withLight({3.0, 0.3, 1.0}, ofLight);
  EXPECT_DOUBLE_EQ(both.p99_9, 5.0);
  EXPECT_DOUBLE_EQ(both.mean, 0.5);
  EXPECT_EQ(withLight({3.0, 0.3, 1.0}, {}).p99_9, 3.0);
}

TEST(ErrorEstimate, ofAnExactPowerLawIsTheErrorItself) {
  // I_h - I = C h^p: with errors e, e/2^p, e/4^p the differences are theirs.
  for (const double p : {1.0, 1.3, 2.0}) {
    const double e = 8.0, half = e * std::exp2(-p), quarter = half * std::exp2(-p);
    const ImageError before = difference(e - half), halving = difference(half - quarter);
    const ErrorEstimate finest = errorAfterHalving(halving, before);
    EXPECT_NEAR(finest.order, p, 1e-12);
    EXPECT_NEAR(finest.p99_9, quarter, 1e-12);
    EXPECT_NEAR(finest.mean, quarter / 10, 1e-12);
    EXPECT_NEAR(errorBeforeHalvings(before, halving).p99_9, e, 1e-12);
  }
}

TEST(ErrorEstimate, staysCarefulWhereNoOrderShows) {
  EXPECT_DOUBLE_EQ(observedOrder(0.0, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(observedOrder(1.0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(observedOrder(1.0, 3.0), 1.0);
  EXPECT_DOUBLE_EQ(observedOrder(100.0, 1.0), 2.0);
  EXPECT_DOUBLE_EQ(errorAfterHalving(difference(0.5)).p99_9, 0.5);
  EXPECT_DOUBLE_EQ(errorBeforeHalvings(difference(0.5), difference(0.5)).p99_9, 2.0);
}

TEST(ErrorEstimate, ofManyHalvingsTrustsAnOrderThatTwoOfThemShow) {
  // Differences of order 2, then of order 1.
  EXPECT_NEAR(errorAfterHalvings({difference(16), difference(4), difference(1)}).p99_9, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(errorAfterHalvings({difference(4), difference(2), difference(1)}).p99_9, 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(errorAfterHalvings({difference(0.5)}).p99_9, 0.5) << "no order yet";
}

TEST(ErrorEstimate, ofManyHalvingsMistrustsADifferenceThatFellByChance) {
  // Order 1 before, then a fall to a tenth: the order stays 1, and 2/(2^1.5 (2^1.5 - 1)) is left of the one
  // before.
  const ErrorEstimate fell = errorAfterHalvings({difference(4), difference(2), difference(0.2)});
  EXPECT_DOUBLE_EQ(fell.order, 1.0);
  EXPECT_NEAR(fell.p99_9, 2.0 / (std::exp2(1.5) * (std::exp2(1.5) - 1.0)), 1e-12);
  // A single order counts as 1.5 at most: 1/(2^1.5 - 1), and here the difference before says more.
  const ErrorEstimate single = errorAfterHalvings({difference(4), difference(1)});
  EXPECT_DOUBLE_EQ(single.order, 1.5);
  EXPECT_NEAR(single.p99_9, 4.0 / (std::exp2(1.5) * (std::exp2(1.5) - 1.0)), 1e-12);
}

TEST(ErrorEstimate, beforeTwoHalvingsIsAtLeastWhatOrderOneLeaves) {
  EXPECT_NEAR(errorBeforeHalvings(difference(4), difference(1)).p99_9, 4.0 * 4.0 / 3.0, 1e-12);
  EXPECT_NEAR(errorBeforeHalvings(difference(1), difference(2)).p99_9, 8.0, 1e-12);
}

TEST(EarlyEnds, costTheRestOfTheRaysThatEndedEarly) {
  Scene scene;
  scene.quality.earlyTermination = 0.99;
  Image image = row(2, 0.0f);
  image.pixels[0] = glm::vec4(0.4f, 0.2f, 0.0f, 0.995f);
  image.pixels[1] = glm::vec4(0.4f, 0.2f, 0.0f, 0.98f); // did not end
  const ImageError ends = errorOfEarlyEnds(image, scene);
  EXPECT_NEAR(ends.largest, 255.0 * 0.005, 1e-4);
  // The rest is as bright as what was passed: red, green and alpha gain 0.005/0.995 of themselves.
  EXPECT_NEAR(ends.mean, 255.0 * 0.005 / 0.995 * (0.4 + 0.2 + 0.995) / 8.0, 1e-4);
}

TEST(EarlyEnds, costNothingWhereNoRayEndsEarly) {
  Scene scene;
  scene.quality.earlyTermination = 1.0;
  const Image image = row(4, 0.9985f);
  EXPECT_EQ(errorOfEarlyEnds(image, scene), ImageError{});
  scene.quality.earlyTermination = 0.9;
  scene.projection = Projection::mip;
  EXPECT_EQ(errorOfEarlyEnds(image, scene), ImageError{});
}

TEST(EarlyEnds, bindTheEstimateFromBelow) {
  const ImageError ends = difference(0.5); // mean 0.05
  EXPECT_EQ(withEarlyEnds({2.0, 0.3, 1.5}, ends), (ErrorEstimate{2.0, 0.3 + 0.05, 1.5}));
  EXPECT_EQ(withEarlyEnds({0.1, 0.0, 1.5}, ends), (ErrorEstimate{0.5, 0.05, 1.5}));
}

} // namespace
} // namespace limn
