// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/programs/FilterBits.h"

#include "support/GlTest.h"

#include <cmath>

namespace limn {
namespace {

// A ramp as a driver shows it whose weights have so many fraction bits, rounded or cut off.
std::vector<float> ramp(int bits, bool isRounded) {
  std::vector<float> values;
  constexpr int places = 1 << mostFilterBits;
  for (int i = 0; i < places; ++i) {
    const double weight = std::ldexp((i + 0.5) / places, bits);
    values.push_back(
        static_cast<float>(std::ldexp(isRounded ? std::round(weight) : std::floor(weight), -bits)));
  }
  return values;
}

TEST(FilterBits, areCountedWhetherWeightsAreRoundedOrCutOff) {
  for (const int bits : {6, 8, 10})
    for (const bool isRounded : {true, false})
      EXPECT_EQ(filterBitsOf(ramp(bits, isRounded)), bits);
  EXPECT_EQ(filterBitsOf(ramp(23, true)), mostFilterBits);
  EXPECT_EQ(filterBitsOf({}), 0);
}

TEST(FilterBits, areToldWithWhatTheyCost) {
  EXPECT_EQ(filterText(mostFilterBits), "weights of at least 12 bits between voxels");
  EXPECT_NE(filterText(8).find("1/512"), std::string::npos) << filterText(8);
}

using FilterBitsOfDriver = test::GlTest;

// Mesa's software drivers weigh in floats; a card has 8 bits or a few more.
TEST_F(FilterBitsOfDriver, areMeasured) {
  const int bits = filterBits();
  EXPECT_GE(bits, 8) << "a 2 x 2 x 2 ramp as the ray caster uploads it";
  if (rendererName().find("pipe") != std::string::npos) {
    EXPECT_EQ(bits, mostFilterBits) << rendererName();
  }
}

} // namespace
} // namespace limn
