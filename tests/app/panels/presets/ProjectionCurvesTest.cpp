// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/Panels.h"

#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

struct Shown {
  Scene scene;
  Histogram histogram;
  ProjectionCurves curves;

  explicit Shown(std::shared_ptr<const Volume> volume) {
    scene.volume = std::move(volume);
    scene.transferFunction.points = {{-200.0, glm::dvec3(1.0), 0.0}, {300.0, glm::dvec3(1.0), 0.6}};
    histogram = histogramOf(*scene.volume);
    curves.note(scene);
  }
  void change(Projection projection) {
    scene = curves.changed(scene, projection, histogram);
    curves.note(scene);
  }
};

TEST(ProjectionCurves, eachKindBringsItsOwnAndGivesTheOneBeforeBack) {
  Shown shown(phantomVolume({.spacingMm = 8.0}));
  const TransferFunction tissue = shown.scene.transferFunction;
  for (const Projection projection :
       {Projection::mip, Projection::minip, Projection::average, Projection::xray}) {
    shown.change(projection);
    EXPECT_NE(shown.scene.transferFunction, tissue);
    EXPECT_EQ(normalised(shown.scene.transferFunction), shown.scene.transferFunction) << "in order";
    shown.change(Projection::composite);
    EXPECT_EQ(shown.scene.transferFunction, tissue);
  }
}

TEST(ProjectionCurves, kindsThatShowTissueShareOne) {
  Shown shown(phantomVolume({.spacingMm = 8.0}));
  const TransferFunction tissue = shown.scene.transferFunction;
  shown.change(Projection::isosurface);
  EXPECT_EQ(shown.scene.transferFunction, tissue);
  shown.change(Projection::compositeIsosurface);
  EXPECT_EQ(shown.scene.transferFunction, tissue);
}

TEST(ProjectionCurves, aCurveThatWasEditedComesBackEdited) {
  Shown shown(phantomVolume({.spacingMm = 8.0}));
  shown.change(Projection::mip);
  shown.scene.transferFunction = shifted(shown.scene.transferFunction, 10.0);
  shown.curves.note(shown.scene);
  const TransferFunction edited = shown.scene.transferFunction;
  shown.change(Projection::composite);
  shown.change(Projection::mip);
  EXPECT_EQ(shown.scene.transferFunction, edited);
}

TEST(ProjectionCurves, inDataWithoutHounsfieldUnitsAreFittedToThem) {
  Grid grid;
  grid.dims = {10, 10, 10};
  std::vector<std::uint8_t> voxels(1000, 3);
  std::fill(voxels.begin() + 600, voxels.end(), std::uint8_t{180});
  Shown shown(std::make_shared<const Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{}));
  for (const Projection projection :
       {Projection::mip, Projection::minip, Projection::average, Projection::xray}) {
    shown.change(projection);
    const auto& points = shown.scene.transferFunction.points;
    EXPECT_GE(points.front().value, -100.0);
    EXPECT_LE(points.back().value, 400.0);
    EXPECT_GT(classify(shown.scene.transferFunction, 180.0).opacity, 0.0);
  }
}

std::shared_ptr<const Volume> airAnd(std::int16_t value) {
  Grid grid;
  grid.dims = {10, 10, 10};
  std::vector<std::int16_t> voxels(1000, -1000);
  std::fill(voxels.begin() + 600, voxels.end(), value);
  return std::make_shared<const Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{});
}

// As of a phantom without dense bone, whose values end far below where the preset is white.
TEST(ProjectionCurves, theMaximumIsWhiteAtTheBrightestVoxelAtTheLatest) {
  const double highest = 792.0;
  Shown shown(airAnd(792));
  shown.change(Projection::mip);
  EXPECT_EQ(classify(shown.scene.transferFunction, highest).color, glm::dvec3(1.0));
  EXPECT_EQ(shown.scene.transferFunction.points.front().value, -150.0) << "fat and air stay black";
}

TEST(ProjectionCurves, theMaximumOfDenseBoneAndMetalIsThatOfThePreset) {
  Shown shown(airAnd(3071));
  shown.change(Projection::mip);
  EXPECT_EQ(shown.scene.transferFunction.points.back().value, 2600.0);
}

TEST(ProjectionCurves, ofAnotherVolumeAreForgotten) {
  Shown shown(phantomVolume({.spacingMm = 8.0}));
  const TransferFunction tissue = shown.scene.transferFunction;
  shown.change(Projection::mip);
  shown.scene.volume = phantomVolume({.spacingMm = 9.0});
  shown.curves.note(shown.scene);
  shown.change(Projection::composite);
  EXPECT_NE(shown.scene.transferFunction, tissue);
  EXPECT_FALSE(shown.scene.transferFunction.points.empty());
}

} // namespace
} // namespace limn
