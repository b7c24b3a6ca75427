// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/ErrorByChance.h"

#include "accuracy/sweep/Halvings.h"
#include "scene/steps/RayFrame.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace limn {
namespace {

// The exact pixels' own error, of what is said of them; the smallest that counts, levels. A pixel rests once
// a halving changes it by less than the last: as changes shrink by half at least, all later ones stay below
// it.
constexpr double mostOfSaid = 0.1;
constexpr double leastOwn = 0.02;
constexpr double still = 0.005;

// Equal steps are halved no further: people wait for it.
constexpr double smallestEqualStep = 1.0 / 128.0;

// FNV-1a over the bytes.
std::uint64_t seedOf(const Image& picture) {
  std::uint64_t seed = 0xcbf29ce484222325u;
  for (const glm::vec4& pixel : picture.pixels)
    for (int channel = 0; channel < 4; ++channel)
      seed = (seed ^ std::bit_cast<std::uint32_t>(pixel[channel])) * 0x100000001b3u;
  return seed;
}

double mostApart(const glm::dvec4& one, const glm::dvec4& other) {
  const glm::dvec4 apart = 255.0 * glm::abs(one - other);
  const double most = std::max({apart.r, apart.g, apart.b, apart.a});
  return most;
}

PrecisePixels chosen(const PrecisePixels& pixels, const std::vector<std::uint8_t>& drawn) {
  PrecisePixels few;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (drawn[i])
      few.push_back(pixels[i]);
  return few;
}

} // namespace

std::vector<std::uint8_t> pixelsByChance(const Scene& scene, const glm::ivec2& size, std::uint64_t seed) {
  const RayFrame frame = rayFrame(scene.camera, scene.volume->grid(), size);
  const IndexBox box = croppedBox(scene.volume->grid(), scene.crop);
  std::vector<std::size_t> met;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      if (!spanInBox(framedRay(frame, x, y, size), box).isEmpty())
        met.push_back(static_cast<std::size_t>(y) * size.x + x);
  std::vector<std::uint8_t> wanted(static_cast<std::size_t>(size.x) * size.y, 0);
  std::mt19937_64 random(seed); // the same on every machine; modulo favours none by more than 2⁻⁴⁰
  for (int n = 0; n < chancePixels && !met.empty(); ++n)
    wanted[met[random() % met.size()]] = 1;
  return wanted;
}

std::optional<ErrorByChance> errorByChance(const Scene& scene, const Image& picture,
                                           const DrawPrecisely& draw) {
  return errorByChance(scene, picture, draw, seedOf(picture));
}

std::optional<ErrorByChance> errorByChance(const Scene& scene, const Image& picture,
                                           const DrawPrecisely& draw, std::uint64_t seed) {
  Halvings halvings(scene.quality, scene.projection, StepControl::cells);
  Scene finer = scene;
  finer.quality = halvings.quality();
  std::vector<std::uint8_t> wanted = pixelsByChance(scene, picture.size, seed);
  const std::vector<std::uint8_t> drawn = wanted;
  PrecisePixels exact(wanted.size(), glm::dvec4(0.0));
  draw(finer, picture.size, wanted, exact);
  if (halvings.isExact()) {
    const ImageError error = imageError(chosen(precise(picture), drawn), chosen(exact, drawn));
    return ErrorByChance{error.largest + still, still, error.p99_9 + still, chancePixels};
  }
  while (halvings.halve() && (finer.quality.fineness || halvings.stepVoxels() >= smallestEqualStep)) {
    finer.quality = halvings.quality();
    const PrecisePixels before = exact;
    draw(finer, picture.size, wanted, exact);
    const ImageError change = imageError(chosen(before, drawn), chosen(exact, drawn));
    const ImageError error = imageError(chosen(precise(picture), drawn), chosen(exact, drawn));
    if (change.largest <= std::max(leastOwn, mostOfSaid * error.largest)) {
      const double own = std::max(change.largest, still);
      return ErrorByChance{error.largest + own, own, error.p99_9 + own, chancePixels};
    }
    for (std::size_t i = 0; i < drawn.size(); ++i)
      wanted[i] = wanted[i] && mostApart(before[i], exact[i]) > still ? 1 : 0;
  }
  return std::nullopt;
}

Message describe(const ErrorByChance& error) {
  // A promise is rounded up.
  return Message::tr(
             "99.9 % of the pixels lie within %1 of 255 levels of the exact picture (95 % sure: of %2 drawn "
             "at random and integrated exactly none lies farther off).")
      .arg(Message::fixed(std::ceil(100.0 * error.levels) / 100.0, 2))
      .arg(error.pixels);
}

} // namespace limn
