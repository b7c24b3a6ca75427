// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/accuracy/ChartPicture.h"

#include <QDialog>

class QVBoxLayout;

namespace limn {

/// The chart of a report in a panel (ChartPicture): a point tells its numbers under the pointer, a click or
/// Enter uses it; arrow keys walk from point to point in order of time.
class AccuracyChart : public QWidget {
  Q_OBJECT

public:
  explicit AccuracyChart(QWidget* parent = nullptr);

  void setReport(const AccuracyReport& report);
  const std::vector<ChartCurve>& curves() const { return m_picture.curves; }
  void setMeasure(ErrorMeasure measure);

  /// Marks the point that the picture on screen uses.
  void setCurrent(std::optional<std::size_t> point);

  /// Whether the report is of an earlier picture: it pales, and its points cannot be used.
  void setStale(bool stale);

  /// Where a point stands in the view; absent where it is not shown.
  std::optional<QPointF> placeOf(std::size_t point) const { return positionOf(m_picture, point); }

  /// How high it would be, pixels, within what can be read and what is worth it.
  void setPreferredHeight(int height);

  QSize sizeHint() const override { return {280, m_height}; }

signals:
  /// The user chose a point of the report.
  void pointPicked(std::size_t point);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  void dress();
  void setHovered(std::optional<std::size_t> point);
  void tell(std::size_t point, const QPoint& at);
  void walk(int direction);

  ChartPicture m_picture;
  std::optional<std::size_t> m_walked; ///< by keys
  bool m_stale = false;
  int m_height = 340;
};

/// A window for a chart that has too little room in its panel. It takes no keyboard when it opens.
class ChartWindow : public QDialog {
  Q_OBJECT

public:
  explicit ChartWindow(QWidget* parent);

  /// Takes the chart in and opens beside the column of its window in which `panel` stands.
  void openBeside(QWidget& chart, const QWidget& panel);

  QSize sizeHint() const override { return {640, 440}; }

private:
  QVBoxLayout* m_room;
};

} // namespace limn
