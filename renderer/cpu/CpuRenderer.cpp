// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/CpuRenderer.h"

#include "cpu/paths/PathScene.h"
#include "cpu/paths/TracePaths.h"
#include "cpu/rays/Threads.h"
#include "cpu/simd/DrawRow.h"
#include "cpu/simd/InstructionSet.h"
#include "engine/PixelRect.h"
#include "engine/VolumeTooLarge.h"
#include "scene/basics/Error.h"

#include <algorithm>
#include <thread>

namespace limn {
namespace {

EffectSet withMore(EffectSet needed, EffectSet more) {
  return canonical(needed.with(more));
}

// How many pixels are drawn before anybody asks whether to go on, and how many such strips a thread takes on
// end. Along many paths of light a pixel takes milliseconds, and so it does cell by cell in noise under a
// function of hundreds of points.
struct StripSize {
  int width = 64, together = 1;
};
constexpr int manyPaths = 256;

StripSize stripSize(const cpu::PictureTerms& terms) {
  if (terms.effects.hasAny(travellingLight) && !terms.travel.found.areKnown())
    return terms.travel.spread < manyPaths ? StripSize{8, 8} : StripSize{1, 1};
  return terms.fineness || terms.isExact ? StripSize{8, 8} : StripSize{};
}

// Nothing to be seen. To fill a picture of 3,000² takes longer than whoever cancels may wait, and a piece of
// it as long as the system takes to hand out its pages.
Image blank(const glm::ivec2& size, const std::function<bool()>& isCancelled) {
  constexpr std::size_t atOnce = 1 << 18; // goes faster, and takes moments
  constexpr std::size_t piece = 1 << 14;
  const auto count = static_cast<std::size_t>(size.x) * size.y;
  if (count <= atOnce)
    return Image(size);
  Image image;
  image.size = size;
  image.pixels.reserve(count);
  while (image.pixels.size() < count) {
    if (isCancelled && image.pixels.size() > 0 && isCancelled())
      throw Cancelled();
    image.pixels.resize(std::min(image.pixels.size() + piece, count), glm::vec4(0.0f));
  }
  return image;
}

} // namespace

CpuRenderer::CpuRenderer(int threads, EmptySpace emptySpace, Weights weights, Tolerance tolerance)
    : m_threads(threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))),
      m_data(m_threads, emptySpace == EmptySpace::skipped, weights == Weights::eightBits,
             tolerance == Tolerance::stepsFirst) {
  cpu::requireInstructionSet();
}

EffectPlan CpuRenderer::plan(const Scene& scene, const std::function<bool()>& isCancelled) {
  return requiredEffects(scene, sceneFacts(scene, isCancelled));
}

SceneFacts CpuRenderer::sceneFacts(const Scene& scene, const std::function<bool()>& isCancelled) {
  m_data.update(scene, isCancelled);
  m_limitation = stepLimitation(scene, mostSamples);
  return m_data.facts(scene);
}

Image CpuRenderer::drawWith(const Scene& scene, const glm::ivec2& size, const PixelRect& tile, Choose choose,
                            EffectSet others, const std::function<bool()>& isCancelled,
                            const LightVolumes* light) {
  if (isPhysical(scene))
    return drawPaths(scene, size, tile, isCancelled);
  const EffectPlan needed = plan(scene, isCancelled);
  Image image = blank(tile.size, isCancelled);
  if (!needed.isVisible)
    return image;
  const EffectSet effects = choose(needed.effects, others);
  const cpu::PictureTerms terms = m_data.terms(scene, size, effects, isCancelled, light);
  const PixelRect covered =
      intersection(tile, coveredPixels(scene.camera, scene.volume->grid(), terms.visibleBox, size));
  const auto drawStrip = [&](const cpu::Strip& strip) {
    cpu::drawRow(terms, strip.y, strip.fromX, strip.toX, &image.pixels[strip.inTile]);
  };
  const StripSize strip = stripSize(terms);
  cpu::forEachStrip(tile, covered, m_threads, drawStrip, isCancelled, strip.width, strip.together);
  return image;
}

// The alpha is that of a picture without light; paths tell the colours.
Image CpuRenderer::drawPaths(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                             const std::function<bool()>& isCancelled) {
  cpu::PathPicture& picture = m_paths.of(scene, size);
  if (!picture.knowsAlpha(tile)) {
    const Image alpha = draw(cpu::alphaOf(scene), size, tile, isCancelled);
    for (int y = 0; y < tile.size.y; ++y)
      for (int x = 0; x < tile.size.x; ++x)
        picture.at(tile.topLeft.x + x, tile.topLeft.y + y).alpha = alpha.at(x, y).a;
  }
  const int count = scene.quality.paths.value_or(pathsOf(scene.shading.physical.until));
  if (count == 0)
    return picture.displayedTile(tile, scene.shading, m_threads);
  const Scene medium = cpu::mediumOf(scene);
  const EffectPlan needed = plan(medium, isCancelled);
  if (needed.isVisible) {
    // Surfaces ask for what the gradient is measured against.
    const EffectSet effects = needed.effects.with(Effect::exponentMap);
    const cpu::PictureTerms terms = m_data.terms(medium, size, effects, isCancelled);
    const cpu::PathTerms paths = m_data.pathTerms(medium, terms, isCancelled);
    const PixelRect covered =
        intersection(tile, coveredPixels(scene.camera, scene.volume->grid(), terms.visibleBox, size));
    picture.limit(tile, count);
    cpu::tracePaths(paths, terms, scene.shading.physical.seed, covered, count, m_threads, isCancelled,
                    picture);
  }
  return picture.displayedTile(tile, scene.shading, m_threads);
}

std::optional<cpu::FilteredPaths> CpuRenderer::withoutNoise(const Scene& scene, const glm::ivec2& size,
                                                            const Effort& effort) {
  const cpu::PathPicture* picture = m_paths.find(scene, size);
  if (!picture)
    return std::nullopt;
  const Effort own{m_threads, effort.isCancelled, effort.report};
  const Scene medium = cpu::mediumOf(scene);
  const EffectPlan needed = plan(medium, effort.isCancelled);
  const cpu::PictureTerms terms =
      m_data.terms(medium, size, needed.effects.with(Effect::exponentMap), effort.isCancelled);
  const cpu::PathTerms paths = m_data.pathTerms(medium, terms, effort.isCancelled);
  const PixelRect covered = coveredPixels(scene.camera, scene.volume->grid(), terms.visibleBox, size);
  return cpu::filtered(*picture,
                       cpu::tracedGuides(paths, terms, scene.shading.physical.seed,
                                         intersection({{0, 0}, size}, covered), own, *picture),
                       scene.shading, own);
}

std::optional<PathFigures> CpuRenderer::pathFigures(const Scene& scene, const glm::ivec2& size) const {
  const cpu::PathPicture* picture = m_paths.find(scene, size);
  return picture ? std::optional(picture->figures(scene.shading, m_threads)) : std::nullopt;
}

int CpuRenderer::followedPaths(const Scene& scene, const glm::ivec2& size) const {
  const cpu::PathPicture* picture = m_paths.find(scene, size);
  return picture ? picture->followed() : 0;
}

std::vector<float> CpuRenderer::pathErrors(const Scene& scene, const glm::ivec2& size) const {
  const cpu::PathPicture* picture = m_paths.find(scene, size);
  return picture ? picture->errors(scene.shading, m_threads) : std::vector<float>();
}

std::optional<Image> CpuRenderer::radiance(const Scene& scene, const glm::ivec2& size) const {
  const cpu::PathPicture* picture = m_paths.find(scene, size);
  return picture ? std::optional(picture->radianceTile({{0, 0}, size})) : std::nullopt;
}

Image CpuRenderer::draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                        const std::function<bool()>& isCancelled) {
  return drawWith(scene, size, tile, withMore, {}, isCancelled);
}

Image CpuRenderer::render(const Scene& scene, const glm::ivec2& size) {
  return drawWith(scene, size, {{0, 0}, size}, withMore, {}, {});
}

Image CpuRenderer::drawWithout(EffectSet leftOut, const Scene& scene, const glm::ivec2& size,
                               const PixelRect& tile, const LightVolumes* light) {
  return drawWith(scene, size, tile, leavingOut, leftOut, {}, light);
}

LightVolumes CpuRenderer::lightOf(const Scene& scene) {
  if (!hasTravellingLight(scene))
    return {};
  const EffectPlan needed = plan(scene);
  return needed.isVisible ? m_data.terms(scene, {1, 1}, needed.effects).travel.found : LightVolumes();
}

Image CpuRenderer::renderUnlimited(const Scene& scene, const glm::ivec2& size) {
  return drawWith(scene, size, {{0, 0}, size}, withMore, {Effect::unlimited}, {});
}

std::string CpuRenderer::name() const {
  return "CPU engine (" + cpu::instructionSetName() + ", " + std::to_string(m_threads) +
         (m_threads == 1 ? " thread)" : " threads)");
}

} // namespace limn
