// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/map/ErrorScale.h"

#include "accuracy/SamplePicture.h"
#include "widgets/controls/color/ColorConversion.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn {
namespace {

constexpr double half = 0.5;
constexpr double mostLevels = 10.0;

} // namespace

double errorScalePlace(double levels) {
  return std::clamp(std::log1p(levels / half) / std::log1p(mostLevels / half), 0.0, 1.0);
}

QColor errorScaleColor(double place) {
  // Hue in degrees from violet (300) through red (380) to yellow (460).
  const double hue = (300.0 + 160.0 * place) * std::acos(-1.0) / 180.0;
  const double chroma = 0.06 + 0.42 * place * (1.0 - place) + 0.05 * place;
  return toQColor(srgbOfOklab(0.22 + 0.74 * place, chroma * std::cos(hue), chroma * std::sin(hue)));
}

QImage errorMapImage(const ErrorMap& map) {
  constexpr int steps = 255;
  std::vector<QRgb> colors(steps + 1);
  for (int i = 0; i <= steps; ++i)
    colors[static_cast<std::size_t>(i)] = errorScaleColor(static_cast<double>(i) / steps).rgb();
  QImage image(map.size.x, map.size.y, QImage::Format_ARGB32_Premultiplied);
  for (int y = 0; y < map.size.y; ++y) {
    auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < map.size.x; ++x) {
      const float levels = map.levels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.size.x) +
                                      static_cast<std::size_t>(x)];
      row[x] =
          levels < 0.0f ? 0u : colors[static_cast<std::size_t>(std::lround(steps * errorScalePlace(levels)))];
    }
  }
  return image;
}

} // namespace limn
