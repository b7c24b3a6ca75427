// SPDX-License-Identifier: GPL-3.0-or-later
#include "SyntheticSeries.h"
#include "support/TestData.h"

#include <cmath>

namespace limn::test {
namespace {

// Expected figures come from the MANIFEST of the shared data unless a comment says otherwise.

std::shared_ptr<const Volume> read(const std::string& relative) {
  return readDicom(sharedFolder() / "data" / relative, {}, {});
}

/// The largest difference of scalars over the voxels that both grids have; they start at the same voxel.
double largestDifference(const Volume& a, const Volume& b) {
  const glm::ivec3 dims = glm::min(a.grid().dims, b.grid().dims);
  double largest = 0.0;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        largest = std::max(largest, std::abs(a.value({i, j, k}) - b.value({i, j, k})));
  return largest;
}

TEST(RealDicom, theHeadCtIsReadWhole) {
  LIMN_NEEDS_SHARED("data/ct_head_cranium/dicom_explicit_le");
  const auto volume = read("ct_head_cranium/dicom_explicit_le");
  EXPECT_EQ(volume->grid().dims, glm::ivec3(256, 256, 108));
  EXPECT_NEAR(volume->grid().spacingMm.x, 0.957, 1e-3);
  EXPECT_NEAR(volume->grid().spacingMm.y, 0.957, 1e-3);
  EXPECT_NEAR(volume->grid().spacingMm.z, 1.5, 1e-9);
  EXPECT_EQ(volume->range(), (ValueRange{-1024.0, 2986.0}));
  EXPECT_EQ(voxelTypeName(volume->stored()), "uint16");
  EXPECT_EQ(volume->grid().direction, glm::dmat3(1.0));
  EXPECT_EQ(volume->info().unit, "HU");
  EXPECT_TRUE(volume->info().warnings.empty());
  EXPECT_EQ(volume->info().patient.name, "CRANIUM, INVESALIUS");
}

TEST(RealDicom, theEnhancedHeadCtsHoldTheSameVoxels) {
  LIMN_NEEDS_SHARED("data/ct_head_cranium/enhanced_108_jpegls.dcm");
  const auto series = read("ct_head_cranium/dicom_explicit_le");
  const auto whole = read("ct_head_cranium/enhanced_108_jpegls.dcm");
  EXPECT_EQ(whole->grid(), series->grid());
  EXPECT_EQ(whole->stored(), series->stored());
  for (const char* file : {"uncompressed", "jpeg_lossless", "j2k_lossless"}) {
    const auto part = read(std::string("ct_head_cranium/enhanced_24_") + file + ".dcm");
    EXPECT_EQ(part->grid().dims, glm::ivec3(256, 256, 24)) << file;
    EXPECT_EQ(part->grid().originMm, series->grid().originMm) << file;
    EXPECT_EQ(largestDifference(*part, *series), 0.0) << file;
    EXPECT_TRUE(part->info().warnings.empty()) << file;
  }
}

struct Variant {
  const char* folder;
  double firstSlice; ///< largest difference there
  double allSlices;
};

TEST(RealDicom, everyTransferSyntaxGivesTheSameVoxelsOrStatesItsLoss) {
  LIMN_NEEDS_SHARED("data/ct_head_cranium/ts_variants");
  const auto series = read("ct_head_cranium/dicom_explicit_le");
  // The MANIFEST's 11 for lossy JPEG 2000 is the figure of the first slice. Over all eight it is 14 (five of
  // 524288 voxels exceed 11), which a second reader of these codestreams, ImageMagick, gives as well.
  const Variant variants[] = {{"implicit_le", 0.0, 0.0},
                              {"explicit_be", 0.0, 0.0},
                              {"deflated", 0.0, 0.0},
                              {"jpeg_lossless_sv1", 0.0, 0.0},
                              {"jpegls_lossless", 0.0, 0.0},
                              {"j2k_lossless", 0.0, 0.0},
                              {"rle", 0.0, 0.0},
                              {"jpeg_extended_12bit_lossy", 8.0, 8.0},
                              {"jpegls_near", 3.0, 3.0},
                              {"j2k_lossy", 11.0, 14.0}};
  for (const auto& [folder, firstSlice, allSlices] : variants) {
    const std::string path = std::string("ct_head_cranium/ts_variants/") + folder;
    const auto volume = read(path);
    EXPECT_EQ(volume->grid().dims, glm::ivec3(256, 256, 8)) << folder;
    EXPECT_EQ(volume->grid().originMm, series->grid().originMm) << folder;
    EXPECT_LE(largestDifference(*volume, *series), allSlices) << folder;
    EXPECT_LE(largestDifference(*read(path + "/IM0001.dcm"), *series), firstSlice) << folder;
    EXPECT_EQ(warns(*volume, "compressed with loss"), allSlices > 0.0) << folder;
  }
}

TEST(RealDicom, theFoldersOfOneSeriesAreNotMixed) {
  LIMN_NEEDS_SHARED("data/ct_head_cranium/ts_variants");
  const auto list = openDicom(sharedFolder() / "data/ct_head_cranium/ts_variants", {})->summaries();
  ASSERT_EQ(list.size(), 10u);
  for (const SeriesSummary& series : list)
    EXPECT_EQ(series.dims, glm::ivec3(256, 256, 8));
}

TEST(RealDicom, theTiltedPhantomStandsUprightAndEveryVoxelStaysInItsPlace) {
  LIMN_NEEDS_SHARED("data/ct_head_phantom_tilt_dicom");
  const auto volume = read("ct_head_phantom_tilt_dicom");
  const Grid& grid = volume->grid();
  EXPECT_TRUE(warns(*volume, "slant by 18.5°"));
  EXPECT_EQ(grid.dims.x, 512);
  EXPECT_EQ(grid.dims.z, 54);
  EXPECT_NEAR(grid.spacingMm.z, 2.371, 1e-3);
  EXPECT_NEAR(glm::determinant(grid.direction), 1.0, 1e-9);
  // Slices I10, I300 and I540 alone, each placed by its own header: at the world position of its voxels the
  // upright volume holds their value, up to the interpolation across one row, here at most half the
  // difference to the neighbours in that column.
  for (const char* name : {"I10", "I300", "I540"}) {
    const auto slice = read(std::string("ct_head_phantom_tilt_dicom/") + name);
    int compared = 0;
    for (int j = 100; j < 412; j += 3)
      for (int i = 100; i < 412; i += 3) {
        const glm::dvec3 index = worldToIndex(grid, indexToWorld(slice->grid(), {i, j, 0}));
        const double here = slice->value({i, j, 0});
        const double above = slice->value({i, j - 1, 0});
        const double below = slice->value({i, j + 1, 0});
        const double slack = std::max(std::abs(here - above), std::abs(here - below)) + 2.0;
        EXPECT_NEAR(index.z, std::round(index.z), 1e-2);
        const glm::dvec3 onPlane(index.x, index.y, std::round(index.z));
        EXPECT_NEAR(valueAt(*volume, onPlane), here, slack) << name << " " << i << " " << j;
        ++compared;
      }
    EXPECT_EQ(compared, 104 * 104);
  }
}

TEST(RealDicom, theMrHeadAveragesItsDistancesAndLeavesPaddingOut) {
  LIMN_NEEDS_SHARED("data/mr_pd_head_dicom");
  const auto volume = read("mr_pd_head_dicom");
  EXPECT_EQ(volume->grid().dims, glm::ivec3(256, 256, 20));
  EXPECT_EQ(volume->range(), (ValueRange{1.0, 1059.0}));
  EXPECT_NEAR(static_cast<double>(volume->invalidVoxels()) / volume->voxelCount(), 0.26, 0.005);
  EXPECT_TRUE(warns(*volume, "6.958 to 7.071 mm apart"));
  EXPECT_EQ(volume->info().modality, "MR");
  EXPECT_EQ(volume->info().unit, "");
}

TEST(RealDicom, oneMrImageIsTheSameInEveryEncoding) {
  LIMN_NEEDS_SHARED("data/odd_dicom");
  const auto plain = read("odd_dicom/MR_small.dcm");
  EXPECT_EQ(plain->grid().dims, glm::ivec3(64, 64, 1));
  for (const char* name : {"RLE", "bigendian", "implicit", "jp2klossless", "jpeg_ls_lossless", "padded"})
    EXPECT_EQ(read(std::string("odd_dicom/MR_small_") + name + ".dcm")->stored(), plain->stored()) << name;
  const auto enhanced = read("odd_dicom/emri_small.dcm");
  EXPECT_EQ(enhanced->grid().dims, glm::ivec3(64, 64, 10));
  EXPECT_FALSE(enhanced->info().orientationKnown);
  for (const char* name : {"RLE", "jpeg_2k_lossless"})
    EXPECT_EQ(read(std::string("odd_dicom/emri_small_") + name + ".dcm")->stored(), enhanced->stored())
        << name;
}

TEST(RealDicom, oneCtImageTellsWhatItIs) {
  LIMN_NEEDS_SHARED("data/odd_dicom");
  const auto volume = read("odd_dicom/CT_small.dcm");
  EXPECT_EQ(volume->grid().dims, glm::ivec3(128, 128, 1));
  EXPECT_NEAR(volume->grid().spacingMm.x, 0.661468, 1e-6); // (0028,0030) of the file
  EXPECT_EQ(volume->grid().spacingMm.z, 5.0);              // (0018,0050)
  EXPECT_EQ(volume->info().unit, "HU");
  EXPECT_TRUE(volume->info().orientationKnown);
  EXPECT_TRUE(warns(*volume, "single image"));
  EXPECT_EQ(read("odd_dicom/no_meta.dcm")->stored(), volume->stored());
}

TEST(RealDicom, aSignTheCodestreamDoesNotKnowIsTakenFromTheHeader) {
  LIMN_NEEDS_SHARED("data/odd_dicom");
  const auto volume = read("odd_dicom/J2K_pixelrep_mismatch.dcm");
  // pydicom's tests give these values for the pixels (279, 47 … 56) and (106, 328 … 337) of the file.
  const int across[] = {621, 412, 138, -193, -520, -767, -907, -966, -988, -995};
  const int along[] = {-377, -121, 141, 383, 633, 910, 1198, 1455, 1638, 1732};
  EXPECT_EQ(volume->value({0, 0, 0}), -2000.0);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(volume->value({279, 47 + i, 0}), across[i]);
    EXPECT_EQ(volume->value({106, 328 + i, 0}), along[i]);
  }
}

TEST(RealDicom, theOddFilesOpenOrSayWhyNot) {
  LIMN_NEEDS_SHARED("data/odd_dicom");
  const auto odd = sharedFolder() / "data/odd_dicom";
  EXPECT_EQ(read("odd_dicom/image_dfl.dcm")->grid().dims, glm::ivec3(512, 512, 1));
  const auto twelveBits = read("odd_dicom/JPGExtended.dcm");
  EXPECT_EQ(twelveBits->grid().dims, glm::ivec3(256, 1024, 1));
  EXPECT_TRUE(warns(*twelveBits, "compressed with loss (76 : 1)"));
  EXPECT_NE(dicomRefusal(odd / "MR_truncated.dcm").find("need 8192 bytes, and it holds 8130"),
            std::string::npos);
  EXPECT_NE(dicomRefusal(odd / "rtplan.dcm").find("holds no image"), std::string::npos);
  EXPECT_NE(dicomRefusal(odd / "badVR.dcm").find("'1A' as its number of frames"), std::string::npos);
}

} // namespace
} // namespace limn::test
