// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/CpuEngine.h"

#include "cpu/CpuCosts.h"

namespace limn {
namespace {

class CpuEngine final : public DrawingEngine {
public:
  explicit CpuEngine(int threads) : m_renderer(threads) {}

  std::optional<Image> draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                            const IsCancelled& isCancelled) override {
    return m_renderer.draw(scene, size, tile, isCancelled);
  }
  double makeReady(const Scene& scene, const Effort& effort) override {
    m_renderer.makeReady(scene, effort);
    return 1.0;
  }
  Image drawUnlimited(const Scene& scene, const glm::ivec2& size) override {
    return m_renderer.renderUnlimited(scene, size);
  }
  bool prepare(const Scene&, const glm::ivec2&) override { return false; }
  std::unique_ptr<EffectMeasurement> measureEffects(const Scene& scene, const glm::ivec2& size) override {
    return measurementOf(std::make_unique<CpuCosts>(m_renderer), scene, size, m_renderer.plan(scene));
  }

  DrawingFacts facts(const Scene& scene) override {
    DrawingFacts facts;
    facts.plan = m_renderer.plan(scene);
    facts.steepestPerMm = m_renderer.steepestPerMm();
    facts.takesAllSamples = m_renderer.limitation().empty();
    return facts;
  }
  GradientScale gradientScale() const override { return m_renderer.gradientScale(); }
  int compiledPrograms() const override { return 0; }
  double memoryMb() const override { return m_renderer.memoryMb(); }
  std::string name() const override { return m_renderer.name(); }
  Message limitation() const override { return m_renderer.limitation(); }

private:
  CpuRenderer m_renderer;
};

} // namespace

std::unique_ptr<DrawingEngine> makeCpuEngine(int threads) {
  return std::make_unique<CpuEngine>(threads);
}

} // namespace limn
