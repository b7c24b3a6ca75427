// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/PlaneSettings.h"
#include "scene/volume/Histogram.h"

#include <array>

namespace limn {

/// The windows that radiologists switch between, HU.
enum class TissueWindow { softTissue, lung, bone, brain };

inline constexpr std::array tissueWindows{TissueWindow::softTissue, TissueWindow::lung, TissueWindow::bone,
                                          TissueWindow::brain};

/// Centre and width, HU.
constexpr GreyWindow windowOf(TissueWindow tissue) {
  switch (tissue) {
  case TissueWindow::softTissue:
    return {40.0, 400.0};
  case TissueWindow::lung:
    return {-600.0, 1500.0};
  case TissueWindow::bone:
    return {400.0, 1800.0};
  case TissueWindow::brain:
    return {40.0, 80.0};
  }
  return {};
}

/// From the smallest to the largest value; of a constant volume one of width 1 about it.
GreyWindow fullWindow(const ValueRange& range);

/// The window that a volume is first shown with: soft tissue where its values are Hounsfield units; otherwise
/// from the half to the 99.5 % quantile, or all where those are one.
GreyWindow firstWindow(const Volume& volume, const Histogram& histogram);

/// The window after a drag by `right` and `up` logical pixels, as in the 3D picture: 256 pixels to the right
/// widen it by e, 256 upwards raise its centre by its width. It stays usable: from a millionth to a million
/// times the volume's range.
GreyWindow windowDragged(const GreyWindow& start, const ValueRange& range, double right, double up);

/// The window in numbers as people say them: whole ones, or of a window narrower than 50 the power of ten
/// that is at most a fiftieth of its width.
GreyWindow rounded(const GreyWindow& window);

/// The window with a typed width, at least a millionth of the range.
GreyWindow withWidth(GreyWindow window, const ValueRange& range, double width);

} // namespace limn
