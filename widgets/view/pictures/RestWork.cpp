// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/RestWork.h"

#include "scene/effects/EffectPlan.h"

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
  if (!isSamePicture(scenes, size))
    m_costSide.reset();
  m_sides.clear();
  for (const Scene& scene : scenes)
    m_sides.push_back({scene, false, false, 0, std::nullopt});
  m_size = size;
  m_costs.reset();
}

// The same, or the same in a window of another size, which the camera follows.
bool RestWork::isSamePicture(const std::vector<Scene>& scenes, const glm::ivec2& size) const {
  const auto isSame = [&](Scene wanted, const Side& side) {
    if (size != m_size) {
      wanted.camera = side.scene.camera;
      wanted.image = side.scene.image;
    }
    return wanted == side.scene;
  };
  return std::equal(scenes.begin(), scenes.end(), m_sides.begin(), m_sides.end(), isSame);
}

bool RestWork::step(DrawingEngine& engine) {
  return warmUp(engine) || findFineLight(engine) || measureOverflow(engine) || measureCosts(engine);
}

bool RestWork::warmUp(DrawingEngine& engine) {
  for (Side& side : m_sides) {
    if (side.isWarm)
      continue;
    m_sheet->resize(warmUpSize);
    m_sheet->lend([&] { side.isWarm = !engine.prepare(side.scene, warmUpSize); });
    return true;
  }
  return false;
}

// The next movement shows light on fine nodes where they are there (LightDetail). They are found with a
// picture of them, which a gesture ends as it ends others.
bool RestWork::findFineLight(DrawingEngine& engine) {
  for (Side& side : m_sides) {
    // Under a lamp that turns with the view nodes are found anew, and what moves of a large volume is
    // smaller.
    const Shading& shading = side.scene.shading;
    const bool turns = shading.shadow.strength > 0.0 && shading.lightAxes == LightAxes::camera;
    if (side.hasFineLight || turns || !hasTravellingLight(side.scene) || side.scene.volume->room() ||
        side.scene.quality.toleranceLevels)
      continue;
    Scene fine = side.scene;
    fine.quality.light = LightDetail::fine;
    m_sheet->resize(glm::ivec2(1));
    m_sheet->draw(engine, fine, {{0, 0}, glm::ivec2(1)});
    side.hasFineLight = true;
    return true;
  }
  return false;
}

bool RestWork::measureOverflow(DrawingEngine& engine) {
  for (Side& side : m_sides) {
    if (side.overflowPieces == 2)
      continue;
    // How bright light gets does not depend on how finely it is found, and nobody cancels this.
    Scene drawn = side.scene;
    if (hasTravellingLight(drawn))
      drawn.quality.light = LightDetail::moving;
    if (!engine.facts(side.scene).plan.effects.has(Effect::lighting)) {
      side.overflowPieces = 2;
      continue;
    }
    // Compile in one piece, draw in the next.
    if (++side.overflowPieces == 1) {
      engine.drawUnlimited(drawn, glm::ivec2(1));
      return true;
    }
    side.overflow = overflowOf(engine.drawUnlimited(drawn, measuredSize()));
    return true;
  }
  return false;
}

bool RestWork::measureCosts(DrawingEngine& engine) {
  if (!m_costSide)
    return false;
  if (!m_costs)
    m_costs = engine.measureEffects(m_sides[static_cast<std::size_t>(*m_costSide)].scene, measuredSize());
  if (!m_costs) // this engine cannot tell
    m_costSide.reset();
  if (!m_costs || m_costs->figures().isComplete)
    return false;
  m_sheet->resize(measuredSize());
  m_sheet->lend([this] { m_costs->step(); });
  return true;
}

glm::ivec2 RestWork::measuredSize() const {
  return smallerSize(m_size, longestMeasured);
}

bool RestWork::isWaiting() const {
  return m_costs && m_costs->figures().isWaiting;
}

EffectTimes RestWork::times() const {
  EffectTimes times;
  if (!m_costs) {
    times.isMeasuring = m_costSide.has_value();
    return times;
  }
  const EffectFigures figures = m_costs->figures();
  times.isMeasuring = !figures.isComplete;
  times.fraction = figures.fraction;
  times.costs = figures.costs;
  times.wouldCosts = figures.wouldCosts;
  times.wholeMs = figures.wholeMs;
  times.method = QString::fromStdString(figures.method);
  times.size = {measuredSize().x, measuredSize().y};
  return times;
}

} // namespace limn
