// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/CasterCosts.h"

namespace limn {
namespace {

// Draws whole pictures again, whatever happens.
struct LeftOut {
  LeftOut(RayCaster& ofCaster, EffectSet effects) : caster(ofCaster) { caster.leaveOut(effects); }
  ~LeftOut() { caster.leaveOut(std::nullopt); }
  LeftOut(const LeftOut&) = delete;
  LeftOut& operator=(const LeftOut&) = delete;
  RayCaster& caster;
};

} // namespace

void CasterCosts::draw(const Scene& scene, EffectSet leftOut, const glm::ivec2& size, const PixelRect& tile) {
  const LeftOut without(m_caster, leftOut);
  for (int y = 0; y < tile.size.y; y += RayCaster::tileSize)
    for (int x = 0; x < tile.size.x; x += RayCaster::tileSize) {
      const glm::ivec2 corner(x, y);
      m_caster.draw(scene, size,
                    {tile.topLeft + corner, glm::min(glm::ivec2(RayCaster::tileSize), tile.size - corner)});
    }
}

void CasterCosts::calibrate(const Work& work) {
  m_timer.emplace();
  m_timer->calibrate(work);
}

} // namespace limn
