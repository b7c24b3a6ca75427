// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/figure/FigureColors.h"

#include <QFont>
#include <QRectF>

class QPainter;

namespace limn {

/// The values over which a scene's curve is shown: those between its outermost points with some room beside
/// them, or the volume's where there are none.
ValueRange legendRange(const Scene& scene);

/// Paints opacity over value, the colours below it, and an axis in the volume's unit.
void paintLegend(QPainter& painter, const QRectF& place, const Scene& scene, const QFont& font,
                 const FigureColors& colors);

} // namespace limn
