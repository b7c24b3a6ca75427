// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/ThumbnailPainter.h"

#include "cpu/CpuEngine.h"
#include "scene/basics/Error.h"
#include "scene/regions/Reduction.h"
#include "widgets/view/pictures/PictureScreen.h"

#include <algorithm>
#include <exception>

namespace limn {
namespace {

// As many as a picture of some hundred pixels tells apart.
constexpr std::size_t mostVoxels = std::size_t{1} << 21;

// What is seen by nobody: a level of 255, nowhere more.
constexpr float leastAlpha = 1.0f / 255.0f;

// Others draw at the same time, for somebody who waits.
constexpr int threads = 1;

bool showsNothing(const Image& picture) {
  return std::ranges::none_of(picture.pixels, [](const glm::vec4& pixel) { return pixel.a > leastAlpha; });
}

} // namespace

ThumbnailPainter::ThumbnailPainter() = default;
ThumbnailPainter::~ThumbnailPainter() = default;

void ThumbnailPainter::draw(const std::vector<Thumbnail>& wanted, const QSize& size, const IsEnded& isEnded,
                            const Drawn& drawn) {
  const glm::ivec2 pixels(size.width(), size.height());
  for (const Thumbnail& one : wanted) {
    if (isEnded())
      throw Cancelled();
    try {
      const Scene scene = reducedScene(one.scene, isEnded);
      const std::optional<Image> picture = m_engine->draw(scene, pixels, {{0, 0}, pixels}, isEnded);
      drawn(one.name, overBackground(*picture, scene.image.background), showsNothing(*picture));
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception&) {
      // What this one shows is told where it is used; the list has the picture of its curve.
    }
  }
}

Scene ThumbnailPainter::reducedScene(const Scene& scene, const IsEnded& isEnded) {
  const glm::ivec3 reduction = reductionTo(scene.volume->grid(), mostVoxels);
  if (m_whole.lock() != scene.volume) {
    m_engine.reset(); // first: there may be no memory for two
    m_volume.reset();
    m_wholeKeep = {};
    m_keep = {};
    m_volume = reduced(scene.volume, reduction, {threads, isEnded, {}});
    m_whole = scene.volume;
    m_engine = makeCpuEngine(threads);
  }
  if (m_wholeKeep != scene.keep) {
    m_wholeKeep = scene.keep;
    m_keep = reduced(scene.keep, reduction);
  }
  Scene small = scene;
  small.volume = m_volume;
  small.keep = m_keep;
  small.quality = {};
  small.quality.stepVoxels = 1.0;
  return small;
}

} // namespace limn
