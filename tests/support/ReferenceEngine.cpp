// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReferenceEngine.h"

#include "engine/VolumeTooLarge.h"
#include "reference/ReferenceIntegrator.h"

#include <algorithm>

namespace limn::test {
namespace {

Image partOf(const Image& image, const PixelRect& tile) {
  Image part(tile.size);
  for (int y = 0; y < tile.size.y; ++y)
    std::copy_n(&image.at(tile.topLeft.x, tile.topLeft.y + y), tile.size.x, &part.at(0, y));
  return part;
}

class ReferenceEngine final : public DrawingEngine {
public:
  explicit ReferenceEngine(int threads) : m_threads(threads) {}

  std::optional<Image> draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                            const IsCancelled& isCancelled) override {
    m_drawn = scene;
    const Image image =
        toImage(renderReference(scene, size, m_threads, isCancelled, Limiting::clampOrKnee, tile));
    return tile.size == size ? image : partOf(image, tile);
  }
  // Voxels are read as they are.
  double makeReady(const Scene&, const Effort&) override { return 1.0; }
  Image drawUnlimited(const Scene& scene, const glm::ivec2& size) override {
    return toImage(renderReference(scene, size, m_threads, {}, Limiting::none));
  }
  bool prepare(const Scene&, const glm::ivec2&) override { return false; }
  std::unique_ptr<EffectMeasurement> measureEffects(const Scene&, const glm::ivec2&) override { return {}; }

  DrawingFacts facts(const Scene& scene) override {
    requireDrawable(scene);
    m_limitation = stepLimitation(scene, mostSamples);
    SceneFacts known;
    known.steepestPerMm = steepness(*scene.volume);
    return {requiredEffects(scene, known), known.steepestPerMm, m_limitation.empty(), true};
  }
  GradientScale gradientScale() const override {
    return m_drawn.volume ? limn::gradientScale(*m_drawn.volume, m_drawn.shading) : GradientScale{};
  }
  int compiledPrograms() const override { return 0; }
  double memoryMb() const override { return 0.0; }
  std::string name() const override { return "reference (double precision)"; }
  Message limitation() const override { return m_limitation; }

private:
  int m_threads;
  Scene m_drawn;
  Message m_limitation;
};

} // namespace

std::unique_ptr<DrawingEngine> makeReferenceEngine(int threads) {
  return std::make_unique<ReferenceEngine>(threads);
}

} // namespace limn::test
