// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGraphicsItem>

#include <optional>

namespace limn {

class AccuracyChart;
struct ChartMark;

/// What Qt Charts does not draw: the spread of times, the line at one level, the current point, and why a
/// chart is empty. Lies above the series of its chart, in the chart's coordinates.
class ChartNotes : public QGraphicsItem {
public:
  explicit ChartNotes(AccuracyChart& chart);

  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
  void paintLegendBelow(QPainter& painter) const;
  void paintEmpty(QPainter& painter) const;
  void paintOneLevel(QPainter& painter) const;
  void paintSpread(QPainter& painter, const ChartMark& mark, const QColor& color) const;
  void paintFloor(QPainter& painter, const ChartMark& mark, const QColor& color) const;
  void paintChosen(QPainter& painter) const;
  std::optional<QPointF> freeCorner(const QSizeF& size, double y) const;
  bool isFree(const QRectF& place) const;

  AccuracyChart& m_chart;
};

} // namespace limn
