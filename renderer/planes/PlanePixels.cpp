// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/PlanePixels.h"

#include "scene/basics/StableMath.h"
#include "scene/function/PointShare.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limn {
namespace {

constexpr int pixelsPerPiece = 1 << 16;

std::uint32_t opaque(const glm::dvec3& color) {
  const glm::uvec3 bytes(glm::clamp(color, 0.0, 1.0) * 255.0 + 0.5);
  return 0xff000000u | bytes.r << 16 | bytes.g << 8 | bytes.b;
}

// The transfer function at steps so fine that classifying a pixel is one look-up.
class TintTable {
public:
  TintTable(const PlaneTint& tint, double lowest, double highest)
      : m_lowest(lowest), m_perValue(highest > lowest ? (steps - 1) / (highest - lowest) : 0.0) {
    for (int i = 0; i < steps; ++i)
      add(tint, m_perValue > 0.0 ? lowest + i / m_perValue : lowest);
  }

  std::size_t stepOf(double value) const {
    return static_cast<std::size_t>(std::lrint((value - m_lowest) * m_perValue));
  }
  const glm::dvec3& color(std::size_t step) const { return m_colors[step]; }
  double opacity(std::size_t step) const { return m_opacities[step]; }

private:
  void add(const PlaneTint& tint, double value) {
    if (tint.emphasisedPoint) {
      m_colors.push_back(emphasisColor);
      m_opacities.push_back(strongestTint * shareOfPoint(tint.function, *tint.emphasisedPoint, value));
      return;
    }
    const Classified tissue = classify(tint.function, value);
    const double path = tintPathMm / tint.function.unitDistanceMm;
    m_colors.push_back(tissue.color);
    m_opacities.push_back(oneMinusExpNeg(extinctionPerMm(tissue.opacity, 1.0) * path));
  }

  static constexpr int steps = 8192;
  double m_lowest;
  double m_perValue;
  std::vector<glm::dvec3> m_colors;
  std::vector<double> m_opacities;
};

std::optional<TintTable> tableOf(const PlaneImage& image, const std::optional<PlaneTint>& tint) {
  if (!tint)
    return std::nullopt;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const double value : image.values)
    if (!std::isnan(value)) {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  return highest < lowest ? std::nullopt : std::optional<TintTable>(std::in_place, *tint, lowest, highest);
}

} // namespace

double greyOf(const GreyWindow& window, double value) {
  return std::clamp((value - window.centre) / window.width + 0.5, 0.0, 1.0);
}

std::vector<std::uint32_t> planePixels(const PlaneImage& image, const GreyWindow& window,
                                       const std::optional<PlaneTint>& tint, const Effort& effort) {
  assert(!tint || !tint->weights || tint->weights->size == image.size);
  const std::optional<TintTable> table = tableOf(image, tint);
  std::vector<std::uint32_t> pixels(image.values.size(), 0);
  const auto paint = [&](std::size_t i) {
    const double value = image.values[i];
    if (std::isnan(value))
      return;
    const double grey = greyOf(window, value);
    if (!table) {
      pixels[i] = 0xff000000u | static_cast<std::uint32_t>(std::lrint(grey * 255.0)) * 0x010101u;
      return;
    }
    const std::size_t step = table->stepOf(value);
    const double weight = tint->weights ? tint->weights->values[i] : 1.0;
    const double cover = std::min(weight * table->opacity(step), strongestTint);
    pixels[i] = opaque(glm::mix(glm::dvec3(grey), table->color(step), cover));
  };
  const int pieces = static_cast<int>((pixels.size() + pixelsPerPiece - 1) / pixelsPerPiece);
  forEachPiece(pieces, effort, [&](int piece) {
    const std::size_t first = static_cast<std::size_t>(piece) * pixelsPerPiece;
    for (std::size_t i = first; i < std::min(pixels.size(), first + pixelsPerPiece); ++i)
      paint(i);
  });
  return pixels;
}

std::vector<std::uint8_t> outlineOf(const PlaneImage& weights, int thickness) {
  const glm::ivec2& size = weights.size;
  std::vector<std::uint8_t> edge(weights.values.size(), 0);
  const auto isDropped = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < size.x && y < size.y && weights.at(x, y) < 0.5;
  };
  const auto isNearDropped = [&](int x, int y) {
    for (int away = 1; away <= thickness; ++away)
      if (isDropped(x - away, y) || isDropped(x + away, y) || isDropped(x, y - away) ||
          isDropped(x, y + away))
        return true;
    return false;
  };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      edge[static_cast<std::size_t>(y) * size.x + x] = weights.at(x, y) >= 0.5 && isNearDropped(x, y);
  return edge;
}

} // namespace limn
