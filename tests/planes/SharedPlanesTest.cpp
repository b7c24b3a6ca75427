// SPDX-License-Identifier: GPL-3.0-or-later
#include "Definition.h"

#include "io/VolumeReader.h"
#include "io/labels/LabelReader.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

using test::coveringPlane;

namespace fs = std::filesystem;

// Real volumes whose axes are not the patient's: 7.7° with 7 mm gaps, and a tilted gantry (18.5°).
class ObliqueVolumes : public testing::TestWithParam<const char*> {};

TEST_P(ObliqueVolumes, areResampledAsDefined) {
  const fs::path path = fs::path("data") / GetParam();
  LIMN_NEEDS_SHARED(path);
  const auto volume = readVolume(test::sharedFolder() / path);
  const glm::dvec3 place = boxCentreMm(volume->grid()) + glm::dvec3(3.3, -7.7, 5.1);
  for (const PatientPlane plane : patientPlanes)
    for (const PlaneInterpolation interpolation : planeInterpolations) {
      const PlaneGrid covering = coveringPlane(volume->grid(), plane, place);
      SCOPED_TRACE(std::string(nameOf(plane)) + " " + nameOf(interpolation));
      // Every third pixel, because the definition takes its time.
      test::expectDefined(*volume, covering, {interpolation, {}}, 3);
      test::expectDefined(*volume, covering, {interpolation, {Slab::Mode::maximum, 10.0}}, 7);
      test::expectDefined(*volume, covering, {interpolation, {Slab::Mode::mean, 10.0}}, 7);
    }
}

INSTANTIATE_TEST_SUITE_P(Shared, ObliqueVolumes,
                         testing::Values("mr_pd_head_dicom", "ct_head_phantom_tilt_dicom"),
                         [](const auto& test) { return std::string(test.param).substr(0, 5); });

// Index axes of labels and MR run opposite ways (LPS and RAS); in the patient they agree.
TEST(SharedPlanes, showLabelsWhereTheMrHasThem) {
  LIMN_NEEDS_SHARED("data/mr_t1_head/label_Brain.nrrd");
  const fs::path folder = test::sharedFolder() / "data/mr_t1_head";
  const auto mr = readVolume(folder / "mr_t1_head.nii.gz");
  const auto labels = readVolume(folder / "label_Brain.nrrd");
  Region onMr = readLabels(folder / "label_Brain.nrrd", mr->grid());
  ASSERT_EQ(onMr.weights.size(), 2u);
  onMr.weights = {0.0, 1.0};
  ASSERT_LT(glm::dot(mr->grid().direction[0], labels->grid().direction[0]), -0.9)
      << "else this shows nothing";
  for (const PatientPlane plane : patientPlanes) {
    SCOPED_TRACE(nameOf(plane));
    const PlaneGrid covering =
        coveringPlane(mr->grid(), plane, boxCentreMm(mr->grid()) + glm::dvec3(20.0, 0.0, 10.0));
    const PlaneImage own = reformatted(*labels, covering, {PlaneInterpolation::nearest, {}});
    const PlaneImage weights = weightsOn(onMr, mr->grid(), covering, PlaneInterpolation::nearest);
    const PlaneImage grey = reformatted(*mr, covering, {});
    int brain = 0, different = 0;
    double inside = 0.0, around = 0.0;
    int others = 0;
    for (std::size_t i = 0; i < own.values.size(); ++i) {
      if (std::isnan(own.values[i]) || std::isnan(weights.values[i]))
        continue;
      brain += own.values[i] > 0.5;
      different += (own.values[i] > 0.5) != (weights.values[i] > 0.5);
      (own.values[i] > 0.5 ? inside : around) += grey.values[i];
      others += own.values[i] <= 0.5;
    }
    EXPECT_GT(brain, 3000);
    // Their grids lie less than half a voxel from each other: only pixels at an edge may differ.
    EXPECT_LE(different, brain / 50);
    // White and grey matter of T1 are bright; around them lie air, bone and scalp.
    EXPECT_GT(inside / brain, 1.5 * around / others);
  }
}

} // namespace
} // namespace limn
