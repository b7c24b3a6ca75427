// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/Looks.h"

#include "io/labels/LabelReader.h"
#include "regions/Cutting.h"

#include <cmath>
#include <fstream>
#include <map>
#include <set>

// What is kept and cut away, written as a segmentation and read again by the program's own reader, which
// knows nothing of the writer.

namespace limn {
namespace {

class WrittenSegmentation : public testing::Test {
protected:
  // An oblique grid, longer than wide, off the origin.
  static Grid obliqueGrid() {
    Grid grid;
    grid.dims = {13, 10, 7};
    grid.spacingMm = {0.7, 1.1, 2.5};
    grid.originMm = {-20.25, 12.0 / 7.0, 1234.5678901234};
    const double c = std::cos(0.4), s = std::sin(0.4);
    grid.direction =
        glm::dmat3(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0) * glm::dmat3(1.0, 0.0, 0.0, 0.0, c, s, 0.0, -s, c);
    return grid;
  }

  static Scene sceneOf(const Region& keep) {
    Scene scene = test::phantomScene();
    scene.volume = std::make_shared<const Volume>(obliqueGrid(), std::vector<float>(13 * 10 * 7, 1.0f),
                                                  Rescale{}, std::nullopt, VolumeInfo{});
    scene.keep = keep;
    return scene;
  }

  // Slabs along x: of two voxels each, in turn.
  static Region slabs(std::vector<Label> labels) {
    std::vector<std::uint8_t> places(13 * 10 * 7);
    for (std::size_t n = 0; n < places.size(); ++n)
      places[n] = static_cast<std::uint8_t>(n % 13 / 2 % labels.size());
    const std::vector<double> weights(labels.size(), 1.0);
    return {Region::Kind::labels, "s",
            std::make_shared<const LabelMap>(glm::ivec3(13, 10, 7), std::move(places), std::move(labels)),
            weights};
  }

  Region readBack(const std::string& segments, const Grid& grid) {
    std::ofstream(folder.path() / "segments.dcm", std::ios::binary) << segments;
    return readLabels(folder.path() / "segments.dcm", grid);
  }

  // For each voxel the name of its label; what no segment has is "".
  static std::vector<std::string> namesOf(const Region& region) {
    std::vector<std::string> names;
    for (std::size_t n = 0; n < 13 * 10 * 7; ++n) {
      const Label& label = region.labels->labels()[region.labels->placeAt(n)];
      names.push_back(label.value == 0 ? "" : label.name);
    }
    return names;
  }

  test::TemporaryFolder folder;
};

TEST_F(WrittenSegmentation, isReadBackVoxelByVoxelWithNamesAndColours) {
  const Region keep = slabs({{0, "background", {}},
                             {7, "Niere, rechts: gro\xC3\x9F", {1.0, 0.0, 0.0}},
                             {300, "bone", {0.2, 0.9, 0.6}}});
  const Scene scene = sceneOf(keep);
  const Region read = readBack(test::objectsOf(scene).segments, scene.volume->grid());
  EXPECT_EQ(namesOf(read), namesOf(keep));
  ASSERT_EQ(read.labels->labels().size(), 3u);
  for (std::size_t place = 1; place < 3; ++place)
    for (int channel = 0; channel < 3; ++channel)
      // Of CIELab in 16 bits no more is lost than eight bits show.
      EXPECT_NEAR(read.labels->labels()[place].color[channel], keep.labels->labels()[place].color[channel],
                  0.5 / 255.0);
}

TEST_F(WrittenSegmentation, hasWhatIsLeftOfTheCutsThePiecesAndWhatWent) {
  const Scene whole = sceneOf({});
  const glm::dvec3 seed = indexToWorld(whole.volume->grid(), {6.0, 5.0, 3.0});
  Scissors scissors;
  scissors.camera.projection = Camera::Projection::orthographic;
  scissors.camera.target = seed;
  scissors.camera.position = seed - 100.0 * whole.volume->grid().direction[2];
  scissors.camera.up = whole.volume->grid().direction[1];
  scissors.camera.heightMm = 40.0;
  scissors.polygon = {{-0.1, -0.1}, {0.2, -0.1}, {0.2, 0.1}, {-0.1, 0.1}};
  const ConnectedPiece piece{
      seed, {0.0, 2.0}, 0, ConnectedPiece::Fate::ownLook, {1.0, {{0.0, {1, 0, 0}, 0.5}}}};
  const CutRegion cut = cutRegion(*whole.volume, {}, {{scissors, true}, {piece, true}});
  ASSERT_GT(cut.taken[0], 0u);
  const Scene scene = sceneOf(cut.region);
  const Region read = readBack(test::objectsOf(scene).segments, scene.volume->grid());
  std::map<std::string, std::size_t> voxels;
  for (const std::string& name : namesOf(read))
    ++voxels[name];
  EXPECT_EQ(voxels["Cut away"], cut.taken[0]);
  EXPECT_EQ(voxels["Piece 1, 0 to 2"], cut.taken[1]);
  EXPECT_EQ(voxels["Kept"] + voxels["Cut away"] + voxels["Piece 1, 0 to 2"], 13u * 10 * 7);
  EXPECT_FALSE(hasSegments(whole));
  EXPECT_TRUE(test::objectsOf(whole).segments.empty());
}

// Those who read it know no cuts: what a person called them says more than a number, a range more than
// nothing.
TEST_F(WrittenSegmentation, callsItsSegmentsAsCutsWereCalledOrByTheirRanges) {
  const Scene whole = sceneOf({});
  const Grid& grid = whole.volume->grid();
  const auto slab = [&](double left, double right, const std::string& name) {
    Scissors scissors;
    scissors.camera.projection = Camera::Projection::orthographic;
    scissors.camera.target = indexToWorld(grid, {6.0, 5.0, 3.0});
    scissors.camera.position = scissors.camera.target - 100.0 * grid.direction[2];
    scissors.camera.up = grid.direction[1];
    scissors.camera.heightMm = 40.0;
    scissors.polygon = {{left, -1.0}, {right, -1.0}, {right, 1.0}, {left, 1.0}};
    return Cut{scissors, true, name};
  };
  const auto piece = [&](double i, ConnectedPiece::Fate fate, const std::string& name) {
    return Cut{ConnectedPiece{
                   indexToWorld(grid, {i, 5.0, 3.0}), {0.5, 1500.0}, 0, fate, {1.0, {{0.0, {1, 0, 0}, 0.5}}}},
               true, name};
  };
  using Fate = ConnectedPiece::Fate;
  const auto namesAfter = [&](const std::vector<Cut>& cuts, const std::string& unit) {
    Scene scene = sceneOf(cutRegion(*whole.volume, {}, cuts).region);
    VolumeInfo info;
    info.unit = unit;
    scene.volume = std::make_shared<const Volume>(grid, std::vector<float>(13 * 10 * 7, 1.0f), Rescale{},
                                                  std::nullopt, info);
    std::set<std::string> names;
    for (const std::string& name : namesOf(readBack(test::objectsOf(scene).segments, grid)))
      names.insert(name);
    return names;
  };
  using Names = std::set<std::string>;
  EXPECT_EQ(namesAfter({slab(-0.1, 0.1, "Jaw"), piece(0.0, Fate::ownLook, "Left ear")}, "HU"),
            (Names{"Cut away: Jaw", "Kept", "Left ear"}));
  EXPECT_EQ(namesAfter({slab(-0.1, 0.1, "Kiefer"), slab(0.2, 0.25, ""), piece(0.0, Fate::hidden, "")}, "HU"),
            (Names{"Cut away: Kiefer; piece 0.5 to 1500 HU; 1 line", "Kept"}));
  EXPECT_EQ(namesAfter({slab(-0.1, 0.1, ""), piece(0.0, Fate::alone, "")}, ""),
            (Names{"Cut away: all but piece 0.5 to 1500; 1 line", "Kept: piece 0.5 to 1500"}));
  EXPECT_EQ(namesAfter({slab(-0.1, 0.1, ""), piece(0.0, Fate::alone, "Heart")}, "HU"),
            (Names{"Cut away: all but Heart; 1 line", "Heart"}));
  // A piece whose seed was cut away before found nothing.
  EXPECT_EQ(namesAfter({slab(-0.1, 0.1, "Jaw"), piece(6.0, Fate::alone, "Heart")}, "HU"),
            (Names{"Cut away: Jaw", "Kept"}));
}

TEST_F(WrittenSegmentation, namesThePatientUnlessThatIsLeftOut) {
  const Scene scene = sceneOf(slabs({{0, "", {}}, {1, "one", {}}}));
  // In UTF-8, whatever the images are written in.
  EXPECT_NE(test::objectsOf(scene).segments.find("B\xC3\xA4r^Anna"), std::string::npos);
  const std::string nobodys = test::objectsOf(scene, true).segments;
  EXPECT_EQ(nobodys.find("Anna"), std::string::npos);
  EXPECT_EQ(namesOf(readBack(nobodys, scene.volume->grid())), namesOf(scene.keep));
}

} // namespace
} // namespace limn
