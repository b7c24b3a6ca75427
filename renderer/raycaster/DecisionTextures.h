// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/ShaderProgram.h"
#include "glsl/decisions/Decisions.h"
#include "glsl/textures/VolumeTexture.h"
#include "raycaster/StoredFields.h"
#include "scene/Scene.h"
#include "scene/effects/EffectSet.h"

#include <optional>

namespace limn {

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
