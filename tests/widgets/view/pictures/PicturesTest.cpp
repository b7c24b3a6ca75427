// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/Pictures.h"
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "engine/DrawingEngine.h"
#include "raycaster/RayCaster.h"
#include "raycaster/RayCasterEngine.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/GlTest.h"
#include "support/MappedVolume.h"
#include "support/ReferenceEngine.h"
#include "support/TemporaryFolder.h"
#include "widgets/view/pictures/PictureLoop.h"
#include "widgets/view/pictures/PictureScreen.h"
#include "widgets/view/pictures/StepSearch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

// Pictures on their way from coarse to exact, without a window, with every engine that there is.

namespace limn {
namespace {

constexpr glm::ivec2 pictureSize{60, 40};

Scene phantomWith(ShadingModel model) {
  static const std::shared_ptr<const Volume> volume = phantomVolume({8.0, 0.0, 1});
  return headScene(volume, model);
}

std::vector<Scene> bothModels() {
  return {phantomWith(ShadingModel::classic), phantomWith(ShadingModel::enhanced)};
}

void finish(Pictures& pictures, const std::vector<Scene>& scenes) {
  pictures.want(scenes, pictureSize);
  pictures.drawCoarsely(InteractionQuality::levelCount - 1, {});
  while (!pictures.refine(5.0))
    EXPECT_FALSE(pictures.state().resting);
}

// Pictures put together on a black screen.
PictureOrder orderOf(CompareLayout layout, const std::vector<PixelRect>& places, const glm::ivec2& screen) {
  PictureOrder order;
  order.scenes.resize(1);
  order.scenes[0].image.background = glm::dvec3(0.0);
  order.layout = layout;
  order.places = places;
  order.screen = screen;
  return order;
}

using PicturesWithoutWindow = test::GlTest;

TEST_F(PicturesWithoutWindow, stripsOfTheRayCasterEndInThePictureThatItDrawsWhole) {
  Pictures pictures(makeRayCasterEngine(), makeGlScreen());
  const std::vector<Scene> scenes = bothModels();
  finish(pictures, scenes);
  ASSERT_TRUE(pictures.state().resting);
  RayCaster whole;
  for (int side = 0; side < 2; ++side)
    EXPECT_EQ(*pictures.side(side).picture().image,
              whole.render(scenes[static_cast<std::size_t>(side)], pictureSize));
}

TEST_F(PicturesWithoutWindow, stripsOfTheReferenceEndInThePictureThatItDrawsWhole) {
  Pictures pictures(test::makeReferenceEngine(), makeMemoryScreen({}));
  const std::vector<Scene> scenes = bothModels();
  finish(pictures, scenes);
  ASSERT_TRUE(pictures.state().resting);
  EXPECT_EQ(pictures.state().renderer, QStringLiteral("reference (double precision)"));
  for (int side = 0; side < 2; ++side)
    EXPECT_EQ(*pictures.side(side).picture().image,
              toImage(renderReference(scenes[static_cast<std::size_t>(side)], pictureSize)));
}

Scene litPhantom() {
  Scene scene = phantomWith(ShadingModel::classic);
  scene.shading.lightDirection = glm::normalize(glm::dvec3(1, 1, -1));
  scene.shading.shadow.strength = 0.7;
  return scene;
}

// Without OpenGL: this one makes no context.
TEST(PicturesInMemory, stripsOfTheCpuEngineEndInThePictureThatItDrawsWholeAndAreShownAsItsBytes) {
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  const std::vector<Scene> scenes = bothModels();
  finish(pictures, scenes);
  CpuRenderer whole;
  for (int side = 0; side < 2; ++side)
    EXPECT_EQ(*pictures.side(side).picture().image,
              whole.render(scenes[static_cast<std::size_t>(side)], pictureSize));
  const PixelRect left{{0, 0}, pictureSize}, right{{62, 0}, pictureSize};
  pictures.show(orderOf(CompareLayout::sideBySide, {left, right}, {122, 40}));
  EXPECT_EQ(pictures.frame().copy(62, 0, 60, 40).convertToFormat(QImage::Format_RGBA8888),
            pictures.side(1).picture().bytes);
  pictures.show(orderOf(CompareLayout::difference, {left, left}, pictureSize));
  const QRgb one = pictures.side(0).picture().bytes.pixel(30, 20);
  const QRgb other = pictures.side(1).picture().bytes.pixel(30, 20);
  // The part that differs most tells colour and strength.
  int most = 0;
  for (const int apart : {qRed(other) - qRed(one), qGreen(other) - qGreen(one), qBlue(other) - qBlue(one)})
    if (std::abs(apart) > std::abs(most))
      most = apart;
  ASSERT_NE(most, 0);
  const glm::dvec3 color =
      std::min(255.0, differenceGain * std::abs(most)) * (most < 0 ? leftBrighterColor : rightBrighterColor);
  const QRgb shown = pictures.frame().pixel(30, 20);
  EXPECT_NEAR(qRed(shown), color.r, 0.5 + 1e-9); // rounded to a level
  EXPECT_NEAR(qGreen(shown), color.g, 0.5 + 1e-9);
  EXPECT_NEAR(qBlue(shown), color.b, 0.5 + 1e-9);
}

// With a tolerance many paths of light are followed, which takes minutes: what moves has fewer, and so has
// the whole picture over which the exact one comes.
TEST(PicturesInMemory, onTheirWayToATolerancePicturesFollowFewPathsOfLight) {
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  Scene scene = litPhantom();
  scene.quality.toleranceLevels = 4.0;
  scene.quality.fineness = 2.0;
  pictures.want({scene}, pictureSize);
  const SidePicture& side = pictures.side(0);
  // However fast the machine.
  EXPECT_GT(pictures.finestLevel(), 0);
  for (const int level : {pictures.finestLevel(), InteractionQuality::levelCount - 1}) {
    pictures.want({scene}, pictureSize);
    pictures.drawCoarsely(level, {});
    EXPECT_FALSE(side.complete()) << level;
    EXPECT_EQ(side.shownScene().quality.light, LightDetail::moving) << level;
  }
  while (side.shownScene().quality.stepVoxels > 2.0 * scene.quality.stepVoxels) {
    ASSERT_FALSE(pictures.refine(0.0)); // a strip at a time, however fast the machine
    EXPECT_EQ(side.shownScene().quality.light, LightDetail::moving);
  }
  EXPECT_FALSE(side.complete());
  while (!pictures.refine(5.0)) {
  }
  CpuRenderer whole;
  EXPECT_EQ(*side.picture().image, whole.render(scene, pictureSize));
  Scene moving = scene;
  moving.quality.light = LightDetail::moving;
  EXPECT_NE(whole.render(moving, pictureSize), *side.picture().image) << "few paths tell something else";
}

// A picture of half the size gets as many paths as there is time for; the whole one begins with as many, and
// goes on: paths are followed once each.
TEST(PicturesInMemory, ofPhysicalLightHaveTwiceAndTwiceAsManyPathsWhileTheyRest) {
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  const Scene scene = phantomWith(ShadingModel::physical);
  finish(pictures, {scene});
  ASSERT_TRUE(pictures.state().resting);
  ASSERT_TRUE(pictures.state().sides[0].paths);
  EXPECT_EQ(pictures.state().sides[0].paths->paths, SidePicture::mostMiddlePaths);
  EXPECT_FALSE(pictures.state().sides[0].paths->rmsLevels) << "nobody has looked yet";
  EXPECT_FALSE(levelsOf(pictures.state().sides[0]));
  std::vector<double> errors;
  for (const int paths : {32, 64, 128}) {
    RestTurn turn = RestTurn::worked;
    while (turn != RestTurn::finished) {
      turn = pictures.workAtRest(true, 5.0);
      ASSERT_NE(turn, RestTurn::nothing);
    }
    const SideState state = pictures.state().sides[0];
    ASSERT_TRUE(state.paths);
    EXPECT_EQ(state.paths->paths, paths);
    ASSERT_TRUE(state.paths->rmsLevels);
    EXPECT_EQ(levelsOf(state), state.paths->p99_9Levels);
    errors.push_back(*state.paths->rmsLevels);
    Scene drawn = scene;
    drawn.shading.physical.until = UntilPaths{paths};
    EXPECT_EQ(*pictures.side(0).picture().image, CpuRenderer().render(drawn, pictureSize));
  }
  // 1/√n from 32 paths to 128: half, give or take what errors found from so few say.
  EXPECT_NEAR(errors[2] / errors[0], 0.5, 0.1);
}

void passes(Pictures& pictures, int count) {
  for (int n = 0; n < count; ++n)
    for (RestTurn turn = RestTurn::worked; turn != RestTurn::finished;) {
      turn = pictures.workAtRest(true, 5.0);
      ASSERT_NE(turn, RestTurn::nothing);
    }
}

// A pass takes as long as all before it: meanwhile the error is that of the rows as they are shown.
TEST(PicturesInMemory, ofPhysicalLightTellTheirErrorStripByStrip) {
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  finish(pictures, {phantomWith(ShadingModel::physical)});
  passes(pictures, 1);
  std::vector<double> told;
  while (told.size() < 3) { // a fast machine draws the first passes in one strip
    const SideState before = pictures.state().sides[0];
    EXPECT_FALSE(before.onTheWay);
    told = {*before.paths->rmsLevels};
    for (RestTurn turn = RestTurn::worked; turn != RestTurn::finished;) {
      turn = pictures.workAtRest(true, 0.0); // a strip a turn
      ASSERT_NE(turn, RestTurn::nothing);
      pictures.judgePass();
      const SideState state = pictures.state().sides[0];
      if (turn == RestTurn::finished)
        continue;
      EXPECT_EQ(state.paths, before.paths) << "what would be saved";
      EXPECT_EQ(levelsOf(state), levelsOf(before));
      if (state.onTheWay && *state.onTheWay->rmsLevels != told.back())
        told.push_back(*state.onTheWay->rmsLevels);
    }
    EXPECT_TRUE(std::ranges::is_sorted(told, std::greater())) << "it never rises";
    const SideState after = pictures.state().sides[0];
    EXPECT_EQ(after.paths->paths, 2 * before.paths->paths);
    EXPECT_NEAR(*after.paths->rmsLevels, told.back(), 0.02 * told.back()) << "its last strip was drawn";
  }
}

// Without the pass that is left stands the picture before it, with its own figures.
TEST(PicturesInMemory, ofPhysicalLightAreAsTheyWereWhereAPassIsLeft) {
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  finish(pictures, {phantomWith(ShadingModel::physical)});
  passes(pictures, 1);
  while (!pictures.state().sides[0].onTheWay) {
    ASSERT_EQ(pictures.workAtRest(true, 0.0), RestTurn::worked);
    pictures.judgePass();
  }
  pictures.leaveRefinementPass();
  EXPECT_FALSE(pictures.state().sides[0].onTheWay);
  pictures.judgePass();
  EXPECT_FALSE(pictures.state().sides[0].onTheWay) << "nothing is drawn";
}

// Exposed otherwise it is there at once, with all that was found; then it goes on.
TEST(PicturesInMemory, ofPhysicalLightAreExposedAnewWithThePathsThatTheyHave) {
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  Scene scene = phantomWith(ShadingModel::physical);
  finish(pictures, {scene});
  passes(pictures, 1);
  ASSERT_EQ(pictures.state().sides[0].paths->paths, 32);
  scene.shading.physical.exposureEv = 1.0;
  pictures.want({scene}, pictureSize);
  EXPECT_EQ(pictures.drawCoarsely(InteractionQuality::levelCount - 1, {}), 0.0);
  EXPECT_EQ(pictures.state().sides[0].paths->paths, 32);
  EXPECT_EQ(pictures.state().sides[0].imageScale, 1.0);
  while (!pictures.refine(5.0)) {
  }
  Scene drawn = scene;
  drawn.shading.physical.until = UntilPaths{32};
  EXPECT_EQ(*pictures.side(0).picture().image, CpuRenderer().render(drawn, pictureSize));
  EXPECT_EQ(qualityShown(scene.quality, pictures.state().sides[0]).paths, 32);
  while (!pictures.state().sides[0].paths->rmsLevels)
    ASSERT_NE(pictures.workAtRest(true, 5.0), RestTurn::nothing);
  EXPECT_EQ(pictures.state().sides[0].paths->paths, 32) << "their error is told before there are more";
  // Another light begins anew.
  scene.shading.physical.sky.above = 0.9;
  pictures.want({scene}, pictureSize);
  EXPECT_GT(pictures.drawCoarsely(InteractionQuality::levelCount - 1, {}), 0.0);
  EXPECT_EQ(pictures.state().sides[0].paths->paths, 1);
}

// On its way the picture never has fewer paths than what it replaces, and each stage is shown.
TEST(PicturesInMemory, ofPhysicalLightOnTheirWayAreOfHalfTheSizeAndLessAndLessNoisy) {
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  pictures.want({phantomWith(ShadingModel::physical)}, pictureSize);
  pictures.drawCoarsely(InteractionQuality::levelCount - 1, {});
  int paths = 0;
  double fraction = 0.0;
  std::set<int> seen;
  for (bool isComplete = false; !isComplete;) {
    isComplete = pictures.refine(0.0); // a strip a turn
    const SideState state = pictures.state().sides[0];
    EXPECT_GE(state.paths->paths, paths);
    EXPECT_GE(state.fraction, fraction);
    paths = state.paths->paths;
    fraction = state.fraction;
    if (!isComplete && paths > 1) {
      EXPECT_EQ(state.imageScale, 0.5);
      seen.insert(paths);
    }
  }
  EXPECT_EQ(seen, (std::set<int>{2, 4, 8, 16}));
  EXPECT_EQ(paths, SidePicture::mostMiddlePaths);
}

TEST(PicturesInMemory, besidePhysicalLightAnotherPictureIsDrawnOnce) {
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  finish(pictures, {phantomWith(ShadingModel::classic), phantomWith(ShadingModel::physical)});
  const std::shared_ptr<const Image> beside = pictures.side(0).picture().image;
  while (pictures.state().sides[1].paths->paths < 64) {
    ASSERT_NE(pictures.workAtRest(true, 5.0), RestTurn::nothing);
    EXPECT_FALSE(pictures.side(0).isFiner());
    EXPECT_LE(pictures.state().refinementFraction, 1.0);
  }
  EXPECT_EQ(pictures.side(0).picture().image, beside);
  EXPECT_FALSE(pictures.state().sides[0].paths);
}

// Whichever quality keeps up with the hand, the picture at rest is that of all voxels.
TEST(PicturesInMemory, ofAVolumeOnDiskMoveWithFewerVoxelsAndRestWithAll) {
  const test::TemporaryFolder folder;
  const Scene inMemory = phantomWith(ShadingModel::classic);
  Scene onDisk = inMemory;
  onDisk.volume = test::mapped(*inMemory.volume, folder.path() / "voxels");
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  ASSERT_EQ(pictures.makeReady(onDisk, {}, 1e3), 1.0);
  const Image expected = CpuRenderer().render(inMemory, pictureSize);
  for (int level = 0; level < InteractionQuality::levelCount; ++level) {
    pictures.want({onDisk}, pictureSize);
    pictures.drawCoarsely(level, {});
    const SideState moving = pictures.state().sides[0];
    ASSERT_TRUE(moving.coarseness) << level;
    EXPECT_GE(moving.coarseness->reduction, 2);
    EXPECT_GT(moving.coarseness->largestError, 0.0);
    EXPECT_NEAR(moving.stepVoxels,
                onDisk.quality.stepVoxels * InteractionQuality::levelAt(level).stepFactor *
                    moving.coarseness->reduction,
                0.25 * moving.stepVoxels)
        << "in voxels of the whole volume";
    EXPECT_FALSE(pictures.effectRowsOf(0).empty());
    EXPECT_FALSE(pictures.state().resting) << "however fast it was drawn";
    while (!pictures.refine(5.0))
      EXPECT_FALSE(pictures.state().resting);
    const SideState resting = pictures.state().sides[0];
    EXPECT_FALSE(resting.coarseness);
    EXPECT_EQ(resting.stepVoxels, onDisk.quality.stepVoxels);
    EXPECT_EQ(*pictures.side(0).picture().image, expected);
  }
}

double meanOf(const QImage& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      sum += qGray(image.pixel(x, y));
  return sum / (double(image.width()) * image.height());
}

// Fewer pixels and larger steps change details, not how bright the picture is. Eyes notice about 2 %.
TEST(PicturesInMemory, noQualityWhileMovingIsBrighterOrDarkerThanThePictureAtRest) {
  constexpr glm::ivec2 size{320, 240};
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  const PixelRect whole{{0, 0}, size};
  std::vector<double> means;
  for (int level = 0; level < InteractionQuality::levelCount; ++level) {
    pictures.want({phantomWith(ShadingModel::classic)}, size);
    pictures.drawCoarsely(level, {});
    pictures.show(orderOf(CompareLayout::single, {whole}, size));
    means.push_back(meanOf(pictures.frame()));
  }
  for (const double mean : means)
    EXPECT_NEAR(mean, means[0], 0.02 * means[0]);
}

TEST_F(PicturesWithoutWindow, anotherRequestDropsWhatIsFinished) {
  Pictures pictures(makeRayCasterEngine(), makeGlScreen());
  std::vector<Scene> scenes{phantomWith(ShadingModel::classic)};
  finish(pictures, scenes);
  scenes[0].camera = orbited(scenes[0].camera, 0.3, 0.0);
  pictures.want(scenes, pictureSize);
  EXPECT_FALSE(pictures.state().resting);
  finish(pictures, scenes);
  EXPECT_EQ(*pictures.side(0).picture().image, RayCaster().render(scenes[0], pictureSize));
}

// Every engine answers what is done at rest, in pieces; one that cannot tell what effects cost says nothing.
TEST_F(PicturesWithoutWindow, whatIsDoneAtRestEndsWithEveryEngine) {
  const auto withOpenGl = [] { return std::make_unique<Pictures>(makeRayCasterEngine(), makeGlScreen()); };
  const auto inMemory = [](std::unique_ptr<DrawingEngine> engine) {
    return std::make_unique<Pictures>(std::move(engine), makeMemoryScreen({}));
  };
  for (const MakePictures& make :
       {MakePictures(withOpenGl), MakePictures([&] { return inMemory(test::makeReferenceEngine()); }),
        MakePictures([&] { return inMemory(makeCpuEngine()); })}) {
    const std::unique_ptr<Pictures> made = make();
    Pictures& pictures = *made;
    finish(pictures, bothModels());
    const bool tells = !pictures.engine().name().starts_with("reference");
    pictures.rest().measureCosts(1);
    while (pictures.workAtRest(false, 5.0) != RestTurn::nothing) {
    }
    EXPECT_TRUE(pictures.state().sides[1].overflow) << pictures.engine().name();
    EXPECT_TRUE(pictures.state().sides[1].estimate) << "from small pictures";
    EXPECT_FALSE(pictures.rest().times().isMeasuring);
    EXPECT_EQ(pictures.rest().times().costs.empty(), !tells) << pictures.engine().name();
  }
}

void refineOnce(Pictures& pictures) {
  RestTurn turn = RestTurn::worked;
  while (turn != RestTurn::nothing && turn != RestTurn::finished)
    turn = pictures.workAtRest(true, 5.0);
  ASSERT_EQ(turn, RestTurn::finished);
}

// A projection that has no error-controlled steps.
TEST_F(PicturesWithoutWindow, refinementHalvesTheStepToThePictureOfThatStep) {
  Pictures pictures(makeRayCasterEngine(), makeGlScreen());
  std::vector<Scene> scenes{phantomWith(ShadingModel::classic)};
  scenes[0].projection = Projection::mip;
  finish(pictures, scenes);
  refineOnce(pictures);
  const double step = pictures.side(0).finishedQuality().stepVoxels;
  EXPECT_EQ(step, scenes[0].quality.stepVoxels / 2.0);
  EXPECT_EQ(*pictures.side(0).picture().image, RayCaster().render(withStep(scenes[0], step), pictureSize));
}

// Two voxels take many halvings to half a level: error-controlled steps are there sooner on any machine.
TEST(PicturesInMemory, refinementByErrorTellsTheTruthAboutThePictureItShows) {
  constexpr glm::ivec2 size{160, 120};
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  std::vector<Scene> scenes = bothModels();
  for (Scene& scene : scenes)
    scene.quality.stepVoxels = 2.0;
  pictures.want(scenes, size);
  pictures.drawCoarsely(0, {});
  while (!pictures.refine(5.0)) {
  }
  refineOnce(pictures);
  for (int side = 0; side < 2; ++side) {
    Scene drawn = scenes[static_cast<std::size_t>(side)];
    drawn.quality = pictures.side(side).finishedQuality();
    ASSERT_EQ(drawn.quality.toleranceLevels, Refinement::toleranceLevels);
    const Image& image = *pictures.side(side).picture().image;
    EXPECT_EQ(image, CpuRenderer(0, CpuRenderer::Tolerance::stepsFirst).render(drawn, size));
    // A sixteenth of the error is left four rungs further.
    Scene exact = drawn;
    exact.quality.fineness = *drawn.quality.fineness + 4.0;
    exact.quality.earlyTermination = 1.0;
    const double truth = imageError(image, CpuRenderer().render(exact, size)).p99_9;
    const SideState state = pictures.state().sides[static_cast<std::size_t>(side)];
    EXPECT_EQ(state.toleranceLevels, Refinement::toleranceLevels);
    EXPECT_GE(state.estimate->p99_9, 0.5 * truth) << "never below half the truth";
    EXPECT_EQ(state.estimate->p99_9, Refinement::toleranceLevels);
    EXPECT_GT(state.estimate->mean, 0.0);
    EXPECT_LT(state.estimate->mean, state.estimate->p99_9);
    EXPECT_TRUE(state.isResolved);
  }
  refineOnce(pictures);
  EXPECT_EQ(pictures.state().refinementEnd, RefinementEnd::withinHalfALevel);
}

// What is found of a resting picture with pixels that lie off its own by `levelsOff(its tolerance)`, until
// nothing is left to do: the tolerances that it was drawn with, one after the other.
std::vector<double> tolerancesUntilRest(const std::function<double(double)>& levelsOff, PictureState& end) {
  const Pictures* judged = nullptr;
  const DrawPrecisely exact = [&](const Scene&, const glm::ivec2&, const std::vector<std::uint8_t>& wanted,
                                  std::vector<glm::dvec4>& pixels) {
    const SidePicture& side = judged->side(0);
    const double off = levelsOff(side.finishedQuality().toleranceLevels.value()) / 255.0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (wanted[i])
        pixels[i] = glm::dvec4(side.picture().image->pixels[i]) + glm::dvec4(off, off, off, 0.0);
  };
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}), [&](const auto&) { return exact; });
  judged = &pictures;
  Scene scene = phantomWith(ShadingModel::classic);
  scene.quality.stepVoxels = 2.0; // halvings would take longer
  finish(pictures, {scene});
  std::vector<double> tolerances;
  for (RestTurn turn = RestTurn::worked; turn != RestTurn::nothing;) {
    turn = pictures.workAtRest(true, 5.0);
    EXPECT_EQ(pictures.state().isFinal, turn == RestTurn::nothing) << "not while a better one may follow";
    const std::optional<double> tolerance = pictures.side(0).finishedQuality().toleranceLevels;
    if (!tolerance || (!tolerances.empty() && tolerances.back() == *tolerance))
      continue;
    tolerances.push_back(*tolerance);
    EXPECT_FALSE(pictures.state().sides[0].chance) << "that was of the picture before";
  }
  end = pictures.state();
  return tolerances;
}

TEST(PicturesInMemory, ofWhichPixelsLieTooFarOffGoOnWithAQuarterOfTheTolerance) {
  PictureState end;
  constexpr double first = Refinement::toleranceLevels;
  EXPECT_EQ(tolerancesUntilRest([](double tolerance) { return tolerance < first ? 0.3 : 2.6; }, end),
            (std::vector{first, first / 4.0}));
  EXPECT_EQ(end.refinementEnd, RefinementEnd::withinHalfALevel);
  ASSERT_TRUE(end.sides[0].chance);
  EXPECT_LE(end.sides[0].chance->levels, screenLevels);
  EXPECT_LE(end.sides[0].estimate->p99_9, first / 4.0);
}

TEST(PicturesInMemory, ofWhichNoPixelLiesTooFarOffStayAsTheyAre) {
  PictureState end;
  EXPECT_EQ(tolerancesUntilRest([](double) { return 0.6; }, end), std::vector{Refinement::toleranceLevels});
  EXPECT_EQ(end.refinementEnd, RefinementEnd::withinHalfALevel);
}

// Steps are not what is missing there.
TEST(PicturesInMemory, ofWhichPixelsStayTooFarOffEndAfterAFewTolerances) {
  PictureState end;
  const std::vector<double> tolerances = tolerancesUntilRest([](double) { return 12.0; }, end);
  EXPECT_GE(tolerances.size(), 2u);
  EXPECT_LE(tolerances.size(), 1u + Refinement::mostTightenings);
  EXPECT_EQ(end.refinementEnd, RefinementEnd::withinHalfALevel);
  ASSERT_TRUE(end.sides[0].chance);
  EXPECT_GT(end.sides[0].chance->levels, screenLevels);
}

TEST_F(PicturesWithoutWindow, theSearchForStepsFindsWhatTheCommandLineFinds) {
  const std::vector<Scene> scenes = bothModels();
  const auto engine = makeRayCasterEngine();
  const auto screen = makeGlScreen();
  const auto sheet = screen->makeSheet();
  constexpr glm::ivec2 size{160, 120};
  StepSearch search(scenes, size, 1.0, screen->stripMs(), StepControl::local,
                    engine->facts(scenes.front()).filterBits);
  while (search.step(*engine, *sheet, 5.0) != RestTurn::finished) {
  }
  RayCaster caster;
  const std::vector<NeededSteps> needed = search.found();
  ASSERT_EQ(needed.size(), scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    Scene scene = scenes[i];
    scene.quality.toleranceLevels = 1.0;
    const WithinTolerance found =
        withinTolerance(scene, size, [&](const Scene& tried, const glm::ivec2& pixels) {
          return caster.render(tried, pixels);
        });
    EXPECT_EQ(needed[i].quality, found.scene.quality);
    EXPECT_EQ(needed[i].estimate.p99_9, std::max(1.0, found.estimateLevels));
    EXPECT_EQ(needed[i].estimate.mean, found.meanLevels);
    EXPECT_EQ(needed[i].holds, found.holds);
    EXPECT_GT(needed[i].expectedMs, 0.0);
  }
}

// --- which road is shorter

ErrorEstimate off(double levels, double order) {
  return {levels, levels, order};
}

// Eight levels at order 2 fall to half a level, 0.51 as halvings count it, in two halvings; at order 1 in
// four.
TEST(RefinementRoad, halvingsTakeTwiceAsLongEachTime) {
  constexpr double smallest = 1.0 / 64.0;
  EXPECT_EQ(msOfHalvings({off(8.0, 2.0)}, 0.5, 100.0, smallest), 100.0 * (2 + 4));
  EXPECT_EQ(msOfHalvings({off(8.0, 1.0)}, 0.5, 100.0, smallest), 100.0 * (2 + 4 + 8 + 16));
  EXPECT_EQ(msOfHalvings({off(8.0, 1.0), off(8.0, 2.0)}, 0.5, 100.0, smallest), 100.0 * (2 + 4 + 8 + 16))
      << "the side that needs the most";
  EXPECT_EQ(msOfHalvings({off(0.1, 1.0)}, 0.5, 100.0, smallest), 200.0) << "one is drawn to know";
  EXPECT_TRUE(std::isinf(msOfHalvings({off(8.0, 1.0)}, 0.1, 100.0, smallest)));
  EXPECT_TRUE(std::isinf(msOfHalvings({std::nullopt}, 0.5, 100.0, smallest)));
}

TEST(RefinementRoad, isThatOfTheToleranceWhereAllSidesGetThereSooner) {
  const NeededSteps quick{{}, {}, 100.0, true};
  const NeededSteps never{{}, {}, 100.0, false};
  EXPECT_TRUE(isToleranceShorter({quick, quick}, 250.0, 1000.0));
  EXPECT_FALSE(isToleranceShorter({quick, quick}, 200.0, 1000.0));
  EXPECT_FALSE(isToleranceShorter({quick, quick}, 250.0, 150.0));
  EXPECT_FALSE(isToleranceShorter({quick, never}, 250.0, 1000.0));
  EXPECT_FALSE(isToleranceShorter({}, 250.0, 1000.0)) << "no such steps";
}

} // namespace
} // namespace limn
