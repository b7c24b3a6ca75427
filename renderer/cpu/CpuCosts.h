// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/CostLight.h"
#include "cpu/CpuRenderer.h"
#include "engine/EffectCosts.h"

namespace limn {

/// Lets the CPU engine draw what is measured; the clock tells its time.
class CpuCosts : public CostedDrawing {
public:
  explicit CpuCosts(CpuRenderer& renderer) : m_renderer(renderer) {}

  bool useLightOf(const Scene& scene) override;
  SceneFacts factsOf(const Scene& scene) const override { return m_renderer.sceneFacts(scene); }
  bool canDraw(const Scene& scene) const override;
  void draw(const Scene& scene, EffectSet leftOut, const glm::ivec2& size, const PixelRect& tile) override;
  Image picture(const Scene& scene, EffectSet leftOut, const glm::ivec2& size) override;
  void calibrate(const Work&) override {}
  double measureMs(const Work& work) override;
  std::string method() const override { return "timed by the clock"; }

private:
  Image tileOf(const Scene& scene, EffectSet leftOut, const glm::ivec2& size, const PixelRect& tile);

  CpuRenderer& m_renderer;
  CostLight m_light;
};

} // namespace limn
