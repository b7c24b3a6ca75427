// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/paths/PathPicture.h"

#include "cpu/paths/Tone.h"
#include "cpu/rays/Threads.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn::cpu {
namespace {

// What paths depend on: not how many there are to be, nor how they are shown, nor the light of other models.
Scene asFollowed(Scene scene) {
  const Shading& asked = scene.shading;
  Shading read;
  read.model = asked.model;
  read.exponentRange = asked.exponentRange;
  read.gradientReference = asked.gradientReference;
  read.gradientCurve = asked.gradientCurve;
  read.gradientSmoothing = asked.gradientSmoothing;
  read.lightDirection = asked.lightDirection;
  read.lightAxes = asked.lightAxes;
  read.physical = asked.physical;
  read.physical.exposureEv = 0.0;
  read.physical.until = {};
  read.physical.filtersNoise = false;
  scene.shading = read;
  scene.quality.paths.reset();
  scene.fog = {};
  scene.image = {};
  return scene;
}

template <class Color>
Image tileOf(const std::vector<PixelPaths>& pixels, int width, const PixelRect& tile, int threads,
             const Color& color) {
  Image image(tile.size);
  forEachStrip(
      tile, tile, threads,
      [&](const Strip& strip) {
        for (int x = strip.fromX; x < strip.toX; ++x) {
          const PixelPaths& pixel = pixels[static_cast<std::size_t>(strip.y) * width + x];
          if (!(pixel.alpha > 0.0f))
            continue;
          const glm::dvec3 mean = pixel.met > 0 ? pixel.sum / double(pixel.met) : glm::dvec3(0.0);
          image.pixels[strip.inTile + x - strip.fromX] = {glm::vec3(double(pixel.alpha) * color(mean)),
                                                          pixel.alpha};
        }
      },
      {}, 512);
  return image;
}

// The standard error of what a pixel shows, levels, by how the display colour changes over it. Of thin tissue
// few paths meet anything: until two have, it may be off by all that it can show.
glm::dvec3 errorOf(const PixelPaths& pixel, const Shading& shading) {
  if (pixel.met < 2)
    return glm::dvec3(255.0 * pixel.alpha);
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
    : m_scene(asFollowed(scene)), m_size(size), m_pixels(static_cast<std::size_t>(size.x) * size.y) {}

bool PathPicture::isOf(const Scene& scene, const glm::ivec2& size) const {
  return m_size == size && m_scene == asFollowed(scene);
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

Image PathPicture::displayedTile(const PixelRect& tile, const Shading& shading, int threads) const {
  return tileOf(m_pixels, m_size.x, tile, threads,
                [&shading](const glm::dvec3& radiance) { return displayed(radiance, shading); });
}

Image PathPicture::radianceTile(const PixelRect& tile) const {
  return tileOf(m_pixels, m_size.x, tile, 1, [](const glm::dvec3& radiance) { return radiance; });
}

int PathPicture::followed() const {
  std::vector<int> counts;
  for (const PixelPaths& pixel : m_pixels) {
    if (pixel.alpha < 0.0f)
      return 0;
    if (pixel.alpha > 0.0f)
      counts.push_back(pixel.paths);
  }
  if (counts.empty() || *std::ranges::min_element(counts) == 0)
    return 0;
  const auto half = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::ranges::nth_element(counts, half);
  return *half;
}

std::vector<float> PathPicture::errors(const Shading& shading, int threads) const {
  std::vector<float> errors(m_pixels.size(), -1.0f);
  forEach(m_size.y, threads, [&](int y) {
    const std::size_t row = static_cast<std::size_t>(y) * m_size.x;
    for (std::size_t n = row; n < row + m_size.x; ++n)
      if (m_pixels[n].isCovered()) {
        const glm::dvec3 error = errorOf(m_pixels[n], shading);
        errors[n] = static_cast<float>(std::max({error.r, error.g, error.b}));
      }
  });
  return errors;
}

PathFigures PathPicture::figures(const Shading& shading, int threads) const {
  PathFigures figures;
  int fewest = std::numeric_limits<int>::max();
  std::vector<const PixelPaths*> covered;
  for (const PixelPaths& pixel : m_pixels) {
    if (pixel.alpha < 0.0f)
      fewest = 0;
    if (!pixel.isCovered())
      continue;
    fewest = std::min(fewest, pixel.paths);
    covered.push_back(&pixel);
  }
  figures.paths = covered.empty() ? 0 : fewest;
  if (covered.empty() || fewest < 2)
    return figures;
  std::vector<float> errors(3 * covered.size());
  constexpr int atOnce = 1024;
  const int pixels = static_cast<int>(covered.size());
  forEach((pixels + atOnce - 1) / atOnce, threads, [&](int piece) {
    for (int n = piece * atOnce; n < std::min(pixels, (piece + 1) * atOnce); ++n) {
      const glm::dvec3 error = errorOf(*covered[static_cast<std::size_t>(n)], shading);
      for (int c = 0; c < 3; ++c)
        errors[3 * static_cast<std::size_t>(n) + c] = static_cast<float>(error[c]);
    }
  });
  double squares = 0.0, sum = 0.0, over = 0.0;
  for (std::size_t n = 0; n < errors.size(); n += 3) {
    float worst = 0.0f;
    for (std::size_t c = n; c < n + 3; ++c) {
      squares += double(errors[c]) * errors[c];
      sum += errors[c];
      worst = std::max(worst, errors[c]);
    }
    figures.largestLevels = std::max(figures.largestLevels, double(worst));
    over += worst > 1.0f ? 1.0 : 0.0;
  }
  figures.rmsLevels = std::sqrt(squares / static_cast<double>(errors.size()));
  figures.meanLevels = sum / static_cast<double>(errors.size());
  figures.shareOverOne = over / static_cast<double>(covered.size());
  const auto rank =
      errors.begin() + static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(errors.size() - 1));
  std::nth_element(errors.begin(), rank, errors.end());
  figures.p99_9Levels = *rank;
  return figures;
}

// The oldest of the coarse ones, of which drags leave many; else the oldest of all.
PathPictures::Kept::iterator PathPictures::leastWorth() {
  std::size_t largest = 0;
  for (const std::unique_ptr<PathPicture>& one : m_pictures)
    largest = std::max(largest, one->bytes());
  for (auto one = m_pictures.end(); one != m_pictures.begin() + alwaysKept;)
    if (2 * (*--one)->bytes() < largest)
      return one;
  return m_pictures.end() - 1;
}

std::size_t PathPictures::bytes() const {
  std::size_t bytes = 0;
  for (const std::unique_ptr<PathPicture>& one : m_pictures)
    bytes += one->bytes();
  return bytes;
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
  while (m_pictures.size() > mostKept || (m_pictures.size() > alwaysKept && bytes() > m_mostBytes))
    m_pictures.erase(leastWorth());
  return *m_pictures.front();
}

const PathPicture* PathPictures::find(const Scene& scene, const glm::ivec2& size) const {
  for (const std::unique_ptr<PathPicture>& one : m_pictures)
    if (one->isOf(scene, size))
      return one.get();
  return nullptr;
}

} // namespace limn::cpu
