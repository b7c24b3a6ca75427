// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Histogram.h"
#include "widgets/curve/plot/PlotTransform.h"

#include <QColor>
#include <QPixmap>

namespace limn {

/// The histogram's outline as heights 0..1, one per pixel column of the plot's visible range: log1p(count)
/// over that of the fullest bin. Where several bins share a column the fullest shows; between bin centres it
/// is linear.
std::vector<double> histogramHeights(const Histogram& histogram, const ValueRange& visible, int columns);

/// What a histogram is painted with.
struct HistogramColors {
  QColor fill, edge;
  bool operator==(const HistogramColors&) const = default;
};

/// The filled outline in the size of the plot, transparent elsewhere.
QPixmap histogramPicture(const Histogram& histogram, const PlotTransform& transform,
                         const HistogramColors& colors, double devicePixelRatio);

/// A histogram with its picture, which is made anew only where something of it changed.
class HistogramCache {
public:
  void setHistogram(const Histogram& histogram);

  /// Null for a histogram without counts.
  QPixmap picture(const PlotTransform& transform, const HistogramColors& colors, double devicePixelRatio);

private:
  struct Key {
    PlotTransform transform;
    HistogramColors colors;
    double devicePixelRatio = 0.0;
    bool operator==(const Key&) const = default;
  };
  Histogram m_histogram;
  Key m_key;
  QPixmap m_picture;
};

} // namespace limn
