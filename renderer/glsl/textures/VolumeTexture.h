// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "glsl/decisions/Decisions.h"
#include "glsl/textures/GraphicsMemory.h"
#include "scene/steps/BlockRanges.h"
#include "scene/steps/EmptySpace.h"
#include "scene/volume/Volume.h"

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

/// The texels along each axis, without the apron, of a volume reduced by whole factors.
glm::ivec3 reducedDims(const glm::ivec3& dims, const glm::ivec3& reduction);

/// Averages boxes of `reduction` voxels, normalises in double and adds the apron.
TextureVoxels textureVoxels(const Volume& volume, const glm::ivec3& reduction);

/// Writes the planes z = `first` … `end`-1 of those texels to `to`, which has room for them.
void fillPlanes(const Volume& volume, const glm::ivec3& reduction, int first, int end, float* to);

/// Rounds a texel to what a fixed-point texture of so many parts holds whose 0..1 stand for `stored`.
float quantised(float texel, const ValueRange& stored, int parts);

/// The inner planes of texels of whose blocks the layer z = `layer` consists, with one more before the first
/// and one behind the last: first and end, counted with the apron of a volume of `size` texels.
glm::ivec2 planesOfLayer(const glm::ivec3& size, int layer);

/// Gathers the layers z = `first` … `end`-1 of blocks of a volume of `size` texels with its apron. `texels`
/// are its planes from the first that belongs to them. BlockRanges::finish is left to the caller.
void gatherLayers(const float* texels, const glm::ivec3& size, int first, int end, BlockRanges& ranges);

/// A volume on the graphics card, down-sampled by whole factors where the driver cannot hold it or it would
/// take more than it may, and where that is allowed.
class VolumeTexture {
public:
  /// Makes room; nothing may be drawn before it is complete. Throws Error (openGl) where even a small texture
  /// is refused, VolumeTooLarge where the whole one is and nothing less may be shown, or where the volume
  /// does not lie in memory.
  explicit VolumeTexture(const Volume& volume, VolumeFormat format = VolumeFormat::r32f,
                         const VolumeRoom& room = {});

  /// Uploads the next layers of the volume that it was made for; only while not complete. Changes texture
  /// bindings. Throws as the constructor does.
  void uploadMore(const Volume& volume);
  bool isComplete() const;
  double uploadedShare() const; ///< 0..1

  unsigned name() const { return m_texture.name(); }

  /// Texture coordinates = centred index · scale + offset.
  glm::dvec3 scale() const;
  glm::dvec3 offset() const { return glm::dvec3(0.5) + m_shift; }

  /// Texture coordinates of the outermost voxel centres, and the size of a texel.
  glm::dvec3 lower() const { return 1.5 / glm::dvec3(m_size); }
  glm::dvec3 upper() const { return 1.0 - lower(); }
  glm::dvec3 texel() const { return 1.0 / glm::dvec3(m_size); }

  /// Texels along each axis, with the apron.
  const glm::ivec3& size() const { return m_size; }

  const glm::ivec3& reduction() const { return m_reduction; }

  const BlockRanges& ranges() const { return m_ranges; }

  /// Block coordinates = texture coordinates · blocksPerTexture + blockOffset: 0 at the first voxel's centre.
  glm::dvec3 blocksPerTexture() const { return glm::dvec3(m_size) / double(blockSize); }
  glm::dvec3 blockOffset() const { return glm::dvec3(-1.5 / blockSize); }

  /// What its texels take on the graphics card.
  std::size_t bytes() const;

  /// One sentence where the volume was down-sampled, otherwise empty.
  Message limitation() const;

private:
  Message tooLarge() const;
  void reduce();
  void allocate();

  GlTexture m_texture;
  VolumeFormat m_format;
  VolumeRoom m_room;
  glm::ivec3 m_dims;
  glm::ivec3 m_size{0};
  glm::ivec3 m_reduction{1};
  BlockRanges m_ranges;
  int m_layersDone = 0;                     ///< of blocks
  int m_planesDone = 0;                     ///< of texels
  std::vector<float> m_texels, m_quantised; ///< of the layers that are being uploaded
  glm::dvec3 m_shift{0.0}; ///< of the box's centre, where the last texel is only partly covered
};

} // namespace limn
