// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "scene/Volume.h"

#include <string>
#include <vector>

namespace limn {

/// Voxels as the shaders read them: normalised over the volume's range, with an apron of one voxel on every
/// side extrapolated linearly (f[-1] = 2f[0] - f[1]; a copy along an axis of one voxel).
struct TextureVoxels {
  glm::ivec3 size{0};      ///< with the apron
  glm::ivec3 reduction{1}; ///< voxels of the volume per texel, along each axis
  std::vector<float> texels;
};

/// Averages boxes of `reduction` voxels, normalises in double and adds the apron.
TextureVoxels textureVoxels(const Volume& volume, const glm::ivec3& reduction);

/// A volume on the graphics card, down-sampled by whole factors where the driver cannot hold it.
class VolumeTexture {
public:
  /// Throws Error (openGl) where even a small texture is refused.
  explicit VolumeTexture(const Volume& volume);

  unsigned name() const { return m_texture.name(); }

  /// Texture coordinates = centred index · scale + offset.
  glm::dvec3 scale() const;
  glm::dvec3 offset() const { return glm::dvec3(0.5) + m_shift; }

  /// Texture coordinates of the outermost voxel centres, and the size of a texel.
  glm::dvec3 lower() const { return 1.5 / glm::dvec3(m_size); }
  glm::dvec3 upper() const { return 1.0 - lower(); }
  glm::dvec3 texel() const { return 1.0 / glm::dvec3(m_size); }

  const glm::ivec3& reduction() const { return m_reduction; }

  /// One sentence where the volume was down-sampled, otherwise empty.
  std::string limitation() const;

private:
  GlTexture m_texture;
  glm::ivec3 m_dims;
  glm::ivec3 m_size{0};
  glm::ivec3 m_reduction{1};
  glm::dvec3 m_shift{0.0}; ///< of the box's centre, where the last texel is only partly covered
};

} // namespace limn
