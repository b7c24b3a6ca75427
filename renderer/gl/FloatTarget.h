// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "scene/basics/Image.h"

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

} // namespace limn
