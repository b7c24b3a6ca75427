// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookText.h"

#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/VtkProperty.h"

namespace limn {
namespace {

const glm::dvec3 plain{1.0};

TEST(LookUnits, gradientsOfVtkAreDividedByTheMeanSpacing) {
  // 50 per voxel of 0.5 mm are 100/mm.
  std::vector<Message> changes;
  const LookTarget target{0.0, 1000.0, 0.5};
  const auto opacity = gradientOpacityFromVtk({{0.0, plain, 0.2}, {50.0, plain, 1.0}}, target, changes);
  ASSERT_TRUE(opacity);
  EXPECT_EQ(opacity->points[1].gradient, 100.0);
  EXPECT_TRUE(test::isTold(changes, "voxels of 0.5 mm"));
  const auto back = gradientOpacityForVtk(opacity, target, changes);
  EXPECT_EQ(back[1].gradient, 50.0);
}

TEST(LookUnits, withoutAVolumeVoxelsOfOneMillimetreAreTakenAndSaid) {
  std::vector<Message> changes;
  const auto opacity = gradientOpacityFromVtk({{0.0, plain, 0.2}, {50.0, plain, 1.0}}, {}, changes);
  EXPECT_EQ(opacity->points[1].gradient, 50.0);
  EXPECT_TRUE(test::isTold(changes, "--for"));
}

TEST(LookUnits, aGradientOpacityOfOneIsNoneAndBelowZeroThereAreNoGradients) {
  std::vector<Message> changes;
  EXPECT_FALSE(gradientOpacityFromVtk({{0.0, plain, 1.0}, {255.0, plain, 1.0}}, {}, changes));
  EXPECT_FALSE(
      gradientOpacityFromVtk({{-10.0, plain, 0.0}, {-1.0, plain, 1.0}, {90.0, plain, 1.0}}, {}, changes));
  EXPECT_TRUE(changes.empty()) << "it is the same picture";
  const auto cut = gradientOpacityFromVtk({{-10.0, plain, 0.0}, {10.0, plain, 1.0}}, LookTarget{}, changes);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->points.front(), (GradientOpacityPoint{0.0, 0.5}));
}

TEST(LookUnits, valuesOfZeroToOneAreStretchedOverTheVolume) {
  const TransferFunction relative{1.0, {{0.0, plain, 0.0}, {0.25, plain, 0.5}, {1.0, plain, 1.0}}};
  const LookTarget target{-1000.0, 3000.0, 1.0};
  std::vector<Message> changes;
  const TransferFunction stretched = stretchedOver(relative, target, changes);
  EXPECT_EQ(stretched.points[0].value, -1000.0);
  EXPECT_EQ(stretched.points[1].value, 0.0);
  EXPECT_EQ(stretched.points[2].value, 3000.0);
  EXPECT_EQ(stretched.points[1].opacity, 0.5);
  EXPECT_TRUE(test::isTold(changes, "stretched over -1000 to 3000"));
}

TEST(LookUnits, opacitiesOverAnotherLengthAreConverted) {
  const TransferFunction function{2.0, {{0.0, plain, 0.0}, {100.0, plain, 0.96}}};
  std::vector<Message> changes;
  const TransferFunction overOne = overOneMillimetre(function, changes);
  EXPECT_EQ(overOne.unitDistanceMm, 1.0);
  // Over half the length an opacity a is 1 - sqrt(1 - a): 0.8 for 0.96.
  const auto expected = [&](double value) {
    return Classified{plain, 1.0 - std::sqrt(1.0 - 0.96 * std::clamp(value / 100.0, 0.0, 1.0))};
  };
  EXPECT_LE(test::largestDifference(overOne, expected, 0.0, 100.0), 0.01);
  EXPECT_NEAR(overOne.points.back().opacity, 0.8, 1e-12);
  EXPECT_TRUE(test::isTold(changes, "2 mm"));
}

TEST(LookUnits, lightOfVtkIsTakenWithoutLossAndGivenBack) {
  std::vector<Message> changes;
  const HeadLight light{true, 0.15, 0.28, 1.42, 50.0, Reflection::phong};
  const Shading shading = shadingOf(light, changes);
  EXPECT_EQ(shading.reflection, Reflection::phong);
  EXPECT_EQ(shading.specular, 1.42) << "more than 1 occurs and stays";
  EXPECT_EQ(shading.specularColor, SpecularColor::light);
  const HeadLight back = headLightOf(shading, Reflection::phong, changes);
  EXPECT_EQ(back.exponent, 50.0);
  EXPECT_EQ(back.specular, 1.42);
  EXPECT_TRUE(changes.empty()) << test::allOf(changes);
}

TEST(LookUnits, highlightsOfBlinnAndPhongAreAsWideAsEachOther) {
  // The half vector turns by half the angle: cos(t/2)^n falls to a half where cos(t)^(n/4) nearly does.
  for (const double exponent : {16.0, 64.0, 200.0}) {
    const double blinn = 2.0 * std::acos(std::pow(0.5, 1.0 / exponent));
    const double phong = std::acos(std::pow(0.5, 1.0 / phongExponent(exponent)));
    EXPECT_NEAR(phong / blinn, 1.0, 0.05) << exponent;
  }
  std::vector<Message> changes;
  Shading shading;
  shading.exponent = 32.0;
  shading.model = ShadingModel::robust;
  EXPECT_EQ(headLightOf(shading, Reflection::phong, changes).exponent, 8.0);
  EXPECT_TRUE(test::isTold(changes, "32"));
  EXPECT_TRUE(test::isTold(changes, "robust"));
  EXPECT_TRUE(test::isTold(changes, "white"));
}

} // namespace
} // namespace limn
