// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/accuracy/chart/ChartLegend.h"
#include "widgets/accuracy/chart/ChartLook.h"
#include "widgets/accuracy/chart/ChartValues.h"

#include <QChart>

#include <optional>

class QScatterSeries;

namespace limn {

class ChartNotes;

/// Error against time, both logarithmic: a curve per family of operating points, the best trade-offs ringed,
/// a line at one level ("accurate to the screen"). Series hold decimal logarithms of ms and levels.
class AccuracyChart : public QChart {
  Q_OBJECT

public:
  explicit AccuracyChart(QGraphicsItem* parent = nullptr);

  /// Both take effect with the next report.
  void setStyle(ChartStyle style) { m_style = style; }
  void setMeasure(ErrorMeasure measure) { m_measure = measure; }

  /// Sizes of text and marks, logical pixels.
  void setTextSize(double pixels) { m_textSize = pixels; }

  /// Where families are named: at the right of the plot, or below it in as many rows as they need.
  void setLegendAtRight(bool atRight);

  /// Names families as the window does, not as reports do; takes effect with the next report.
  void setPlainNames(bool plain) { m_plainNames = plain; }

  /// At most so many labelled places along each axis.
  void setMostTicks(int timeTicks, int errorTicks);

  void setReport(const AccuracyReport& report);
  const AccuracyReport& report() const { return m_report; }
  const std::vector<ChartCurve>& curves() const { return m_curves; }

  /// Marks the points of the report that the pictures on screen use; out of range marks none.
  void setCurrent(std::optional<std::size_t> point);

  /// Lifts the point under the pointer, or the one that keys walked to.
  void setHovered(std::optional<std::size_t> point);

  /// Where a point of the report stands, in the chart's coordinates; absent where it is not shown.
  std::optional<QPointF> positionOf(std::size_t point) const;

  /// The point nearest to a position within so many pixels of it.
  std::optional<std::size_t> pointNear(const QPointF& position, double radius) const;

protected:
  void resizeEvent(QGraphicsSceneResizeEvent* event) override;

private:
  friend class ChartNotes;

  void addAxes();
  std::vector<QPointF> bestTradeOffs() const;
  void addTradeOffLine(const std::vector<QPointF>& best);
  void addTradeOffRings(const std::vector<QPointF>& best);
  void addCurve(const ChartCurve& curve, const CurveLook& look);
  QScatterSeries* addMarks(const CurveLook& look, bool filled);
  void attach(QXYSeries* series, bool isInLegend);
  void dress();
  void arrange();
  std::vector<LegendEntry> legendEntries() const;
  QRectF legendRect() const;
  QString nameOf(const ChartCurve& curve) const;
  QFont textFont(double scale = 1.0) const;
  QPointF placeOf(const ChartMark& mark) const;
  QPointF positionAt(double ms, double levels) const;

  ChartStyle m_style = ChartStyle::light;
  ErrorMeasure m_measure = ErrorMeasure::p99_9;
  double m_textSize = 12.0;
  bool m_legendAtRight = false;
  bool m_plainNames = false;
  int m_timeTicks = 6;
  int m_errorTicks = 8;
  AccuracyReport m_report;
  std::vector<ChartCurve> m_curves;
  LogAxis m_timeAxis;
  LogAxis m_errorAxis;
  std::optional<std::size_t> m_current;
  std::optional<std::size_t> m_hovered;
  ChartNotes* m_notes;
};

} // namespace limn
