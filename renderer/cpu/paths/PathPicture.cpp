// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/paths/PathPicture.h"

#include "cpu/paths/Tone.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn::cpu {
namespace {

// A pixel counts from half a level of alpha on (DEFINITION section 9).
constexpr float leastAlpha = 1.0f / 510.0f;

Scene withoutEnd(Scene scene) {
  scene.shading.physical.until = {};
  scene.quality.paths.reset();
  return scene;
}

template <class Color>
Image tileOf(const std::vector<PixelPaths>& pixels, int width, const PixelRect& tile, const Color& color) {
  Image image(tile.size);
  for (int y = 0; y < tile.size.y; ++y)
    for (int x = 0; x < tile.size.x; ++x) {
      const PixelPaths& pixel =
          pixels[static_cast<std::size_t>(tile.topLeft.y + y) * width + tile.topLeft.x + x];
      if (!(pixel.alpha > 0.0f))
        continue;
      const glm::dvec3 mean = pixel.met > 0 ? pixel.sum / double(pixel.met) : glm::dvec3(0.0);
      image.at(x, y) = {glm::vec3(double(pixel.alpha) * color(mean)), pixel.alpha};
    }
  return image;
}

// The standard error of what a pixel shows, levels, by how the display colour changes over it.
glm::dvec3 errorOf(const PixelPaths& pixel, const Shading& shading) {
  const double count = pixel.met;
  const glm::dvec3 mean = pixel.sum / count;
  const glm::dvec3 variance = glm::max(pixel.squares / count - mean * mean, glm::dvec3(0.0)) / (count - 1.0);
  const glm::dvec3 error = glm::sqrt(variance);
  const glm::dvec3 above = displayed(mean + error, shading);
  const glm::dvec3 below = displayed(mean - error, shading);
  return 255.0 * double(pixel.alpha) * 0.5 * glm::abs(above - below);
}

} // namespace

PathPicture::PathPicture(const Scene& scene, const glm::ivec2& size)
    : m_scene(withoutEnd(scene)), m_size(size), m_pixels(static_cast<std::size_t>(size.x) * size.y) {}

bool PathPicture::isOf(const Scene& scene, const glm::ivec2& size) const {
  return m_size == size && m_scene == withoutEnd(scene);
}

void PathPicture::limit(const PixelRect& tile, int paths) {
  for (int y = tile.topLeft.y; y < tile.topLeft.y + tile.size.y; ++y)
    for (int x = tile.topLeft.x; x < tile.topLeft.x + tile.size.x; ++x)
      if (PixelPaths& pixel = at(x, y); pixel.paths > paths) {
        const float alpha = pixel.alpha;
        pixel = {};
        pixel.alpha = alpha;
      }
}

bool PathPicture::knowsAlpha(const PixelRect& tile) const {
  for (int y = tile.topLeft.y; y < tile.topLeft.y + tile.size.y; ++y)
    for (int x = tile.topLeft.x; x < tile.topLeft.x + tile.size.x; ++x)
      if (m_pixels[static_cast<std::size_t>(y) * m_size.x + x].alpha < 0.0f)
        return false;
  return true;
}

Image PathPicture::displayedTile(const PixelRect& tile) const {
  return tileOf(m_pixels, m_size.x, tile,
                [this](const glm::dvec3& radiance) { return displayed(radiance, m_scene.shading); });
}

Image PathPicture::radianceTile(const PixelRect& tile) const {
  return tileOf(m_pixels, m_size.x, tile, [](const glm::dvec3& radiance) { return radiance; });
}

PathFigures PathPicture::figures() const {
  PathFigures figures;
  int fewest = std::numeric_limits<int>::max();
  std::vector<float> errors;
  double squares = 0.0;
  bool areAllCompared = true;
  for (const PixelPaths& pixel : m_pixels) {
    if (pixel.alpha < 0.0f)
      fewest = 0;
    if (!(pixel.alpha >= leastAlpha))
      continue;
    fewest = std::min(fewest, pixel.paths);
    areAllCompared = areAllCompared && pixel.paths >= 2;
    // Of thin tissue few paths meet anything: until two have, it may be off by all that it can show.
    const glm::dvec3 error =
        pixel.met < 2 ? glm::dvec3(255.0 * pixel.alpha) : errorOf(pixel, m_scene.shading);
    for (int c = 0; c < 3; ++c) {
      errors.push_back(static_cast<float>(error[c]));
      squares += error[c] * error[c];
    }
  }
  figures.paths = fewest == std::numeric_limits<int>::max() ? 0 : fewest;
  if (errors.empty() || !areAllCompared)
    return figures;
  figures.rmsLevels = std::sqrt(squares / static_cast<double>(errors.size()));
  const auto rank =
      errors.begin() + static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(errors.size() - 1));
  std::nth_element(errors.begin(), rank, errors.end());
  figures.p99_9Levels = *rank;
  return figures;
}

PathPicture& PathPictures::of(const Scene& scene, const glm::ivec2& size) {
  std::erase_if(m_pictures, [&](const std::unique_ptr<PathPicture>& one) { return !one->isOfVolume(scene); });
  const auto known = std::ranges::find_if(
      m_pictures, [&](const std::unique_ptr<PathPicture>& one) { return one->isOf(scene, size); });
  std::unique_ptr<PathPicture> picture;
  if (known != m_pictures.end()) {
    picture = std::move(*known);
    m_pictures.erase(known);
  } else {
    picture = std::make_unique<PathPicture>(scene, size);
  }
  m_pictures.push_front(std::move(picture));
  if (m_pictures.size() > mostKept)
    m_pictures.pop_back();
  return *m_pictures.front();
}

const PathPicture* PathPictures::find(const Scene& scene, const glm::ivec2& size) const {
  for (const std::unique_ptr<PathPicture>& one : m_pictures)
    if (one->isOf(scene, size))
      return one.get();
  return nullptr;
}

} // namespace limn::cpu
