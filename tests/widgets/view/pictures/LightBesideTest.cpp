// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/LightBeside.h"
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "raycaster/RayCasterEngine.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/GlTest.h"
#include "widgets/view/pictures/PictureScreen.h"
#include "widgets/view/pictures/Pictures.h"

#include <atomic>
#include <memory>

// Light that OpenGL looks up and the processor follows, without a window.

namespace limn {
namespace {

constexpr glm::ivec2 besideSize{60, 40};

Scene plainHead() {
  static const std::shared_ptr<const Volume> volume = phantomVolume({8.0, 0.0, 1});
  return headScene(volume, ShadingModel::classic);
}

Scene headInShadow() {
  Scene scene = plainHead();
  scene.shading.lightDirection = glm::normalize(glm::dvec3(1, 1, -1));
  scene.shading.shadow.strength = 0.7;
  return scene;
}

class LightBesideOpenGl : public test::GlTest {
protected:
  void finish(const Scene& scene) {
    pictures().want({scene}, besideSize);
    pictures().drawCoarsely(InteractionQuality::levelCount - 1, {});
    while (!pictures().refine(5.0)) {
    }
  }
  void comeToTheEnd() {
    while (!pictures().state().refinementEnd)
      pictures().workAtRest(true, 20.0);
  }
  // Made once there is a context.
  Pictures& pictures() {
    if (!m_pictures)
      m_pictures = std::make_unique<Pictures>(makeRayCasterEngine(), makeGlScreen(), MakePrecise(), [this] {
        ++made;
        return makeCpuEngine(2);
      });
    return *m_pictures;
  }
  void TearDown() override {
    m_pictures.reset();
    GlTest::TearDown();
  }

  std::atomic<int> made = 0; ///< of engines that follow light

private:
  std::unique_ptr<Pictures> m_pictures;
};

TEST_F(LightBesideOpenGl, aFinalPictureIsReplacedByOneWhoseLightIsFollowedAndSaysHowNearThatIs) {
  finish(headInShadow());
  EXPECT_FALSE(pictures().state().sides[0].isLightMeasured);
  comeToTheEnd();
  const PictureState state = pictures().state();
  EXPECT_EQ(state.refinementEnd, RefinementEnd::gridOfLight);
  EXPECT_FALSE(state.refines);
  const SidePicture& side = pictures().side(0);
  CpuRenderer processor;
  EXPECT_EQ(*side.picture().image, processor.render(side.shownScene(), besideSize));
  EXPECT_TRUE(state.sides[0].isLightMeasured);
  ASSERT_TRUE(state.sides[0].estimate);
  Scene exact = side.shownScene();
  exact.quality.light = LightDetail::sampled;
  const ImageError found = imageError(*side.picture().image, processor.render(exact, besideSize));
  EXPECT_GT(found.p99_9, 0.0);
  EXPECT_GE(state.sides[0].estimate->p99_9, 0.8 * found.p99_9); // of steps and light
}

TEST_F(LightBesideOpenGl, nothingIsFollowedOfPicturesWithoutItNorOfThoseThatAreNotSharpened) {
  finish(plainHead());
  comeToTheEnd();
  EXPECT_EQ(made, 0);
  finish(headInShadow());
  while (pictures().workAtRest(false, 20.0) != RestTurn::nothing) {
  }
  EXPECT_EQ(made, 0);
}

TEST_F(LightBesideOpenGl, anotherPictureEndsItAndIsFollowedAnew) {
  finish(headInShadow());
  while (made == 0)
    pictures().workAtRest(true, 20.0);
  Scene turned = headInShadow();
  turned.camera = orbited(turned.camera, 0.5, 0.0);
  finish(turned);
  EXPECT_FALSE(pictures().state().sides[0].isLightMeasured) << "what was known of the picture before";
  comeToTheEnd();
  EXPECT_EQ(*pictures().side(0).picture().image,
            CpuRenderer().render(pictures().side(0).shownScene(), besideSize));
}

} // namespace
} // namespace limn
