// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/BlockWalk.h"

#include "scene/LabelLooks.h"

#include <limits>

namespace limn {

BlockSteps blockSteps(const Scene& scene, const BlockFacts& facts, const Effort& effort) {
  const LabelLooks looks = labelLooks(scene);
  BlockLooks ofBlocks;
  if (looks.areAny())
    ofBlocks = blockLooks(*scene.keep.labels, looks.ofLabel, {facts.blocks, glm::ivec3(factCells)}, effort,
                          facts.facts.get_allocator().room());
  return blockSteps(facts, looks.functions, ofBlocks, smallestSpacingMm(scene.volume->grid()),
                    factWeights(scene.keep, facts, effort), effort);
}

std::optional<LocalStepTerms> localStepTerms(const Scene& scene) {
  if (!finenessOf(scene.quality))
    return std::nullopt;
  return localStepTerms(scene, blockFacts(*scene.volume));
}

std::optional<LocalStepTerms> localStepTerms(const Scene& scene, const BlockFacts& facts,
                                             const Effort& effort) {
  const std::optional<double> fineness = finenessOf(scene.quality);
  if (!fineness)
    return std::nullopt;
  const Grid& grid = scene.volume->grid();
  const double smallest = smallestSpacingMm(grid);
  return LocalStepTerms{blockSteps(scene, facts, effort), *fineness, smallest, centreIndex(grid)};
}

BlockWalk::BlockWalk(const LocalStepTerms& terms, const FramedRay& ray, const RaySpan& span)
    : m_terms(&terms), m_first((ray.anchor + span.begin * ray.direction + terms.centre) / double(factCells)),
      m_advance(ray.direction / double(factCells)), m_end(span.end - span.begin),
      m_next(glm::clamp(glm::ivec3(glm::floor(m_first)), glm::ivec3(0), terms.steps.blocks - 1)) {}

bool BlockWalk::enterNext() {
  do {
    if (!(m_exit < m_end))
      return false;
    m_rungs = m_terms->steps.rungs[voxelOffset(m_terms->steps.blocks, m_next.x, m_next.y, m_next.z)];

    // Leave through the nearest face ahead; the outermost blocks have no end.
    double exit = std::numeric_limits<double>::infinity();
    int through = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const bool isForward = m_advance[axis] > 0.0;
      const int last = isForward ? m_terms->steps.blocks[axis] - 1 : 0;
      if (std::abs(m_advance[axis]) * factCells < 1e-20 || m_next[axis] == last)
        continue;
      const double face = m_next[axis] + (isForward ? 1.0 : 0.0);
      const double at = (face - m_first[axis]) / m_advance[axis];
      if (at < exit) {
        exit = at;
        through = axis;
      }
    }
    if (exit < m_end)
      m_next[through] += m_advance[through] > 0.0 ? 1 : -1;
    m_entry = m_exit;
    m_exit = std::max(std::min(exit, m_end), m_entry);
  } while (!(m_exit > m_entry));
  return true;
}

} // namespace limn
