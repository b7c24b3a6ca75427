// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "scene/basics/Image.h"

#include <array>

namespace limn {

/// A framebuffer of 32-bit float RGBA without a window, bound while it lives; its contents begin undefined.
class FloatTarget {
public:
  /// Throws Error (openGl) where the driver refuses it.
  explicit FloatTarget(const glm::ivec2& size);
  ~FloatTarget();
  FloatTarget(const FloatTarget&) = delete;
  FloatTarget& operator=(const FloatTarget&) = delete;

private:
  void restore() const;

  GlTexture m_color;
  GlFramebuffer m_framebuffer;
  int m_drawBefore = 0;
  int m_readBefore = 0;
  int m_textureBefore = 0;
};

/// Reads a picture from the framebuffer bound; rows from the top.
Image readBack(const glm::ivec2& size);

/// A picture on the GPU that can be drawn into and shown: one texture of premultiplied RGBA, 32-bit floats,
/// lower left corner first.
class PictureTarget {
public:
  PictureTarget();

  /// Makes room for `size` pixels; keeps what is there where the size is the same. Throws Error (openGl)
  /// where the driver cannot.
  void resize(const glm::ivec2& size);

  /// Lets the following drawing go into the picture.
  void bind() const;

  /// Puts pixels that were computed in memory, rows from the top, into the picture.
  void write(const glm::ivec2& topLeft, const Image& pixels);

  /// Reads the picture back; waits for the drawing to end.
  Image read() const;

  unsigned texture() const { return m_texture.name(); }
  const glm::ivec2& size() const { return m_size; }
  bool isEmpty() const { return m_size.x == 0; }

private:
  GlTexture m_texture;
  GlFramebuffer m_framebuffer;
  glm::ivec2 m_size{0};
};

/// A finished 8-bit picture on the GPU, RGBA, lower left corner first.
class ByteTexture {
public:
  ByteTexture();

  /// Uploads `size.x · size.y · 4` bytes, rows from bottom to top.
  void upload(const glm::ivec2& size, const unsigned char* bytes);

  unsigned texture() const { return m_texture.name(); }

private:
  GlTexture m_texture;
};

/// Remembers the OpenGL state that drawing a picture changes and puts it back when it dies, for contexts that
/// are shared with a toolkit. Texture bindings are kept of the first `textureUnits` units. The constructor
/// sets what exact pixels need: no blending, depth, stencil or face test, no dithering, all channels written.
class SavedState {
public:
  SavedState();
  ~SavedState();
  SavedState(const SavedState&) = delete;
  SavedState& operator=(const SavedState&) = delete;

  static constexpr int textureUnits = 10;
  static constexpr int capabilities = 7;

private:
  std::array<unsigned char, capabilities> m_enabled{};
  std::array<unsigned char, 4> m_colorMask{};
  std::array<int, textureUnits> m_textures2D{};
  std::array<int, textureUnits> m_textures3D{};
  std::array<int, 4> m_viewport{};
  std::array<int, 4> m_scissorBox{};
  int m_program = 0;
  int m_vertexArray = 0;
  int m_arrayBuffer = 0;
  int m_activeTexture = 0;
  int m_unpackAlignment = 4;
  int m_unpackBuffer = 0;
  std::array<int, 4> m_blendFactors{};
  std::array<int, 2> m_blendEquations{};
};

} // namespace limn
