// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/VolumeBytes.h"

namespace limn {
namespace {

using namespace test;

const std::string nrrdBasics =
    "NRRD0004\n# made by a test\ntype: short\ndimension: 3\nsizes: 2 3 4\nendian: little\n";
const std::string plainNrrd = nrrdBasics + "encoding: raw\n";

// Axis i steps 2 mm along the space's second axis, j 3 mm along its third, k 4 mm against its first.
std::string placedIn(const std::string& space) {
  return plainNrrd + "space: " + space +
         "\nspace directions: (0,2,0) (0,0,3) (-4,0,0)\nspace origin: (10,20,30)\n\n" + voxels();
}

TEST(Nrrd, everyNamedSpaceBecomesLps) {
  // Voxel (1, 2, 3) in the file's space: (10 - 12, 20 + 2, 30 + 6) = (-2, 22, 36).
  for (const char* space : {"left-posterior-superior", "LPS"})
    expectNear(indexToWorld(openedAs("a.nrrd", placedIn(space))->grid(), {1, 2, 3}), {-2, 22, 36});
  for (const char* space : {"right-anterior-superior", "RAS"})
    expectNear(indexToWorld(openedAs("a.nrrd", placedIn(space))->grid(), {1, 2, 3}), {2, -22, 36});
  for (const char* space : {"left-anterior-superior", "LAS"})
    expectNear(indexToWorld(openedAs("a.nrrd", placedIn(space))->grid(), {1, 2, 3}), {-2, -22, 36});
  const auto volume = openedAs("a.nrrd", placedIn("LPS"));
  EXPECT_TRUE(volume->info().orientationKnown);
  EXPECT_TRUE(volume->info().warnings.empty());
  expectNear(volume->grid().spacingMm, {2, 3, 4});
  EXPECT_EQ(volume->value({1, 2, 3}), 23.0);
}

TEST(Nrrd, aSpaceThatIsNotThePatientsLeavesTheOrientationUnknown) {
  const auto volume = openedAs("a.nrrd", placedIn("scanner-xyz"));
  EXPECT_FALSE(volume->info().orientationKnown);
  EXPECT_TRUE(warns(*volume, "Orientation unknown"));
}

TEST(Nrrd, spacingsAloneLeaveTheOrientationUnknown) {
  const auto volume = openedAs("a.nrrd", plainNrrd + "spacings: 0.5 0.5 2\n\n" + voxels());
  EXPECT_FALSE(volume->info().orientationKnown);
  EXPECT_TRUE(volume->info().spacingKnown);
  expectNear(volume->grid().spacingMm, {0.5, 0.5, 2.0});
  EXPECT_FALSE(openedAs("a.nrrd", plainNrrd + "\n" + voxels())->info().spacingKnown);
}

TEST(Nrrd, spaceUnitsBecomeMillimetres) {
  const auto volume =
      openedAs("a.nrrd", plainNrrd +
                             "space: LPS\nspace directions: (2,0,0) (0,3,0) (0,0,4)\nspace units: \"um\" "
                             "\"um\" \"um\"\nspace origin: (5,0,0)\n\n" +
                             voxels());
  expectNear(volume->grid().spacingMm, {0.002, 0.003, 0.004}, 1e-12);
  EXPECT_NEAR(volume->grid().originMm.x, 0.005, 1e-12);
}

TEST(Nrrd, gzipTextAndBigEndianHoldTheSameVoxels) {
  const auto expected = openedAs("a.nrrd", plainNrrd + "\n" + voxels())->stored();
  EXPECT_EQ(openedAs("a.nrrd", nrrdBasics + "encoding: gzip\n\n" + deflated(voxels()))->stored(), expected);
  std::string text;
  for (int i = 0; i < 24; ++i)
    text += std::to_string(i) + (i % 5 == 4 ? "\n" : " ");
  EXPECT_EQ(openedAs("a.nrrd", nrrdBasics + "encoding: ascii\n\n" + text)->stored(), expected);
  std::string header = plainNrrd;
  header.replace(header.find("little"), 6, "big");
  EXPECT_EQ(openedAs("a.nrrd", header + "\n" + bytesOf(rising<std::int16_t>(24), true))->stored(), expected);
}

TEST(Nrrd, whatIsNotSupportedIsRefusedByName) {
  EXPECT_NE(refusalAs("a.nrrd", nrrdBasics + "encoding: bzip2\n\n" + voxels()).find("bzip2"),
            std::string::npos);
  std::string header = plainNrrd;
  header.replace(header.find("short"), 5, "block");
  EXPECT_NE(refusalAs("a.nrrd", header + "\n" + voxels()).find("block"), std::string::npos);
  header = plainNrrd;
  header.erase(header.find("endian: little\n"), 15);
  EXPECT_NE(refusalAs("a.nrrd", header + "\n" + voxels()).find("byte order"), std::string::npos);
}

TEST(Nrrd, aShortFileIsRefused) {
  EXPECT_NE(refusalAs("a.nrrd", plainNrrd + "\n" + voxels().substr(1)).find("holds only"), std::string::npos);
  EXPECT_NE(refusalAs("a.nrrd", nrrdBasics + "encoding: gzip\n\n" + deflated(voxels().substr(4)))
                .find("22 of the 24"),
            std::string::npos);
  EXPECT_NE(refusalAs("a.nrrd", nrrdBasics + "encoding: ascii\n\n" +
                                    "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 ")
                .find("22 of the 24"),
            std::string::npos);
  refusalAs("a.nrrd", plainNrrd); // no blank line
  refusalAs("a.nrrd",
            "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3\nencoding: raw\nendian: little\n\n" + voxels());
}

TEST(Nrrd, aVolumeLargerThanAnyComputerIsCalledTooLarge) {
  std::string header = plainNrrd;
  const std::size_t sizes = header.find("sizes: ");
  header.replace(sizes, header.find('\n', sizes) - sizes, "sizes: 20000 20000 20000");
  const std::string refusal = refusalAs("a.nrrd", header + "\n" + voxels());
  EXPECT_NE(refusal.find("20000 x 20000 x 20000, which is too large"), std::string::npos) << refusal;
}

TEST(Nrrd, shearedAxesAreRefused) {
  const std::string axes = "space: LPS\nspace directions: (2,0,0) (0.5,3,0) (0,0,4)\n\n";
  EXPECT_NE(refusalAs("a.nrrd", plainNrrd + axes + voxels()).find("sheared"), std::string::npos);
}

TEST(Nrrd, aColourAxisBecomesLuminanceAndAVectorAxisIsRefused) {
  const std::string start = "NRRD0004\ntype: uchar\ndimension: 4\nencoding: raw\nsizes: 3 2 1 1\n";
  const std::string directions = "space: LPS\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n";
  const std::string colors = bytesOf<std::uint8_t>({255, 0, 0, 10, 20, 30});
  const auto volume =
      openedAs("a.nrrd", start + directions + "kinds: RGB-color domain domain domain\n\n" + colors);
  // BT.709: 0.2126·255 = 54.2; 0.2126·10 + 0.7152·20 + 0.0722·30 = 18.6.
  EXPECT_EQ(volume->value({0, 0, 0}), 54.0);
  EXPECT_EQ(volume->value({1, 0, 0}), 19.0);
  EXPECT_TRUE(warns(*volume, "luminance"));
  EXPECT_NE(refusalAs("a.nrrd", start + directions + "kinds: vector domain domain domain\n\n" + colors)
                .find("vector"),
            std::string::npos);
  EXPECT_NE(refusalAs("a.nrrd", start + "\n" + colors).find("spatial"), std::string::npos);
}

TEST(Nrrd, ofSeveralVolumesTheFirstIsRead) {
  const auto volume = openedAs(
      "a.nrrd", "NRRD0004\ntype: uchar\ndimension: 4\nencoding: raw\nsizes: 2 1 1 3\nspace: LPS\n"
                "space directions: (1,0,0) (0,1,0) (0,0,1) none\nkinds: domain domain domain list\n\n" +
                    bytesOf<std::uint8_t>({1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(volume->range(), (ValueRange{1.0, 2.0}));
  EXPECT_TRUE(warns(*volume, "3 volumes"));
}

class DetachedNrrd : public testing::Test {
protected:
  std::filesystem::path header(const std::string& dataFile, const std::string& more = "") {
    const auto file = m_folder.path() / "sub" / "a.nhdr";
    writeBytes(file, plainNrrd + more + "data file: " + dataFile + "\n");
    return file;
  }
  void SetUp() override {
    std::filesystem::create_directory(m_folder.path() / "sub");
    writeBytes(m_folder.path() / "sub" / "a.raw", voxels());
    writeBytes(m_folder.path() / "secret.raw", voxels());
  }
  TemporaryFolder m_folder;
};

TEST_F(DetachedNrrd, readsTheFileBesideTheHeader) {
  EXPECT_EQ(readVolume(header("a.raw"))->value({1, 2, 3}), 23.0);
  EXPECT_EQ(readVolume(header("./a.raw"))->value({1, 2, 3}), 23.0);
}

TEST_F(DetachedNrrd, skipsLinesAndBytes) {
  writeBytes(m_folder.path() / "sub" / "b.raw", "one\ntwo\nxyz" + voxels());
  EXPECT_EQ(readVolume(header("b.raw", "line skip: 2\nbyte skip: 3\n"))->value({1, 2, 3}), 23.0);
  EXPECT_EQ(readVolume(header("b.raw", "byte skip: -1\n"))->value({1, 2, 3}), 23.0);
}

TEST_F(DetachedNrrd, namesThatLeaveTheFolderAreRefused) {
  EXPECT_NE(refusalOf(header("../secret.raw")).find("not in the folder"), std::string::npos);
  EXPECT_NE(refusalOf(header("x/../../secret.raw")).find("not in the folder"), std::string::npos);
  EXPECT_NE(refusalOf(header((m_folder.path() / "secret.raw").string())).find("not in the folder"),
            std::string::npos);
}

TEST_F(DetachedNrrd, missingAndManyFilesAreRefused) {
  EXPECT_NE(refusalOf(header("none.raw")).find("missing"), std::string::npos);
  EXPECT_NE(refusalOf(header("a%d.raw 1 3 1")).find("several files"), std::string::npos);
  EXPECT_NE(refusalOf(header("LIST\na.raw\nb.raw")).find("several files"), std::string::npos);
}

} // namespace
} // namespace limn
