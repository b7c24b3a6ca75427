// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h> // before any OpenGL header of Qt

#include "widgets/view/pictures/PictureScreen.h"

#include "engine/DrawingEngine.h"
#include "gl/PictureTarget.h"
#include "glsl/PicturePresenter.h"
#include "widgets/view/pictures/TileSchedule.h"

namespace limn {
namespace {

class GlPixels {
public:
  virtual ~GlPixels() = default;
  virtual unsigned texture() const = 0;
};

// Waits for what it lets draw: a software renderer only then does the work.
class GlSheet final : public PictureSheet, public GlPixels {
public:
  void resize(const glm::ivec2& size) override { m_target.resize(size); }
  void draw(DrawingEngine& engine, const Scene& scene, const PixelRect& tile) override {
    m_target.bind();
    if (const std::optional<Image> pixels = engine.draw(scene, m_target.size(), tile, {}))
      m_target.write(tile.topLeft, *pixels);
    glFinish();
  }
  void lend(const std::function<void()>& work) override {
    m_target.bind();
    work();
    glFinish();
  }
  Image read() const override { return m_target.read(); }
  FinishedPicture finished(const glm::dvec3& background) const override {
    return limn::finished(std::make_shared<const Image>(read()), background);
  }
  bool isEmpty() const override { return m_target.isEmpty(); }
  unsigned texture() const override { return m_target.texture(); }

private:
  PictureTarget m_target;
};

class GlFinishedSheet final : public FinishedSheet, public GlPixels {
public:
  void set(const FinishedPicture& picture) override {
    const QImage upwards = picture.bytes.mirrored();
    m_bytes.upload({upwards.width(), upwards.height()}, upwards.constBits());
  }
  unsigned texture() const override { return m_bytes.texture(); }

private:
  ByteTexture m_bytes;
};

unsigned textureOf(const ShownPixels& pixels) {
  return dynamic_cast<const GlPixels&>(pixels).texture();
}

class GlScreen final : public PictureScreen {
public:
  std::unique_ptr<PictureSheet> makeSheet() override { return std::make_unique<GlSheet>(); }
  std::unique_ptr<FinishedSheet> makeFinishedSheet() override { return std::make_unique<GlFinishedSheet>(); }

  double stripMs() const override { return TileSchedule::usualMs; }

  // Qt's painter leaves its own state behind.
  void reset() override {
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glUseProgram(0);
    glActiveTexture(GL_TEXTURE0);
  }

  void clear(const glm::ivec2& size, const glm::dvec3& background) override {
    m_height = size.y;
    glViewport(0, 0, size.x, size.y);
    glClearColor(static_cast<float>(background.r), static_cast<float>(background.g),
                 static_cast<float>(background.b), 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  }

  void show(const ShownPixels& pixels, const PixelRect& place, const PixelRect& part,
            const glm::dvec3& background) override {
    m_presenter.show(textureOf(pixels), {m_height, place, part}, background);
  }

  void showDifference(const ShownPixels& left, const ShownPixels& right, const PixelRect& place,
                      const PixelRect& part, const glm::dvec3& background, double gain) override {
    m_presenter.showDifference(textureOf(left), textureOf(right), {m_height, place, part}, background, gain);
  }

private:
  PicturePresenter m_presenter;
  int m_height = 0;
};

} // namespace

std::unique_ptr<PictureScreen> makeGlScreen() {
  return std::make_unique<GlScreen>();
}

} // namespace limn
