// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing in tiles into a framebuffer of the caller's, as a window does.
#include "raycaster/RayCaster.h"
#include "scene/volume/Phantom.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/TravellingScenes.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

constexpr glm::ivec2 tiledSize{70, 50};

// A framebuffer of floats bound for the life of a test, filled with a colour that drawing must replace.
struct Canvas {
  Canvas() {
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, tiledSize.x, tiledSize.y, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glClearColor(0.25f, 0.5f, 0.75f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  ~Canvas() {
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
  }
  Image read() const {
    Image flipped(tiledSize), image(tiledSize);
    glReadPixels(0, 0, tiledSize.x, tiledSize.y, GL_RGBA, GL_FLOAT, flipped.pixels.data());
    for (int y = 0; y < tiledSize.y; ++y)
      for (int x = 0; x < tiledSize.x; ++x)
        image.at(x, y) = flipped.at(x, tiledSize.y - 1 - y);
    return image;
  }
  GLuint texture = 0, framebuffer = 0;
};

Scene robustPhantom() {
  static const std::shared_ptr<const Volume> volume = phantomVolume({.spacingMm = 5.0});
  Scene scene = test::headScene(volume, ShadingModel::robust);
  scene.quality = Quality{};
  scene.quality.stepVoxels = 0.5;
  return scene;
}

using Tiles = test::GlTest;

void expectTilingChangesNothing(const Scene& scene) {
  RayCaster caster;
  const Image whole = caster.render(scene, tiledSize);
  EXPECT_EQ(caster.render(scene, tiledSize), whole) << "the second time";
  for (const glm::ivec2& tile :
       {glm::ivec2(70, 50), glm::ivec2(7, 50), glm::ivec2(64, 64), glm::ivec2(13, 11), glm::ivec2(70, 1)}) {
    const Canvas canvas;
    for (int y = 0; y < tiledSize.y; y += tile.y)
      for (int x = 0; x < tiledSize.x; x += tile.x)
        caster.draw(scene, tiledSize, {{x, y}, glm::min(tile, tiledSize - glm::ivec2(x, y))});
    EXPECT_EQ(canvas.read(), whole) << "tiles of " << tile.x << " x " << tile.y;
  }
}

TEST_F(Tiles, anyTilingGivesTheWholePictureToTheBit) {
  expectTilingChangesNothing(robustPhantom());
}

TEST_F(Tiles, anyTilingOfErrorControlledStepsGivesTheWholePictureToTheBit) {
  Scene scene = robustPhantom();
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = 4;
  expectTilingChangesNothing(scene);
}

TEST_F(Tiles, aTileChangesNothingBesideItself) {
  RayCaster caster;
  const Canvas canvas;
  caster.draw(robustPhantom(), tiledSize, {{20, 10}, {8, 9}});
  const Image image = canvas.read();
  for (int y = 0; y < tiledSize.y; ++y)
    for (int x = 0; x < tiledSize.x; ++x) {
      const bool isInside = x >= 20 && x < 28 && y >= 10 && y < 19;
      EXPECT_EQ(image.at(x, y) == glm::vec4(0.25f, 0.5f, 0.75f, 1.0f), !isInside) << x << ", " << y;
    }
}

TEST_F(Tiles, drawingLeavesTheStateOfTheContextAsItWas) {
  RayCaster caster;
  const Canvas canvas;
  glEnable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  glViewport(1, 2, 3, 4);
  glScissor(5, 6, 7, 8);
  glActiveTexture(GL_TEXTURE2);
  glBindTexture(GL_TEXTURE_2D, canvas.texture);
  caster.draw(robustPhantom(), tiledSize, {{0, 0}, tiledSize});
  EXPECT_TRUE(glIsEnabled(GL_BLEND));
  EXPECT_TRUE(glIsEnabled(GL_DEPTH_TEST));
  EXPECT_TRUE(glIsEnabled(GL_CULL_FACE));
  EXPECT_FALSE(glIsEnabled(GL_SCISSOR_TEST));
  GLboolean mask[4];
  glGetBooleanv(GL_COLOR_WRITEMASK, mask);
  EXPECT_TRUE(mask[0] && !mask[1] && mask[2] && !mask[3]);
  GLint viewport[4], scissor[4], framebuffer = 0, texture = 0, active = 0, program = -1;
  glGetIntegerv(GL_VIEWPORT, viewport);
  glGetIntegerv(GL_SCISSOR_BOX, scissor);
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  EXPECT_TRUE(viewport[0] == 1 && viewport[3] == 4);
  EXPECT_TRUE(scissor[0] == 5 && scissor[3] == 8);
  EXPECT_EQ(static_cast<GLuint>(framebuffer), canvas.framebuffer);
  EXPECT_EQ(active, GL_TEXTURE2);
  EXPECT_EQ(static_cast<GLuint>(texture), canvas.texture);
  EXPECT_EQ(program, 0);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Tiles, ofLightOnItsWayChangeNothing) {
  expectTilingChangesNothing(test::shadowedHead(6.0));
}

} // namespace
} // namespace limn
