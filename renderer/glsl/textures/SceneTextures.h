// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "glsl/decisions/Decisions.h"
#include "glsl/textures/LookTextures.h"
#include "glsl/textures/SmoothedTexture.h"
#include "glsl/textures/VolumeTexture.h"
#include "scene/LabelLooks.h"
#include "scene/Scene.h"
#include "scene/effects/EffectPlan.h"
#include "scene/function/PiecewiseTable.h"
#include "scene/light/GradientField.h"
#include "scene/regions/BlockWeights.h"
#include "scene/steps/BlockSteps.h"
#include "scene/steps/EmptySpace.h"
#include "scene/steps/RayFrame.h"

#include <memory>
#include <optional>
#include <vector>

namespace limn {

/// The entries of a format's table: the function at equal distances over the volume's range, both ends
/// included (HARD_CASES H26 and H27). None for the exact format. `stepMm` is the step for which
/// corrected entries hold their opacity.
std::vector<glm::vec4> tableEntries(const TransferFunction& function, const ValueRange& range,
                                    TableFormat format, double stepMm);

/// The function as a table shows it, linear between entries, to tell where something can be seen; the
/// function itself for the exact format.
TransferFunction tabulated(const TransferFunction& function, const ValueRange& range, TableFormat format);

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

/// The map of error-controlled steps on the graphics card: for each block the distance, in blocks, to the
/// nearest of which something shows (red), its plain rung + 128 (green) and its resolving rung (blue).
class BlockStepTexture {
public:
  /// Gathers the facts of a new volume and the rungs under a new transfer function or kept region, and
  /// uploads them; changes texture bindings.
  void update(const Scene& scene);

  unsigned name() const { return m_texture.name(); }
  const glm::ivec3& blocks() const { return m_steps.blocks; }

  /// False where the finest step misses bands of the transfer function.
  bool resolvesFunction() const { return m_steps.resolvesFunction; }

private:
  GlTexture m_texture;
  std::shared_ptr<const Volume> m_volume;
  BlockFacts m_facts;
  std::optional<LabelLooks> m_looks;
  Region m_keep;
  BlockSteps m_steps;
};

/// A piecewise function on the graphics card.
class FunctionTexture {
public:
  void upload(const PiecewiseTable& table);

  unsigned bins() const { return m_bins.name(); }
  unsigned segments() const { return m_segments.name(); }
  unsigned occupancy() const { return m_occupancy.name(); }
  const glm::vec3& domain() const { return m_domain; }
  int loopSteps() const { return m_loopSteps; }

private:
  GlTexture m_bins;
  GlTexture m_segments;
  GlTexture m_occupancy;
  glm::vec3 m_domain{0.0f};
  int m_loopSteps = 0;
};

/// The distances of an EmptySpaceMap on the graphics card.
class EmptySpaceTexture {
public:
  void upload(const glm::ivec3& blocks, const BlockDistances& distances);

  unsigned name() const { return m_texture.name(); }

private:
  GlTexture m_texture;
  glm::ivec3 m_blocks{0};
};

/// What a scene needs on the graphics card and what must be measured of its volume once. Uploads and measures
/// what differs from the scene before and nothing else.
class SceneTextures {
public:
  /// Of the decisions those count that concern the volume's format and where the function shows.
  explicit SceneTextures(const Decisions& decisions = {}, const VolumeRoom& room = {})
      : m_decisions(decisions), m_room(room) {}

  /// Uploads a piece of the scene's volume, where it is not there yet, then smooths and uploads a piece of
  /// what its normals are found from, where the scene asks for that; the share that is there, 1 once all is.
  /// Changes texture bindings.
  double uploadVolume(const Scene& scene);

  /// Uploads volume and functions; changes texture bindings.
  void update(const Scene& scene);

  /// Measures the gradients of the volume of the last update, where an effect reads them.
  void measure(const Scene& scene, EffectSet effects);

  /// Facts on which the effects of the scene of the last update depend. Measures what they need.
  SceneFacts facts(const Scene& scene);

  /// The steepness of the volume of the last update; measures it once.
  double steepestPerMm();

  const VolumeTexture& volume() const { return *m_volumeTexture; }
  const EmptySpaceTexture& emptySpace() const { return m_emptySpace; }
  const SmoothedTexture& smoothed() const { return m_smoothed; }
  const RegionTexture& region() const { return m_region; }
  const LookTextures& looks() const { return m_looks; }

  /// Valid where the scene of the last update asks for error-controlled steps.
  const BlockStepTexture& blockSteps() const { return m_blockSteps; }

  /// The part of the volume outside which nothing may show, in centred index coordinates.
  IndexBox visibleBox() const;
  const FunctionTexture& function() const { return m_function; }
  const FunctionTexture& gradientCurve() const { return m_gradientCurve; }

  /// Valid where an effect reads the gradient, after `measure`.
  const GradientScale& gradientScale() const { return m_gradientScale; }

  /// One sentence where the volume is shown down-sampled, otherwise empty.
  Message limitation() const { return m_volumeTexture ? m_volumeTexture->limitation() : Message(); }

  /// The unit of gradients in the shaders, value/mm: the volume's range per smallest spacing.
  double gradientUnit() const;

private:
  // What decides where nothing can be seen.
  struct EmptySpaceKey {
    TransferFunction function;
    bool showsFunction = true;
    std::optional<double> isovalue;
    Region keep;
    bool operator==(const EmptySpaceKey&) const = default;
  };

  void beginVolume(const Scene& scene);
  void updateEmptySpace(const Scene& scene);

  Decisions m_decisions;
  VolumeRoom m_room;
  std::shared_ptr<const Volume> m_volume;
  std::optional<VolumeTexture> m_volumeTexture;
  RegionTexture m_region;
  LookTextures m_looks;
  std::optional<LabelLooks> m_functionShown;
  PiecewiseTable m_functionTable;
  FunctionTexture m_function;
  std::optional<EmptySpaceKey> m_emptySpaceShown;
  EmptySpaceTexture m_emptySpace;
  BlockStepTexture m_blockSteps;
  EmptySpaceMap m_empty;
  std::optional<GradientOpacity> m_gradientOpacityShown;
  FunctionTexture m_gradientCurve;
  GradientScale m_gradientScale;
  std::optional<double> m_steepness;
  GradientField m_gradients;
  SmoothedTexture m_smoothed;
};

} // namespace limn
