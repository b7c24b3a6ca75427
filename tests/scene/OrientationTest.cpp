// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Orientation.h"

#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace limn {
namespace {

TEST(Orientation, lettersAreOneOfEachPair) {
  for (const char* letters : {"LPS", "RAI", "SLA", "IPR"})
    EXPECT_TRUE(areAxisLetters(letters)) << letters;
  for (const char* letters : {"", "LP", "LPSI", "LRS", "LLS", "lps", "XPS"})
    EXPECT_FALSE(areAxisLetters(letters)) << letters;
}

TEST(Orientation, aGridRunsWhereTheLettersSayAndStaysWhereItIs) {
  Grid grid{{4, 5, 6}, {1.0, 2.0, 3.0}, {-10.0, 20.0, 7.0}, glm::dmat3(1.0)};
  EXPECT_EQ(axisLettersOf(grid), "LPS");
  std::string letters = "AIR";
  const Grid turned = withAxisLetters(grid, letters);
  EXPECT_EQ(axisLettersOf(turned), "AIR");
  // LPS: to the front is -y, to the feet -z, to the right -x.
  EXPECT_EQ(turned.direction[0], glm::dvec3(0, -1, 0));
  EXPECT_EQ(turned.direction[1], glm::dvec3(0, 0, -1));
  EXPECT_EQ(turned.direction[2], glm::dvec3(-1, 0, 0));
  EXPECT_EQ(boxCentreMm(turned), boxCentreMm(grid));
  EXPECT_EQ(turned.dims, grid.dims);
  EXPECT_EQ(turned.spacingMm, grid.spacingMm);
}

TEST(Orientation, everyAnswerIsReadBack) {
  std::string pairs[] = {"LR", "PA", "SI"};
  std::sort(std::begin(pairs), std::end(pairs));
  int answers = 0;
  do {
    for (unsigned ends = 0; ends < 8; ++ends) {
      const std::string letters{pairs[0][ends & 1], pairs[1][ends >> 1 & 1], pairs[2][ends >> 2 & 1]};
      EXPECT_EQ(axisLettersOf(withAxisLetters(Grid{{2, 3, 4}}, letters)), letters);
      ++answers;
    }
  } while (std::next_permutation(std::begin(pairs), std::end(pairs)));
  EXPECT_EQ(answers, 48); // 3! axes times 2^3 ends
}

TEST(Orientation, aVolumeOrientedByHandSharesItsVoxelsAndIsKnown) {
  VolumeInfo info;
  info.orientationKnown = false;
  info.warnings = {orientationUnknown, "Something else."};
  const Volume volume(Grid{{2, 1, 1}}, std::vector<std::int16_t>{3, 7}, {}, std::nullopt, info);
  const auto oriented = orientedByHand(volume, "RPS");
  EXPECT_EQ(&oriented->stored(), &volume.stored());
  EXPECT_TRUE(oriented->info().orientationKnown);
  EXPECT_EQ(oriented->info().orientationByHand, "RPS");
  EXPECT_EQ(oriented->info().warnings, std::vector<Message>{"Something else."});
  EXPECT_EQ(oriented->range(), volume.range());
  EXPECT_EQ(oriented->value({1, 0, 0}), 7.0);
  EXPECT_FALSE(volume.info().orientationKnown);
}

} // namespace
} // namespace limn
