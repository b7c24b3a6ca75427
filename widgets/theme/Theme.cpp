// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/theme/Theme.h"

#include <QFile>

#include <array>
#include <cmath>
#include <utility>

// Qt's macro declares a function and so must stand outside every namespace.
static void initialiseResources() {
  Q_INIT_RESOURCE(limn_widgets);
}

namespace limn {
namespace {

double linearChannel(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double relativeLuminance(const QColor& color) {
  return 0.2126 * linearChannel(color.redF()) + 0.7152 * linearChannel(color.greenF()) +
         0.0722 * linearChannel(color.blueF());
}

void setDisabled(QPalette& palette, const ThemeColors& colors) {
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText,
                          QPalette::PlaceholderText})
    palette.setColor(QPalette::Disabled, role, colors.disabledText);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, colors.border);
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, colors.disabledText);
}

} // namespace

void loadWidgetResources() {
  initialiseResources();
}

ThemeColors themeColors(Look look) {
  if (look == Look::contrast)
    return {.window = "#000000",
            .base = "#000000",
            .raised = "#000000",
            .hover = "#262626",
            .border = "#b0b0b0",
            .grid = "#333333",
            .text = "#ffffff",
            .secondaryText = "#f0f0f0",
            .disabledText = "#b8b8b8",
            .accent = "#ffd400",
            .accentText = "#000000",
            .outline = "#ffffff",
            .histogram = "#3a3a3a",
            .histogramEdge = "#dcdcdc",
            .curve = "#ffffff"};
  if (look == Look::dark)
    return {.window = "#212428",
            .base = "#191b1e",
            .raised = "#2d3137",
            .hover = "#383d44",
            .border = "#41474f",
            .grid = "#2a2d32",
            .text = "#e6e9ed",
            .secondaryText = "#a4acb7",
            .disabledText = "#929aa4",
            .accent = "#5aa7ff",
            .accentText = "#0b1625",
            .outline = "#777e88",
            .histogram = "#434951",
            .histogramEdge = "#a4acb7",
            .curve = "#e6e9ed"};
  return {.window = "#f3f4f6",
          .base = "#ffffff",
          .raised = "#ffffff",
          .hover = "#e6e9ee",
          .border = "#c6ccd4",
          .grid = "#eceef1",
          .text = "#1b1f24",
          .secondaryText = "#57606b",
          .disabledText = "#636a73",
          .accent = "#1667cc",
          .accentText = "#ffffff",
          .outline = "#80878f",
          .histogram = "#d3d8de",
          .histogramEdge = "#57606b",
          .curve = "#262b31"};
}

ThemeColors themeColors(const QPalette& palette) {
  return themeColors(lookOf(palette));
}

Look lookOf(const QPalette& palette) {
  if (!isDark(palette))
    return Look::light;
  return palette.color(QPalette::Window) == themeColors(Look::contrast).window ? Look::contrast : Look::dark;
}

QPalette themePalette(Look look) {
  const ThemeColors c = themeColors(look);
  const bool dark = look != Look::light;
  QPalette palette(c.text, c.raised, c.hover, c.border, c.border, c.text, c.text, c.base, c.window);
  palette.setColor(QPalette::Midlight, c.hover);
  palette.setColor(QPalette::Dark, c.border);
  palette.setColor(QPalette::Shadow, dark ? QColor("#0e1012") : QColor("#9aa1aa"));
  palette.setColor(QPalette::AlternateBase, c.grid);
  palette.setColor(QPalette::Highlight, c.accent);
  palette.setColor(QPalette::HighlightedText, c.accentText);
  palette.setColor(QPalette::Link, c.accent);
  palette.setColor(QPalette::LinkVisited, c.accent);
  palette.setColor(QPalette::ToolTipBase, dark ? c.raised : c.text);
  palette.setColor(QPalette::ToolTipText, dark ? c.text : c.base);
  palette.setColor(QPalette::PlaceholderText, c.secondaryText);
  setDisabled(palette, c);
  return palette;
}

QString themeStyleSheet(Look look) {
  loadWidgetResources();
  QFile file(QStringLiteral(":/limn/theme.qss"));
  if (!file.open(QIODevice::ReadOnly))
    qFatal("The style sheet is missing from the program's resources.");
  const ThemeColors c = themeColors(look);
  const std::array<std::pair<const char*, QColor>, 12> names{{{"@window", c.window},
                                                              {"@base", c.base},
                                                              {"@raised", c.raised},
                                                              {"@hover", c.hover},
                                                              {"@border", c.border},
                                                              {"@grid", c.grid},
                                                              {"@outline", c.outline},
                                                              {"@text", c.text},
                                                              {"@secondary", c.secondaryText},
                                                              {"@disabled", c.disabledText},
                                                              {"@accentText", c.accentText},
                                                              {"@accent", c.accent}}};
  QString sheet = QString::fromUtf8(file.readAll());
  // The tick is drawn in the colour of text on the accent.
  const bool isTickLight = c.accentText.lightness() > 127;
  sheet.replace(QLatin1String("@check"),
                isTickLight ? QStringLiteral("check-light") : QStringLiteral("check-dark"));
  for (const auto& [name, color] : names)
    sheet.replace(QLatin1String(name), color.name());
  return sheet;
}

bool isDark(const QPalette& palette) {
  return relativeLuminance(palette.color(QPalette::Window)) <
         relativeLuminance(palette.color(QPalette::WindowText));
}

} // namespace limn
