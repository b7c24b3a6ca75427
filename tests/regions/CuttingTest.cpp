// SPDX-License-Identifier: GPL-3.0-or-later
#include "Sets.h"

#include "regions/Cutting.h"
#include "regions/PiecePick.h"
#include "regions/ScissorSet.h"
#include "regions/ValueSet.h"
#include "scene/basics/Error.h"
#include "scene/volume/Orientation.h"
#include "support/JudgedTime.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <random>

namespace limn {
namespace {

using test::forEachVoxel;
using test::setOf;

// An oblique grid whose voxels are longer than wide, off the origin.
Grid obliqueGrid(const glm::ivec3& dims) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {1.0, 1.5, 2.5};
  grid.originMm = {-20.0, 12.0, 5.0};
  const double c = std::cos(0.4), s = std::sin(0.4);
  grid.direction =
      glm::dmat3(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0) * glm::dmat3(1.0, 0.0, 0.0, 0.0, c, s, 0.0, -s, c);
  return grid;
}

Camera cameraOn(const Grid& grid, const glm::dvec3& from, double mm, Camera::Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.target = boxCentreMm(grid);
  camera.position = camera.target + mm * glm::normalize(from);
  camera.heightMm = 60.0;
  return camera;
}

std::vector<glm::dvec2> star(double radius, int corners) {
  std::vector<glm::dvec2> line;
  for (int n = 0; n < corners; ++n) {
    // Every second corner of a star with seven: it crosses itself.
    const double angle = 2.0 * std::numbers::pi * (3 * n) / corners;
    line.emplace_back(0.1 + radius * std::cos(angle), -0.05 + radius * std::sin(angle));
  }
  return line;
}

// The law, voxel by voxel (DEFINITION section 10).
bool isTaken(const Scissors& scissors, const Grid& grid, const glm::ivec3& voxel) {
  const glm::dvec3 world = indexToWorld(grid, glm::dvec3(voxel));
  const auto place = placeInPicture(scissors.camera, world);
  if (!place || isInside(scissors.polygon, *place) != scissors.removesInside)
    return false;
  if (!scissors.depthMm)
    return true;
  const glm::dvec3 fromEye = world - scissors.camera.position;
  const double depth = scissors.camera.projection == Camera::Projection::perspective
                           ? glm::length(fromEye)
                           : glm::dot(fromEye, basisOf(scissors.camera).forward);
  return depth >= scissors.depthMm->x && depth <= scissors.depthMm->y;
}

std::size_t differing(const BitGrid& a, const BitGrid& b) {
  BitGrid onlyA = a, onlyB = b;
  onlyA -= b;
  onlyB -= a;
  return onlyA.count() + onlyB.count();
}

TEST(Scissors, takeTheVoxelsThatProjectInsideTheLineFromAnyCamera) {
  const Grid grid = obliqueGrid({37, 29, 23});
  const glm::dvec3 directions[] = {{0, -1, 0}, {1, 0.3, 0.2}, {-0.4, 0.5, 1}, {0.1, 0.05, -1}};
  for (const Camera::Projection projection :
       {Camera::Projection::perspective, Camera::Projection::orthographic})
    for (const glm::dvec3& from : directions)
      for (const double mm : {150.0, 12.0}) // from outside, and from a camera inside the volume
        for (const bool removesInside : {true, false})
          for (const std::optional<glm::dvec2>& depth :
               {std::optional<glm::dvec2>(), std::optional(glm::dvec2(0.3 * mm, mm + 4.0))}) {
            const Scissors scissors{cameraOn(grid, from, mm, projection), 1.5, star(0.6, 7), removesInside,
                                    depth};
            const BitGrid expected =
                setOf(grid.dims, [&](const glm::ivec3& voxel) { return isTaken(scissors, grid, voxel); });
            EXPECT_EQ(differing(takenBy(scissors, grid), expected), 0u)
                << "from " << from.x << " at " << mm << " mm, inside " << removesInside;
            EXPECT_GT(expected.count(), 0u);
          }
}

TEST(Scissors, workAlongAnAxisWhereRowsAreSeenEndOn) {
  Grid grid;
  grid.dims = {20, 17, 15};
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 from(0.0);
    from[axis] = 1.0;
    for (const Camera::Projection projection :
         {Camera::Projection::perspective, Camera::Projection::orthographic}) {
      Camera camera = cameraOn(grid, from, 80.0, projection);
      camera.up = axis == 2 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
      const Scissors scissors{camera, 1.0, star(0.2, 5), true, {}};
      const BitGrid expected =
          setOf(grid.dims, [&](const glm::ivec3& voxel) { return isTaken(scissors, grid, voxel); });
      EXPECT_EQ(differing(takenBy(scissors, grid), expected), 0u) << "axis " << axis;
      EXPECT_GT(expected.count(), 0u);
    }
  }
}

TEST(Scissors, takeNothingWithALineOfTwoPointsOrOffThePicture) {
  const Grid grid = obliqueGrid({12, 12, 12});
  Scissors scissors{cameraOn(grid, {0, -1, 0}, 100.0, Camera::Projection::perspective), 1.0, {}, true, {}};
  EXPECT_EQ(takenBy(scissors, grid).count(), 0u);
  scissors.polygon = {{-1, -1}, {1, 1}};
  EXPECT_EQ(takenBy(scissors, grid).count(), 0u);
  scissors.polygon = {{50, 50}, {51, 50}, {51, 51}};
  EXPECT_EQ(takenBy(scissors, grid).count(), 0u);
  scissors.removesInside = false;
  EXPECT_EQ(takenBy(scissors, grid).count(), 12u * 12u * 12u);
}

TEST(Scissors, takeThousandsOfCornersAsWell) {
  const Grid grid = obliqueGrid({24, 24, 24});
  Scissors scissors{
      cameraOn(grid, {0.3, -1, 0.2}, 120.0, Camera::Projection::perspective), 1.0, {}, true, {}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.8, 0.8);
  for (int n = 0; n < 5000; ++n)
    scissors.polygon.emplace_back(place(random), place(random));
  const BitGrid expected =
      setOf(grid.dims, [&](const glm::ivec3& voxel) { return isTaken(scissors, grid, voxel); });
  EXPECT_EQ(differing(takenBy(scissors, grid), expected), 0u);
}

// A volume of values at random, smooth enough to have pieces of all sizes.
std::shared_ptr<const Volume> cloudy(const glm::ivec3& dims) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> value(0, 100);
  std::vector<std::int16_t> stored(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
  for (std::int16_t& voxel : stored)
    voxel = static_cast<std::int16_t>(value(random));
  return std::make_shared<const Volume>(obliqueGrid(dims), std::move(stored), Rescale{}, std::nullopt,
                                        VolumeInfo{});
}

BitGrid removedFrom(const CutRegion& cut, const glm::ivec3& dims) {
  const LabelMap& map = *cut.region.labels;
  return setOf(dims, [&](const glm::ivec3& v) {
    return map.placeAt(voxelOffset(dims, v.x, v.y, v.z)) == map.labels().size() - 1;
  });
}

BitGrid valuesFrom(const Volume& volume, double low, double high) {
  return setOf(volume.grid().dims, [&](const glm::ivec3& v) {
    const double value = valueAt(volume, glm::dvec3(v));
    return value >= low && value <= high;
  });
}

TEST(Pieces, areWhatHangsTogetherWithTheSeedAndGrowIntoWhatIsOutsideTheRange) {
  const glm::ivec3 dims(30, 21, 17);
  const auto volume = cloudy(dims);
  const BitGrid inRange = valuesFrom(*volume, 92.0, 100.0);
  const BitGrid largest = test::largestPartOf(inRange);
  ASSERT_GT(largest.count(), 5u);
  glm::ivec3 seed(-1);
  forEachVoxel(dims, [&](const glm::ivec3& v) {
    if (seed.x < 0 && largest.at(v))
      seed = v;
  });
  const glm::dvec3 seedMm = indexToWorld(volume->grid(), glm::dvec3(seed) + 0.3);
  for (const int grow : {0, 1}) {
    BitGrid expected = largest;
    forEachVoxel(dims, [&](const glm::ivec3& v) {
      for (const glm::ivec3& face : {glm::ivec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}})
        for (const int sign : {-1, 1})
          if (const glm::ivec3 near = v + sign * face;
              grow == 1 && test::isInside(dims, near) && largest.at(near) && !inRange.at(v))
            expected.set(v);
    });
    const ConnectedPiece piece{seedMm, {92.0, 100.0}, grow, ConnectedPiece::Fate::hidden};
    const CutRegion hidden = cutRegion(*volume, {}, {{piece, true}});
    EXPECT_EQ(differing(removedFrom(hidden, dims), expected), 0u) << "grown by " << grow;
    EXPECT_EQ(hidden.taken.front(), expected.count());
    ConnectedPiece alone = piece;
    alone.fate = ConnectedPiece::Fate::alone;
    const CutRegion kept = cutRegion(*volume, {}, {{alone, true}});
    EXPECT_EQ(differing(removedFrom(kept, dims), expected.complement()), 0u);
    EXPECT_EQ(kept.left, expected.count());
  }
}

TEST(Pieces, areFoundAmongWhatEarlierCutsAndLabelsLeave) {
  const glm::ivec3 dims(9, 5, 5);
  std::vector<std::int16_t> stored(9 * 5 * 5, 0);
  for (int x = 0; x < 9; ++x)
    stored[voxelOffset(dims, x, 2, 2)] = 100; // a bar
  Grid grid;
  grid.dims = dims;
  const auto volume =
      std::make_shared<const Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
  // A label in its middle divides it where it is hidden.
  std::vector<std::uint8_t> places(9 * 5 * 5, 0);
  places[voxelOffset(dims, 4, 2, 2)] = 1;
  Region labels{
      Region::Kind::labels,
      "l",
      std::make_shared<const LabelMap>(dims, std::move(places), std::vector<Label>{{0, "", {}}, {1, "", {}}}),
      {1.0, 1.0}};
  const Cut left{ConnectedPiece{{0, 2, 2}, {50.0, 200.0}, 0, ConnectedPiece::Fate::hidden}, true};
  EXPECT_EQ(cutRegion(*volume, labels, {left}).taken.front(), 9u);
  labels.weights[1] = 0.0;
  const CutRegion divided = cutRegion(*volume, labels, {left});
  EXPECT_EQ(divided.taken.front(), 4u);
  EXPECT_FALSE(needsCutting(divided.region));
  Region shown = divided.region;
  shown.weights[1] = 1.0;
  EXPECT_TRUE(needsCutting(shown)) << "the piece reaches further where the label is shown";
  EXPECT_EQ(cutRegion(*volume, shown, shown.cuts).taken.front(), 9u);
  // What lies in air, beside the volume or among what is hidden is no piece, and keeps nothing alone.
  for (const glm::dvec3& seed : {glm::dvec3(0, 0, 0), glm::dvec3(-40, 2, 2), glm::dvec3(4, 2, 2)}) {
    const CutRegion none = cutRegion(
        *volume, labels, {{ConnectedPiece{seed, {50.0, 200.0}, 1, ConnectedPiece::Fate::alone}, true}});
    EXPECT_EQ(none.taken.front(), 0u);
  }
}

// Two bars of a value that do not touch, in a field of 0.
std::shared_ptr<const Volume> twoBars(const glm::ivec3& dims) {
  std::vector<std::int16_t> stored(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 0);
  for (int x = 0; x < dims.x; ++x)
    for (const int y : {1, 4})
      stored[voxelOffset(dims, x, y, 2)] = 100;
  Grid grid;
  grid.dims = dims;
  return std::make_shared<const Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
}

TEST(Pieces, withALookAreLabelsThatNothingIsTakenFrom) {
  const glm::ivec3 dims(9, 6, 5);
  const auto volume = twoBars(dims);
  const TransferFunction red{1.0, {{50.0, {1.0, 0.0, 0.0}, 0.9}}}, blue{2.0, {{50.0, {0.0, 0.0, 1.0}, 0.5}}};
  const auto pieceOf = [](double y, const TransferFunction& look) {
    return Cut{ConnectedPiece{{3, y, 2}, {50.0, 200.0}, 0, ConnectedPiece::Fate::ownLook, look}, true};
  };
  const CutRegion one = cutRegion(*volume, {}, {pieceOf(1, red)});
  EXPECT_EQ(one.taken.front(), 9u);
  EXPECT_EQ(one.left, 9u * 6 * 5);
  EXPECT_FALSE(isCutAway(one.region));
  EXPECT_FALSE(isRestricting(one.region));
  EXPECT_EQ(withoutCuts(one.region), Region{});
  ASSERT_EQ(labelOfCut(one.region, 0), 1u);
  EXPECT_EQ(one.region.looks, std::vector<TransferFunction>{red});
  // One that is cut away in part, and one that a later one has.
  const Cut hidden{ConnectedPiece{{3, 1, 2}, {50.0, 200.0}, 0, ConnectedPiece::Fate::hidden}, true};
  const std::vector<Cut> cuts{pieceOf(1, red), pieceOf(4, red), pieceOf(4, blue), hidden};
  const CutRegion all = cutRegion(*volume, {}, cuts);
  const CutRegion after = cutRegion(*volume, one.region, cuts);
  EXPECT_EQ(after.region.labels->placeAt(0), all.region.labels->placeAt(0));
  forEachVoxel(dims, [&](const glm::ivec3& v) {
    const std::size_t voxel = voxelOffset(dims, v.x, v.y, v.z);
    const std::size_t place = all.region.labels->placeAt(voxel);
    const bool isBar = v.z == 2 && (v.y == 1 || v.y == 4);
    ASSERT_EQ(place, !isBar ? 0u : v.y == 1 ? 4u : 3u);
    ASSERT_EQ(after.region.labels->placeAt(voxel), place) << "going on from the first";
  });
  EXPECT_EQ(ownLabels(all.region), 1u);
  EXPECT_EQ(all.region.weights, (std::vector<double>{1.0, 1.0, 1.0, 1.0, 0.0}));
  EXPECT_EQ(all.region.looks[lookOfLabel(all.region, 3) - 1], blue);
  EXPECT_FALSE(needsCutting(all.region));
  EXPECT_EQ(withoutCuts(all.region), Region{});
}

TEST(Pieces, withALookFadeWithTheirLabelAndKeepTheLooksOfOthers) {
  const glm::ivec3 dims(9, 6, 5);
  const auto volume = twoBars(dims);
  std::vector<std::uint8_t> places(9 * 6 * 5, 0);
  for (int x = 0; x < 9; ++x)
    places[voxelOffset(dims, x, 4, 2)] = 1;
  const TransferFunction red{1.0, {{50.0, {1.0, 0.0, 0.0}, 0.9}}}, blue{2.0, {{50.0, {0.0, 0.0, 1.0}, 0.5}}};
  const std::vector<Label> labels{{0, "", {}}, {1, "", {}}};
  const Region before = withLooks(
      {Region::Kind::labels, "l", std::make_shared<const LabelMap>(dims, places, labels), {1.0, 0.25}},
      {{0, blue}});
  const CutRegion cut =
      cutRegion(*volume, before,
                {{ConnectedPiece{{3, 4, 2}, {50.0, 200.0}, 0, ConnectedPiece::Fate::ownLook, red}, true}});
  EXPECT_EQ(cut.region.weights, (std::vector<double>{1.0, 0.25, 0.25}));
  EXPECT_EQ(cut.region.looks[lookOfLabel(cut.region, 0) - 1], blue);
  EXPECT_EQ(cut.region.looks[lookOfLabel(cut.region, 2) - 1], red);
  EXPECT_EQ(withoutCuts(cut.region), before) << "the piece's look goes with it";
}

TEST(Cuts, oneAfterTheOtherAreWhatAllAtOnceAre) {
  const glm::ivec3 dims(30, 21, 17);
  const auto volume = cloudy(dims);
  const Camera camera = cameraOn(volume->grid(), {0.2, -1, 0.3}, 150.0, Camera::Projection::perspective);
  std::vector<Cut> cuts{
      {Scissors{camera, 1.0, star(0.15, 5), true, {}}, true},
      {ConnectedPiece{boxCentreMm(volume->grid()), {0.0, 101.0}, 1, ConnectedPiece::Fate::alone}, true},
      {Scissors{camera, 1.0, star(0.1, 7), false, {}}, true}};
  const CutRegion all = cutRegion(*volume, {}, cuts);
  Region region;
  for (std::size_t n = 1; n <= cuts.size(); ++n)
    region = cutRegion(*volume, region, {cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(n)}).region;
  EXPECT_EQ(region.weights, all.region.weights);
  const auto mapOf = [&](const Region& cut) { return removedFrom({cut, {}, 0}, dims); };
  EXPECT_EQ(differing(mapOf(region), mapOf(all.region)), 0u);
  // A cut that is switched off or taken out is as if it had never been.
  cuts[1].isOn = false;
  EXPECT_EQ(differing(mapOf(cutRegion(*volume, region, cuts).region),
                      mapOf(cutRegion(*volume, {}, {cuts[0], cuts[2]}).region)),
            0u);
  const CutRegion none = cutRegion(*volume, region, {});
  EXPECT_EQ(none.region, Region{});
  EXPECT_EQ(none.left, static_cast<std::size_t>(30 * 21 * 17));
}

TEST(Cuts, takeTheSameVoxelsWhereThoseAreTurnedAndMirroredByHand) {
  const glm::ivec3 dims(30, 21, 17);
  const auto volume = cloudy(dims);
  const Camera camera = cameraOn(volume->grid(), {0.2, -1, 0.3}, 150.0, Camera::Projection::perspective);
  const std::vector<Cut> cuts{
      {Scissors{camera, 1.0, star(0.15, 5), true, glm::dvec2(0.0, 152.0)}, true},
      {ConnectedPiece{boxCentreMm(volume->grid()), {0.0, 101.0}, 1, ConnectedPiece::Fate::alone}, true}};
  const BitGrid before = removedFrom(cutRegion(*volume, {}, cuts), dims);
  for (const char* letters : {"RPS", "IRA", "PIR"}) {
    const auto turned = orientedByHand(*volume, letters);
    const std::vector<Cut> moved = cutsMoved(cuts, volume->grid(), turned->grid());
    EXPECT_EQ(differing(removedFrom(cutRegion(*turned, {}, moved), dims), before), 0u) << letters;
    EXPECT_GT(differing(removedFrom(cutRegion(*turned, {}, cuts), dims), before), 0u) << letters;
  }
}

TEST(Cuts, addOneLabelToThoseOfASegmentationAndLeaveTheirWeights) {
  const glm::ivec3 dims(8, 8, 8);
  std::vector<std::int16_t> stored(512, 0);
  Grid grid;
  grid.dims = dims;
  const auto volume =
      std::make_shared<const Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
  for (const std::size_t labels :
       {std::size_t{2}, std::size_t{256}, std::size_t{65535}, std::size_t{65536}}) {
    std::vector<Label> list;
    for (std::size_t n = 0; n < labels; ++n)
      list.push_back({static_cast<int>(n), "", {}});
    std::vector<std::uint16_t> places(512);
    for (std::size_t n = 0; n < 512; ++n)
      places[n] = static_cast<std::uint16_t>(n % labels);
    Region region{Region::Kind::labels, "l", std::make_shared<const LabelMap>(dims, std::move(places), list),
                  std::vector<double>(labels, 0.5)};
    const Scissors scissors{
        cameraOn(grid, {0, -1, 0}, 60.0, Camera::Projection::perspective), 1.0, star(0.3, 5), true, {}};
    if (labels == 65536) {
      EXPECT_THROW(cutRegion(*volume, region, {{scissors, true}}), Error);
      continue;
    }
    const CutRegion cut = cutRegion(*volume, region, {{scissors, true}});
    EXPECT_EQ(ownLabels(cut.region), labels);
    EXPECT_EQ(cut.region.weights.back(), 0.0);
    EXPECT_EQ(withoutCuts(cut.region), region);
    EXPECT_GT(cut.taken.front(), 0u);
  }
}

TEST(PiecePick, takesTheRangeThatTheCurveShowsAroundTheValue) {
  const ValueRange values{-1000.0, 3000.0};
  const TransferFunction bone{1.0, {{200.0, {}, 0.0}, {300.0, {}, 0.2}, {1000.0, {}, 0.9}}};
  EXPECT_EQ(rangeAround(bone, values, 700.0, 0.02), glm::dvec2(210.0, 3000.0));
  EXPECT_EQ(rangeAround(bone, values, -50.0, 0.02), glm::dvec2(210.0, 3000.0)) << "the nearest one";
  EXPECT_EQ(rangeAround(bone, values, 700.0, 0.1), glm::dvec2(250.0, 3000.0));
  const TransferFunction bands{
      1.0,
      {{0.0, {}, 0.0}, {10.0, {}, 0.2}, {20.0, {}, 0.0}, {40.0, {}, 0.0}, {50.0, {}, 0.4}, {60.0, {}, 0.0}}};
  const auto second = rangeAround(bands, values, 48.0, 0.02);
  ASSERT_TRUE(second);
  EXPECT_DOUBLE_EQ(second->x, 40.5);
  EXPECT_DOUBLE_EQ(second->y, 59.5);
  EXPECT_FALSE(rangeAround({}, values, 0.0, 0.02));
  EXPECT_FALSE(rangeAround({1.0, {{0.0, {}, 0.0}}}, values, 0.0, 0.02));
}

TEST(PiecePick, pointsAtTheMostOpaqueVoxelNearBy) {
  Grid grid;
  grid.dims = {9, 9, 9};
  std::vector<std::int16_t> stored(729, 40); // a veil around a bone of one voxel
  stored[voxelOffset(grid.dims, 4, 4, 4)] = 800;
  Scene scene;
  scene.volume =
      std::make_shared<const Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
  scene.transferFunction = {1.0, {{0.0, {}, 0.05}, {200.0, {}, 0.05}, {800.0, {}, 0.9}}};
  const auto bone = pieceAt(scene, {5.2, 4.6, 3.0});
  ASSERT_TRUE(bone);
  EXPECT_EQ(bone->seedMm, glm::dvec3(4.0));
  EXPECT_NEAR(bone->range.x, 200.0 + 600.0 * (0.45 - 0.05) / 0.85, 1e-9) << "half of its opacity";
  const auto veil = pieceAt(scene, {8.0, 8.0, 8.0});
  ASSERT_TRUE(veil);
  EXPECT_EQ(veil->range.x, 0.0);
  EXPECT_FALSE(pieceAt(scene, {30.0, 4.0, 4.0})) << "beside the volume";
  scene.transferFunction = {1.0, {{0.0, {}, 0.0}, {300.0, {}, 0.0}, {800.0, {}, 0.9}}};
  EXPECT_FALSE(pieceAt(scene, {8.0, 8.0, 8.0})) << "nothing is seen there";
}

TEST(PiecePick, narrowsTheEndThatIsNotTheVolumesAndKeepsTheSeed) {
  const auto volume = cloudy({10, 10, 10});
  const glm::dvec3 seed = indexToWorld(volume->grid(), {3, 4, 5});
  const double value = valueAt(*volume, {3, 4, 5});
  const ValueRange& values = volume->range();
  const ConnectedPiece piece{seed, {0.5 * value, values.highest}, 1, ConnectedPiece::Fate::hidden};
  const double notch = 0.02 * (values.highest - values.lowest);
  ASSERT_GT(0.5 * value, 2.0 * notch) << "neither end is met by one notch";
  EXPECT_DOUBLE_EQ(narrowed(piece, *volume, 1.0).range.x, 0.5 * value + notch);
  EXPECT_DOUBLE_EQ(narrowed(piece, *volume, -1.0).range.x, 0.5 * value - notch);
  EXPECT_DOUBLE_EQ(narrowed(piece, *volume, 1.0).range.y, values.highest);
  // The seed's own value is read back through its place in the world.
  EXPECT_NEAR(narrowed(piece, *volume, 1000.0).range.x, value, 1e-9);
  EXPECT_DOUBLE_EQ(narrowed(piece, *volume, -1000.0).range.x, values.lowest);
}

TEST(PiecePick, narrowsTheUpperEndAloneByAFifthOfWhatLiesAboveTheSeed) {
  const auto volume = cloudy({10, 10, 10});
  const glm::dvec3 seed = indexToWorld(volume->grid(), {3, 4, 5});
  const double value = valueAt(*volume, {3, 4, 5});
  const ValueRange& values = volume->range();
  ASSERT_LT(value, values.highest);
  const ConnectedPiece piece{seed, {values.lowest, values.highest + 100.0}, 1, ConnectedPiece::Fate::hidden};
  const ConnectedPiece less = narrowedAbove(piece, *volume, 1.0);
  EXPECT_EQ(less.range.x, piece.range.x);
  // The seed's own value is read back through its place in the world.
  EXPECT_NEAR(less.range.y, value + 0.8 * (values.highest - value), 1e-9);
  EXPECT_NEAR(narrowedAbove(less, *volume, -1.0).range.y, values.highest, 1e-9);
  const ConnectedPiece least = narrowedAbove(piece, *volume, 100.0);
  EXPECT_NEAR(least.range.y, value, 1e-9);
  EXPECT_GT(narrowedAbove(least, *volume, -1.0).range.y, value) << "and widens again";
  EXPECT_FALSE(isNarrowest(piece, *volume));
  EXPECT_TRUE(
      isNarrowest({seed, {valueAt(*volume, worldToIndex(volume->grid(), seed)), values.highest}}, *volume));
}

// A ball of 30 ± 4 in a block of 60, both of which a curve shows alike.
TEST(PiecePick, takesValuesLikeThoseAroundThePlace) {
  Grid grid;
  grid.dims = {31, 31, 31};
  std::vector<std::int16_t> stored;
  for (int z = 0; z < 31; ++z)
    for (int y = 0; y < 31; ++y)
      for (int x = 0; x < 31; ++x) {
        const bool isBall = glm::length(glm::dvec3(x - 15, y - 15, z - 15)) <= 10.0;
        stored.push_back(static_cast<std::int16_t>(isBall ? 30 + 4 * ((x + y + z) % 2 == 0 ? 1 : -1) : 60));
      }
  const Volume volume(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
  const glm::dvec3 middle(15.0);
  const ConnectedPiece all{middle, {-100.0, 100.0}};
  const ConnectedPiece ball = withValuesAround(all, volume, {}, middle);
  EXPECT_EQ(ball.seedMm, middle) << "from where a reach is told";
  // Mean 30 and deviation 4 but for the one voxel in the middle of an odd count.
  EXPECT_NEAR(ball.range.x, 20.0, 0.5);
  EXPECT_NEAR(ball.range.y, 40.0, 0.5);
  const BitGrid found = pieceAmong(BitGrid(grid.dims).complement(), volume, {ball.seedMm, ball.range, 0});
  for (int z = 0; z < 31; ++z)
    for (int y = 0; y < 31; ++y)
      for (int x = 0; x < 31; ++x)
        EXPECT_EQ(found.at({x, y, z}), glm::length(glm::dvec3(x - 15, y - 15, z - 15)) <= 10.0);
  EXPECT_EQ(withValuesAround({middle, {500.0, 600.0}}, volume, {}, middle).range, glm::dvec2(500.0, 600.0))
      << "nothing of the piece lies there";
  // The middle, which has 26, cut away.
  const Region cut = cutRegion(volume, {}, {{ConnectedPiece{middle, {26.0, 26.0}, 0}, true}}).region;
  const ConnectedPiece beside = withValuesAround(all, volume, cut, middle);
  EXPECT_GT(pieceAmong(keptVoxels(cut, volume), volume, beside).count(), 0u);
}

TEST(Pieces, reachNoFartherThanIsAskedFor) {
  const glm::ivec3 dims(24, 20, 16);
  const Grid grid = obliqueGrid(dims);
  const Volume volume(grid, std::vector<std::int16_t>(24 * 20 * 16, 7), Rescale{}, std::nullopt,
                      VolumeInfo{});
  ConnectedPiece piece{indexToWorld(grid, {4, 9, 8}), {0.0, 10.0}, 1, ConnectedPiece::Fate::hidden};
  piece.reachMm = 6.0;
  const BitGrid found = pieceAmong(BitGrid(dims).complement(), volume, piece);
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        const double mm = glm::distance(indexToWorld(grid, {x, y, z}), piece.seedMm);
        if (std::abs(mm - 6.0) > 1e-9) { // on the border rounding decides
          EXPECT_EQ(found.at({x, y, z}), mm < 6.0) << x << " " << y << " " << z;
        }
      }
  EXPECT_GT(found.count(), 100u);
  piece.reachMm.reset();
  EXPECT_EQ(pieceAmong(BitGrid(dims).complement(), volume, piece).count(), 24u * 20u * 16u);
}

TEST(PiecePick, tellsHowLargeASetIs) {
  const auto volume = cloudy({70, 9, 8});
  const BitGrid set = valuesFrom(*volume, 30.0, 60.0);
  double sum = 0.0;
  forEachVoxel(set.dims(), [&](const glm::ivec3& v) {
    if (set.at(v))
      sum += valueAt(*volume, glm::dvec3(v));
  });
  const SetFigures figures = figuresOf(set, *volume, {30.0, 60.0});
  EXPECT_DOUBLE_EQ(figures.millilitres, static_cast<double>(set.count()) * 1.0 * 1.5 * 2.5 / 1000.0);
  EXPECT_NEAR(figures.mean, sum / static_cast<double>(set.count()), 1e-9);
  EXPECT_EQ(figures.values, (ValueRange{30.0, 60.0}));
  EXPECT_EQ(figuresOf(BitGrid(set.dims()), *volume, {30.0, 60.0}).millilitres, 0.0);
  // The rim that goes with a piece has other values.
  const BitGrid grown = dilated(set, glm::dvec3(1.0), {});
  ASSERT_GT(grown.count(), set.count());
  const BitGrid within = valuesWithin(*volume, {30.0, 60.0}, {});
  BitGrid meant = grown;
  meant &= within;
  EXPECT_DOUBLE_EQ(figuresOf(grown, *volume, {30.0, 60.0}).millilitres,
                   static_cast<double>(meant.count()) * 1.0 * 1.5 * 2.5 / 1000.0);
}

// Asked for: 300 ms for 512²×300 voxels once a line is closed (by the issue's own words on two cores).
TEST(CutTimes, aLargeVolumeAnswersWithin300Ms) {
  Grid grid;
  grid.dims = {512, 512, 300};
  grid.spacingMm = {0.7, 0.7, 1.0};
  std::vector<std::int16_t> stored(static_cast<std::size_t>(512) * 512 * 300);
  for (std::size_t n = 0; n < stored.size(); ++n)
    stored[n] = static_cast<std::int16_t>(n % 512 < 300 ? 300 : 0);
  const auto volume =
      std::make_shared<const Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
  std::vector<glm::dvec2> line;
  for (int n = 0; n < 300; ++n) {
    const double angle = 2.0 * std::numbers::pi * n / 300;
    line.emplace_back(0.3 * std::cos(angle), 0.3 * std::sin(angle));
  }
  const Camera camera = cameraOn(grid, {0.3, -1, 0.2}, 900.0, Camera::Projection::perspective);
  const auto judge = [&](const char* what, const Cut& cut) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_GT(cutRegion(*volume, {}, {cut}).taken.front(), 0u);
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
    test::judgeMs(what, passed.count(), 300.0);
  };
  judge("scissors in 512×512×300", {Scissors{camera, 1.0, line, true, {}}, true});
  judge("a piece of half of 512×512×300",
        {ConnectedPiece{boxCentreMm(grid), {100.0, 400.0}, 1, ConnectedPiece::Fate::hidden}, true});
}

// Halves of a volume along x, labels 0 and 1.
Region halves(const glm::ivec3& dims) {
  std::vector<std::uint8_t> places;
  for (int n = 0; n < dims.x * dims.y * dims.z; ++n)
    places.push_back(n % dims.x < dims.x / 2 ? 0 : 1);
  const std::vector<Label> labels{{0, "left", glm::dvec3(1.0)}, {1, "right", glm::dvec3(1.0)}};
  return {Region::Kind::labels, "s", std::make_shared<const LabelMap>(dims, places, labels), {1.0, 0.5}};
}

TEST(Cutting, looksOfLabelsSurviveCutsAndTheirWayBack) {
  const Grid grid = obliqueGrid({12, 9, 7});
  const Volume volume(grid, std::vector<float>(12 * 9 * 7, 1.0f), Rescale{}, std::nullopt, VolumeInfo{});
  const TransferFunction look{2.0, {{0.0, glm::dvec3(1.0), 0.5}}};
  const Region before = withLooks(halves(grid.dims), {{1, look}});
  const Scissors scissors{
      cameraOn(grid, {0.0, -1.0, 0.2}, 200.0, Camera::Projection::orthographic), 1.0, star(0.4, 7), true, {}};
  const Region cut = cutRegion(volume, before, {{scissors, true}}).region;
  ASSERT_TRUE(cut.isCut);
  EXPECT_EQ(cut.looks, before.looks);
  EXPECT_EQ(lookOfLabel(cut, 0), 0u);
  EXPECT_EQ(lookOfLabel(cut, 1), 1u);
  EXPECT_EQ(lookOfLabel(cut, 2), 0u) << "what is cut away";
  EXPECT_EQ(cut.weights.back(), 0.0);
  EXPECT_EQ(withoutCuts(cut), before);
  // Looks that are given afterwards stay, too.
  Region later = cutRegion(volume, withLooks(before, {}), {{scissors, true}}).region;
  later = withLooks(later, {{1, look}});
  EXPECT_EQ(withoutCuts(later).looks, before.looks);
  EXPECT_EQ(lookOfLabel(withoutCuts(later), 1), 1u);
}

TEST(Cutting, whatFadesBesideAPieceKeepsItsLook) {
  const glm::ivec3 dims(12, 9, 7);
  const TransferFunction look{2.0, {{0.0, glm::dvec3(1.0), 0.5}}};
  const Region region = withLooks(halves(dims), {{1, look}});
  const BitGrid piece = setOf(dims, [](const glm::ivec3& at) { return at.y < 4; });
  const Region shown = lit(region, piece, 0.25);
  for (int n = 0; n < dims.x * dims.y * dims.z; ++n) {
    const std::size_t place = shown.labels->placeAt(static_cast<std::size_t>(n));
    const bool isLit = n / dims.x % dims.y < 4;
    const bool isRight = n % dims.x >= dims.x / 2;
    ASSERT_EQ(lookOfLabel(shown, place), isRight ? 1u : 0u);
    ASSERT_EQ(shown.weights[place], !isLit ? 0.25 : isRight ? 0.5 : 1.0);
  }
}

} // namespace
} // namespace limn
