// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/BlockSteps.h"
#include "scene/steps/LocalSteps.h"
#include "scene/steps/RayFrame.h"

namespace limn {

/// What the rays of a picture in error-controlled steps share.
struct LocalStepTerms {
  BlockSteps steps;
  double fineness = 0.0;
  double smallestMm = 1.0;
  glm::dvec3 centre{0.0}; ///< index of the box's centre

  /// The step of a rung, mm.
  double stepMm(int rung) const { return stepOfRung(rung) * ladderScale(fineness) * smallestMm; }
};

/// The rungs of every block of a scene, of whose volume the facts are known. Throws Cancelled.
BlockSteps blockSteps(const Scene& scene, const BlockFacts& facts, const Effort& effort = {});

/// The terms of a scene, of whose volume the facts may be known; absent where it is drawn in equal steps.
std::optional<LocalStepTerms> localStepTerms(const Scene& scene);
std::optional<LocalStepTerms> localStepTerms(const Scene& scene, const BlockFacts& facts,
                                             const Effort& effort = {});

/// The chords of a ray in the blocks that it crosses, one after the other. Twin of shaders/local_steps.glsl,
/// which leaps over empty blocks; here each is visited.
class BlockWalk {
public:
  BlockWalk(const LocalStepTerms& terms, const FramedRay& ray, const RaySpan& span);

  /// Enters the next block in which there is anything of the ray; false behind its end.
  bool enterNext();

  const StepRungs& rungs() const { return m_rungs; }
  double entry() const { return m_entry; } ///< mm behind the span's begin
  double exit() const { return m_exit; }

private:
  const LocalStepTerms* m_terms;
  glm::dvec3 m_first;   // in blocks, at the span's begin
  glm::dvec3 m_advance; // blocks per mm
  double m_end;
  glm::ivec3 m_next;
  StepRungs m_rungs;
  double m_entry = 0.0;
  double m_exit = 0.0;
};

} // namespace limn
