// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "scene/Scene.h"
#include "scene/steps/BlockSteps.h"

#include <memory>
#include <optional>

namespace limn {

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
  std::optional<TransferFunction> m_function;
  Region m_keep;
  BlockSteps m_steps;
};

} // namespace limn
