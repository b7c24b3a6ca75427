// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/Pictures.h"
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "engine/DrawingEngine.h"
#include "raycaster/RayCaster.h"
#include "raycaster/RayCasterEngine.h"
#include "reference/ReferenceEngine.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/GlTest.h"
#include "widgets/view/pictures/GlScreen.h"
#include "widgets/view/pictures/MemoryScreen.h"
#include "widgets/view/pictures/PictureLoop.h"

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
  Pictures pictures(makeReferenceEngine(), makeMemoryScreen({}));
  const std::vector<Scene> scenes = bothModels();
  finish(pictures, scenes);
  ASSERT_TRUE(pictures.state().resting);
  EXPECT_EQ(pictures.state().renderer, QStringLiteral("reference (double precision)"));
  for (int side = 0; side < 2; ++side)
    EXPECT_EQ(*pictures.side(side).picture().image,
              toImage(renderReference(scenes[static_cast<std::size_t>(side)], pictureSize)));
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
  pictures.show({CompareLayout::sideBySide, {left, right}, {122, 40}, 0, false}, glm::dvec3(0.0));
  EXPECT_EQ(pictures.frame().copy(62, 0, 60, 40).convertToFormat(QImage::Format_RGBA8888),
            pictures.side(1).picture().bytes);
  pictures.show({CompareLayout::difference, {left, left}, pictureSize, 0, false}, glm::dvec3(0.0));
  const QRgb one = pictures.side(0).picture().bytes.pixel(30, 20);
  const QRgb other = pictures.side(1).picture().bytes.pixel(30, 20);
  EXPECT_EQ(qRed(pictures.frame().pixel(30, 20)),
            std::min(255.0, differenceGain * std::abs(qRed(one) - qRed(other))));
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
    pictures.show({CompareLayout::single, {whole}, size, 0, false}, glm::dvec3(0.0));
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
       {MakePictures(withOpenGl), MakePictures([&] { return inMemory(makeReferenceEngine()); }),
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

TEST_F(PicturesWithoutWindow, refinementHalvesTheStepToThePictureOfThatStep) {
  Pictures pictures(makeRayCasterEngine(), makeGlScreen());
  const std::vector<Scene> scenes{phantomWith(ShadingModel::classic)};
  finish(pictures, scenes);
  RestTurn turn = RestTurn::worked;
  while (turn != RestTurn::nothing && turn != RestTurn::finished)
    turn = pictures.workAtRest(true, 5.0);
  ASSERT_EQ(turn, RestTurn::finished);
  const double step = pictures.side(0).finishedStepVoxels();
  EXPECT_EQ(step, scenes[0].quality.stepVoxels / 2.0);
  EXPECT_EQ(*pictures.side(0).picture().image, RayCaster().render(withStep(scenes[0], step), pictureSize));
}

} // namespace
} // namespace limn
