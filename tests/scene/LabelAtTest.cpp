// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/LabelAt.h"

#include "scene/LabelLooks.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

// A row of three voxels: background, liver, spleen.
Region threeLabels() {
  return {Region::Kind::labels,
          "seg",
          std::make_shared<const LabelMap>(
              glm::ivec3(3, 1, 1), std::vector<std::uint8_t>{0, 1, 2},
              std::vector<Label>{{0, "Background", {}}, {5, "liver", {}}, {7, "spleen", {}}}),
          {1.0, 0.0, 1.0}};
}

TEST(LabelAt, isThatOfTheNearestVoxelWhateverItWeighs) {
  const Region region = threeLabels();
  EXPECT_EQ(voxelLabelAt(region, {0.49, 0.0, 0.0}), 0u);
  EXPECT_EQ(voxelLabelAt(region, {0.51, 0.2, -0.4}), 1u);
  EXPECT_EQ(voxelLabelAt(region, {2.4, 0.0, 0.0}), 2u);
  EXPECT_EQ(voxelLabelAt(region, {-0.5, -0.5, -0.5}), 0u);
  for (const glm::dvec3& beside : {glm::dvec3(2.5, 0, 0), {-0.51, 0, 0}, {0, 0.5, 0}, {0, 0, -1}})
    EXPECT_EQ(voxelLabelAt(region, beside), std::nullopt);
  EXPECT_EQ(labelNameAt(region, {1.0, 0.0, 0.0}), "liver");
  EXPECT_EQ(labelNameAt(region, {0.0, 0.0, 0.0}), "") << "the background has no name to tell";
}

TEST(LabelAt, isNoneWithoutASegmentation) {
  EXPECT_EQ(voxelLabelAt(Region{}, {0, 0, 0}), std::nullopt);
  EXPECT_EQ(voxelLabelAt(bodyRegion({2, 1, 1}, std::vector<std::uint8_t>{0, 1}), {1, 0, 0}), std::nullopt);
  EXPECT_EQ(labelNameAt(Region{}, {0, 0, 0}), "");
  EXPECT_EQ(ownLookAt(Region{}, {0, 0, 0}), nullptr);
}

TEST(LabelAt, liesUnderWhatWasCutAway) {
  Region cut = threeLabels();
  cut.uncut = cut.labels;
  std::vector<Label> labels = cut.labels->labels();
  labels.push_back({-1, "cut", {}});
  cut.labels =
      std::make_shared<const LabelMap>(glm::ivec3(3, 1, 1), std::vector<std::uint8_t>{0, 3, 2}, labels);
  cut.weights.push_back(0.0);
  cut.isCut = true;
  EXPECT_EQ(labelNameAt(cut, {1.0, 0.0, 0.0}), "liver");
}

TEST(LabelAt, knowsTheCurveThatALabelHas) {
  const TransferFunction red{1.0, {{0.0, {1, 0, 0}, 0.5}}};
  const Region region = withLooks(threeLabels(), {{2, red}});
  EXPECT_EQ(ownLookAt(region, {1.0, 0.0, 0.0}), nullptr);
  ASSERT_NE(ownLookAt(region, {2.0, 0.0, 0.0}), nullptr);
  EXPECT_EQ(*ownLookAt(region, {2.0, 0.0, 0.0}), red);
}

TEST(LabelAt, ofAPieceThatWasPickedReadsThePiecesCurve) {
  const TransferFunction red{1.0, {{0.0, {1, 0, 0}, 0.5}}}, blue{1.0, {{0.0, {0, 0, 1}, 0.5}}};
  for (const bool hasSegmentation : {false, true}) {
    Region region = hasSegmentation ? withLooks(threeLabels(), {{2, blue}}) : Region{};
    region.uncut = region.labels;
    std::vector<Label> labels = hasSegmentation ? region.labels->labels() : std::vector<Label>(1);
    labels.push_back({-3, "Piece 1", {}});
    const auto piece = static_cast<std::uint8_t>(labels.size() - 1);
    const std::uint8_t last = hasSegmentation ? 2 : 0;
    region.labels = std::make_shared<const LabelMap>(glm::ivec3(3, 1, 1),
                                                     std::vector<std::uint8_t>{0, piece, last}, labels);
    region.weights.assign(labels.size(), 1.0);
    region.cuts = {{ConnectedPiece{{}, {}, 0, ConnectedPiece::Fate::ownLook, red}, true}};
    region.isCut = true;
    region = withLookOf(region, piece, red);
    ASSERT_NE(ownLookAt(region, {1.0, 0.0, 0.0}), nullptr);
    EXPECT_EQ(*ownLookAt(region, {1.0, 0.0, 0.0}), red);
    EXPECT_EQ(ownLookAt(region, {0.0, 0.0, 0.0}), nullptr);
    EXPECT_EQ(ownLookAt(region, {2.0, 0.0, 0.0}) != nullptr, hasSegmentation) << "beside it";
    EXPECT_EQ(labelNameAt(region, {1.0, 0.0, 0.0}), hasSegmentation ? "liver" : "");
  }
}

} // namespace
} // namespace limn
