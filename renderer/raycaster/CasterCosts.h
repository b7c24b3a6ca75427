// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/CostLight.h"
#include "engine/EffectCosts.h"
#include "gl/GpuTimer.h"
#include "raycaster/RayCaster.h"

namespace limn {

/// Lets the ray caster draw what is measured, with exactly the program of the effects that are left, into the
/// framebuffer bound, which has room for the picture. The caster draws whole pictures again after each.
/// Needs the same context current for every call and for its end.
class CasterCosts : public CostedDrawing {
public:
  explicit CasterCosts(RayCaster& caster) : m_caster(caster) {}

  bool useLightOf(const Scene& scene) override;
  SceneFacts factsOf(const Scene& scene) const override { return m_caster.sceneFacts(scene); }
  bool canDraw(const Scene& scene) const override;
  void draw(const Scene& scene, EffectSet leftOut, const glm::ivec2& size, const PixelRect& tile) override;
  Image picture(const Scene& scene, EffectSet leftOut, const glm::ivec2& size) override;
  void calibrate(const Work& work) override;
  double measureMs(const Work& work) override { return m_timer->measureMs(work); }
  std::string method() const override { return m_timer ? m_timer->description() : std::string(); }

private:
  RayCaster& m_caster;
  CostLight m_light;
  std::optional<GpuTimer> m_timer;
};

} // namespace limn
