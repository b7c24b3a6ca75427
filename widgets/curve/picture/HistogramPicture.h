// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/HistogramView.h"
#include "scene/volume/Histogram.h"
#include "widgets/plot/PlotTransform.h"
#include "widgets/theme/Theme.h"

#include <QPixmap>
#include <QPolygonF>

namespace limn {

/// The histogram's outline as heights 0..1, one per pixel column of the plot's visible range: count, or
/// log1p(count), over that of the fullest bin; or the share of all that lies up to the middle of the bin.
/// Where several bins share a column the highest shows; between bin centres it is linear.
std::vector<double> histogramHeights(const Histogram& histogram, const ValueRange& visible, int columns,
                                     HistogramScale scale = HistogramScale::logarithmic);

/// The area below the outline, and the line along it that tells its shape, each in the size of the plot and
/// transparent elsewhere: colours of the curve lie between them.
struct HistogramPicture {
  QPixmap area;
  QPixmap edge;
  QPolygonF line; ///< the edge, from the plot's upper left corner
};

/// A histogram with its picture, which is made anew only where something of it changed.
class HistogramCache {
public:
  void setHistogram(const Histogram& histogram);
  void setScale(HistogramScale scale) { m_key.scale = scale, m_picture = {}; }

  /// Null pictures for a histogram without counts.
  HistogramPicture picture(const PlotTransform& transform, const ThemeColors& colors,
                           double devicePixelRatio);

private:
  struct Key {
    HistogramScale scale = HistogramScale::logarithmic;
    PlotTransform transform;
    QColor area; ///< stands for the look
    double devicePixelRatio = 0.0;
    bool operator==(const Key&) const = default;
  };
  Histogram m_histogram;
  Key m_key;
  HistogramPicture m_picture;
};

} // namespace limn
