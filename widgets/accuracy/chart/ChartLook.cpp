// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/chart/ChartLook.h"

#include "widgets/Theme.h"

#include <array>

namespace limn {
namespace {

// After Okabe and Ito, "Color Universal Design" (2008): their yellow is too faint on white and gives way to
// ochre; on dark ground the same hues are lighter.
constexpr std::array<const char*, 8> onLight{"#0072b2", "#d55e00", "#00876a", "#b0478c",
                                             "#b98600", "#8a4b2a", "#5b4bb5", "#4d4d4d"};
constexpr std::array<const char*, 8> onDark{"#56b4e9", "#ff8f4d", "#2fc79f", "#e693c6",
                                            "#f0c24b", "#d0a080", "#a99bff", "#c9cdd2"};
constexpr std::array<QScatterSeries::MarkerShape, 6> shapes{
    QScatterSeries::MarkerShapeCircle,   QScatterSeries::MarkerShapeRectangle,
    QScatterSeries::MarkerShapeTriangle, QScatterSeries::MarkerShapeRotatedRectangle,
    QScatterSeries::MarkerShapePentagon, QScatterSeries::MarkerShapeStar};

} // namespace

ChartColors chartColors(ChartStyle style) {
  if (style == ChartStyle::print)
    return {.background = "#ffffff",
            .text = "#111111",
            .secondaryText = "#444444",
            .grid = "#e4e4e4",
            .border = "#777777",
            .accent = "#1667cc",
            .trade = "#eaeaea"};
  const ThemeColors theme = themeColors(style == ChartStyle::dark ? Look::dark : Look::light);
  return {.background = theme.window,
          .text = theme.text,
          .secondaryText = theme.secondaryText,
          .grid = style == ChartStyle::dark ? QColor("#2f3338") : QColor("#e0e3e7"),
          .border = theme.border,
          .accent = theme.accent,
          .trade = style == ChartStyle::dark ? QColor("#30353b") : QColor("#e1e4e9")};
}

CurveLook curveLook(ChartStyle style, int curve) {
  const auto& colors = style == ChartStyle::dark ? onDark : onLight;
  const auto index = static_cast<std::size_t>(curve);
  return {colors[index % colors.size()], shapes[index % shapes.size()], index >= colors.size()};
}

} // namespace limn
