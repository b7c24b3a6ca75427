// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/PixelRect.h"
#include "gl/ShaderProgram.h"

namespace limn {

/// Puts pictures into the bound framebuffer, over a background.
class PicturePresenter {
public:
  /// Throws Error (openGl) where its shaders do not compile.
  PicturePresenter();

  /// Where in a framebuffer of height `framebufferHeight` a picture goes, y down: `place` is the whole
  /// picture, stretched to it; only what lies in `part` is drawn.
  struct Placement {
    int framebufferHeight = 0;
    PixelRect place;
    PixelRect part;
  };

  /// Draws the picture over the background.
  void show(unsigned texture, const Placement& placement, const glm::dvec3& background) const;

  /// Draws the signed difference of two pictures over the background, times `gain`
  /// (scene/view/CompareLayout).
  void showDifference(unsigned left, unsigned right, const Placement& placement, const glm::dvec3& background,
                      double gain) const;

private:
  void draw(unsigned left, unsigned right, const Placement& placement, const glm::dvec3& background,
            double gain) const;

  ShaderProgram m_program;
  GlVertexArray m_vertexArray;
};

} // namespace limn
