// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/VolumeReader.h"
#include "scene/basics/Error.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <ostream>

namespace limn {
namespace {

// One line of the shared folder's MANIFEST: what a file must open as.
struct Expected {
  const char* file;
  glm::ivec3 dims;
  glm::dvec3 spacingMm;
  const char* type;
  ValueRange range;
  bool orientationKnown;
};

void PrintTo(const Expected& expected, std::ostream* out) {
  *out << expected.file;
}

class RealVolume : public testing::TestWithParam<Expected> {};

TEST_P(RealVolume, opensAsItsManifestSays) {
  const Expected& expected = GetParam();
  const std::string relative = std::string("data/") + expected.file;
  LIMN_NEEDS_SHARED(relative);
  const auto volume = readVolume(test::sharedFolder() / relative);
  EXPECT_EQ(volume->grid().dims, expected.dims);
  // The manifest rounds to four figures.
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(volume->grid().spacingMm[axis], expected.spacingMm[axis], 5e-4 * expected.spacingMm[axis]);
  EXPECT_EQ(voxelTypeName(volume->stored()), expected.type);
  EXPECT_NEAR(volume->range().lowest, expected.range.lowest, 0.05);
  EXPECT_NEAR(volume->range().highest, expected.range.highest, 0.05);
  EXPECT_EQ(volume->info().orientationKnown, expected.orientationKnown);
  EXPECT_EQ(volume->invalidVoxels(), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Manifest, RealVolume,
    testing::Values(
        Expected{"ct_head_cranium/ct_head_cranium.nii.gz",
                 {256, 256, 108},
                 {0.957, 0.957, 1.5},
                 "int16",
                 {-1024, 2986},
                 true},
        Expected{"ct_head_cranium/ct_head_cranium_simmetal.nii.gz",
                 {256, 256, 48},
                 {0.957, 0.957, 1.5},
                 "int16",
                 {-1024, 7000},
                 true},
        Expected{"ct_thorax_contrast/lidc2_uint8.vti",
                 {256, 256, 133},
                 {1.40625, 1.40625, 2.5},
                 "uint8",
                 {0, 255},
                 false},
        Expected{"cta_brain_avm/cta_brain_avm_uint8.nii.gz",
                 {337, 319, 154},
                 {0.5469, 0.5469, 1.0},
                 "uint8",
                 {0, 563.2},
                 true},
        Expected{
            "mr_t1_head/mr_t1_head.nii.gz", {160, 232, 160}, {1.0, 0.8984, 0.8984}, "uint8", {0, 512}, true},
        Expected{
            "mr_t1_head/label_Skull.nrrd", {160, 232, 160}, {1.0, 0.8984, 0.8984}, "uint8", {0, 1}, true},
        Expected{
            "mr_t1_head/label_Brain.nrrd", {160, 232, 160}, {1.0, 0.8984, 0.8984}, "uint8", {0, 1}, true},
        Expected{"mr_t1_head/label_BrainSkull.nrrd",
                 {160, 232, 160},
                 {1.0, 0.8984, 0.8984},
                 "uint8",
                 {0, 1},
                 true},
        Expected{"mr_brain_nrrd/brain1_image.nrrd",
                 {256, 256, 25},
                 {0.78125, 0.78125, 6.5},
                 "int16",
                 {0, 3057},
                 true},
        Expected{"mr_brain_nrrd/brain1_label.nrrd",
                 {256, 256, 25},
                 {0.78125, 0.78125, 6.5},
                 "int32",
                 {0, 1},
                 true},
        Expected{"classic/bonsai.nii.gz", {256, 256, 256}, {1, 1, 1}, "uint8", {0, 255}, true},
        Expected{"classic/bonsai_mhd/bonsai.mhd", {256, 256, 256}, {1, 1, 1}, "uint8", {0, 255}, true},
        Expected{"classic/engine.nii.gz", {256, 256, 128}, {1, 1, 1}, "uint8", {0, 255}, true},
        Expected{"classic/engine_png_stack", {256, 256, 128}, {1, 1, 1}, "uint8", {0, 255}, false},
        Expected{"classic/fuel.nii.gz", {64, 33, 32}, {1, 1, 1}, "uint8", {0, 255}, true},
        Expected{"classic/tooth/tooth.nhdr", {103, 94, 161}, {1, 1, 1}, "uint16", {0, 1300}, false},
        Expected{
            "classic/tooth/tooth_u16_deflate.tif", {103, 94, 161}, {1, 1, 1}, "uint16", {0, 1300}, false},
        Expected{"classic/hydrogen_float32_base64.vti", {64, 64, 64}, {1, 1, 1}, "float32", {0, 1}, false}));

std::shared_ptr<const Volume> readShared(const std::string& file) {
  return readVolume(test::sharedFolder() / "data" / file);
}

// The means of `image` at the world positions of the set and of the unset voxels of `label`.
struct Means {
  double inside = 0.0;
  double outside = 0.0;
  std::size_t insideCount = 0;
};

// `mirror` flips the axes of the world about the centre of the image where it is -1.
Means meansUnder(const Volume& image, const Volume& label, const glm::dvec3& mirror = glm::dvec3(1.0)) {
  const glm::dvec3 centre = boxCentreMm(image.grid());
  glm::dvec2 sum(0.0), count(0.0);
  const glm::ivec3 dims = label.grid().dims;
  for (int k = 0; k < dims.z; k += 2)
    for (int j = 0; j < dims.y; j += 2)
      for (int i = 0; i < dims.x; i += 2) {
        const glm::dvec3 world = indexToWorld(label.grid(), {i, j, k});
        const glm::dvec3 index = worldToIndex(image.grid(), centre + mirror * (world - centre));
        const glm::ivec3 nearest(glm::round(index));
        if (glm::any(glm::lessThan(nearest, glm::ivec3(0))) ||
            glm::any(glm::greaterThanEqual(nearest, image.grid().dims)))
          continue;
        const int side = label.value({i, j, k}) > 0.5 ? 1 : 0;
        sum[side] += image.value(nearest);
        count[side] += 1.0;
      }
  return {sum[1] / count[1], sum[0] / count[0], static_cast<std::size_t>(count[1])};
}

// A NIfTI image (RAS) and its NRRD labels (LPS) have opposite index axes x and y and one world: the boxes
// coincide (the labels' origin is rounded to five figures), and the dark bone of the T1 image lies under the
// skull label. Measured: mean 120.5 in place, 126.2 to 166.5 when any axis is turned round about the centre.
TEST(RealVolumes, leftIsLeftInNiftiAndNrrd) {
  LIMN_NEEDS_SHARED("data/mr_t1_head/label_Skull.nrrd");
  const auto head = readShared("mr_t1_head/mr_t1_head.nii.gz");
  const auto skull = readShared("mr_t1_head/label_Skull.nrrd");
  EXPECT_LT(glm::distance(boxCentreMm(head->grid()), boxCentreMm(skull->grid())), 0.01);
  EXPECT_NEAR(glm::dot(head->grid().direction[0], skull->grid().direction[0]), -1.0, 1e-6);
  EXPECT_NEAR(glm::dot(head->grid().direction[1], skull->grid().direction[1]), -1.0, 1e-6);
  EXPECT_NEAR(glm::dot(head->grid().direction[2], skull->grid().direction[2]), 1.0, 1e-6);
  const Means inPlace = meansUnder(*head, *skull);
  ASSERT_GT(inPlace.insideCount, 20000u);
  for (const glm::dvec3& mirror :
       {glm::dvec3(-1, 1, 1), glm::dvec3(1, -1, 1), glm::dvec3(1, 1, -1), glm::dvec3(-1, -1, 1)})
    EXPECT_GT(meansUnder(*head, *skull, mirror).inside, inPlace.inside + 5.0);
}

// Measured: mean 199 inside the brain's label, 74 outside; 183 to 193 inside when turned round other than
// left to right, where the head is too symmetric for a mean to tell.
TEST(RealVolumes, theBrainLabelLiesOnBrain) {
  LIMN_NEEDS_SHARED("data/mr_t1_head/label_Brain.nrrd");
  const auto head = readShared("mr_t1_head/mr_t1_head.nii.gz");
  const Means means = meansUnder(*head, *readShared("mr_t1_head/label_Brain.nrrd"));
  ASSERT_GT(means.insideCount, 50000u);
  EXPECT_GT(means.inside, 2.5 * means.outside);
  for (const glm::dvec3& mirror : {glm::dvec3(1, -1, 1), glm::dvec3(1, 1, -1), glm::dvec3(-1, -1, 1)})
    EXPECT_LT(meansUnder(*head, *readShared("mr_t1_head/label_Brain.nrrd"), mirror).inside,
              means.inside - 5.0);
}

TEST(RealVolumes, theBonsaiIsTheSameInNiftiAndMetaImage) {
  LIMN_NEEDS_SHARED("data/classic/bonsai.nii.gz");
  EXPECT_EQ(readShared("classic/bonsai.nii.gz")->stored(),
            readShared("classic/bonsai_mhd/bonsai.mhd")->stored());
}

TEST(RealVolumes, theToothIsTheSameInNrrdAndTiff) {
  LIMN_NEEDS_SHARED("data/classic/tooth/tooth.nhdr");
  EXPECT_EQ(readShared("classic/tooth/tooth.nhdr")->stored(),
            readShared("classic/tooth/tooth_u16_deflate.tif")->stored());
}

TEST(RealVolumes, theEngineIsTheSameInNiftiAndPictures) {
  LIMN_NEEDS_SHARED("data/classic/engine.nii.gz");
  EXPECT_EQ(readShared("classic/engine.nii.gz")->stored(), readShared("classic/engine_png_stack")->stored());
}

} // namespace
} // namespace limn
