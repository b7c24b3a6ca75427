// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/CpuCosts.h"

#include "cpu/LightStore.h"

#include <chrono>

namespace limn {
namespace {

// Whether light is found along many paths, which takes up to milliseconds a pixel.
bool samplesLight(const Quality& quality) {
  return quality.light == LightDetail::sampled || (asksFineLight(quality) && quality.toleranceLevels);
}

} // namespace

Image CpuCosts::tileOf(const Scene& scene, EffectSet leftOut, const glm::ivec2& size, const PixelRect& tile) {
  return m_renderer.drawWithout(leftOut, scene, size, tile, &m_light.light());
}

bool CpuCosts::useLightOf(const Scene& scene) {
  if (!cpu::looksUpLight(scene)) {
    m_light.useNone();
    return true;
  }
  return m_light.use(scene, [this](const Scene& first) { return m_renderer.lightOf(first); });
}

// No step may hold up a window for a minute.
bool CpuCosts::canDraw(const Scene& scene) const {
  return !(samplesLight(scene.quality) && requiredEffects(scene, {}).effects.hasAny(travellingLight));
}

void CpuCosts::draw(const Scene& scene, EffectSet leftOut, const glm::ivec2& size, const PixelRect& tile) {
  tileOf(scene, leftOut, size, tile);
}

Image CpuCosts::picture(const Scene& scene, EffectSet leftOut, const glm::ivec2& size) {
  return tileOf(scene, leftOut, size, {{0, 0}, size});
}

double CpuCosts::measureMs(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace limn
