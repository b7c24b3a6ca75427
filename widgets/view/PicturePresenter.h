// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "raycaster/RayCaster.h"

namespace limn {

/// Puts pictures into the bound framebuffer, over a background. Needs the same OpenGL context current for
/// every call and for its end.
class PicturePresenter {
public:
  /// Throws Error (openGl) where its shaders do not compile.
  PicturePresenter();
  ~PicturePresenter();
  PicturePresenter(const PicturePresenter&) = delete;
  PicturePresenter& operator=(const PicturePresenter&) = delete;

  /// Where in a framebuffer of height `framebufferHeight` a picture goes, y down: `place` is the whole
  /// picture, stretched to it; only what lies in `part` is drawn.
  struct Placement {
    int framebufferHeight = 0;
    PixelRect place;
    PixelRect part;
  };

  /// Draws the picture over the background.
  void show(unsigned texture, const Placement& placement, const glm::dvec3& background) const;

  /// Draws the absolute difference of two pictures over the background, times `gain`.
  void showDifference(unsigned left, unsigned right, const Placement& placement, const glm::dvec3& background,
                      double gain) const;

private:
  void draw(unsigned left, unsigned right, const Placement& placement, const glm::dvec3& background,
            double gain) const;

  unsigned m_program = 0;
  unsigned m_vertexArray = 0;
  int m_left = -1, m_right = -1, m_background = -1, m_gain = -1;
};

} // namespace limn
