// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Histogram.h"
#include "widgets/curve/plot/PlotTransform.h"

#include <QColor>
#include <QPixmap>

namespace limn {

/// The histogram's outline as heights 0..1, one per pixel column of the plot's visible range: log1p(count)
/// over that of the fullest bin. Where several bins share a column the fullest shows; between bin centres it
/// is linear.
std::vector<double> histogramHeights(const Histogram& histogram, const ValueRange& visible, int columns);

/// The filled outline in the size of the plot, transparent elsewhere.
QPixmap histogramPicture(const Histogram& histogram, const PlotTransform& transform, const QColor& color,
                         double devicePixelRatio);

} // namespace limn
