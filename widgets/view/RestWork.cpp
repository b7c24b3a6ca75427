// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h> // before any OpenGL header of Qt

#include "widgets/view/RestWork.h"

#include <algorithm>

namespace limn {
namespace {

// Small enough for a frame to fit into a turn of the event loop on a software renderer.
constexpr int longestMeasured = 256;

constexpr glm::ivec2 warmUpSize{16, 16};

} // namespace

glm::ivec2 smallerSize(const glm::ivec2& size, int longest) {
  const double scale = std::min(1.0, static_cast<double>(longest) / std::max(size.x, size.y));
  return glm::max(glm::ivec2(1), glm::ivec2(glm::round(glm::dvec2(size) * scale)));
}

void RestWork::want(const std::vector<Scene>& scenes, const glm::ivec2& size) {
  m_sides.clear();
  for (const Scene& scene : scenes)
    m_sides.push_back({scene, false, 0, std::nullopt});
  m_size = size;
  m_costSide.reset();
  m_costs.reset();
}

bool RestWork::step(RayCaster& caster) {
  return warmUp(caster) || measureOverflow(caster) || measureCosts(caster);
}

bool RestWork::warmUp(RayCaster& caster) {
  for (Side& side : m_sides) {
    if (side.isWarm)
      continue;
    m_target.resize(warmUpSize);
    m_target.bind();
    side.isWarm = !caster.warmUp(side.scene, warmUpSize);
    glFinish();
    return true;
  }
  return false;
}

bool RestWork::measureOverflow(RayCaster& caster) {
  for (Side& side : m_sides) {
    if (side.overflowPieces == 2)
      continue;
    if (!caster.plan(side.scene).effects.has(Effect::lighting)) {
      side.overflowPieces = 2;
      continue;
    }
    // Compile in one piece, draw in the next.
    if (++side.overflowPieces == 1) {
      caster.renderUnlimited(side.scene, glm::ivec2(1));
      return true;
    }
    side.overflow = overflowOf(caster.renderUnlimited(side.scene, smallerSize(m_size, longestMeasured)));
    return true;
  }
  return false;
}

bool RestWork::measureCosts(RayCaster& caster) {
  if (!m_costSide)
    return false;
  if (!m_costs) {
    const Scene& scene = m_sides[static_cast<std::size_t>(*m_costSide)].scene;
    m_costs.emplace(scene, smallerSize(m_size, longestMeasured), effectRows(scene, caster.plan(scene)));
  }
  if (m_costs->isComplete())
    return false;
  m_target.resize(m_costs->size());
  m_target.bind();
  m_costs->step(caster);
  return true;
}

EffectTimes RestWork::times() const {
  EffectTimes times;
  times.isMeasuring = m_costSide && !(m_costs && m_costs->isComplete());
  if (!m_costs)
    return times;
  times.fraction = m_costs->fraction();
  times.size = {m_costs->size().x, m_costs->size().y};
  times.method = QString::fromStdString(m_costs->method());
  if (m_costs->isComplete()) {
    times.costs = m_costs->costs();
    times.wholeMs = m_costs->wholeMs();
  }
  return times;
}

} // namespace limn
