// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"

#include <glm/glm.hpp>

namespace limn {

/// A framebuffer of premultiplied RGBA in 32-bit floats, bound while it lives; then what was bound before is
/// bound again.
class FloatTarget {
public:
  /// Throws Error (openGl) where the driver cannot draw into one of `size` pixels.
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
};

} // namespace limn
