// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/OrientationMarks.h"
#include "widgets/view/overlay/Titles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

OrientationLetters lettersFrom(StandardView view) {
  Grid grid;
  grid.dims = {10, 20, 30};
  return orientationLetters(standardView(Camera{}, grid, view));
}

// Radiological convention: what is shown is seen from the named side, so from the front the patient's left
// is on the right; from above, with the face towards the top, the patient's left is on the left.
TEST(OrientationLetters, ofTheSixStandardViews) {
  EXPECT_EQ(lettersFrom(StandardView::anterior), (OrientationLetters{"R", "L", "S", "I"}));
  EXPECT_EQ(lettersFrom(StandardView::posterior), (OrientationLetters{"L", "R", "S", "I"}));
  EXPECT_EQ(lettersFrom(StandardView::left), (OrientationLetters{"A", "P", "S", "I"}));
  EXPECT_EQ(lettersFrom(StandardView::right), (OrientationLetters{"P", "A", "S", "I"}));
  EXPECT_EQ(lettersFrom(StandardView::superior), (OrientationLetters{"L", "R", "A", "P"}));
  EXPECT_EQ(lettersFrom(StandardView::inferior), (OrientationLetters{"R", "L", "A", "P"}));
}

TEST(OrientationLetters, ofAnObliqueDirectionNameTheStrongestAxisFirst) {
  EXPECT_EQ(lettersOf({0.8, -0.6, 0.0}), "LA");
  EXPECT_EQ(lettersOf({-0.3, 0.2, -0.93}), "IR"); // 0.2 is further than 75° away
}

TEST(ScaleBar, hasTheLongestRoundLengthThatFits) {
  EXPECT_EQ(scaleBar(0.5, 150.0).lengthMm, 50.0); // 75 mm fit
  EXPECT_EQ(scaleBar(0.5, 150.0).pixels, 100.0);
  EXPECT_EQ(scaleBar(1.0, 20.0).lengthMm, 20.0);
  EXPECT_EQ(scaleBar(1.0, 199.0).lengthMm, 100.0);
  EXPECT_EQ(scaleBar(0.0, 100.0).pixels, 0.0);
}

TEST(ScaleBar, millimetresPerPixelHoldAtTheTarget) {
  const Camera perspective{.position = {0, -100, 0}, .target = {0, 0, 0}, .fovYDeg = 90.0};
  EXPECT_NEAR(mmPerPixel(perspective, 400.0), 0.5, 1e-12); // 2 · 100 mm · tan 45° over 400 pixels
  EXPECT_NEAR(mmPerPixel(perspective, 400.0, glm::dvec3(30, -60, 0)), 0.2, 1e-12) << "40 mm before the eye";
  for (const double behind : {-160.0, -100.0, -99.5}) // 60 mm behind it, in it, at less than a hundredth
    EXPECT_NEAR(mmPerPixel(perspective, 400.0, glm::dvec3(0, behind, 0)), 0.5, 1e-12) << behind;
  const Camera parallel{.projection = Camera::Projection::orthographic, .heightMm = 200.0};
  EXPECT_EQ(mmPerPixel(parallel, 400.0), 0.5);
}

TEST(ScaleBar, aTargetAsDeepAsThePivotLeavesWhatIsSeen) {
  const Camera camera{.position = {10, -100, 5}, .target = {0, 20, 0}, .fovYDeg = 40.0};
  const glm::dvec3 pivot(30, -60, 8);
  const Camera moved = withTargetAsDeepAs(camera, pivot);
  // Rounding of unit vectors and of sums of a hundred millimetres.
  EXPECT_NEAR(glm::length(basisOf(moved).forward - basisOf(camera).forward), 0.0, 1e-14);
  EXPECT_NEAR(glm::dot(moved.target - pivot, basisOf(camera).forward), 0.0, 1e-12);
  EXPECT_NEAR(mmPerPixel(moved, 400.0), mmPerPixel(camera, 400.0, pivot), 1e-12);
  EXPECT_EQ(withTargetAsDeepAs(camera, glm::dvec3(0, -160, 0)), camera) << "behind the eye";
  EXPECT_EQ(withTargetAsDeepAs(camera, std::nullopt), camera);
}

TEST(SideText, namesTheFewNumbersThatMatter) {
  Scene scene;
  EXPECT_EQ(sideDetails(scene, {}), QStringList(QString::fromUtf8("SP 32")));
  scene.shading.model = ShadingModel::enhanced;
  SideState state;
  state.completeMs = 23.4;
  EXPECT_EQ(sideDetails(scene, state), (QStringList{"23 ms", "SP 1–64 · O 0–3"}));
  state.contrast = 0.2017;
  state.overflow = Overflow{0.0283, 0.1};
  state.estimate = ErrorEstimate{0.42, 0.0, 1.0};
  state.isRough = false;
  EXPECT_EQ(sideDetails(scene, state), (QStringList{"within 0.4 levels", "23 ms", "SP 1–64 · O 0–3"}))
      << "what is told of its light stands in the status bar";
  state.chance = ErrorByChance{0.912, 0.005, 0.6, 2995};
  EXPECT_EQ(sideDetails(scene, state).first(), QStringLiteral("within 0.92 levels"))
      << "as the status bar says";
  state.measuredLevels = 0.5;
  EXPECT_EQ(sideDetails(scene, state).first(), QStringLiteral("within 0.92 levels"))
      << "a smaller picture was measured";
  state.measuredLevels.reset();
  state.chance.reset();
  state.onTheWay = PathFigures{64, 0.1, 0.3};
  EXPECT_EQ(sideDetails(scene, state).first(), QStringLiteral("within 0.3 levels"))
      << "as it is shown by now";
  state.onTheWay.reset();
  scene.shading.gradientSmoothing = 4.55;
  EXPECT_EQ(sideDetails(scene, state).last(),
            QStringLiteral("SP 1–64 · O 0–3 · normals smoothed by 4.55 mm"));
  EXPECT_EQ(sideTitle(scene), QString::fromUtf8("Enhanced"));
  scene.projection = Projection::mip;
  EXPECT_EQ(sideTitle(scene), QString::fromUtf8("Maximum (MIP)"));
  state = {};
  state.completeMs = 4.16;
  EXPECT_EQ(sideDetails(scene, state), (QStringList{"4.2 ms", "unlit, the same with every model"}));
}

} // namespace
} // namespace limn
