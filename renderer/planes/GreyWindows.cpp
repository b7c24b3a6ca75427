// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/GreyWindows.h"

#include "scene/presets/PresetFit.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Of the range: narrower or wider ones show nothing that these do not.
constexpr double narrowest = 1e-6;
constexpr double widest = 1e6;

double widthOf(const ValueRange& range) {
  return range.highest > range.lowest ? range.highest - range.lowest : 1.0;
}

} // namespace

GreyWindow fullWindow(const ValueRange& range) {
  return {0.5 * (range.lowest + range.highest), widthOf(range)};
}

GreyWindow firstWindow(const Volume& volume, const Histogram& histogram) {
  if (looksLikeHounsfield(volume))
    return windowOf(TissueWindow::softTissue);
  if (histogram.counts.empty())
    return fullWindow(volume.range());
  const ValueRange most{quantile(histogram, 0.005), quantile(histogram, 0.995)};
  return fullWindow(most.highest > most.lowest ? most : volume.range());
}

GreyWindow windowDragged(const GreyWindow& start, const ValueRange& range, double right, double up) {
  const double factor = std::exp(std::clamp(right / 256.0, -20.0, 20.0));
  const double reach = widest * widthOf(range);
  return withWidth(
      {std::clamp(start.centre + up / 256.0 * start.width, range.lowest - reach, range.highest + reach),
       start.width},
      range, start.width * factor);
}

GreyWindow rounded(const GreyWindow& window) {
  const double unit = std::min(1.0, std::pow(10.0, std::floor(std::log10(window.width / 50.0))));
  return {unit * std::round(window.centre / unit), unit * std::round(window.width / unit)};
}

GreyWindow withWidth(GreyWindow window, const ValueRange& range, double width) {
  window.width = std::clamp(width, narrowest * widthOf(range), widest * widthOf(range));
  return window;
}

} // namespace limn
