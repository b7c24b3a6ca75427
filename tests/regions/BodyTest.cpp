// SPDX-License-Identifier: GPL-3.0-or-later
#include "Sets.h"

#include "io/VolumeReader.h"
#include "regions/Body.h"
#include "scene/basics/Error.h"
#include "scene/volume/Phantom.h"
#include "support/JudgedTime.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <limits>
#include <ostream>

namespace limn {
namespace {

using test::forEachVoxel;

constexpr std::int16_t air = -1000, tissue = 40, tableHu = 200;

VolumeInfo ctInfo() {
  VolumeInfo info;
  info.modality = "CT";
  info.unit = "HU";
  return info;
}

// A CT volume of voxels of 1 mm.
template <class Value>
Volume ctOf(const glm::ivec3& dims, Value&& value) {
  using T = std::decay_t<decltype(value(glm::ivec3(0)))>;
  std::vector<T> stored;
  forEachVoxel(dims, [&](const glm::ivec3& voxel) { stored.push_back(value(voxel)); });
  Grid grid;
  grid.dims = dims;
  return Volume(grid, std::move(stored), {}, std::nullopt, ctInfo());
}

bool isKept(const Region& region, const glm::ivec3& voxel) {
  const LabelMap& map = *region.labels;
  return map.placeAt(voxelOffset(map.dims(), voxel.x, voxel.y, voxel.z)) == 1;
}

// How many voxels of a set a region drops.
std::size_t dropped(const Region& region, const BitGrid& set) {
  std::size_t count = 0;
  forEachVoxel(set.dims(),
               [&](const glm::ivec3& voxel) { count += set.at(voxel) && !isKept(region, voxel) ? 1 : 0; });
  return count;
}

// The phantom on a table: a slab behind the head, `gap` voxels from its hindmost one; `strutVoxels` voxels of
// the table's stuff, square, bridge the gap.
struct OnTable {
  std::shared_ptr<const Volume> head = phantomVolume({3.0, 0.0, 1});
  std::unique_ptr<Volume> volume;
  BitGrid body = tissueOf(*head, -300.0, {});
  BitGrid table = BitGrid(body.dims());

  OnTable(int gap, int strutVoxels) {
    const glm::ivec3 dims = body.dims();
    int back = 0;
    forEachVoxel(dims, [&](const glm::ivec3& v) { back = body.at(v) ? std::max(back, v.y) : back; });
    const auto& whole = std::get<StoredVoxels<std::int16_t>>(head->stored());
    std::vector<std::int16_t> stored(whole.begin(), whole.end());
    forEachVoxel(dims, [&](const glm::ivec3& v) {
      const bool isSlab = v.y > back + gap && v.y <= back + gap + 3;
      const glm::ivec2 beside = glm::abs(glm::ivec2(v.x, v.z) - glm::ivec2(dims.x, dims.z) / 2);
      const bool isStrut =
          v.y > dims.y / 2 && v.y <= back + gap && std::max(beside.x, beside.y) * 2 < strutVoxels;
      if ((!isSlab && !isStrut) || body.at(v))
        return;
      table.set(v);
      stored[voxelOffset(dims, v.x, v.y, v.z)] = tableHu;
    });
    volume =
        std::make_unique<Volume>(head->grid(), std::move(stored), head->rescale(), std::nullopt, ctInfo());
  }
};

TEST(Body, ofAHeadOnATableIsTheHead) {
  const OnTable scene(2, 0);
  const BodyFinding found = findBody(*scene.volume);
  EXPECT_TRUE(found.isSure) << found.doubt.english();
  EXPECT_FALSE(found.isAlone);
  EXPECT_EQ(found.doubt.english(), "");
  EXPECT_EQ(found.region.kind, Region::Kind::body);
  EXPECT_EQ(found.region.labels->dims(), scene.body.dims());
  EXPECT_EQ(dropped(found.region, scene.body), 0u);
  EXPECT_EQ(dropped(found.region, scene.table), scene.table.count());
}

TEST(Body, keepsTheEdgeOfTheSkin) {
  // Two voxels of what is not tissue stay around it, so that the soft edge of the skin is not cut.
  const OnTable scene(4, 0);
  const Region region = findBody(*scene.volume).region;
  const BitGrid skin = test::setOf(scene.body.dims(), [&](const glm::ivec3& voxel) {
    if (scene.body.at(voxel))
      return false;
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-2, -1, 1, 2}) {
        glm::ivec3 near = voxel;
        near[axis] += step;
        if (test::isInside(scene.body.dims(), near) && scene.body.at(near))
          return true;
      }
    return false;
  });
  EXPECT_GT(skin.count(), 1000u);
  EXPECT_EQ(dropped(region, skin), 0u);
}

TEST(Body, aTableThatHangsOnByAThreadFallsAway) {
  const OnTable scene(2, 1);
  const BodyFinding found = findBody(*scene.volume);
  EXPECT_TRUE(found.isSure) << found.doubt.english();
  EXPECT_EQ(dropped(found.region, scene.body), 0u);
  // The thread itself stays with the head, and so may the voxels of the table that it ends in.
  EXPECT_GT(dropped(found.region, scene.table), scene.table.count() * 95 / 100);
}

TEST(Body, isNotSureOfWhatItTouchesBroadly) {
  // A second block hangs on the first by a plate that is thinner than the ball, as wide as the blocks.
  const auto value = [](const glm::ivec3& v) {
    const bool isAcross = v.y >= 4 && v.y < 36;
    const bool isBlock =
        isAcross && v.z >= 4 && v.z < 36 && ((v.x >= 4 && v.x < 64) || (v.x >= 70 && v.x < 84));
    const bool isPlate = isAcross && v.x >= 64 && v.x < 70 && v.z % 4 < 2 && v.z >= 4 && v.z < 36;
    return isBlock || isPlate ? tissue : air;
  };
  const Volume volume = ctOf({90, 40, 40}, value);
  const BodyFinding found = findBody(volume);
  EXPECT_FALSE(found.isSure);
  EXPECT_NE(found.doubt.english().find("touches it by"), std::string::npos) << found.doubt.english();
  EXPECT_EQ(dropped(found.region, tissueOf(volume, -300.0, {})), 0u) << "what is not sure is not cut";
}

TEST(Body, isNotSureOfOneBodyOfTwo) {
  // 60 of 100 columns of tissue belong to the first.
  const Volume volume = ctOf({120, 30, 30}, [](const glm::ivec3& v) {
    const bool isFirst = v.x >= 5 && v.x < 65, isSecond = v.x >= 72 && v.x < 112;
    return (isFirst || isSecond) && v.y >= 5 && v.y < 25 && v.z >= 5 && v.z < 25 ? tissue : air;
  });
  const BodyFinding found = findBody(volume);
  EXPECT_FALSE(found.isSure);
  EXPECT_EQ(found.doubt.english(),
            "only 60 % of the tissue hangs together, so a part of the patient may be hidden");
  EXPECT_TRUE(isKept(found.region, {30, 15, 15}));
  EXPECT_FALSE(isKept(found.region, {90, 15, 15}));
}

TEST(Body, hasItsAirInside) {
  // A lung that opens to no side, and a windpipe that leaves through the top.
  const Volume volume = ctOf({60, 60, 40}, [](const glm::ivec3& v) {
    const glm::ivec2 across = glm::abs(glm::ivec2(v.x, v.y) - 30);
    const int ring = std::max(across.x, across.y);
    const bool isLung = ring < 12 && v.z >= 10 && v.z < 30, isPipe = ring < 4 && v.z >= 30;
    return ring < 22 && !isLung && !isPipe ? tissue : air;
  });
  const Region region = findBody(volume).region;
  EXPECT_TRUE(isKept(region, {30, 30, 20}));
  EXPECT_TRUE(isKept(region, {30, 30, 38}));
  EXPECT_FALSE(isKept(region, {2, 2, 20}));
}

TEST(Body, withoutTissueIsNone) {
  const BodyFinding found = findBody(ctOf({20, 20, 20}, [](const glm::ivec3&) { return air; }));
  EXPECT_EQ(found.region, Region{});
  EXPECT_FALSE(found.isSure);
  EXPECT_EQ(found.doubt.english(), "it holds no tissue");
}

// Volumes in which nothing lies beside the body: all tissue, one slice, one row, one voxel.
TEST(Body, besideWhichNothingLiesKeepsEverythingAndHidesNothing) {
  for (const glm::ivec3& dims : {glm::ivec3(40, 40, 40), {40, 40, 1}, {70, 1, 1}, {1, 1, 1}}) {
    const Volume volume = ctOf(dims, [](const glm::ivec3&) { return tissue; });
    const BodyFinding found = findBody(volume);
    EXPECT_FALSE(found.isSure);
    EXPECT_TRUE(found.isAlone);
    EXPECT_EQ(found.doubt.english(), "nothing lies beside it");
    EXPECT_EQ(dropped(found.region, tissueOf(volume, -300.0, {})), 0u)
        << dims.x << "×" << dims.y << "×" << dims.z;
  }
}

TEST(Body, mayBeCutByEveryFaceOfTheVolume) {
  // The middle of the phantom, which touches all six faces.
  const auto head = phantomVolume({3.0, 0.0, 1});
  const glm::ivec3 all = head->grid().dims, dims = all / 3;
  const Volume volume =
      ctOf(dims, [&](const glm::ivec3& v) { return static_cast<std::int16_t>(head->value(v + all / 3)); });
  EXPECT_EQ(dropped(findBody(volume).region, tissueOf(volume, -300.0, {})), 0u);
}

TEST(Body, doesNotHoldPadding) {
  // A round field of view in NaN, as scanners write it: a body, a table, and nothing known around them.
  const glm::ivec3 dims(80, 80, 10);
  const auto radius = [](const glm::ivec3& v) { return glm::length(glm::dvec2(v.x, v.y) - 40.0); };
  const Volume volume = ctOf(dims, [&](const glm::ivec3& v) {
    if (radius(v) > 38.0)
      return std::numeric_limits<float>::quiet_NaN();
    return static_cast<float>(radius(v) < 20.0 ? tissue : v.y >= 66 && v.y < 70 ? tableHu : air);
  });
  const BodyFinding found = findBody(volume);
  EXPECT_TRUE(found.isSure) << found.doubt.english();
  EXPECT_TRUE(isKept(found.region, {40, 40, 5}));
  EXPECT_FALSE(isKept(found.region, {40, 68, 5}));
  EXPECT_FALSE(isKept(found.region, {1, 1, 5}));
}

TEST(Body, tellsHowFarItIsAndIsLeftWhenCancelled) {
  const OnTable scene(2, 0);
  std::vector<double> told;
  const Effort watched{1, {}, [&](double fraction) { told.push_back(fraction); }};
  (void)findBody(*scene.volume, watched);
  ASSERT_GT(told.size(), 10u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_DOUBLE_EQ(told.back(), 1.0);
  // Wherever it is told to stop, it does.
  for (const int after : {0, 5, 50, 200}) {
    int asked = 0;
    const Effort stopped{1, [&] { return asked++ >= after; }, {}};
    EXPECT_THROW((void)findBody(*scene.volume, stopped), Cancelled) << after;
  }
}

// Real volumes: what is expected of each.
struct Expected {
  const char* file;
  bool isSure;
};

void PrintTo(const Expected& expected, std::ostream* out) {
  *out << expected.file;
}

class RealBody : public testing::TestWithParam<Expected> {};

TEST_P(RealBody, keepsEveryVoxelOfTheLargestPieceOfTissue) {
  const std::string file = std::string("data/") + GetParam().file;
  LIMN_NEEDS_SHARED(file);
  const auto volume = readVolume(test::sharedFolder() / file);
  const BodyFinding found = findBody(*volume);
  EXPECT_EQ(found.isSure, GetParam().isSure) << found.doubt.english();
  const BitGrid all = tissueOf(*volume, tissueThreshold(*volume, {}), {});
  const BitGrid largest = test::largestPartOf(all);
  EXPECT_EQ(dropped(found.region, largest), 0u);
  BitGrid beside = all;
  beside -= largest;
  // What lies around the body falls away, but for what lies inside it (teeth, phantoms) or next to it.
  EXPECT_GT(dropped(found.region, beside), beside.count() / 2);
  std::printf("%s: %zu of %zu voxels of tissue fall away; %s\n", file.c_str(), dropped(found.region, all),
              all.count(), found.isSure ? "sure" : found.doubt.english().c_str());
}

INSTANTIATE_TEST_SUITE_P(Shared, RealBody,
                         testing::Values(Expected{"ct_head_cranium/dicom_explicit_le", true},
                                         Expected{"ct_thorax_contrast/lidc2_uint8.vti", false},
                                         Expected{"ct_head_phantom_tilt_dicom", false}));

TEST(BodyTimes, aHeadTakesLessThanASecondAndALargeChestLessThanFive) {
  for (const auto& [dims, most] : {std::pair(glm::ivec3(256, 256, 108), 1000.0), {{512, 512, 300}, 5000.0}}) {
    const Volume volume = ctOf(dims, [&size = dims](const glm::ivec3& v) {
      // A body with airways of all sizes on a curved table, and noise.
      const glm::dvec3 p = glm::dvec3(v) / glm::dvec3(size) * 2.0 - 1.0;
      const double wave = std::sin(20.0 * p.x) * std::sin(20.0 * p.y) * std::sin(20.0 * p.z);
      const bool isBody = glm::length(glm::dvec2(p.x, p.y)) < 0.7 && wave < 0.5;
      const bool isTable = std::abs(glm::length(glm::dvec2(p.x, p.y)) - 0.85) < 0.02 && p.y > 0.4;
      const unsigned noise = static_cast<unsigned>((v.x * 73 + v.y * 179 + v.z * 283) * 2654435761u) >> 26;
      return static_cast<std::int16_t>((isBody ? tissue : isTable ? tableHu : air) + static_cast<int>(noise));
    });
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(findBody(volume).isSure);
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
    test::judgeMs("body of " + std::to_string(dims.x) + "×" + std::to_string(dims.y) + "×" +
                      std::to_string(dims.z),
                  passed.count(), most);
  }
}

} // namespace
} // namespace limn
