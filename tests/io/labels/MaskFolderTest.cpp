// SPDX-License-Identifier: GPL-3.0-or-later
// Segmentations that have a mask for each structure, in NIfTI files as TotalSegmentator writes them, and
// names that a file of many labels carries.
#include "io/labels/MaskFolder.h"

#include "io/NiftiBytes.h"

#include <algorithm>
#include <fstream>
#include <numeric>

namespace limn {
namespace {

constexpr glm::ivec3 maskDims{6, 5, 4};
constexpr int maskVoxels = 6 * 5 * 4;

// A grid of 2 mm in RAS from (10, 20, 30) on, with columns to the right.
test::NiftiFields maskFields() {
  test::NiftiFields fields;
  fields.dim = {3, maskDims.x, maskDims.y, maskDims.z, 1, 1, 1, 1};
  fields.pixdim = {1, 2, 2, 2, 0, 0, 0, 0};
  fields.datatype = 2; // uint8
  fields.sformCode = 1;
  fields.rows = {2, 0, 0, 10, 0, 2, 0, 20, 0, 0, 2, 30};
  return fields;
}

// Ones in a box of voxels, the upper corner excluded.
std::vector<std::uint8_t> boxOf(const glm::ivec3& lower, const glm::ivec3& upper) {
  std::vector<std::uint8_t> voxels(maskVoxels, 0);
  for (int z = lower.z; z < upper.z; ++z)
    for (int y = lower.y; y < upper.y; ++y)
      for (int x = lower.x; x < upper.x; ++x)
        voxels[voxelOffset(maskDims, x, y, z)] = 1;
  return voxels;
}

class MaskFolder : public testing::Test {
protected:
  MaskFolder() {
    std::filesystem::create_directories(masks());
    write("ct.nii.gz", maskFields(), std::vector<std::uint8_t>(maskVoxels, 0), folder.path());
    grid = readVolume(folder.path() / "ct.nii.gz")->grid();
  }

  std::filesystem::path masks() const { return folder.path() / "segmentations"; }

  void write(const std::string& name, const test::NiftiFields& fields,
             const std::vector<std::uint8_t>& voxels, const std::filesystem::path& where) const {
    const std::string bytes = test::niftiFile(fields, test::bytesOf(voxels));
    std::ofstream(where / name, std::ios::binary) << (name.ends_with(".gz") ? test::deflated(bytes) : bytes);
  }
  void mask(const std::string& name, const std::vector<std::uint8_t>& voxels) const {
    write(name, maskFields(), voxels, masks());
  }

  std::string refusal() const {
    try {
      (void)readSegmentation(masks(), grid);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  }

  static std::vector<std::string> namesIn(const Region& region) {
    std::vector<std::string> names;
    for (const Label& label : region.labels->labels())
      names.push_back(label.name);
    return names;
  }

  test::TemporaryFolder folder;
  Grid grid;
};

TEST_F(MaskFolder, becomesOneLabelMapCalledAfterItsFiles) {
  mask("liver.nii.gz", boxOf({0, 0, 0}, {3, 2, 2}));
  mask("kidney_left.nii.gz", boxOf({4, 0, 0}, {6, 2, 1}));
  mask("spleen.nii", boxOf({0, 3, 2}, {1, 5, 4}));
  mask("appendix.nii.gz", std::vector<std::uint8_t>(maskVoxels, 0)); // absent, as it is written then
  ASSERT_TRUE(isMaskFolder(masks()));
  const Segmentation read = readSegmentation(masks(), grid);
  EXPECT_EQ(read.remark.english(), "");
  EXPECT_EQ(read.region.kind, Region::Kind::labels);
  EXPECT_EQ(read.region.source, masks().string());
  EXPECT_EQ(readSegmentation(masks() / "", grid).region.source, masks().string()) << "with a slash behind it";
  EXPECT_EQ(namesIn(read.region), (std::vector<std::string>{"Background", "kidney left", "liver", "spleen"}));
  // Files are numbered by name, the empty one, too: what a scene says of a number holds whatever they hold.
  EXPECT_EQ(read.region.labels->labels()[1].value, 2);
  EXPECT_EQ(read.region.labels->labels()[3].value, 4);
  EXPECT_EQ(read.region.weights, std::vector<double>(4, 1.0));
  const auto liver = boxOf({0, 0, 0}, {3, 2, 2}), kidney = boxOf({4, 0, 0}, {6, 2, 1}),
             spleen = boxOf({0, 3, 2}, {1, 5, 4});
  for (std::size_t voxel = 0; voxel < maskVoxels; ++voxel)
    ASSERT_EQ(read.region.labels->placeAt(voxel), liver[voxel]    ? 2u
                                                  : kidney[voxel] ? 1u
                                                  : spleen[voxel] ? 3u
                                                                  : 0u)
        << voxel;
  EXPECT_NE(read.region.labels->labels()[1].color, read.region.labels->labels()[2].color);
}

TEST_F(MaskFolder, ofTwoMasksTheLaterByNameHasTheVoxelWhichIsSaid) {
  mask("stomach.nii.gz", boxOf({0, 0, 0}, {4, 1, 1}));
  mask("colon.nii.gz", boxOf({2, 0, 0}, {6, 1, 1}));
  mask("duodenum.nii.gz", boxOf({5, 0, 0}, {6, 2, 1}));
  const Segmentation read = readSegmentation(masks(), grid);
  const LabelMap& map = *read.region.labels;
  EXPECT_EQ(map.labels()[map.placeAt(2)].name, "stomach");
  EXPECT_EQ(map.labels()[map.placeAt(4)].name, "colon");
  EXPECT_EQ(map.labels()[map.placeAt(5)].name, "duodenum");
  EXPECT_EQ(read.remark.english(),
            "3 voxels lie in more than one mask and belong to the one whose name comes last; most of them, "
            "2, to stomach and not to colon.");
  std::filesystem::remove(masks() / "duodenum.nii.gz");
  EXPECT_EQ(readSegmentation(masks(), grid).remark.english(),
            "2 voxels lie in two masks and belong to the one whose name comes last: to stomach and not to "
            "colon.");
}

TEST_F(MaskFolder, saysFirstWhichLabelsOthersLeftNoVoxel) {
  mask("brain.nii.gz", boxOf({0, 0, 0}, {2, 1, 1}));
  mask("head.nii.gz", boxOf({0, 0, 0}, {4, 1, 1}));
  const Segmentation one = readSegmentation(masks(), grid);
  EXPECT_EQ(one.covered.english(), "brain has no voxels of its own: head, read after it, covers them.");
  EXPECT_EQ(one.remark.english(),
            one.covered.english() + " 2 voxels lie in two masks and belong to the one whose name comes last: "
                                    "to head and not to brain.");
  EXPECT_EQ(readSegmentations({masks() / "brain.nii.gz", masks() / "head.nii.gz"}, grid).covered,
            one.covered);
  mask("cerebellum.nii.gz", boxOf({2, 0, 0}, {4, 1, 1}));
  EXPECT_EQ(readSegmentation(masks(), grid).covered.english(),
            "2 labels have no voxels of their own, because head, read after them, covers them: brain, "
            "cerebellum.");
  mask("cerebellum.nii.gz", boxOf({1, 0, 0}, {3, 1, 1}));
  mask("head.nii.gz", boxOf({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(readSegmentation(masks(), grid).covered.english(),
            "brain has no voxels of its own: masks read after it cover them.");
  mask("brain.nii.gz", boxOf({0, 0, 0}, {2, 2, 1}));
  EXPECT_TRUE(readSegmentation(masks(), grid).covered.empty()) << "some are left";
}

TEST_F(MaskFolder, callsAMaskWhoseNameTellsNothingAfterItsWholeName) {
  mask("label_1.nii.gz", boxOf({0, 0, 0}, {1, 1, 1}));
  mask("label_Brain.nii.gz", boxOf({2, 0, 0}, {3, 1, 1}));
  mask("mask.nii.gz", boxOf({4, 0, 0}, {5, 1, 1}));
  EXPECT_EQ(namesIn(readSegmentation(masks(), grid).region),
            (std::vector<std::string>{"Background", "label_1", "Brain", "mask"}));
}

TEST_F(MaskFolder, callsNoMaskAfterThePatient) {
  mask("meier_anna_1.nii.gz", boxOf({0, 0, 0}, {1, 1, 1}));
  mask("meier_anna_liver.nii.gz", boxOf({2, 0, 0}, {3, 1, 1}));
  mask("meier_spleen.nii.gz", boxOf({4, 0, 0}, {5, 1, 1}));
  const PatientLabel patient{"MEIER^ANNA", "", ""};
  EXPECT_EQ(namesIn(readSegmentation(masks(), grid, {}, patient).region),
            (std::vector<std::string>{"Background", "Label 1", "liver", "spleen"}));
  mask("anna_liver.nii.gz", boxOf({5, 1, 1}, {6, 2, 2})); // another liver: neither is it alone
  EXPECT_EQ(namesIn(readSegmentation(masks(), grid, {}, patient).region),
            (std::vector<std::string>{"Background", "Label 1", "Label 2", "Label 3", "spleen"}));
}

TEST_F(MaskFolder, leavesOutWhatIsNoMaskAndSaysSo) {
  mask("liver.nii.gz", boxOf({0, 0, 0}, {3, 2, 2}));
  std::vector<std::uint8_t> image(maskVoxels);
  std::iota(image.begin(), image.end(), std::uint8_t{0});
  mask("ct.nii.gz", image);
  EXPECT_EQ(readSegmentation(masks(), grid).remark.english(), "ct.nii.gz is no mask and was left out.");
  std::ofstream(masks() / "statistics.json") << "{}";
  std::ofstream(masks() / ".DS_Store") << "hidden";
  std::filesystem::create_directory(masks() / "more");
  const Segmentation read = readSegmentation(masks(), grid);
  EXPECT_EQ(read.remark.english(), "2 files are no masks and were left out: ct.nii.gz, statistics.json.");
  EXPECT_EQ(namesIn(read.region), (std::vector<std::string>{"Background", "liver"}));
}

TEST_F(MaskFolder, masksThatAreChosenComeInTheirOrderWithoutWhatIsNone) {
  mask("stomach.nii.gz", boxOf({0, 0, 0}, {4, 1, 1}));
  mask("colon.nii.gz", boxOf({2, 0, 0}, {6, 1, 1}));
  mask("ct.nii.gz", test::rising<std::uint8_t>(maskVoxels));
  const std::vector<std::filesystem::path> files{masks() / "stomach.nii.gz", masks() / "ct.nii.gz",
                                                 masks() / "colon.nii.gz"};
  const Segmentation read = readSegmentations(files, grid);
  EXPECT_EQ(namesIn(read.region), (std::vector<std::string>{"Background", "stomach", "colon"}));
  EXPECT_EQ(read.region.labels->labels()[2].value, 2) << "what is no mask has no number";
  EXPECT_EQ(sourcesOf(read.region), (std::vector<std::string>{files[0].string(), files[2].string()}));
  EXPECT_EQ(read.remark.english(),
            "ct.nii.gz is no mask and was left out. 2 voxels lie in two masks and belong to the one that was "
            "opened last: to colon and not to stomach.");
  // One is read as it is by itself, also where the others are no masks.
  mask("liver.nii.gz", [] {
    std::vector<std::uint8_t> sevens = boxOf({0, 0, 0}, {3, 2, 2});
    std::ranges::replace(sevens, std::uint8_t{1}, std::uint8_t{7});
    return sevens;
  }());
  const Segmentation liver = readSegmentations({files[1], masks() / "liver.nii.gz"}, grid);
  EXPECT_EQ(liver.region.labels->labels()[1].value, 7);
  EXPECT_EQ(liver.remark.english(), "ct.nii.gz is no mask and was left out.");
  EXPECT_EQ(readSegmentations({files[0]}, grid).region.source, files[0].string());
  try {
    (void)readSegmentations({files[1], files[1]}, grid);
    ADD_FAILURE() << "no mask was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("ct.nii.gz: neither it nor another file that was chosen"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(MaskFolder, isRefusedWithoutAnyMask) {
  mask("a.nii.gz", test::rising<std::uint8_t>(maskVoxels));
  EXPECT_NE(refusal().find("segmentations"), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("no file in it is the mask of a structure"), std::string::npos) << refusal();
  mask("b.nii.gz", std::vector<std::uint8_t>(maskVoxels, 0));
  EXPECT_NE(refusal().find("all of its masks are empty"), std::string::npos) << refusal();
  EXPECT_FALSE(isMaskFolder(folder.path() / "nowhere"));
  EXPECT_FALSE(isMaskFolder(masks() / "a.nii.gz"));
  std::filesystem::create_directory(folder.path() / "texts");
  std::ofstream(folder.path() / "texts" / "a.txt") << "text";
  EXPECT_FALSE(isMaskFolder(folder.path() / "texts"));
}

TEST_F(MaskFolder, namesAFileThatIsDamagedOrLiesElsewhere) {
  mask("liver.nii.gz", boxOf({0, 0, 0}, {3, 2, 2}));
  std::ofstream(masks() / "spleen.nii.gz", std::ios::binary) << "cut off";
  EXPECT_NE(refusal().find("spleen.nii.gz"), std::string::npos) << refusal();
  std::filesystem::remove(masks() / "spleen.nii.gz");
  test::NiftiFields far = maskFields();
  far.rows[3] = 5000;
  write("pancreas.nii.gz", far, boxOf({0, 0, 0}, {1, 1, 1}), masks());
  EXPECT_NE(refusal().find("pancreas.nii.gz"), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("it lies elsewhere than the volume"), std::string::npos) << refusal();
}

TEST_F(MaskFolder, ofAnotherGridGoesToTheNearestVoxels) {
  // Columns run the other way, from the last one back; and a mask of 4 mm, whose voxel is two by two by two.
  test::NiftiFields turned = maskFields();
  turned.rows = {-2, 0, 0, 10 + 2 * (maskDims.x - 1), 0, 2, 0, 20, 0, 0, 2, 30};
  write("liver.nii.gz", turned, boxOf({0, 0, 0}, {1, 1, 1}), masks());
  test::NiftiFields coarse = maskFields();
  coarse.dim = {3, 3, 2, 2, 1, 1, 1, 1};
  coarse.pixdim = {1, 4, 4, 4, 0, 0, 0, 0};
  coarse.rows = {4, 0, 0, 11, 0, 4, 0, 21, 0, 0, 4, 31};
  write("spleen.nii.gz", coarse, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, masks());
  const LabelMap map = *readSegmentation(masks(), grid).region.labels;
  for (int z = 0; z < maskDims.z; ++z)
    for (int y = 0; y < maskDims.y; ++y)
      for (int x = 0; x < maskDims.x; ++x) {
        const std::string wanted = x == maskDims.x - 1 && y == 0 && z == 0 ? "liver"
                                   : x < 2 && y < 2 && z < 2               ? "spleen"
                                                                           : "Background";
        ASSERT_EQ(map.labels()[map.placeAt(voxelOffset(maskDims, x, y, z))].name, wanted)
            << x << ' ' << y << ' ' << z;
      }
}

TEST_F(MaskFolder, mayHaveMoreThan255Masks) {
  for (int n = 0; n < 300; ++n) {
    std::vector<std::uint8_t> voxels(maskVoxels, 0);
    voxels[static_cast<std::size_t>(n % maskVoxels)] = 1;
    char name[32];
    std::snprintf(name, sizeof name, "part_%03d.nii", n);
    mask(name, voxels);
  }
  const LabelMap map = *readSegmentation(masks(), grid).region.labels;
  EXPECT_EQ(map.labels().size(), 301u);
  EXPECT_EQ(map.labels()[map.placeAt(0)].name, "part 240") << "the last that has the voxel: 0, 120, 240";
  EXPECT_EQ(map.labels()[map.placeAt(59)].name, "part 299");
}

TEST_F(MaskFolder, tellsHowFarItIsAndCanBeCancelled) {
  for (const char* name : {"a.nii.gz", "b.nii.gz", "c.nii.gz", "d.nii.gz"})
    mask(name, boxOf({0, 0, 0}, {3, 2, 2}));
  std::vector<double> told;
  const Progress progress{[&](double done, const Message&) { told.push_back(done); }, {}};
  (void)readSegmentation(masks(), grid, progress);
  ASSERT_GT(told.size(), 4u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1.0);
  EXPECT_GT(told.back(), 0.75);
  int asked = 0;
  EXPECT_THROW((void)readSegmentation(masks(), grid, {{}, [&] { return ++asked > 6; }}), Cancelled);
}

TEST_F(MaskFolder, aMaskThatIsOpenedAloneIsCalledAsInItsFolder) {
  mask("label_kidney_left.nii.gz", boxOf({0, 0, 0}, {3, 2, 2}));
  for (const auto& path : {masks(), masks() / "label_kidney_left.nii.gz"})
    EXPECT_EQ(namesIn(readSegmentation(path, grid).region),
              (std::vector<std::string>{"Background", "kidney left"}))
        << path;
}

// A label map as TotalSegmentator's --ml writes it: an extension of code 0 with a table in XML, in a NIfTI-1
// of either byte order.
TEST_F(MaskFolder, oneFileOfManyLabelsHasTheNamesOfItsTable) {
  std::string table = "<?xml version=\"1.0\" encoding=\"UTF-8\"?> <CaretExtension> <VolumeInformation "
                      "Index=\"0\"> <LabelTable>\n";
  std::vector<std::uint8_t> voxels(maskVoxels, 0);
  for (int n = 1; n <= 104; ++n) {
    table += "<Label Key=\"" + std::to_string(n) + "\" Red=\"0.5\" Green=\"0.25\" Blue=\"1\" Alpha=\"1\">" +
             "<![CDATA[organ & no " + std::to_string(n) + "]]></Label>\n";
    voxels[static_cast<std::size_t>(n)] = static_cast<std::uint8_t>(n);
  }
  table += "</LabelTable> <VolumeType><![CDATA[Label]]></VolumeType> </VolumeInformation></CaretExtension>\n";
  voxels[110] = 200; // which the table does not know
  for (const bool isBig : {false, true}) {
    test::NiftiFields fields = maskFields();
    fields.bigEndian = isBig;
    std::string header = test::NiftiWriter(fields).bytes();
    const std::size_t size = (table.size() + 8 + 15) / 16 * 16;
    header.replace(108, 4, test::bytesOf(std::vector<float>{352.0f + static_cast<float>(size)}, isBig));
    const std::string extension =
        test::bytesOf(std::vector<std::int32_t>{static_cast<std::int32_t>(size), 0}, isBig) + table +
        std::string(size - 8 - table.size(), '\0');
    std::ofstream(folder.path() / "all.nii.gz", std::ios::binary)
        << test::deflated(header + std::string("\1\0\0\0", 4) + extension + test::bytesOf(voxels));
    const Segmentation read = readSegmentation(folder.path() / "all.nii.gz", grid);
    const auto& labels = read.region.labels->labels();
    ASSERT_EQ(labels.size(), 106u);
    EXPECT_EQ(labels[0].name, "Background");
    EXPECT_EQ(labels[1], (Label{1, "organ & no 1", {0.5, 0.25, 1.0}}));
    EXPECT_EQ(labels[104].name, "organ & no 104");
    EXPECT_EQ(labels[105].name, "Label 200");
    // Sizes that lie are no reason to refuse a file whose voxels are sound.
    for (const std::int32_t lie : {0, -16, 1 << 30}) {
      std::string damaged = extension;
      damaged.replace(0, 4, test::bytesOf(std::vector<std::int32_t>{lie}, isBig));
      std::ofstream(folder.path() / "lie.nii", std::ios::binary)
          << header + std::string("\1\0\0\0", 4) + damaged + test::bytesOf(voxels);
      EXPECT_EQ(readLabels(folder.path() / "lie.nii", grid).labels->labels()[1].name, "Label 1") << lie;
    }
  }
}

} // namespace
} // namespace limn
