// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace limn {

/// What may stand on and around the pictures of a figure.
enum class FigureMark {
  panelLetters, ///< a, b, c, d
  names,        ///< of the panels, with how they are lit
  orientation,  ///< R, L, A, P, S, I at the edges of the pictures
  scaleBar,     ///< in millimetres
  curve,        ///< the transfer function over its colours, with an axis in the volume's unit
  labels,       ///< that have curves of their own, with their colours
  measurements, ///< distances, angles, ellipses and marks that are seen in the pictures
  accuracy,     ///< how far a picture is from the exact one
  region,       ///< what is hidden of the volume
  notForDiagnosis
};

inline constexpr std::array figureMarks{
    FigureMark::panelLetters, FigureMark::names,          FigureMark::orientation,  FigureMark::scaleBar,
    FigureMark::curve,        FigureMark::labels,         FigureMark::measurements, FigureMark::accuracy,
    FigureMark::region,       FigureMark::notForDiagnosis};

/// The size of a figure, and what it shows beside its pictures. What the pictures are is told by scenes.
struct FigureSettings {
  enum class Unit { pixels, centimetres };
  enum class Page { white, black, transparent };

  Unit unit = Unit::centimetres;
  double width = 17.0;          ///< in `unit`, > 0; 17 cm are two columns of a journal
  std::optional<double> height; ///< in `unit`; absent: as the shape of the pictures asks
  double dotsPerInch = 300.0;
  double panelAspect = 1.0; ///< width over height of a picture, where no height is given
  double textPoints = 8.0;  ///< of the body, 1/72 inch
  Page page = Page::white;  ///< what lies around the pictures, and under them where they are transparent
  std::array<bool, figureMarks.size()> marks{true, true, true, true, true, true, true, true, true, true};

  bool shows(FigureMark mark) const { return marks[static_cast<std::size_t>(mark)]; }
  bool operator==(const FigureSettings&) const = default;
};

/// The range of what may be asked for; a painter addresses no more pixels.
inline constexpr double fewestFigurePixels = 64.0;
inline constexpr double mostFigurePixels = 32000.0;
inline constexpr double fewestDotsPerInch = 10.0;
inline constexpr double mostDotsPerInch = 2400.0;
inline constexpr std::size_t mostPanels = 4;

/// A length of the figure's unit in pixels.
inline double toPixels(const FigureSettings& settings, double length) {
  constexpr double centimetresPerInch = 2.54;
  return settings.unit == FigureSettings::Unit::pixels ? length
                                                       : length * settings.dotsPerInch / centimetresPerInch;
}

/// The same figure with `factor` times as many pixels: everything keeps its proportions.
inline FigureSettings scaledBy(FigureSettings settings, double factor) {
  settings.dotsPerInch *= factor;
  if (settings.unit == FigureSettings::Unit::pixels) {
    settings.width *= factor;
    if (settings.height)
      *settings.height *= factor;
  }
  return settings;
}

inline constexpr std::array figureUnits{FigureSettings::Unit::pixels, FigureSettings::Unit::centimetres};
inline constexpr std::array figurePages{FigureSettings::Page::white, FigureSettings::Page::black,
                                        FigureSettings::Page::transparent};

/// The words in files and on the command line.
inline const char* nameOf(FigureMark mark) {
  constexpr std::array names{"letters", "names",        "orientation", "scale",  "curve",
                             "labels",  "measurements", "accuracy",    "region", "note"};
  return names[static_cast<std::size_t>(mark)];
}
inline const char* nameOf(FigureSettings::Unit unit) {
  constexpr std::array names{"px", "cm"};
  return names[static_cast<std::size_t>(unit)];
}
inline const char* nameOf(FigureSettings::Page page) {
  constexpr std::array names{"white", "black", "transparent"};
  return names[static_cast<std::size_t>(page)];
}

} // namespace limn
