// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/NiftiBytes.h"

namespace limn {
namespace {

using namespace test;

// Reads a file of these fields with the int16 voxels 0 … 23.
std::shared_ptr<const Volume> opened(const NiftiFields& fields) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.nii";
  writeBytes(file, niftiFile(fields, bytesOf(rising<std::int16_t>(24), fields.bigEndian)));
  return readVolume(file);
}

// RAS: x = -2 i + 10, y = 4 k + 20, z = 3 j + 30.
NiftiFields withSform() {
  NiftiFields fields;
  fields.sformCode = 1;
  fields.rows = {-2, 0, 0, 10, 0, 0, 4, 20, 0, 3, 0, 30};
  return fields;
}

TEST(Nifti, theSformPlacesTheVoxels) {
  const auto volume = opened(withSform());
  EXPECT_EQ(volume->grid().dims, glm::ivec3(2, 3, 4));
  expectNear(volume->grid().spacingMm, {2, 3, 4});
  // Voxel (1, 2, 3): RAS (8, 32, 36), so LPS (-8, -32, 36).
  expectNear(indexToWorld(volume->grid(), {1, 2, 3}), {-8, -32, 36});
  EXPECT_TRUE(volume->info().orientationKnown);
  EXPECT_TRUE(volume->info().warnings.empty());
  EXPECT_EQ(volume->info().format, "NIfTI-1");
  // x is fastest: (1, 2, 3) is voxel 1 + 2·2 + 3·6.
  EXPECT_EQ(volume->value({1, 2, 3}), 23.0);
  EXPECT_EQ(volume->value({1, 0, 2}), 13.0);
}

TEST(Nifti, theQformPlacesTheVoxelsAndItsSignTurnsTheThirdAxis) {
  NiftiFields fields;
  fields.qformCode = 1;
  fields.pixdim[0] = -1.0;
  fields.offset = {10, 20, 30};
  // No rotation: RAS (10 + 2, 20 + 2·3, 30 - 3·4) = (12, 26, 18).
  expectNear(indexToWorld(opened(fields)->grid(), {1, 2, 3}), {-12, -26, 18});
  fields.pixdim[0] = 1.0;
  expectNear(indexToWorld(opened(fields)->grid(), {1, 2, 3}), {-12, -26, 42});
  // A quarter turn about z takes +x to +y and +y to -x: RAS (10 - 6, 20 + 2, 30 + 12).
  fields.quaternion = {0, 0, std::sqrt(0.5)};
  expectNear(indexToWorld(opened(fields)->grid(), {1, 2, 3}), {-4, -22, 42});
  // A half turn about x (the rest a is 0): RAS (10 + 2, 20 - 6, 30 - 12).
  fields.quaternion = {1, 0, 0};
  expectNear(indexToWorld(opened(fields)->grid(), {1, 2, 3}), {-12, -14, 18});
}

TEST(Nifti, ofTwoPlacementsTheSformHoldsAndTheDifferenceIsSaid) {
  NiftiFields fields = withSform();
  fields.qformCode = 1;
  const auto volume = opened(fields);
  expectNear(indexToWorld(volume->grid(), {1, 2, 3}), {-8, -32, 36});
  EXPECT_TRUE(warns(*volume, "sform, qform"));
}

TEST(Nifti, aDamagedSformGivesWayToTheQform) {
  NiftiFields fields;
  fields.qformCode = 1;
  fields.sformCode = 1; // all rows zero
  const auto volume = opened(fields);
  expectNear(indexToWorld(volume->grid(), {1, 2, 3}), {-2, -6, 12});
  EXPECT_TRUE(warns(*volume, "sform"));
}

TEST(Nifti, withoutPlacementOnlyTheSpacingIsKnown) {
  const auto volume = opened(NiftiFields{});
  EXPECT_FALSE(volume->info().orientationKnown);
  EXPECT_TRUE(volume->info().spacingKnown);
  EXPECT_TRUE(warns(*volume, "Orientation unknown"));
  expectNear(volume->grid().spacingMm, {2, 3, 4});
}

TEST(Nifti, withoutSpacingOneMillimetreIsAssumedAndSaid) {
  NiftiFields fields;
  fields.pixdim = {};
  const auto volume = opened(fields);
  EXPECT_FALSE(volume->info().spacingKnown);
  EXPECT_TRUE(warns(*volume, "Spacing unknown"));
  expectNear(volume->grid().spacingMm, {1, 1, 1});
}

TEST(Nifti, unitsBecomeMillimetres) {
  NiftiFields fields = withSform();
  fields.units = 3 + 8; // micrometres, seconds
  const auto volume = opened(fields);
  expectNear(volume->grid().spacingMm, {0.002, 0.003, 0.004}, 1e-9);
  expectNear(volume->grid().originMm, {-0.010, -0.020, 0.030}, 1e-9);
}

TEST(Nifti, bothByteOrdersAndBothVersionsAgree) {
  const auto expected = opened(withSform());
  for (const int version : {1, 2})
    for (const bool bigEndian : {false, true}) {
      NiftiFields fields = withSform();
      fields.version = version;
      fields.bigEndian = bigEndian;
      const auto volume = opened(fields);
      EXPECT_EQ(volume->stored(), expected->stored());
      EXPECT_EQ(volume->grid(), expected->grid());
      EXPECT_EQ(volume->info().format, version == 1 ? "NIfTI-1" : "NIfTI-2");
    }
}

TEST(Nifti, aPairOpensByEitherName) {
  const TemporaryFolder folder;
  NiftiFields fields = withSform();
  fields.isPair = true;
  writeBytes(folder.path() / "a.hdr", NiftiWriter(fields).bytes());
  writeBytes(folder.path() / "a.img", bytesOf(rising<std::int16_t>(24)));
  EXPECT_EQ(readVolume(folder.path() / "a.hdr")->value({1, 2, 3}), 23.0);
  EXPECT_EQ(readVolume(folder.path() / "a.img")->value({1, 2, 3}), 23.0);
  std::filesystem::remove(folder.path() / "a.img");
  EXPECT_NE(refusalOf(folder.path() / "a.hdr").find("a.img is missing"), std::string::npos);
}

TEST(Nifti, slopeAndInterceptRescaleAndAZeroSlopeDoesNot) {
  NiftiFields fields = withSform();
  fields.slope = 2.5;
  fields.intercept = -4.0;
  EXPECT_EQ(opened(fields)->value({1, 2, 3}), 2.5 * 23.0 - 4.0);
  EXPECT_EQ(voxelTypeName(opened(fields)->stored()), "int16");
  fields.slope = 0.0;
  EXPECT_EQ(opened(fields)->rescale(), Rescale{});
}

TEST(Nifti, ofSeveralVolumesTheFirstIsReadAndThatIsSaid) {
  const TemporaryFolder folder;
  NiftiFields fields = withSform();
  fields.dim = {4, 2, 3, 4, 5, 1, 1, 1};
  writeBytes(folder.path() / "a.nii", niftiFile(fields, bytesOf(rising<std::int16_t>(120))));
  const auto volume = readVolume(folder.path() / "a.nii");
  EXPECT_EQ(volume->voxelCount(), 24u);
  EXPECT_EQ(volume->range().highest, 23.0);
  EXPECT_TRUE(warns(*volume, "5 volumes"));
}

TEST(Nifti, coloursBecomeLuminance) {
  const TemporaryFolder folder;
  NiftiFields fields = withSform();
  fields.dim = {3, 2, 1, 1, 1, 1, 1, 1};
  fields.datatype = 128;
  fields.slope = 3.0; // has no meaning for colours
  writeBytes(folder.path() / "a.nii", niftiFile(fields, bytesOf<std::uint8_t>({255, 0, 0, 10, 20, 30})));
  const auto volume = readVolume(folder.path() / "a.nii");
  // BT.709: 0.2126·255 = 54.2; 0.2126·10 + 0.7152·20 + 0.0722·30 = 18.6.
  EXPECT_EQ(volume->value({0, 0, 0}), 54.0);
  EXPECT_EQ(volume->value({1, 0, 0}), 19.0);
  EXPECT_TRUE(warns(*volume, "luminance"));
}

template <class T>
void expectType(int datatype, const std::string& name) {
  const TemporaryFolder folder;
  NiftiFields fields = withSform();
  fields.datatype = datatype;
  writeBytes(folder.path() / "a.nii", niftiFile(fields, bytesOf(rising<T>(24))));
  const auto volume = readVolume(folder.path() / "a.nii");
  EXPECT_EQ(voxelTypeName(volume->stored()), name);
  EXPECT_EQ(volume->value({1, 2, 3}), 23.0);
}

TEST(Nifti, everyNumberTypeKeepsItsTypeButLongIntegers) {
  expectType<std::uint8_t>(2, "uint8");
  expectType<std::int16_t>(4, "int16");
  expectType<std::int32_t>(8, "int32");
  expectType<float>(16, "float32");
  expectType<double>(64, "float64");
  expectType<std::int8_t>(256, "int8");
  expectType<std::uint16_t>(512, "uint16");
  expectType<std::uint32_t>(768, "uint32");
  expectType<std::int64_t>(1024, "float64");
  expectType<std::uint64_t>(1280, "float64");
}

TEST(Nifti, invalidFloatsAreCountedAndReplaced) {
  const TemporaryFolder folder;
  NiftiFields fields = withSform();
  fields.datatype = 16;
  std::vector<float> values = rising<float>(24);
  values[0] = std::nanf("");
  values[5] = HUGE_VALF;
  writeBytes(folder.path() / "a.nii", niftiFile(fields, bytesOf(values)));
  const auto volume = readVolume(folder.path() / "a.nii");
  EXPECT_EQ(volume->invalidVoxels(), 2u);
  EXPECT_EQ(volume->range(), (ValueRange{1.0, 23.0}));
}

TEST(Nifti, aShearedVolumeIsRefused) {
  const TemporaryFolder folder;
  NiftiFields fields = withSform();
  fields.rows = {2, 0, 1, 0, 0, 3, 0, 0, 0, 0, 4, 0}; // x gains 1 mm per slice
  writeBytes(folder.path() / "a.nii", niftiFile(fields, bytesOf(rising<std::int16_t>(24))));
  EXPECT_NE(refusalOf(folder.path() / "a.nii").find("sheared"), std::string::npos);
}

TEST(Nifti, aTruncatedFileIsRefusedPlainAndCompressed) {
  const TemporaryFolder folder;
  const std::string whole = niftiFile(withSform(), bytesOf(rising<std::int16_t>(24)));
  writeBytes(folder.path() / "a.nii", whole.substr(0, whole.size() - 1));
  EXPECT_NE(refusalOf(folder.path() / "a.nii").find("holds only"), std::string::npos);
  writeBytes(folder.path() / "b.nii.gz", deflated(whole.substr(0, whole.size() - 2)));
  EXPECT_NE(refusalOf(folder.path() / "b.nii.gz").find("23 of the 24"), std::string::npos);
  writeBytes(folder.path() / "c.nii", whole.substr(0, 200));
  refusalOf(folder.path() / "c.nii");
}

TEST(Nifti, damagedCompressedDataAreRefused) {
  const TemporaryFolder folder;
  std::string file = deflated(niftiFile(withSform(), bytesOf(rising<std::int16_t>(24))));
  // The last eight bytes are the check sum and the length.
  file[file.size() - 8] = static_cast<char>(file[file.size() - 8] + 1);
  writeBytes(folder.path() / "a.nii.gz", file);
  EXPECT_NE(refusalOf(folder.path() / "a.nii.gz").find("damaged"), std::string::npos);
}

TEST(Nifti, aHeaderThatAsksForMoreThanTheFileCanHoldIsRefusedBeforeAnyRoomIsMade) {
  const TemporaryFolder folder;
  NiftiFields fields = withSform();
  fields.dim = {3, 3000, 3000, 3000, 1, 1, 1, 1};
  writeBytes(folder.path() / "a.nii.gz", deflated(niftiFile(fields, std::string(1 << 20, '\0'))));
  EXPECT_NE(refusalOf(folder.path() / "a.nii.gz").find("holds only"), std::string::npos);
}

TEST(Nifti, aStreamThatGoesOnBehindTheVoxelsIsReadNoFurther) {
  const TemporaryFolder folder;
  const std::string file =
      niftiFile(withSform(), bytesOf(rising<std::int16_t>(24)) + std::string(64 << 20, '\0'));
  writeBytes(folder.path() / "a.nii.gz", deflated(file));
  EXPECT_EQ(readVolume(folder.path() / "a.nii.gz")->voxelCount(), 24u);
}

TEST(Nifti, aGzipFileOfSeveralMembersIsReadThrough) {
  const TemporaryFolder folder;
  const std::string whole = niftiFile(withSform(), bytesOf(rising<std::int16_t>(24)));
  writeBytes(folder.path() / "a.nii.gz", deflated(whole.substr(0, 360)) + deflated(whole.substr(360)));
  EXPECT_EQ(readVolume(folder.path() / "a.nii.gz")->value({1, 2, 3}), 23.0);
}

TEST(Nifti, impossibleDimensionsAndTypesAreRefused) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.nii";
  const std::string voxels = bytesOf(rising<std::int16_t>(24));
  NiftiFields fields = withSform();
  fields.dim[2] = -3;
  writeBytes(file, niftiFile(fields, voxels));
  refusalOf(file);
  fields = withSform();
  fields.datatype = 32; // complex
  writeBytes(file, niftiFile(fields, voxels));
  EXPECT_NE(refusalOf(file).find("complex"), std::string::npos);
}

} // namespace
} // namespace limn
