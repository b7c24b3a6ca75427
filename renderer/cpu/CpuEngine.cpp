// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/CpuEngine.h"

#include "cpu/CpuCosts.h"
#include "scene/regions/Reduction.h"
#include "scene/volume/Pyramid.h"

#include <optional>
#include <vector>

namespace limn::cpu {
namespace {

// Scenes of fewer voxels, in memory, that stand in for those of a volume which does not lie there.
class StandIns {
public:
  /// Voxels of at most so many bytes for each level; one voxel in any case.
  explicit StandIns(std::uint64_t mostBytes) : m_mostBytes(mostBytes) {}

  /// Makes those of a volume, and forgets the last one's; none where it lies in memory. False where they are
  /// there. Throws Cancelled, and is then without any.
  bool makeReady(const std::shared_ptr<const Volume>& volume, const Effort& effort);

  /// Of a scene that is to be drawn in `size` pixels: of the levels whose voxels are no larger than a pixel
  /// in the middle of the volume the coarsest, or the finest. Absent where the volume is not the one made
  /// ready.
  std::optional<StandIn> of(const Scene& scene, const glm::ivec2& size);

  const std::vector<CoarseVolume>& levels() const { return m_levels; }

private:
  const Region& kept(const Region& keep, int reduction, std::size_t level);

  struct Kept {
    Region whole, coarse;
  };

  std::uint64_t m_mostBytes;
  std::shared_ptr<const Volume> m_whole;
  std::vector<CoarseVolume> m_levels;
  std::vector<Kept> m_kept; // what was kept last, of each level
};

double pixelMm(const Scene& scene, const glm::ivec2& size) {
  const Camera& camera = scene.camera;
  const double away = camera.projection == Camera::Projection::orthographic
                          ? 1.0
                          : glm::length(camera.position - boxCentreMm(scene.volume->grid()));
  return 2.0 * halfHeight(camera) * away / size.y;
}

bool StandIns::makeReady(const std::shared_ptr<const Volume>& volume, const Effort& effort) {
  if (volume == m_whole)
    return false;
  m_whole.reset();
  m_levels.clear();
  m_kept.clear();
  if (volume->room())
    m_levels = pyramidOf(*volume, m_mostBytes, effort);
  m_kept.resize(m_levels.size());
  m_whole = volume;
  return true;
}

std::optional<StandIn> StandIns::of(const Scene& scene, const glm::ivec2& size) {
  if (m_levels.empty() || scene.volume != m_whole)
    return std::nullopt;
  const double pixel = pixelMm(scene, size);
  std::size_t level = 0;
  while (level + 1 < m_levels.size() && smallestSpacingMm(m_levels[level + 1].volume->grid()) <= pixel)
    ++level;
  const CoarseVolume& coarse = m_levels[level];
  StandIn standIn{scene, {coarse.reduction, coarse.largestError}};
  standIn.scene.volume = coarse.volume;
  standIn.scene.keep = kept(scene.keep, coarse.reduction, level);
  return standIn;
}

const Region& StandIns::kept(const Region& keep, int reduction, std::size_t level) {
  Kept& last = m_kept[level];
  if (last.whole != keep)
    last = {keep, reduced(keep, glm::ivec3(reduction))};
  return last.coarse;
}

} // namespace
} // namespace limn::cpu

namespace limn {
namespace {

// Of the memory that the process keeps for itself, for each level that stands in for a volume: next to it
// lies what is made of it, and of two pictures.
constexpr std::uint64_t shareOfBudget = 8;

// Of getting ready, for the ranges of blocks; the rest is for what stands in.
constexpr double rangesShare = 0.4;

class CpuEngine final : public DrawingEngine {
public:
  CpuEngine(int threads, const MemoryBudget& budget)
      : m_threads(threads), m_whole(threads, CpuRenderer::Tolerance::stepsFirst),
        m_standIns(budget.bytes() / shareOfBudget), m_last(&m_whole) {}

  std::optional<Image> draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                            const IsCancelled& isCancelled) override {
    return rendererFor(scene).draw(scene, size, tile, isCancelled);
  }
  double makeReady(const Scene& scene, const Effort& effort) override {
    const bool isOnDisk = scene.volume && scene.volume->room();
    m_whole.makeReady(scene, isOnDisk ? partOf(effort, 0.0, rangesShare) : effort);
    if (isOnDisk || !m_standIns.levels().empty())
      readyStandIns(scene, partOf(effort, rangesShare, 1.0));
    return 1.0;
  }
  std::optional<StandIn> standInFor(const Scene& scene, const glm::ivec2& size) override {
    return m_standIns.of(scene, size);
  }
  Image drawUnlimited(const Scene& scene, const glm::ivec2& size) override {
    return rendererFor(scene).renderUnlimited(scene, size);
  }
  bool prepare(const Scene&, const glm::ivec2&) override { return false; }
  std::unique_ptr<EffectMeasurement> measureEffects(const Scene& scene, const glm::ivec2& size) override {
    // Paths are followed once, not with and without something.
    if (isPhysical(scene))
      return nullptr;
    CpuRenderer& renderer = rendererFor(scene);
    return measurementOf(std::make_unique<CpuCosts>(renderer), scene, size, renderer.plan(scene));
  }

  DrawingFacts facts(const Scene& scene) override {
    CpuRenderer& renderer = rendererFor(scene);
    DrawingFacts facts;
    facts.plan = renderer.plan(scene);
    facts.steepestPerMm = renderer.steepestPerMm();
    facts.takesAllSamples = renderer.limitation().empty();
    facts.goesByCells = facts.findsLightOfSamples = true;
    return facts;
  }
  std::optional<PathFigures> pathFigures(const Scene& scene, const glm::ivec2& size) override {
    return rendererFor(scene).pathFigures(scene, size);
  }
  int followedPaths(const Scene& scene, const glm::ivec2& size) override {
    return isPhysical(scene) ? rendererFor(scene).followedPaths(scene, size) : 0;
  }
  GradientScale gradientScale() const override { return m_last->gradientScale(); }
  int compiledPrograms() const override { return 0; }
  double memoryMb() const override {
    double all = m_whole.memoryMb();
    for (const auto& renderer : m_ofLevels)
      all += renderer->memoryMb();
    return all;
  }
  std::string name() const override { return m_whole.name(); }
  Message limitation() const override { return m_last->limitation(); }

private:
  void readyStandIns(const Scene& scene, const Effort& effort) {
    m_last = &m_whole;
    if (!m_standIns.makeReady(scene.volume, effort))
      return;
    m_ofLevels.clear();
    while (m_ofLevels.size() < m_standIns.levels().size())
      m_ofLevels.push_back(std::make_unique<CpuRenderer>(m_threads, CpuRenderer::Tolerance::stepsFirst));
  }

  // What stands in for a volume has a renderer of its own: what is known of either stays while they take
  // turns.
  CpuRenderer& rendererFor(const Scene& scene) {
    m_last = &m_whole;
    for (std::size_t n = 0; n < m_standIns.levels().size(); ++n)
      if (m_standIns.levels()[n].volume == scene.volume)
        m_last = m_ofLevels[n].get();
    return *m_last;
  }

  int m_threads;
  CpuRenderer m_whole;
  cpu::StandIns m_standIns;
  std::vector<std::unique_ptr<CpuRenderer>> m_ofLevels;
  CpuRenderer* m_last; // that drew, or told facts
};

} // namespace

std::unique_ptr<DrawingEngine> makeCpuEngine(int threads, const MemoryBudget& budget) {
  return std::make_unique<CpuEngine>(threads, budget);
}

} // namespace limn
