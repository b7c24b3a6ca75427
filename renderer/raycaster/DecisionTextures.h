// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "gl/ShaderProgram.h"
#include "glsl/decisions/Decisions.h"
#include "glsl/textures/VolumeTexture.h"
#include "scene/Scene.h"
#include "scene/basics/Message.h"
#include "scene/effects/EffectSet.h"
#include "scene/function/TransferFunction.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace limn {

/// A 3D texture of four channels, read with linear interpolation, beside the texture of a volume and of the
/// same size.
class VoxelTexture {
public:
  enum class Format { halves, bytes };

  /// Writes the texels of slice k, x fastest.
  using FillSlice = std::function<void(int k, std::vector<glm::vec4>& texels)>;

  /// Uploads slice by slice, which needs no second copy of the whole. `what` names it in the Error (openGl)
  /// that is thrown where the driver has no room for it.
  VoxelTexture(const glm::ivec3& size, Format format, const Message& what, const FillSlice& fill);

  unsigned name() const { return m_texture.name(); }
  std::size_t bytes() const { return m_bytes; }

private:
  GlTexture m_texture;
  std::size_t m_bytes = 0;
};

/// Gradients of texels made before drawing, and what one of the stored numbers means.
struct StoredGradients {
  VoxelTexture texture;
  double unitPerStored = 1.0; ///< of a component (halves) or of the modulus (directions)
};

/// `scale` leads from a difference over two texels to the unit of gradients in the shaders, whose components
/// then are at most 1. Halves are off by at most 2⁻¹¹ of a component (eleven binary digits) down to
/// components of 2⁻²⁹; what is interpolated are vectors, as DEFINITION section 2 asks. Directions are off by
/// at most 1/255 in each component, moduli by 1/510 of the largest; interpolated apart, a weak gradient turns
/// a strong neighbour's direction as much as that turns its own.
StoredGradients storedGradients(const TextureVoxels& voxels, const glm::dvec3& scale, GradientFormat format);

/// What the transfer function makes of each texel: colour times opacity, and opacity over the unit distance.
/// To be made anew with every change of the function.
VoxelTexture classifiedVolume(const TextureVoxels& voxels, const ValueRange& range,
                              const TransferFunction& function, ClassificationOrder order);

/// What decisions other than the program's own need on the graphics card beside the textures of the scene:
/// a table of the transfer function, gradients made before, voxels classified before. Nothing for the
/// defaults.
class DecisionTextures {
public:
  explicit DecisionTextures(const Decisions& decisions) : m_decisions(decisions) {}

  /// Makes what a picture of these effects needs and what differs from the scene before; changes texture
  /// bindings. `volume` holds the scene's volume. Throws Error (openGl) where the driver has no room.
  void update(const Scene& scene, const VolumeTexture& volume, EffectSet effects);

  /// Sets the samplers and uniforms of the blocks of shaders/decisions and binds their textures.
  void apply(const ShaderProgram& program) const;

  /// What is kept for every voxel on the graphics card.
  std::size_t bytes() const;

private:
  // What a table depends on.
  struct TableKey {
    TransferFunction function;
    ValueRange range;
    double stepMm = 0.0;
    bool operator==(const TableKey&) const = default;
  };

  void updateTable(const Scene& scene);
  void updateGradients(const Scene& scene, const VolumeTexture& volume);
  void updateClassified(const Scene& scene, const VolumeTexture& volume);

  Decisions m_decisions;
  std::shared_ptr<const Volume> m_volume;
  std::optional<StoredGradients> m_gradients;
  std::optional<TextureVoxels> m_voxels; ///< kept to be classified anew
  std::optional<TransferFunction> m_classifiedBy;
  std::optional<VoxelTexture> m_classified;
  GlTexture m_table;
  std::optional<TableKey> m_tableShown;
  int m_tableEntries = 0;
};

} // namespace limn
