// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/accuracy/chart/ChartValues.h"

#include <QChartView>

namespace limn {

class AccuracyChart;

/// The chart of a report in a panel: a point tells its numbers under the pointer, a click or Enter uses it;
/// arrow keys walk from point to point in order of time.
class AccuracyChartView : public QChartView {
  Q_OBJECT

public:
  explicit AccuracyChartView(QWidget* parent = nullptr);

  void setReport(const AccuracyReport& report);
  void setMeasure(ErrorMeasure measure);

  /// Marks the point that the picture on screen uses.
  void setCurrent(std::optional<std::size_t> point);

  /// Whether the report is of an earlier picture: it pales, and its points cannot be used.
  void setStale(bool stale);

  /// Where a point stands in the view; absent where it is not shown.
  std::optional<QPointF> positionOf(std::size_t point) const;

  /// How high it would be, pixels, within what can be read and what is worth it.
  void setPreferredHeight(int height);

  QSize sizeHint() const override { return {280, m_height}; }

signals:
  /// The user chose a point of the report.
  void pointPicked(std::size_t point);

protected:
  bool viewportEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void changeEvent(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  void dress();
  void tell(std::size_t point, const QPoint& at);
  void walk(int direction);

  AccuracyChart* m_chart;
  std::optional<std::size_t> m_walked; ///< by keys
  bool m_stale = false;
  int m_height = 340;
};

} // namespace limn
