// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/labels/LabelReader.h"

#include "io/VolumeReader.h"
#include "scene/basics/Error.h"
#include "support/TemporaryFolder.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <fstream>

namespace limn {
namespace {

// How many voxels have each label, by value.
std::map<int, std::size_t> countsIn(const LabelMap& map) {
  std::map<int, std::size_t> counts;
  std::size_t voxel = 0;
  for (int n = 0; n < map.dims().x * map.dims().y * map.dims().z; ++n)
    ++counts[map.labels()[map.placeAt(voxel++)].value];
  return counts;
}

std::size_t countOf(const Volume& volume, double value) {
  std::size_t count = 0;
  visitVoxels(volume, [&](const auto& stored) {
    for (const auto voxel : stored)
      count += static_cast<double>(voxel) == value ? 1 : 0;
  });
  return count;
}

Grid cube(int size) {
  Grid grid;
  grid.dims = glm::ivec3(size);
  return grid;
}

class LabelReader : public testing::Test {
protected:
  std::filesystem::path file(const std::string& name, const std::string& content) const {
    std::ofstream(folder.path() / name, std::ios::binary) << content;
    return folder.path() / name;
  }

  std::string refusalOf(const std::filesystem::path& path, const Grid& grid) const {
    try {
      (void)readLabels(path, grid);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  }

  test::TemporaryFolder folder;
};

const std::string nrrdStart =
    "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\n"
    "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n"
    "encoding: ascii\n";

TEST_F(LabelReader, takesNamesAndColoursOfSlicersSegmentations) {
  const auto path =
      file("slicer.seg.nrrd",
           nrrdStart + "Segment0_ID:=Segment_1\nSegment0_Name:=Left kidney\nSegment0_LabelValue:=3\n"
                       "Segment0_Color:=0.5 0.25 1\nSegment1_ID:=Segment_2\nSegment1_Name:=Bone: all\n"
                       "Segment1_LabelValue:=5\nSegment1_Color:=2 x\n\n0 3 3 5 5 5 9 0\n");
  const Region region = readLabels(path, cube(2));
  EXPECT_EQ(region.kind, Region::Kind::labels);
  EXPECT_EQ(region.source, path.string());
  EXPECT_EQ(region.weights, std::vector<double>(4, 1.0));
  const auto& labels = region.labels->labels();
  ASSERT_EQ(labels.size(), 4u);
  EXPECT_EQ(labels[1], (Label{3, "Left kidney", {0.5, 0.25, 1.0}}));
  EXPECT_EQ(labels[2].name, "Bone: all");
  EXPECT_EQ(labels[3].name, "Label 9");
  EXPECT_EQ(countsIn(*region.labels), (std::map<int, std::size_t>{{0, 2}, {3, 2}, {5, 3}, {9, 1}}));
}

TEST_F(LabelReader, theOnlyLabelOfAFileThatNamesNoneIsCalledAfterTheFile) {
  const auto nameIn = [&](const char* name, const std::string& keys, const char* voxels) {
    return readLabels(file(name, nrrdStart + keys + voxels), cube(2)).labels->labels()[1].name;
  };
  const char* const one = "\n0 3 3 0 0 0 3 0\n";
  EXPECT_EQ(nameIn("label_Brain.nrrd", "", one), "Brain");
  EXPECT_EQ(nameIn("vessels_of_head.seg.nrrd", "", one), "vessels of head");
  EXPECT_EQ(nameIn("segmentation.nrrd", "", one), "Label 3") << "which tells nothing";
  EXPECT_EQ(nameIn("label_7.nrrd", "", one), "Label 3");
  EXPECT_EQ(nameIn("organs.nrrd", "", "\n0 3 3 0 0 0 5 0\n"), "Label 3") << "one of several";
  const std::string named = "Segment0_ID:=Segment_1\nSegment0_Name:=Cortex\nSegment0_LabelValue:=3\n";
  EXPECT_EQ(nameIn("label_Brain.nrrd", named, one), "Cortex") << "as the file has it";
  const std::string unnamed =
      "Segment0_ID:=Segment_1\nSegment0_Name:=\nSegment0_LabelValue:=3\nSegment0_Color:=1 0 0\n";
  EXPECT_EQ(nameIn("label_Brain.nrrd", unnamed, one), "Brain");
  EXPECT_EQ(readLabels(folder.path() / "label_Brain.nrrd", cube(2)).labels->labels()[1].color,
            glm::dvec3(1.0, 0.0, 0.0));
}

TEST_F(LabelReader, theOnlyLabelOfAFileIsNeverCalledAfterThePatient) {
  const PatientLabel patient{"MEIER^ANNA", "", ""};
  const auto nameIn = [&](const char* name) {
    const auto path = file(name, nrrdStart + "\n0 3 3 0 0 0 3 0\n");
    return readSegmentation(path, cube(2), {}, patient).region.labels->labels()[1].name;
  };
  EXPECT_EQ(nameIn("Meier_Anna_liver.nrrd"), "liver");
  EXPECT_EQ(nameIn("Meier_Anna.seg.nrrd"), "Label 3");
}

TEST_F(LabelReader, refusesWhatIsNoLabelMapOfTheVolume) {
  const auto image = file("image.nrrd", "NRRD0004\ntype: float\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\n"
                                        "encoding: ascii\n\n0 1.5 2 3 4 5 6 7\n");
  EXPECT_NE(refusalOf(image, cube(2)).find("image.nrrd"), std::string::npos) << refusalOf(image, cube(2));
  EXPECT_NE(refusalOf(image, cube(2)).find("no whole numbers"), std::string::npos);
  const auto labels = file("labels.nrrd", nrrdStart + "\n0 3 3 5 5 5 9 0\n");
  Grid elsewhere = cube(2);
  elsewhere.originMm = {500, 0, 0};
  EXPECT_NE(refusalOf(labels, elsewhere).find("it lies elsewhere than the volume"), std::string::npos);
  EXPECT_NE(refusalOf(folder.path() / "gone.nrrd", cube(2)).find("no such file"), std::string::npos);
}

TEST_F(LabelReader, laysRealLabelsOnTheirVolumes) {
  for (const auto& [volume, labels, name] :
       {std::tuple("mr_t1_head/mr_t1_head.nii.gz", "mr_t1_head/label_Brain.nrrd", "Brain"),
        {"mr_t1_head/mr_t1_head.nii.gz", "mr_t1_head/label_Skull.nrrd", "Skull"},
        {"mr_brain_nrrd/brain1_image.nrrd", "mr_brain_nrrd/brain1_label.nrrd", "brain1"}}) {
    LIMN_NEEDS_SHARED(std::string("data/") + volume);
    const auto image = readVolume(test::sharedFolder() / "data" / volume);
    const auto path = test::sharedFolder() / "data" / labels;
    const Region region = readLabels(path, image->grid());
    EXPECT_EQ(region.labels->dims(), image->grid().dims);
    ASSERT_EQ(region.labels->labels().size(), 2u) << labels;
    EXPECT_EQ(region.labels->labels()[1].name, name);
    // One grid, or its mirror image: each labelled voxel lands on exactly one.
    EXPECT_EQ(countsIn(*region.labels)[1], countOf(*readVolume(path), 1.0)) << labels;
  }
}

TEST_F(LabelReader, isCancelled) {
  const auto labels = file("labels.nrrd", nrrdStart + "\n0 3 3 5 5 5 9 0\n");
  EXPECT_THROW((void)readLabels(labels, cube(2), {{}, [] { return true; }}), Cancelled);
}

} // namespace
} // namespace limn
