// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/picture/HistogramPicture.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limn {
namespace {

// `behind` is the height beyond the last bin.
double heightBetweenBins(const std::vector<double>& heights, double bin, double behind) {
  const double centre = bin - 0.5;
  const double first = std::floor(centre);
  const auto at = [&](double i) {
    return i < 0.0                                    ? 0.0
           : i >= static_cast<double>(heights.size()) ? behind
                                                      : heights[static_cast<std::size_t>(i)];
  };
  return std::lerp(at(first), at(first + 1.0), centre - first);
}

// The share of all voxels up to the middle of each bin.
std::vector<double> percentiles(const Histogram& histogram) {
  const auto total = static_cast<double>(
      std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0}));
  std::vector<double> heights;
  double before = 0.0;
  for (const std::uint64_t count : histogram.counts) {
    const auto own = static_cast<double>(count);
    heights.push_back(total > 0.0 ? (before + own / 2.0) / total : 0.0);
    before += own;
  }
  return heights;
}

std::vector<double> binHeights(const Histogram& histogram, HistogramScale scale) {
  if (scale == HistogramScale::percentile)
    return percentiles(histogram);
  const auto heightOf = [scale](std::uint64_t count) {
    return scale == HistogramScale::linear ? static_cast<double>(count)
                                           : std::log1p(static_cast<double>(count));
  };
  const double fullest = heightOf(*std::max_element(histogram.counts.begin(), histogram.counts.end()));
  std::vector<double> heights;
  heights.reserve(histogram.counts.size());
  for (const std::uint64_t count : histogram.counts)
    heights.push_back(fullest > 0.0 ? heightOf(count) / fullest : 0.0);
  return heights;
}

QPixmap emptyPicture(const QSizeF& size, double devicePixelRatio) {
  QPixmap picture((size * devicePixelRatio).toSize());
  picture.setDevicePixelRatio(devicePixelRatio);
  picture.fill(Qt::transparent);
  return picture;
}

// Over the values that `transform` shows; `devicePixelRatio` > 0 is that of the screen.
HistogramPicture histogramPicture(const Histogram& histogram, HistogramScale scale,
                                  const PlotTransform& transform, const ThemeColors& colors,
                                  double devicePixelRatio) {
  const QSizeF size = transform.plot.size();
  const int columns = std::max(1, static_cast<int>(size.width()));
  const std::vector<double> heights = histogramHeights(histogram, transform.visible, columns, scale);
  QPolygonF edge;
  for (int i = 0; i < columns; ++i) // leave a little air above the fullest bin
    edge << QPointF(i + 0.5, size.height() * (1.0 - 0.92 * heights[static_cast<std::size_t>(i)]));
  QPolygonF area = edge;
  area << QPointF(size.width(), size.height()) << QPointF(0.0, size.height());

  HistogramPicture picture{emptyPicture(size, devicePixelRatio), emptyPicture(size, devicePixelRatio), edge};
  QPainter inArea(&picture.area);
  inArea.setRenderHint(QPainter::Antialiasing);
  inArea.setPen(Qt::NoPen);
  inArea.setBrush(colors.histogram);
  inArea.drawPolygon(area);
  QPainter onEdge(&picture.edge);
  onEdge.setRenderHint(QPainter::Antialiasing);
  onEdge.setPen(QPen(colors.histogramEdge, 1.0));
  onEdge.drawPolyline(edge);
  return picture;
}

} // namespace

std::vector<double> histogramHeights(const Histogram& histogram, const ValueRange& visible, int columns,
                                     HistogramScale scale) {
  std::vector<double> outline(static_cast<std::size_t>(columns), 0.0);
  const double width = histogram.range.highest - histogram.range.lowest;
  if (histogram.counts.empty() || !(width > 0.0))
    return outline;
  const std::vector<double> heights = binHeights(histogram, scale);
  const double behind = scale == HistogramScale::percentile ? 1.0 : 0.0;
  const auto bins = static_cast<double>(heights.size());
  const double binsPerColumn = (visible.highest - visible.lowest) / columns / width * bins;
  const double firstBin = (visible.lowest - histogram.range.lowest) / width * bins;
  for (int column = 0; column < columns; ++column) {
    const double from = firstBin + column * binsPerColumn;
    double& height = outline[static_cast<std::size_t>(column)];
    height = heightBetweenBins(heights, from + 0.5 * binsPerColumn, behind);
    if (binsPerColumn <= 1.0)
      continue;
    const double last = std::min(from + binsPerColumn, bins);
    for (double bin = std::max(0.0, std::floor(from)); bin < last; bin += 1.0)
      height = std::max(height, heights[static_cast<std::size_t>(bin)]);
  }
  return outline;
}

void HistogramCache::setHistogram(const Histogram& histogram) {
  m_histogram = histogram;
  m_picture = {};
}

HistogramPicture HistogramCache::picture(const PlotTransform& transform, const ThemeColors& colors,
                                         double devicePixelRatio) {
  if (m_histogram.counts.empty())
    return {};
  const Key key{m_key.scale, transform, colors.histogram, devicePixelRatio};
  if (m_picture.area.isNull() || key != m_key) {
    m_key = key;
    m_picture = histogramPicture(m_histogram, key.scale, transform, colors, devicePixelRatio);
  }
  return m_picture;
}

} // namespace limn
