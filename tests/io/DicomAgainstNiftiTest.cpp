// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/VolumeReader.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

namespace limn::test {
namespace {

TEST(DicomAgainstNifti, theHeadCtLiesAtTheSamePlaceInBothFormats) {
  LIMN_NEEDS_SHARED("data/ct_head_cranium/dicom_explicit_le");
  const auto folder = sharedFolder() / "data/ct_head_cranium";
  const auto dicom = readVolume(folder / "dicom_explicit_le");
  const auto nifti = readVolume(folder / "ct_head_cranium.nii.gz");
  ASSERT_EQ(dicom->grid().dims, nifti->grid().dims);
  EXPECT_EQ(dicom->range(), nifti->range());
  // The NIfTI file runs from back to front (LAS), the DICOM series from front to back (LPS): rows are
  // reversed.
  const glm::ivec3 dims = dicom->grid().dims;
  double farthest = 0.0;
  std::size_t different = 0;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) {
        const glm::ivec3 mirrored(i, dims.y - 1 - j, k);
        different += dicom->value({i, j, k}) != nifti->value(mirrored) ? 1 : 0;
        const glm::dvec3 offset =
            indexToWorld(dicom->grid(), {i, j, k}) - indexToWorld(nifti->grid(), mirrored);
        farthest = std::max(farthest, glm::length(offset));
      }
  EXPECT_EQ(different, 0u);
  // Both headers round: the spacing 0.9570312 (DICOM) differs from the float of NIfTI by 5e-8 relative, over
  // 122 mm.
  EXPECT_LT(farthest, 1e-4);
}

} // namespace
} // namespace limn::test
