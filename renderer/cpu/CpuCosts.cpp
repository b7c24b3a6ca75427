// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/CpuCosts.h"

#include <chrono>

namespace limn {

Image CpuCosts::tileOf(const Scene& scene, EffectSet leftOut, const glm::ivec2& size, const PixelRect& tile) {
  if (!m_light)
    m_light = m_renderer.lightOf(scene);
  return m_renderer.drawWithout(leftOut, scene, size, tile, &*m_light);
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
