// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/OverlayRows.h"

#include <algorithm>

namespace limn {
namespace {

constexpr double plateGap = 4.0; // between a text and a plate

bool inTheWay(const QRectF& plate, double top, const QSizeF& size, const std::vector<double>& columns) {
  const QRectF kept = plate.adjusted(-plateGap, -plateGap, plateGap, plateGap);
  return std::ranges::any_of(columns, [&](double column) {
    return kept.intersects(QRectF(QPointF(column - size.width() / 2.0, top), size));
  });
}

} // namespace

double clearRowBelow(double top, const QSizeF& size, const std::vector<double>& columns,
                     const std::vector<QRectF>& plates) {
  // From the uppermost on: a text that has yielded to one plate may meet the next.
  std::vector<QRectF> sorted = plates;
  std::ranges::sort(sorted, [](const QRectF& a, const QRectF& b) { return a.bottom() < b.bottom(); });
  for (const QRectF& plate : sorted)
    if (inTheWay(plate, top, size, columns))
      top = plate.bottom() + plateGap;
  return top;
}

double clearRowAbove(double bottom, const QSizeF& size, const std::vector<double>& columns,
                     const std::vector<QRectF>& plates) {
  std::vector<QRectF> sorted = plates;
  std::ranges::sort(sorted, [](const QRectF& a, const QRectF& b) { return a.top() > b.top(); });
  for (const QRectF& plate : sorted)
    if (inTheWay(plate, bottom - size.height(), size, columns))
      bottom = plate.top() - plateGap;
  return bottom;
}

} // namespace limn
