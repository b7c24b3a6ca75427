// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "gl/ShaderProgram.h"
#include "scene/light/LightGrid.h"
#include "scene/volume/Grid.h"

#include <optional>

namespace limn {

/// What was found of the light that comes to a scene, on the graphics card.
class LightTextures {
public:
  /// Uploads what differs from the light before; changes texture bindings. Throws Error (openGl) where the
  /// driver has no room for it.
  void update(const LightVolumes& light);

  /// Binds them and sets, in a program in use, where nodes lie on a grid and how samples ask them: as of a
  /// fine picture where one is asked for and the nodes are.
  void apply(const ShaderProgram& program, const Grid& grid, bool isFine) const;

  /// Whether samples of such a picture look at what stands near them, beside the nodes.
  bool looksNear(const Grid& grid, bool isFine) const;

  /// What they take on the card.
  std::size_t bytes() const;

private:
  LightLook lookOn(const Grid& grid, bool isFine) const;

  LightVolumes m_light;
  std::optional<GlTexture> m_direct, m_ambient; ///< absent: nothing was drawn with such light yet
};

} // namespace limn
