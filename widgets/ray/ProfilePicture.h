// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/RayProfile.h"
#include "widgets/Theme.h"
#include "widgets/curve/plot/PlotTransform.h"
#include "widgets/ray/ProfileText.h"

#include <array>

class QPainter;

namespace limn {

/// What a chart of a ray shows: three lanes above each other over one axis of depth.
struct ProfilePicture {
  const RayProfile& profile;
  ProfileNames names;
  PlotTransform depths; ///< the plot of all lanes; millimetres of depth from left to right
  ThemeColors colors;
  std::optional<double> half;      ///< mm, where half of the light is gathered
  std::optional<double> cursor;    ///< mm, what is read
  std::optional<double> crosshair; ///< mm, of the slices, where it lies on the ray
};

/// The lanes of a plot from top to bottom: value, opacity, contribution. Each has a line of text above it.
std::array<QRectF, 3> lanesOf(const QRectF& plot);

/// The plot of a chart of this size: all but what the axis takes.
QRectF profilePlot(const QSizeF& size);

/// Paints lanes, axis, marks and texts.
void paintProfile(QPainter& painter, const ProfilePicture& picture);

} // namespace limn
