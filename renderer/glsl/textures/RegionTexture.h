// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "glsl/textures/VolumeTexture.h"
#include "scene/regions/BlockWeights.h"

#include <optional>
#include <vector>

namespace limn {

/// The weights of a kept region on the graphics card, beside the texels of its volume.
class RegionTexture {
public:
  /// Uploads a region that differs from the one before, beside the same volume's texture; one that restricts
  /// nothing is let go. Changes texture bindings. Throws Error (openGl) where the driver has no room for it.
  void update(const Region& region, const VolumeTexture& volume);

  /// What texture coordinates of the volume read weights from; 0 where all is kept.
  unsigned name() const { return m_texture ? m_texture->name() : 0; }

  /// Of the blocks of the volume's texture; none where all is kept.
  const BlockWeights& blocks() const { return m_blocks; }

private:
  Region m_region;
  std::optional<GlTexture> m_texture;
  BlockWeights m_blocks;
};

} // namespace limn
