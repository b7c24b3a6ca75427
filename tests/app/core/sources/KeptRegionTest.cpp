// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/sources/KeptRegion.h"
#include "app/core/sources/SceneSource.h"
#include "scene/view/Camera.h"
#include "scene/volume/Phantom.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace limn {
namespace {

TEST(KeptRegion, ofAVolumeWithoutTissueIsEverythingWithASentence) {
  VolumeInfo info;
  info.unit = "HU";
  Grid grid;
  grid.dims = {4, 4, 4};
  const Volume air(grid, std::vector<std::int16_t>(64, -1000), {}, std::nullopt, info);
  const FoundRegion found = bodyOf(air);
  EXPECT_EQ(found.region, Region{});
  EXPECT_EQ(found.remark.english(),
            "No body was found in the volume (it holds no tissue), so everything is kept.");
  EXPECT_EQ(sureBodyOf(air), Region{});
}

TEST(KeptRegion, ofAHeadAloneIsItsBodyOnlyWhereAskedFor) {
  const auto phantom = phantomVolume({8.0, 0.0, 1});
  const FoundRegion asked = bodyOf(*phantom);
  EXPECT_EQ(asked.region.kind, Region::Kind::body);
  EXPECT_EQ(asked.remark.english(), "");
  EXPECT_EQ(sureBodyOf(*phantom), Region{}) << "there is no table to hide";
}

// Of lines that are opened again it is said only where something that was meant to go is still there.
TEST(KeptRegion, aLineThatLeavesAllIsNoReasonForAWordWhereItIsOpenedAgain) {
  const auto phantom = phantomVolume({16.0, 0.0, 1});
  const Camera camera = defaultCamera(phantom->grid());
  const std::vector<glm::dvec2> everything{{-9.0, -9.0}, {9.0, -9.0}, {9.0, 9.0}, {-9.0, 9.0}};
  const std::vector<glm::dvec2> left{{-9.0, -9.0}, {0.0, -9.0}, {0.0, 9.0}, {-9.0, 9.0}};
  const std::vector<glm::dvec2> corner{{8.0, 8.0}, {9.0, 8.0}, {9.0, 9.0}};
  const Cut half{Scissors{camera, 1.0, left, true, {}}};
  const Cut leaves{Scissors{camera, 1.0, everything, false, {}}};
  const Cut misses{Scissors{camera, 1.0, corner, true, {}}};
  for (const std::vector<Cut>& opened : {std::vector{leaves}, std::vector{half, leaves}})
    EXPECT_EQ(cutIn(*phantom, FoundRegion{}, opened, {}).remark.english(), "");
  EXPECT_EQ(cutIn(*phantom, Region{}, {half, misses}, {}).remark.english(),
            "Cut 2 takes nothing away: its line goes around nothing that is left.");
  const Region before = cutIn(*phantom, Region{}, {half}, {}).region;
  EXPECT_EQ(cutIn(*phantom, before, {half, leaves}, {}).remark.english(),
            "Cut 2 takes nothing away: its line goes around all that is left.")
      << "just drawn";
}

// A volume of 8 voxels, and a label map on its grid.
class LabelledScene : public testing::Test {
protected:
  LabelledScene() {
    write("v.nrrd", "0 10 20 30 40 50 60 70");
    write("seg.nrrd", "0 3 3 0 5 5 0 0");
  }

  void write(const std::string& name, const std::string& values) const {
    std::filesystem::create_directories((folder.path() / name).parent_path());
    std::ofstream(folder.path() / name)
        << "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: ascii\n\n"
        << values << "\n";
  }

  std::string scene(const std::string& name, const std::string& keep) const {
    std::filesystem::create_directories((folder.path() / name).parent_path());
    std::ofstream(folder.path() / name) << R"({"limn_scene": 1, "volume": "v.nrrd", "keep": )" << keep << "}";
    return (folder.path() / name).string();
  }

  // Files that are opened beside what is kept.
  FoundRegion opened(const Region& kept, const std::vector<const char*>& names, const Volume& volume) const {
    std::vector<std::filesystem::path> files;
    for (const char* name : names)
      files.push_back(folder.path() / name);
    return openedBeside(kept, readBeside(files, volume), volume);
  }

  static std::vector<std::string> namesIn(const Region& region) {
    std::vector<std::string> names;
    for (const Label& label : region.labels->labels())
      names.push_back(label.name);
    return names;
  }

  test::TemporaryFolder folder;
};

TEST_F(LabelledScene, weighsItsLabels) {
  const LoadedScene loaded =
      loadScene(scene("s.json", R"({"labels": "seg.nrrd", "weights": {"5": 0.25}})"), {}, {});
  const Region& keep = loaded.scene.keep;
  EXPECT_EQ(keep.kind, Region::Kind::labels);
  EXPECT_EQ(keep.source, (folder.path() / "seg.nrrd").string());
  EXPECT_EQ(keep.weights, (std::vector<double>{1.0, 1.0, 0.25}));
  EXPECT_EQ(weightAt(keep, {0, 0, 1}), 0.25);
  EXPECT_EQ(weightAt(keep, {1, 1, 1}), 1.0);
  // Written and read again, it is the same.
  std::ofstream(folder.path() / "again.json") << sceneToJson(loaded.scene, "v.nrrd");
  const Region again = loadScene((folder.path() / "again.json").string(), {}, {}).scene.keep;
  EXPECT_EQ(again.weights, keep.weights);
  EXPECT_EQ(again.source, keep.source);
}

TEST_F(LabelledScene, givesItsLabelsLooksAlsoWhereItIsCut) {
  const std::string look =
      R"({"points": [{"value": 20, "color": [1, 0, 0], "opacity": 0.5}], "unit_distance_mm": 2})";
  const std::string labels = R"({"labels": "seg.nrrd", "looks": {"3": )" + look + R"(, "5": )" + look + "}}";
  const TransferFunction expected{2.0, {{20.0, {1.0, 0.0, 0.0}, 0.5}}};
  const Region alone = loadScene(scene("s.json", labels), {}, {}).scene.keep;
  EXPECT_EQ(alone.looks, std::vector{expected}) << "equal looks are one";
  EXPECT_EQ(alone.lookOf, (std::vector<std::uint8_t>{0, 1, 1}));
  // A line around everything to the left of the middle.
  const std::string cut =
      R"({"scissors": {"camera": {"projection": "orthographic", "position": [0.5, -9, 0.5],
      "target": [0.5, 0.5, 0.5], "height_mm": 4}, "polygon": [[-1, -1], [0, -1], [0, 1], [-1, 1]]}})";
  const LoadedScene loaded = loadScene(scene("cut.json", "[" + labels + ", " + cut + "]"), {}, {});
  const Region& keep = loaded.scene.keep;
  ASSERT_TRUE(keep.isCut);
  EXPECT_EQ(keep.looks, alone.looks);
  EXPECT_EQ(lookOfLabel(keep, 3), 0u) << "what is cut away";
  std::ofstream(folder.path() / "again.json") << sceneToJson(loaded.scene, "v.nrrd");
  const Region again = loadScene((folder.path() / "again.json").string(), {}, {}).scene.keep;
  EXPECT_EQ(again.looks, keep.looks);
  EXPECT_EQ(lookOfLabel(again, 1), 1u);
  EXPECT_EQ(again.cuts, keep.cuts);
}

TEST_F(LabelledScene, findsALabelMapThatLiesBesideTheVolume) {
  const std::string path = scene("moved/s.json", R"({"labels": "seg.nrrd"})");
  SourceOptions options;
  options.volume = folder.path() / "v.nrrd";
  EXPECT_EQ(loadScene(path, options, {}).scene.keep.source, (folder.path() / "seg.nrrd").string());
}

TEST_F(LabelledScene, aMaskComesToTheMasksThatAreOpenAndOtherLabelsReplaceThem) {
  write("a.nrrd", "0 7 7 0 0 0 0 0");
  write("b.nrrd", "0 0 1 0 0 0 1 1");
  const TransferFunction look{2.0, {{20.0, {1.0, 0.0, 0.0}, 0.5}}};
  LoadedScene loaded = loadScene(scene("s.json", R"({"labels": "a.nrrd", "weights": {"7": 0.5}})"), {}, {});
  Region& keep = loaded.scene.keep;
  keep = withLooks(keep, {{1, look}});
  const FoundRegion both = opened(keep, {"b.nrrd"}, *loaded.scene.volume);
  EXPECT_EQ(both.remark.english(),
            "1 voxel lies in two masks and belongs to the one that was opened last: to "
            "b and not to a.");
  EXPECT_EQ(sourcesOf(both.region), (std::vector<std::string>{(folder.path() / "a.nrrd").string(),
                                                              (folder.path() / "b.nrrd").string()}));
  EXPECT_EQ(both.region.weights, (std::vector<double>{1.0, 0.5, 1.0})) << "as they were shown";
  EXPECT_EQ(lookOfLabel(both.region, 1), 1u);
  EXPECT_EQ(lookOfLabel(both.region, 2), 0u);
  EXPECT_EQ(both.region.labels->placeAt(1), 1u);
  EXPECT_EQ(both.region.labels->placeAt(2), 2u);
  EXPECT_FALSE(replacesLabels(both.region, keep));
  // Once more it is the same; what is no mask takes the place of all.
  EXPECT_EQ(sourcesOf(opened(both.region, {"b.nrrd"}, *loaded.scene.volume).region), sourcesOf(both.region));
  const FoundRegion together = opened(keep, {"a.nrrd", "b.nrrd", "v.nrrd"}, *loaded.scene.volume);
  EXPECT_EQ(together.region.weights, both.region.weights)
      << "what was open is shown as it was, chosen again or not";
  EXPECT_EQ(together.region.looks, both.region.looks);
  EXPECT_EQ(together.remark.english(), "v.nrrd is no mask and was left out. " + both.remark.english());
  const Region alone = opened(keep, {"a.nrrd"}, *loaded.scene.volume).region;
  EXPECT_EQ(alone.weights, keep.weights);
  EXPECT_EQ(alone.looks, keep.looks);
  const Region seg = opened(both.region, {"seg.nrrd"}, *loaded.scene.volume).region;
  EXPECT_EQ(seg.weights.size(), 3u);
  EXPECT_EQ(sourcesOf(seg), std::vector<std::string>{(folder.path() / "seg.nrrd").string()});
  EXPECT_TRUE(replacesLabels(seg, both.region));
  // Written and read again, both are there.
  keep = both.region;
  std::ofstream(folder.path() / "again.json") << sceneToJson(loaded.scene, "v.nrrd");
  const Region again = loadScene((folder.path() / "again.json").string(), {}, {}).scene.keep;
  EXPECT_EQ(sourcesOf(again), sourcesOf(keep));
  EXPECT_EQ(again.weights, keep.weights);
  EXPECT_EQ(again.looks, keep.looks);
}

TEST_F(LabelledScene, aMaskComesToOpenOnesWhoseFilesHaveGone) {
  write("a.nrrd", "0 7 7 0 0 0 0 0");
  write("b.nrrd", "0 0 0 0 0 0 1 1");
  write("c.nrrd", "1 1 0 0 0 0 0 0");
  const LoadedScene loaded =
      loadScene(scene("s.json", R"({"labels": "a.nrrd", "weights": {"7": 0.5}})"), {}, {});
  const Volume& volume = *loaded.scene.volume;
  const Region two = opened(loaded.scene.keep, {"b.nrrd"}, volume).region;
  std::filesystem::remove(folder.path() / "a.nrrd");
  std::filesystem::remove(folder.path() / "b.nrrd");
  const FoundRegion three = opened(two, {"c.nrrd"}, volume);
  EXPECT_EQ(namesIn(three.region), (std::vector<std::string>{"Background", "a", "b", "c"}));
  EXPECT_EQ(three.region.weights, (std::vector<double>{1.0, 0.5, 1.0, 1.0}));
  const std::vector<std::size_t> places{3, 3, 1, 0, 0, 0, 2, 2};
  for (std::size_t voxel = 0; voxel < places.size(); ++voxel)
    EXPECT_EQ(three.region.labels->placeAt(voxel), places[voxel]) << voxel;
  EXPECT_EQ(three.remark.english(),
            "1 voxel lies in two masks and belongs to the one that was opened last: to "
            "c and not to a.");
}

// What comes last has the voxels: a mask that is opened once more has them again, and as its file is now.
TEST_F(LabelledScene, aMaskThatIsOpenedOnceMoreBecomesTheLast) {
  write("a.nrrd", "0 7 7 0 0 0 0 0");
  write("b.nrrd", "0 0 1 0 0 0 1 1");
  LoadedScene loaded = loadScene(scene("s.json", R"({"labels": "a.nrrd", "weights": {"7": 0.5}})"), {}, {});
  const Volume& volume = *loaded.scene.volume;
  const Region both = opened(loaded.scene.keep, {"b.nrrd"}, volume).region;
  write("a.nrrd", "0 0 7 7 0 0 0 0");
  const Region again = opened(both, {"a.nrrd"}, volume).region;
  EXPECT_EQ(namesIn(again), (std::vector<std::string>{"Background", "b", "a"}));
  EXPECT_EQ(again.weights, (std::vector<double>{1.0, 1.0, 0.5}));
  const std::vector<std::size_t> places{0, 0, 2, 2, 0, 0, 1, 1};
  for (std::size_t voxel = 0; voxel < places.size(); ++voxel)
    EXPECT_EQ(again.labels->placeAt(voxel), places[voxel]) << voxel;
  // As its files are read.
  loaded.scene.keep = again;
  std::ofstream(folder.path() / "again.json") << sceneToJson(loaded.scene, "v.nrrd");
  const Region read = loadScene((folder.path() / "again.json").string(), {}, {}).scene.keep;
  EXPECT_EQ(read.labels->labels(), again.labels->labels());
  EXPECT_EQ(read.weights, again.weights);
  for (std::size_t voxel = 0; voxel < places.size(); ++voxel)
    EXPECT_EQ(read.labels->placeAt(voxel), places[voxel]) << voxel;
}

// The others are not read again, so that what it took from them does not come back by itself.
TEST_F(LabelledScene, aMaskThatIsSmallerThanBeforeTellsWhatItLeavesToNobody) {
  write("a.nrrd", "0 7 7 0 0 0 0 0");
  write("b.nrrd", "0 0 1 0 0 0 1 1");
  const LoadedScene loaded = loadScene(scene("s.json", R"({"labels": "a.nrrd"})"), {}, {});
  const Volume& volume = *loaded.scene.volume;
  const Region both = opened(loaded.scene.keep, {"b.nrrd"}, volume).region;
  EXPECT_EQ(opened(both, {"b.nrrd"}, volume).remark.english(), "") << "as it was";
  write("b.nrrd", "0 0 0 0 0 0 1 1");
  const FoundRegion smaller = opened(both, {"b.nrrd"}, volume);
  EXPECT_EQ(smaller.region.labels->placeAt(2), 0u);
  EXPECT_EQ(smaller.remark.english(),
            "1 voxel that b had before belongs to no mask now; open a mask that has "
            "it, too, once more.");
  EXPECT_EQ(opened(smaller.region, {"a.nrrd"}, volume).region.labels->placeAt(2), 2u) << "which helps";
}

// Of a large mask looking for that takes as long as placing it.
TEST_F(LabelledScene, lookingForWhatAMaskLeavesToNobodyIsCancelledToo) {
  write("a.nrrd", "0 7 7 0 0 0 0 0");
  write("b.nrrd", "0 0 1 0 0 0 1 1");
  const LoadedScene loaded = loadScene(scene("s.json", R"({"labels": "a.nrrd"})"), {}, {});
  const Volume& volume = *loaded.scene.volume;
  const Region both = opened(loaded.scene.keep, {"b.nrrd"}, volume).region;
  const Segmentation again = readBeside({folder.path() / "b.nrrd"}, volume);
  constexpr double allArePlaced = 0.8;
  double done = 0.0;
  Progress progress;
  progress.report = [&done](double fraction, const Message&) {
    EXPECT_GE(fraction, done);
    done = fraction;
  };
  progress.isCancelled = [&done] { return done > allArePlaced + 0.01; };
  EXPECT_THROW(openedBeside(both, again, volume, progress), Cancelled);
  EXPECT_LT(done, 1.0);
}

// A segment of 3D Slicer keeps its name and colour among others, and when a scene reads it again.
TEST_F(LabelledScene, aSegmentThatItsFileDescribesKeepsItsNameAmongMasks) {
  std::ofstream(folder.path() / "a.seg.nrrd")
      << "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: ascii\n"
         "Segment0_ID:=Segment_1\nSegment0_Name:=Left kidney\nSegment0_LabelValue:=4\n"
         "Segment0_Color:=0.25 0.5 1\n\n0 4 4 0 0 0 0 0\n";
  write("b.nrrd", "0 0 0 0 0 0 1 1");
  const Label kidney{1, "Left kidney", {0.25, 0.5, 1.0}};
  LoadedScene loaded = loadScene(scene("s.json", R"({"labels": "a.seg.nrrd"})"), {}, {});
  const Region joined = opened(loaded.scene.keep, {"b.nrrd"}, *loaded.scene.volume).region;
  EXPECT_EQ(joined.labels->labels()[1], kidney);
  EXPECT_EQ(joined.labels->labels()[2].name, "b");
  loaded.scene.keep = joined;
  std::ofstream(folder.path() / "again.json") << sceneToJson(loaded.scene, "v.nrrd");
  const Region again = loadScene((folder.path() / "again.json").string(), {}, {}).scene.keep;
  EXPECT_EQ(again.labels->labels(), joined.labels->labels());
}

// What a file calls its segment may be what another file is called.
TEST_F(LabelledScene, noTwoMasksHaveOneName) {
  std::filesystem::create_directories(folder.path() / "x");
  std::ofstream(folder.path() / "a.seg.nrrd")
      << "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: ascii\n"
         "Segment0_ID:=Segment_1\nSegment0_Name:=kidney\nSegment0_LabelValue:=4\n\n0 4 4 0 0 0 0 0\n";
  write("x/kidney.nrrd", "0 0 0 0 0 0 1 1");
  LoadedScene loaded = loadScene(scene("s.json", R"({"labels": "a.seg.nrrd"})"), {}, {});
  const Region joined = opened(loaded.scene.keep, {"x/kidney.nrrd"}, *loaded.scene.volume).region;
  EXPECT_EQ(namesIn(joined), (std::vector<std::string>{"Background", "kidney", "kidney (x)"}));
  EXPECT_EQ(namesIn(opened({}, {"a.seg.nrrd", "x/kidney.nrrd"}, *loaded.scene.volume).region),
            namesIn(joined));
  EXPECT_EQ(namesIn(opened(joined, {"a.seg.nrrd"}, *loaded.scene.volume).region),
            (std::vector<std::string>{"Background", "kidney", "a"}))
      << "opened once more it comes last";
}

TEST_F(LabelledScene, masksOfOneFileNameAreToldApartByTheirFolders) {
  write("left/mask.nrrd", "0 7 7 0 0 0 0 0");
  write("right/mask.nrrd", "0 0 0 0 0 0 1 1");
  LoadedScene loaded = loadScene(scene("s.json", R"({"labels": "left/mask.nrrd"})"), {}, {});
  const Region both = opened(loaded.scene.keep, {"right/mask.nrrd"}, *loaded.scene.volume).region;
  EXPECT_EQ(namesIn(both), (std::vector<std::string>{"Background", "mask (left)", "mask (right)"}));
  EXPECT_EQ(namesIn(opened({}, {"left/mask.nrrd", "right/mask.nrrd"}, *loaded.scene.volume).region),
            namesIn(both));
  write("left/liver.nrrd", "0 7 7 0 0 0 0 0");
  write("right/liver.nrrd", "0 0 0 0 0 0 1 1");
  EXPECT_EQ(namesIn(opened({}, {"left/liver.nrrd", "right/liver.nrrd"}, *loaded.scene.volume).region),
            (std::vector<std::string>{"Background", "liver (left)", "liver (right)"}));
}

TEST_F(LabelledScene, isRefusedInASentenceWithoutItsLabelMapOrLabel) {
  for (const auto& [keep, named] : std::map<std::string, std::string>{
           {R"({"labels": "gone.nrrd"})", "gone.nrrd); put them there or beside the volume"},
           {R"({"labels": "seg.nrrd", "looks": {"4": {"points": []}}})",
            "look to label 4, which seg.nrrd does not have"},
           {R"({"labels": "seg.nrrd", "weights": {"4": 0}})", "label 4, which seg.nrrd does not have"}})
    try {
      (void)loadScene(scene("s.json", keep), {}, {});
      ADD_FAILURE() << keep;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace limn
