// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QSize>

namespace limn {

/// How large the window is at its first start, in points: four fifths of a large screen, 1440 × 900 where it
/// has room for that, and on a small one all of it but for a title bar. `available` is what the screen leaves
/// beside its own bars.
QSize firstWindowSize(const QSize& available);

/// A window as it was left on another screen, whole on this one: cut to what the screen has free, with room
/// for a title bar, and moved inside.
QRect withinScreen(QRect window, const QRect& available);

/// How much of such a window its panels take at the first start, in points.
struct FirstDockSizes {
  int presetsWidth;
  int propertiesWidth;
  int curveHeight;
};

/// The curve alone gives way where a window is lower than 800, so that the picture stays the larger part. The
/// panels beside the picture are as narrow as they can be (presets, which ask for more than they are given
/// here) until a wide window has room for lines that are read with ease.
FirstDockSizes firstDockSizes(const QSize& window);

} // namespace limn
