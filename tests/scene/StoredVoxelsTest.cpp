// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Volume.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(StoredVoxels, copiesShareUntilOneIsChanged) {
  StoredVoxels<int> first(std::vector<int>{1, 2, 3});
  StoredVoxels<int> second = first;
  EXPECT_EQ(first.data(), second.data());
  second.writable()[0] = 7;
  EXPECT_EQ(first, StoredVoxels<int>(std::vector<int>{1, 2, 3}));
  EXPECT_EQ(second, StoredVoxels<int>(std::vector<int>{7, 2, 3}));
}

TEST(StoredVoxels, changeInTheirPlaceWhereNobodySharesThem) {
  StoredVoxels<int> voxels(std::vector<int>{1, 2, 3});
  const int* place = voxels.data();
  voxels.writable()[2] = 9;
  EXPECT_EQ(voxels.data(), place);
  EXPECT_EQ(voxels[2], 9);
}

TEST(StoredVoxels, keepWhatTheyLieInAndNeverWriteThere) {
  const auto elsewhere = std::make_shared<const std::vector<int>>(std::vector<int>{1, 2, 3});
  StoredVoxels<int> voxels(std::span<const int>(*elsewhere), elsewhere);
  EXPECT_EQ(elsewhere.use_count(), 2);
  voxels.writable()[0] = 7;
  EXPECT_EQ(elsewhere->front(), 1);
  EXPECT_EQ(voxels[0], 7);
  EXPECT_EQ(elsewhere.use_count(), 1) << "a copy needs the other no longer";
}

} // namespace
} // namespace limn
