// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/PictureStatus.h"
#include "scene/volume/Phantom.h"

#include <QTextDocument>

#include <gtest/gtest.h>

namespace limn {
namespace {

SideState sideWithin(double levels, double stepVoxels = 0.25) {
  SideState side;
  side.stepVoxels = stepVoxels;
  side.shownMs = 11.6;
  side.isRough = false;
  side.estimate = ErrorEstimate{levels, 0.1 * levels, 1.5};
  return side;
}

PictureState resting(std::vector<SideState> sides) {
  PictureState state;
  state.sides = std::move(sides);
  state.resting = true;
  return state;
}

std::string lineOf(const PictureState& state) {
  return pictureStatusText(state, {}).line().toStdString();
}

TEST(PictureStatusText, tellsErrorStepAndTimeOfThePictureAtRest) {
  EXPECT_EQ(lineOf(resting({sideWithin(0.74)})),
            "estimated within 0.7 of 255 levels · step 1/4 voxel · 12 ms · OpenGL");
  EXPECT_EQ(lineOf({}), "") << "no picture";
}

TEST(PictureStatusText, isAToolTipWhoseLongLinesAreBroken) {
  PictureStatus status;
  PictureStatusText text;
  text.toolTip = QStringLiteral("an error < 1\nof physical light");
  status.setText(text);
  EXPECT_TRUE(Qt::mightBeRichText(status.toolTip())) << status.toolTip().toStdString();
  EXPECT_TRUE(status.toolTip().contains(QStringLiteral("an error &lt; 1<br>of physical light")))
      << status.toolTip().toStdString();
}

TEST(PictureStatusText, hasOneBadgeForWhatThePictureIs) {
  const auto badge = [](const PictureState& state) { return pictureStatusText(state, {}).badge; };
  PictureState state = resting({sideWithin(1.0), sideWithin(0.4)});
  EXPECT_EQ(badge(state), QStringLiteral("○ nearly exact")) << "as far as an estimate can tell";
  state.refines = true;
  EXPECT_EQ(badge(state), QStringLiteral("◐ refining"));
  state.refines = false;
  state.sides[0].chance = ErrorByChance{1.0, 0.005, 0.6, chancePixels};
  EXPECT_EQ(badge(state), QStringLiteral("○ nearly exact")) << "of one side pixels were drawn";
  state.sides[1].measuredLevels = 0.5;
  EXPECT_EQ(badge(state), QStringLiteral("● exact to the screen"));
  state.sides[0].chance.reset();
  state.sides[1].measuredLevels.reset();
  state.sides[1].estimate->p99_9 = 1.1;
  state.refines = true;
  EXPECT_EQ(badge(state), QStringLiteral("◐ refining"));
  state.sides[1].estimate.reset();
  EXPECT_EQ(badge(state), QStringLiteral("◐ refining")) << "nobody knows yet";
  state.resting = false;
  EXPECT_EQ(badge(state), QStringLiteral("○ preview"));
  EXPECT_EQ(badge(resting({sideWithin(12.4)})), QStringLiteral("○ not exact")) << "and not to be refined";
  state = resting({sideWithin(0.2)});
  state.sides[0].isResolved = false;
  EXPECT_EQ(badge(state), QStringLiteral("○ not resolved"));
}

TEST(PictureStatusText, whoAsksIsToldContrastAndOverflowOfThePicturesAtRest) {
  PictureState state = resting({sideWithin(1.0), sideWithin(0.4)});
  state.sides[0].contrast = 0.2017;
  state.sides[1].contrast = 0.25;
  state.sides[1].overflow = Overflow{0.0283, 0.1};
  const QString tip = pictureStatusText(state, {}).toolTip;
  EXPECT_TRUE(tip.contains(QStringLiteral("Light at the left: contrast 0.202 (RMS)."))) << tip.toStdString();
  EXPECT_TRUE(
      tip.contains(QStringLiteral("at the right: contrast 0.250 (RMS), 2.8 % of the pixels brighter")))
      << tip.toStdString();
  state.resting = false;
  EXPECT_FALSE(pictureStatusText(state, {}).toolTip.contains(QStringLiteral("contrast")))
      << "of the last one";
}

TEST(PictureStatusText, tellsThatWhatMovesHasFewerVoxelsAndHowFarTheyAreOff) {
  PictureState state = resting({sideWithin(1.0), sideWithin(0.4)});
  state.resting = false;
  state.sides[0].coarseness = Coarseness{4, 0.0312};
  state.sides[1].coarseness = Coarseness{8, 0.01};
  const PictureStatusText text = pictureStatusText(state, {});
  EXPECT_EQ(text.badge, QStringLiteral("○ preview, voxels 4× coarser")) << "the side that is off the most";
  EXPECT_EQ(text.step, QStringLiteral("preview from 1/4 of the voxels along each axis"));
  EXPECT_TRUE(text.toolTip.contains(QStringLiteral("at most 3.2 % of the range")))
      << text.toolTip.toStdString() << ": a bound is rounded up";
}

TEST(PictureStatusText, tellsTheWorseOfTwoSidesAndTheTimeOfBoth) {
  EXPECT_EQ(lineOf(resting({sideWithin(12.4), sideWithin(3.0)})),
            "estimated within 12 of 255 levels · step 1/4 voxel · 23 ms · OpenGL");
}

TEST(PictureStatusText, tellsWhatWasMeasuredInPlaceOfAnEstimate) {
  PictureState state = resting({sideWithin(0.76)});
  state.sides[0].measuredLevels = 0.347; // promised with two digits, rounded up, as the panel does
  EXPECT_TRUE(lineOf(state).starts_with("within 0.35 of 255 levels, measured in a smaller picture"))
      << lineOf(state);
  state.sides[0].estimate.reset();
  EXPECT_TRUE(lineOf(state).starts_with("within 0.35 of 255 levels, measured"));
}

TEST(PictureStatusText, tellsWhatChanceSaysOfThePictureInPlaceOfAnEstimate) {
  PictureState state = resting({sideWithin(0.76), sideWithin(0.3)});
  state.sides[0].chance = ErrorByChance{0.912, 0.005, 0.6, chancePixels};
  state.sides[1].chance = ErrorByChance{0.4, 0.005, 0.2, chancePixels};
  EXPECT_TRUE(lineOf(state).starts_with("99.9 % of pixels within 0.92 of 255 levels (95 % sure)"))
      << lineOf(state);
  const QString toolTip = pictureStatusText(state, {}).toolTip;
  EXPECT_TRUE(toolTip.contains(QStringLiteral("of 2995 drawn at random"))) << toolTip.toStdString();
  EXPECT_TRUE(pictureStatusText(state, {}).badge.contains(QStringLiteral("exact to the screen")));
  EXPECT_FALSE(toolTip.contains(QStringLiteral("99.9th percentile"))) << "one picture has one error";
  state.sides[0].chance->levels = 1.2;
  EXPECT_FALSE(pictureStatusText(state, {}).badge.contains(QStringLiteral("exact to the screen")))
      << "beside 1.2 levels, whatever was estimated";
  state.refinementEnd = RefinementEnd::withinHalfALevel;
  EXPECT_EQ(pictureStatusText(state, {}).badge, QStringLiteral("○ nearly exact"));
  EXPECT_TRUE(toolTip.contains(QStringLiteral("999 of 1000 lie within 0.6 levels"))) << toolTip.toStdString();
  state.sides[0].chance->levels = 2.58;
  EXPECT_EQ(pictureStatusText(state, {}).badge, QStringLiteral("○ nearly exact")) << "a single pixel is";
  state.sides[0].chance->p99_9 = 1.1;
  EXPECT_EQ(pictureStatusText(state, {}).badge, QStringLiteral("○ not exact")) << "more than one are";
  state.sides[0].chance->p99_9 = 0.6;
  state.sides[0].chance->levels = 11.65;
  EXPECT_EQ(pictureStatusText(state, {}).badge, QStringLiteral("○ not exact")) << "that is seen";
  state.sides[0].measuredLevels = 0.347;
  state.sides[1].measuredLevels = 0.2;
  EXPECT_TRUE(lineOf(state).starts_with("99.9 % of pixels within 12 of 255 levels (95 % sure)"))
      << "what was measured is of a smaller picture: " << lineOf(state);
  EXPECT_EQ(pictureStatusText(state, {}).badge, QStringLiteral("○ not exact")) << "whatever was measured";
  EXPECT_TRUE(pictureStatusText(state, {}).toolTip.contains(
      QStringLiteral("a smaller picture of the same scene were measured to lie within 0.35 levels")));
}

TEST(PictureStatusText, whoReadsThatItIsNotExactIsToldWhyAndWhatCanBeDone) {
  PictureState state = resting({sideWithin(0.5)});
  const auto tells = [&](const char* part) {
    return pictureStatusText(state, {}).toolTip.contains(QLatin1String(part));
  };
  EXPECT_TRUE(tells("while \"Sharpen while nothing moves\" is off"));
  state.refines = true;
  EXPECT_FALSE(tells("is off")) << "it is under way";
  state.refines = false;
  state.refinementEnd = RefinementEnd::withinHalfALevel;
  EXPECT_TRUE(tells("smaller ones would show no difference"));
  state.sides[0].chance = ErrorByChance{2.58, 0.005, 1.2, chancePixels};
  EXPECT_FALSE(tells("smaller ones would show no difference")) << "pixels say otherwise";
  EXPECT_TRUE(tells("\"Show where it is not exact\" in the accuracy panel"));
  state.sides[0].chance->levels = 0.9;
  EXPECT_FALSE(tells("Single pixels lie farther off"));
}

TEST(PictureStatusText, ofTwoPicturesSaysWhichIsWorseWhereOneWasMeasured) {
  PictureState state = resting({sideWithin(0.3), sideWithin(0.76)});
  EXPECT_TRUE(lineOf(state).starts_with("estimated within 0.8 of 255 levels"));
  state.sides[1].measuredLevels = 0.347;
  EXPECT_TRUE(lineOf(state).starts_with("right within 0.35 of 255 levels, measured")) << lineOf(state);
  state.sides[0].estimate->p99_9 = 2.0;
  EXPECT_TRUE(lineOf(state).starts_with("left estimated within 2.0 of 255 levels")) << lineOf(state);
}

TEST(PictureStatusText, whoAsksIsToldOfWhichPictureTheNumberIs) {
  const auto tip = [](const PictureState& state) { return pictureStatusText(state, {}).toolTip; };
  const QString left =
      QStringLiteral("This is the left picture; the right one lies closer to its exact one.");
  PictureState state = resting({sideWithin(0.3), sideWithin(0.76)});
  state.sides[0].chance = ErrorByChance{0.49, 0.005, 0.3, chancePixels};
  state.sides[1].chance = ErrorByChance{0.47, 0.005, 0.3, chancePixels};
  EXPECT_TRUE(tip(state).contains(QStringLiteral("0.49"))) << tip(state).toStdString();
  EXPECT_TRUE(tip(state).contains(left)) << tip(state).toStdString();
  state.sides[1].chance->levels = 0.5;
  EXPECT_TRUE(tip(state).contains(QStringLiteral("This is the right picture"))) << tip(state).toStdString();
  state.sides[0].chance->levels = 0.5;
  EXPECT_FALSE(tip(state).contains(QStringLiteral("This is the "))) << "both lie as far off";
  state.sides.pop_back();
  EXPECT_FALSE(tip(state).contains(QStringLiteral("This is the "))) << "there is one";
}

TEST(PictureStatusText, saysWhereAnEstimateIsRoughMissingOrWorthNothing) {
  PictureState state = resting({sideWithin(2.0), sideWithin(1.0)});
  state.sides[0].isRough = true;
  EXPECT_TRUE(lineOf(state).starts_with("estimated within about 2.0 of 255 levels"));
  state.sides[1].estimate.reset();
  EXPECT_TRUE(lineOf(state).starts_with("estimating…"));
  state.sides[1].isResolved = false;
  EXPECT_TRUE(lineOf(state).starts_with("not resolved")) << "however good a number the other side has";
}

TEST(PictureStatusText, neverClaimsThatThereIsNoErrorNorMoreThanThereCanBe) {
  EXPECT_TRUE(lineOf(resting({sideWithin(0.0)})).starts_with("estimated within 0.1 of 255 levels"));
  EXPECT_TRUE(lineOf(resting({sideWithin(400.0)})).starts_with("estimated within 255 of 255 levels"));
}

TEST(PictureStatusText, saysHowCoarseThePreviewIs) {
  PictureState state = resting({sideWithin(20.0, 1.0)});
  state.resting = false;
  state.sides[0].imageScale = 0.375;
  EXPECT_EQ(pictureStatusText(state, {}).step.toStdString(), "preview at 3/8 resolution");
  state.sides[0].imageScale = 1.0;
  EXPECT_EQ(pictureStatusText(state, {}).step.toStdString(), "preview, step 1 voxel");
}

TEST(PictureStatusText, saysThatItRefinesAndWhyItStopped) {
  PictureState state = resting({sideWithin(0.4, 1.0 / 64.0)});
  const auto step = [&] { return pictureStatusText(state, {}).step.toStdString(); };
  state.refines = true;
  EXPECT_EQ(step(), "step 1/64 voxel, refining");
  state.refines = false;
  const std::pair<RefinementEnd, const char*> ends[] = {
      {RefinementEnd::withinHalfALevel, "refined, step 1/64 voxel"},
      {RefinementEnd::smallestStep, "smallest step, 1/64 voxel"},
      {RefinementEnd::sampleLimit, "smallest possible step, 1/64 voxel"},
      {RefinementEnd::patience, "smallest practical step, 1/64 voxel"},
      {RefinementEnd::failed, "step 1/64 voxel, not refined"}};
  for (const auto& [end, text] : ends) {
    state.refinementEnd = end;
    EXPECT_EQ(step(), text);
  }
}

TEST(PictureStatusText, tellsOfErrorControlledStepsTheirTolerance) {
  PictureState state = resting({sideWithin(0.46)});
  state.sides[0].toleranceLevels = 0.5;
  state.refinementEnd = RefinementEnd::withinHalfALevel;
  EXPECT_EQ(lineOf(state),
            "estimated within 0.5 of 255 levels · refined, step chosen by error · 12 ms · OpenGL");
  const QString tip = pictureStatusText(state, {}).toolTip;
  EXPECT_TRUE(tip.contains(QStringLiteral("chosen by error, meant for 0.5 of 255 levels")))
      << tip.toStdString();
  EXPECT_FALSE(tip.contains(QStringLiteral("order"))) << "which no halving has shown";
}

TEST(PictureStatusText, namesStepsSoThatTheyCanBeTyped) {
  EXPECT_EQ(stepText(1.0 / 16.0), QStringLiteral("1/16 voxel"));
  EXPECT_EQ(stepText(1.0), QStringLiteral("1 voxel"));
  EXPECT_EQ(stepText(2.0), QStringLiteral("2 voxels"));
  EXPECT_EQ(stepText(0.3 / 8.0), QStringLiteral("0.0375 voxel"));
  for (const double step : {0.3, 0.7, 1.1})
    for (int halvings = 0; halvings < 7; ++halvings) {
      const double smaller = step / (1 << halvings);
      EXPECT_EQ(stepText(smaller).section(QLatin1Char(' '), 0, 0).toDouble(), smaller);
    }
}

TEST(PictureStatusText, explainsTheNumbersInItsToolTip) {
  Scene scene;
  scene.volume = phantomVolume({8.0, 0.0, 1});
  const QString tip = pictureStatusText(resting({sideWithin(0.74)}), scene).toolTip;
  for (const char* part : {"999 of 1000", "step 1/4", "2 mm", "order 1.50", "0.74"})
    EXPECT_TRUE(tip.contains(QString::fromUtf8(part))) << part << "\n" << tip.toStdString();
}

TEST(PictureStatusText, ofPhysicalLightTellsItsPathsAndTheirError) {
  PictureState state;
  state.sides.resize(1);
  state.resting = state.refines = true;
  SideState& side = state.sides.front();
  side.stepVoxels = 0.5;
  side.paths = PathFigures{1, {}, {}};
  EXPECT_EQ(pictureStatusText(state, {}).estimate, QStringLiteral("1 path, estimating…"));
  side.paths = PathFigures{64, 1.3, 3.5};
  side.estimate = ErrorEstimate{3.5, 1.3, 1.0};
  const PictureStatusText text = pictureStatusText(state, {});
  EXPECT_EQ(text.estimate, QStringLiteral("within 1.3 levels RMS after 64 paths"));
  EXPECT_EQ(text.step, QStringLiteral("random paths, refining"));
  EXPECT_TRUE(text.toolTip.contains(QStringLiteral("64 paths of each pixel"))) << text.toolTip.toStdString();
  EXPECT_FALSE(text.toolTip.contains(QStringLiteral("step"))) << text.toolTip.toStdString();
  side.onTheWay = PathFigures{64, 1.1, 3.1};
  const PictureStatusText onTheWay = pictureStatusText(state, {});
  EXPECT_EQ(onTheWay.estimate, QStringLiteral("within 1.1 levels RMS after 64 paths"));
  EXPECT_TRUE(onTheWay.toolTip.contains(QStringLiteral("within 3.1"))) << onTheWay.toolTip.toStdString();
}

} // namespace
} // namespace limn
