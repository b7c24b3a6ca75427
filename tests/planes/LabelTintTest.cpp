// SPDX-License-Identifier: GPL-3.0-or-later
// Slices tinted by the looks of labels, against shares and extinctions added up by hand.
#include "PlaneVolumes.h"

#include "planes/PlanePixels.h"
#include "scene/basics/StableMath.h"
#include "scene/function/PointShare.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

// As opaque over 10 mm as `share` says, whatever the value.
TransferFunction evenly(const glm::dvec3& color, double share, double unitDistanceMm = 1.0) {
  const double opacity = 1.0 - std::pow(1.0 - share, unitDistanceMm / tintPathMm);
  return {unitDistanceMm, {{-1000.0, color, opacity}, {1000.0, color, opacity}}};
}

// Eight voxels in a row, 2 mm each: two of each label, the last of which is hidden.
class LabelTint : public testing::Test {
protected:
  LabelTint() {
    grid = test::plainGrid({8, 3, 3}, glm::dvec3(2.0));
    std::vector<std::uint8_t> places;
    for (int voxel = 0; voxel < 72; ++voxel)
      places.push_back(static_cast<std::uint8_t>(voxel % 8 / 2));
    scene.volume = std::make_shared<const Volume>(test::noiseOf(grid));
    scene.transferFunction = evenly({1.0, 1.0, 1.0}, 0.5);
    Region region{Region::Kind::labels,
                  "seg",
                  std::make_shared<const LabelMap>(
                      grid.dims, places,
                      std::vector<Label>{{0, "Background", {}}, {1, "a", {}}, {2, "b", {}}, {3, "c", {}}}),
                  {1.0, 1.0, 0.5, 0.0}};
    scene.keep = withLooks(
        region, {{1, evenly({1, 0, 0}, 0.6)}, {2, evenly({0, 1, 0}, 0.4, 3.0)}, {3, evenly({0, 0, 1}, 0.6)}});
    looks = labelLooks(scene);
    plane = test::coveringPlane(grid, PatientPlane::axial, {0.0, 0.0, 2.0});
  }

  // A plane four times as fine.
  PlaneGrid fine() const {
    PlaneGrid other = plane;
    other.spacingMm /= 4.0;
    other.size *= 4;
    return other;
  }

  std::vector<std::uint32_t> tinted(const PlaneGrid& on, PlaneInterpolation interpolation,
                                    std::optional<std::size_t> point = std::nullopt) const {
    const PlaneImage image = reformatted(*scene.volume, on, {interpolation, {}});
    const PlaneLooks onPlane{looks, sharesOn(scene.keep, looks, grid, on, interpolation)};
    return planePixels(image, black, PlaneTint{scene.transferFunction, nullptr, point, &onPlane});
  }

  static glm::dvec3 colorOf(std::uint32_t pixel) {
    return {pixel >> 16 & 255, pixel >> 8 & 255, pixel & 255};
  }

  Grid grid;
  Scene scene;
  LabelLooks looks;
  PlaneGrid plane;
  const GreyWindow black{1e6, 1.0};
};

TEST_F(LabelTint, sharesAreThoseOfTheDefinitionAtThePixelsPlace) {
  const PlaneGrid on = fine();
  const PlaneShares shares = sharesOn(scene.keep, looks, grid, on, PlaneInterpolation::linear);
  const PlaneImage image = reformatted(*scene.volume, on, {});
  int several = 0;
  for (int y = 0; y < on.size.y; ++y)
    for (int x = 0; x < on.size.x; ++x) {
      const std::span<const LookShare> found = shares.at(x, y);
      ASSERT_EQ(found.empty(), std::isnan(image.at(x, y))) << x << ' ' << y;
      if (found.empty())
        continue;
      const LookShares wanted = lookSharesAt(looks, scene.keep, worldToIndex(grid, pixelToWorld(on, {x, y})));
      ASSERT_EQ(found.size(), wanted.count) << x << ' ' << y;
      several += found.size() > 1 ? 1 : 0;
      for (std::size_t n = 0; n < found.size(); ++n) {
        EXPECT_EQ(found[n].look, wanted.all[n].look);
        // The pixel's place is found another way, over some ten roundings of numbers below 100.
        EXPECT_NEAR(found[n].share, wanted.all[n].share, 1e-12);
        EXPECT_NEAR(found[n].weight, wanted.all[n].weight, 1e-12);
      }
    }
  EXPECT_GT(several, 10);
}

TEST_F(LabelTint, nearestVoxelsHaveTheirOwnLookAndHiddenOnesNone) {
  const std::vector<std::uint32_t> pixels = tinted(plane, PlaneInterpolation::nearest);
  ASSERT_EQ(plane.size, glm::ivec2(8, 3));
  // A centimetre of each, on black: 0.5 white, 0.6 red, half of 0.4 green, nothing.
  const glm::dvec3 wanted[] = {{127.5, 127.5, 127.5}, {153, 0, 0}, {0, 51, 0}, {0, 0, 0}};
  for (int x = 0; x < 8; ++x)
    for (int channel = 0; channel < 3; ++channel) // half a level of rounding, and half a level for 127.5
      EXPECT_NEAR(colorOf(pixels[static_cast<std::size_t>(8 + x)])[channel], wanted[x / 2][channel], 1.0)
          << x;
}

TEST_F(LabelTint, betweenLabelsMixesExtinctionsByShares) {
  const PlaneGrid on = fine();
  const std::vector<std::uint32_t> pixels = tinted(on, PlaneInterpolation::linear);
  const glm::dvec3 colors[] = {{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const double covers[] = {0.5, 0.6, 0.5 * 0.4, 0.0};
  int compared = 0;
  for (int x = 0; x < on.size.x; ++x) {
    const double index = worldToIndex(grid, pixelToWorld(on, {x, on.size.y / 2})).x;
    const double place = std::clamp(index, 0.0, 7.0);
    const int low = std::min(static_cast<int>(place), 6);
    double extinction = 0.0;
    glm::dvec3 color(0.0);
    for (const int voxel : {low, low + 1}) {
      const double share = 1.0 - std::abs(place - voxel);
      const double own = -share * std::log(1.0 - covers[voxel / 2]);
      extinction += own;
      color += own * colors[voxel / 2];
    }
    if (extinction > 0.0)
      color /= extinction;
    const glm::dvec3 wanted = 255.0 * std::min(1.0 - std::exp(-extinction), strongestTint) * color;
    const std::size_t pixel = static_cast<std::size_t>(on.size.y / 2) * on.size.x + x;
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(colorOf(pixels[pixel])[channel], wanted[channel], 1.0) << x;
    ++compared;
  }
  EXPECT_EQ(compared, 32);
}

TEST_F(LabelTint, looksThatAreTheScenesTintAsTheScenesAlone) {
  const PlaneGrid on = fine();
  const PlaneImage image = reformatted(*scene.volume, on, {});
  const PlaneImage weights = weightsOn(scene.keep, grid, on, PlaneInterpolation::linear);
  LabelLooks alike;
  alike.functions = {scene.transferFunction, evenly({1, 0, 0}, 0.6)};
  alike.ofLabel = {0, 0, 0, 0};
  const PlaneLooks onPlane{alike, sharesOn(scene.keep, alike, grid, on, PlaneInterpolation::linear)};
  const auto alone = planePixels(image, black, PlaneTint{scene.transferFunction, &weights});
  const auto byLooks =
      planePixels(image, black, PlaneTint{scene.transferFunction, &weights, std::nullopt, &onPlane});
  for (std::size_t i = 0; i < alone.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) // a level where rounding decides
      ASSERT_NEAR(colorOf(alone[i])[channel], colorOf(byLooks[i])[channel], 1.0) << i;
}

TEST_F(LabelTint, aPointOfTheScenesCurveLightsUpOnlyWhatIsShownByIt) {
  const std::vector<std::uint32_t> pixels = tinted(plane, PlaneInterpolation::nearest, 0);
  bool isLit = false;
  for (int x = 0; x < 8; ++x) {
    const glm::dvec3 color = colorOf(pixels[static_cast<std::size_t>(8 + x)]);
    if (x < 2)
      isLit = isLit || color != glm::dvec3(0.0);
    else
      EXPECT_EQ(color, glm::dvec3(0.0)) << x;
  }
  EXPECT_TRUE(isLit);
}

TEST_F(LabelTint, aPointOfALabelsCurveLightsUpInThatLabelAlone) {
  const PlaneImage image = reformatted(*scene.volume, plane, {PlaneInterpolation::nearest, {}});
  const PlaneLooks onPlane{looks, sharesOn(scene.keep, looks, grid, plane, PlaneInterpolation::nearest)};
  const std::vector<std::uint32_t> pixels =
      planePixels(image, black, PlaneTint{scene.transferFunction, nullptr, 0, &onPlane, looks.ofLabel[1]});
  bool isLit = false;
  for (int x = 0; x < 8; ++x) {
    const glm::dvec3 color = colorOf(pixels[static_cast<std::size_t>(8 + x)]);
    if (x / 2 == 1)
      isLit = isLit || color != glm::dvec3(0.0);
    else
      EXPECT_EQ(color, glm::dvec3(0.0)) << x;
  }
  EXPECT_TRUE(isLit);
}

TEST_F(LabelTint, isCancelled) {
  EXPECT_THROW((void)sharesOn(scene.keep, looks, grid, fine(), PlaneInterpolation::linear,
                              {0, [] { return true; }, {}}),
               Cancelled);
}

} // namespace
} // namespace limn
