// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "glsl/textures/VolumeTexture.h"

#include <memory>
#include <optional>

namespace limn {

/// The field whose gradients are those of smooth normals (DEFINITION section 2) on the graphics card, beside
/// the texels of its volume and of the same size, in floats.
class SmoothedTexture {
public:
  /// Goes on uploading `smoothed` beside `volume`; the share that is there, 1 once all is. What it had of
  /// another is let go. Changes texture bindings. Throws VolumeTooLarge where both take more than
  /// they may, or the driver has no room for it.
  double uploadMore(const std::shared_ptr<const Volume>& smoothed, const VolumeTexture& volume,
                    const VolumeRoom& room);

  /// What texture coordinates of the volume read it from; 0 where there is none.
  unsigned name() const { return m_texture ? m_texture->name() : 0; }

  /// What its texels take on the graphics card.
  std::size_t bytes() const { return m_texture ? bytesOfFloats(m_size) : 0; }

private:
  static std::size_t bytesOfFloats(const glm::ivec3& size) {
    return sizeof(float) * static_cast<std::size_t>(size.x) * size.y * size.z;
  }

  std::shared_ptr<const Volume> m_smoothed;
  std::optional<GlTexture> m_texture;
  glm::ivec3 m_size{0};
  int m_planesDone = 0;
};

} // namespace limn
