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

// A transfer function at steps so fine that classifying a pixel is one look-up.
class TintTable {
public:
  TintTable(const TransferFunction& function, const std::optional<std::size_t>& emphasisedPoint,
            const ValueRange& range, int steps)
      : m_lowest(range.lowest),
        m_perValue(range.highest > range.lowest ? (steps - 1) / (range.highest - range.lowest) : 0.0) {
    for (int i = 0; i < steps; ++i)
      add(function, emphasisedPoint, m_perValue > 0.0 ? m_lowest + i / m_perValue : m_lowest);
  }

  std::size_t stepOf(double value) const {
    return static_cast<std::size_t>(std::lrint((value - m_lowest) * m_perValue));
  }
  const glm::dvec3& color(std::size_t step) const { return m_colors[step]; }
  double opacity(std::size_t step) const { return m_opacities[step]; }

private:
  void add(const TransferFunction& function, const std::optional<std::size_t>& emphasisedPoint,
           double value) {
    if (emphasisedPoint) {
      m_colors.push_back(emphasisColor);
      m_opacities.push_back(strongestTint * shareOfPoint(function, *emphasisedPoint, value));
      return;
    }
    const Classified tissue = classify(function, value);
    const double path = tintPathMm / function.unitDistanceMm;
    m_colors.push_back(tissue.color);
    m_opacities.push_back(oneMinusExpNeg(extinctionPerMm(tissue.opacity, 1.0) * path));
  }

  double m_lowest;
  double m_perValue;
  std::vector<glm::dvec3> m_colors;
  std::vector<double> m_opacities;
};

std::optional<ValueRange> rangeOf(const PlaneImage& image) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const double value : image.values)
    if (!std::isnan(value)) {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  return highest < lowest ? std::nullopt : std::optional(ValueRange{lowest, highest});
}

// What covers the grey of a pixel.
struct Cover {
  glm::dvec3 color{0.0};
  double opacity = 0.0;
};

// The tint of every pixel, of which the tables are made that a slice shows.
class Covers {
public:
  Covers(const PlaneImage& image, const PlaneTint& tint, const ValueRange& range) : m_tint(tint) {
    std::vector<bool> isShown(tint.looks ? tint.looks->looks.functions.size() : 1, !tint.looks);
    if (tint.looks)
      for (const PlaneShares::Row& row : tint.looks->shares.rows)
        for (const LookShare& share : row.shares)
          isShown[share.look] = isShown[share.look] || share.weight > 0.0;
    // Of many looks together the tables must not take longer than their pixels.
    const auto shown = static_cast<int>(std::count(isShown.begin(), isShown.end(), true));
    const int steps = std::clamp(4 * mostSteps / std::max(shown, 1), mostSteps / 4, mostSteps);
    m_tables.resize(isShown.size());
    forEachPiece(static_cast<int>(isShown.size()), {}, [&](int piece) {
      const auto look = static_cast<std::size_t>(piece);
      const bool isLit = isShown[look] && (look == tint.emphasisedLook || !tint.emphasisedPoint);
      const TransferFunction& function = look == 0 ? tint.function : tint.looks->looks.functions[look];
      if (isLit)
        m_tables[look].emplace(function, tint.emphasisedPoint, range, steps);
    });
    m_width = image.size.x;
  }

  Cover at(std::size_t pixel, double value) const {
    if (m_tint.looks)
      return mixed(
          m_tint.looks->shares.at(static_cast<int>(pixel) % m_width, static_cast<int>(pixel) / m_width),
          value);
    const TintTable& table = *m_tables.front();
    const std::size_t step = table.stepOf(value);
    return {table.color(step), (m_tint.weights ? m_tint.weights->values[pixel] : 1.0) * table.opacity(step)};
  }

private:
  static constexpr int mostSteps = 8192;

  Cover alone(const LookShare& share, double value) const {
    const std::optional<TintTable>& table = m_tables[share.look];
    if (!table)
      return {};
    const std::size_t step = table->stepOf(value);
    return {table->color(step), share.weight * table->opacity(step)};
  }

  Cover mixed(std::span<const LookShare> shares, double value) const {
    if (shares.size() == 1)
      return alone(shares.front(), value);
    double extinction = 0.0;
    glm::dvec3 color(0.0);
    for (const LookShare& share : shares) {
      const std::optional<TintTable>& table = m_tables[share.look];
      if (!table)
        continue;
      const std::size_t step = table->stepOf(value);
      const double own = share.share * minusLog1mOpacity(share.weight * table->opacity(step));
      extinction += own;
      color += own * table->color(step);
    }
    return extinction > 0.0 ? Cover{color / extinction, oneMinusExpNeg(extinction)} : Cover{};
  }

  const PlaneTint& m_tint;
  std::vector<std::optional<TintTable>> m_tables; ///< by look; of none that shows nothing
  int m_width = 0;
};

} // namespace

double greyOf(const GreyWindow& window, double value) {
  return std::clamp((value - window.centre) / window.width + 0.5, 0.0, 1.0);
}

std::vector<std::uint32_t> planePixels(const PlaneImage& image, const GreyWindow& window,
                                       const std::optional<PlaneTint>& tint, const Effort& effort) {
  assert(!tint || !tint->weights || tint->weights->size == image.size);
  assert(!tint || !tint->looks || tint->looks->shares.size == image.size);
  const std::optional<ValueRange> range = tint ? rangeOf(image) : std::nullopt;
  const std::optional<Covers> covers =
      range ? std::optional<Covers>(std::in_place, image, *tint, *range) : std::nullopt;
  std::vector<std::uint32_t> pixels(image.values.size(), 0);
  const auto paint = [&](std::size_t i) {
    const double value = image.values[i];
    if (std::isnan(value))
      return;
    const double grey = greyOf(window, value);
    if (!covers) {
      pixels[i] = 0xff000000u | static_cast<std::uint32_t>(std::lrint(grey * 255.0)) * 0x010101u;
      return;
    }
    const Cover cover = covers->at(i, value);
    pixels[i] = opaque(glm::mix(glm::dvec3(grey), cover.color, std::min(cover.opacity, strongestTint)));
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
