// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "raycaster/PixelRect.h"
#include "scene/Gradient.h"
#include "scene/Image.h"
#include "scene/Scene.h"

#include <memory>
#include <string>
#include <vector>

namespace limn {

/// Draws scenes with GLSL on the current OpenGL context (3.0 or newer). Owns textures and programs and keeps
/// them while scenes share them: a new control point uploads a small table, a new camera nothing.
/// All calls, construction and destruction included, need the same context to be current.
class RayCaster {
public:
  /// Stepping over empty space changes no bit of a picture; tests and benchmarks switch it off to show that.
  enum class EmptySpace { skipped, sampled };

  /// Throws Error (openGl) where the driver lacks what drawing needs, naming it.
  explicit RayCaster(EmptySpace emptySpace = EmptySpace::skipped);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// Draws the pixels of `tile` of a picture of `size` pixels into the bound framebuffer as premultiplied
  /// RGBA without background; pixels outside the volume become zero. Any tiling gives the same picture bit
  /// for bit. The framebuffer's lower left corner is the picture's.
  void draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile);

  /// Draws a whole picture off screen in 32-bit floats and reads it back.
  Image render(const Scene& scene, const glm::ivec2& size);

  /// The number of samples of each pixel's ray, row by row from the top, 0 where it misses the volume: what
  /// tests and error figures need beside the picture.
  std::vector<int> sampleCounts(const Scene& scene, const glm::ivec2& size);

  /// How many shader programs were compiled so far: editing a control point must not raise it.
  int compiledPrograms() const;

  /// The gradient moduli that the scene drawn last was lit with; meaningful where its lighting reads r.
  const GradientScale& gradientScale() const;

  /// A sentence each where the volume had to be down-sampled to fit the driver's textures and where the last
  /// picture's step would have needed too many samples; empty otherwise.
  std::string limitation() const;

private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

} // namespace limn
