// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/RayCasterEngine.h"

#include "cpu/LightFinder.h"
#include "gl/HeadlessContext.h"
#include "raycaster/CasterCosts.h"
#include "raycaster/RayCaster.h"
#include "scene/effects/EffectPlan.h"

namespace limn {
namespace {

// Tiles are handed to the driver, which cannot be called back: whoever draws asks for small ones.
class RayCasterEngine final : public DrawingEngine {
public:
  explicit RayCasterEngine(double mostVolumeMb)
      : m_caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, {},
                 {mostVolumeMb, false}) {
    m_caster.askForLight([this](const Scene& scene) { return light().known(scene); });
  }

  std::optional<Image> draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                            const IsCancelled&) override {
    m_caster.draw(scene, size, tile);
    return std::nullopt;
  }
  double makeReady(const Scene& scene, const Effort&) override {
    if (scene.volume != m_volume.lock())
      m_light.reset(); // keeps its volume
    m_volume = scene.volume;
    return m_caster.makeReady(scene);
  }
  bool isFindingLight(const Scene& scene) override {
    return hasTravellingLight(scene) && light().isFinding(scene);
  }
  Image drawUnlimited(const Scene& scene, const glm::ivec2& size) override {
    return m_caster.renderUnlimited(scene, size);
  }
  bool prepare(const Scene& scene, const glm::ivec2& size) override { return m_caster.warmUp(scene, size); }
  std::unique_ptr<EffectMeasurement> measureEffects(const Scene& scene, const glm::ivec2& size) override {
    return measurementOf(std::make_unique<CasterCosts>(m_caster), scene, size, m_caster.plan(scene));
  }
  DrawingFacts facts(const Scene& scene) override { return m_caster.facts(scene); }
  GradientScale gradientScale() const override { return m_caster.gradientScale(); }
  int compiledPrograms() const override { return m_caster.compiledPrograms(); }
  double memoryMb() const override { return m_caster.volumeMb(); }
  std::string name() const override { return m_name; }
  Message limitation() const override { return m_caster.limitation(); }

private:
  // A thread that most pictures do without.
  LightInBackground& light() {
    if (!m_light)
      m_light.emplace();
    return *m_light;
  }

  RayCaster m_caster;
  std::weak_ptr<const Volume> m_volume;
  std::optional<LightInBackground> m_light;
  std::string m_name = rendererName();
};

} // namespace

std::unique_ptr<DrawingEngine> makeRayCasterEngine() {
  return makeRayCasterEngineWithin(anyMb);
}

std::unique_ptr<DrawingEngine> makeRayCasterEngineWithin(double mostVolumeMb) {
  return std::make_unique<RayCasterEngine>(mostVolumeMb);
}

} // namespace limn
