// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/CasterCosts.h"

#include "engine/VolumeTooLarge.h"
#include "gl/PictureTarget.h"

namespace limn {
namespace {

// Draws whole pictures again, whatever happens.
struct LeftOut {
  LeftOut(RayCaster& ofCaster, EffectSet effects, const LightVolumes& light) : caster(ofCaster) {
    caster.leaveOut(effects);
    caster.holdLight(light);
  }
  ~LeftOut() {
    caster.leaveOut(std::nullopt);
    caster.holdLight(std::nullopt);
  }
  LeftOut(const LeftOut&) = delete;
  LeftOut& operator=(const LeftOut&) = delete;
  RayCaster& caster;
};

} // namespace

bool CasterCosts::useLightOf(const Scene& scene) {
  return m_light.use(scene, [this](const Scene& first) { return m_caster.lightOf(first); });
}

bool CasterCosts::canDraw(const Scene& scene) const {
  try {
    requireLightOfShaders(scene);
    return true;
  } catch (const BeyondDriver&) {
    return false;
  }
}

void CasterCosts::draw(const Scene& scene, EffectSet leftOut, const glm::ivec2& size, const PixelRect& tile) {
  const LeftOut without(m_caster, leftOut, m_light.light());
  for (int y = 0; y < tile.size.y; y += RayCaster::tileSize)
    for (int x = 0; x < tile.size.x; x += RayCaster::tileSize) {
      const glm::ivec2 corner(x, y);
      m_caster.draw(scene, size,
                    {tile.topLeft + corner, glm::min(glm::ivec2(RayCaster::tileSize), tile.size - corner)});
    }
}

Image CasterCosts::picture(const Scene& scene, EffectSet leftOut, const glm::ivec2& size) {
  draw(scene, leftOut, size, {{0, 0}, size});
  return readBack(size);
}

void CasterCosts::calibrate(const Work& work) {
  m_timer.emplace();
  m_timer->calibrate(work);
}

} // namespace limn
