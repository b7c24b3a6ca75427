// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/Workbench.h"

#include "gl/GlObjects.h"
#include "gl/SavedState.h"
#include "glsl/PicturePresenter.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

GlTexture textureOf(GLint format, const glm::ivec2& size, GLenum type, const void* pixels) {
  GlTexture texture;
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, format, size.x, size.y, 0, GL_RGBA, type, pixels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

// OpenGL's rows go upwards.
template <class Pixel>
std::vector<Pixel> upsideDown(const std::vector<Pixel>& pixels, const glm::ivec2& size) {
  std::vector<Pixel> flipped(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t row = i / size.x;
    flipped[(size.y - 1 - row) * size.x + i % size.x] = pixels[i];
  }
  return flipped;
}

} // namespace

std::vector<glm::u8vec4> presented(const DrawnPicture& picture, const glm::dvec3& background) {
  const SavedState saved;
  const glm::ivec2& size = picture.size;
  const std::vector<glm::vec4> floats(picture.pixels.begin(), picture.pixels.end());
  const GlTexture drawn = textureOf(GL_RGBA32F, size, GL_FLOAT, upsideDown(floats, size).data());
  const GlTexture screen = textureOf(GL_RGBA8, size, GL_UNSIGNED_BYTE, nullptr);
  const GlFramebuffer framebuffer;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, screen.name(), 0);
  const PixelRect whole{{0, 0}, size};
  PicturePresenter().show(drawn.name(), {size.y, whole, whole}, background);
  std::vector<glm::u8vec4> levels(picture.pixels.size());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, levels.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return upsideDown(levels, size);
}

} // namespace limn
