// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/RayCasterEngine.h"

#include "cpu/CpuEngine.h"
#include "cpu/LightFinder.h"
#include "gl/HeadlessContext.h"
#include "raycaster/CasterCosts.h"
#include "raycaster/RayCaster.h"
#include "scene/effects/EffectPlan.h"

namespace limn {
namespace {

// Whether a picture's light is found along paths from its samples, which no shader follows: at rest, and to
// compare with. What moves has it from nodes.
bool followsLight(const Scene& scene) {
  return hasTravellingLight(scene) && !scene.quality.toleranceLevels &&
         (scene.quality.light == LightDetail::spread || scene.quality.light == LightDetail::sampled);
}

Scene fromNodes(Scene scene) {
  if (followsLight(scene))
    scene.quality.light = LightDetail::fine;
  return scene;
}

// Draws with OpenGL but for pictures whose light the processor follows: it draws those.
//
// Tiles are handed to the driver, which cannot be called back: whoever draws asks for small ones.
class RayCasterEngine final : public DrawingEngine {
public:
  explicit RayCasterEngine(double mostVolumeMb)
      : m_caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, {},
                 {mostVolumeMb, false}) {
    m_caster.askForLight([this](const Scene& scene) { return light().known(scene); });
  }

  std::optional<Image> draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                            const IsCancelled& isCancelled) override {
    m_isByProcessor = followsLight(scene);
    if (m_isByProcessor)
      return processor().draw(scene, size, tile, isCancelled);
    m_caster.draw(scene, size, tile);
    return std::nullopt;
  }
  double makeReady(const Scene& scene, const Effort&) override {
    if (scene.volume != m_volume.lock()) { // they keep theirs
      m_light.reset();
      m_processor.reset();
    }
    m_volume = scene.volume;
    return m_caster.makeReady(scene);
  }
  bool isFindingLight(const Scene& scene) override {
    return hasTravellingLight(scene) && !followsLight(scene) && light().isFinding(scene);
  }
  Image drawUnlimited(const Scene& scene, const glm::ivec2& size) override {
    return m_caster.renderUnlimited(fromNodes(scene), size);
  }
  bool prepare(const Scene& scene, const glm::ivec2& size) override {
    return m_caster.warmUp(fromNodes(scene), size);
  }
  std::unique_ptr<EffectMeasurement> measureEffects(const Scene& scene, const glm::ivec2& size) override {
    if (followsLight(scene))
      return processor().measureEffects(scene, size);
    return measurementOf(std::make_unique<CasterCosts>(m_caster), scene, size, m_caster.plan(scene));
  }
  // What the processor knows of a scene it would find out anew in each frame of a drag.
  DrawingFacts facts(const Scene& scene) override {
    DrawingFacts facts = m_caster.facts(fromNodes(scene));
    if (followsLight(scene))
      facts.filterBits = mostFilterBits;
    return facts;
  }
  GradientScale gradientScale() const override {
    return m_isByProcessor ? m_processor->gradientScale() : m_caster.gradientScale();
  }
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

  DrawingEngine& processor() {
    if (!m_processor)
      m_processor = makeCpuEngine();
    return *m_processor;
  }

  RayCaster m_caster;
  std::weak_ptr<const Volume> m_volume;
  std::optional<LightInBackground> m_light;
  std::unique_ptr<DrawingEngine> m_processor;
  bool m_isByProcessor = false; // the last picture
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
