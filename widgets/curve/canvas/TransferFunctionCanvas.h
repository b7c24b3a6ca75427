// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Histogram.h"
#include "widgets/Gesture.h"
#include "widgets/curve/canvas/CurveDrag.h"
#include "widgets/curve/edits/CurveSubject.h"
#include "widgets/curve/plot/CanvasPicture.h"

#include <QWidget>

#include <optional>

class QMenu;

namespace limn {

/// The plot of a transfer function over the histogram, with all its gestures (the table "TF canvas" of the
/// users' conventions): see the members of TransferFunctionEditor for what is shown. Every point can be
/// moved, the first and the last too: outside them the function is constant, so they are no different from
/// others, and a clinician moves a CT ramp by its ends. One point always stays.
class TransferFunctionCanvas : public QWidget {
  Q_OBJECT

public:
  explicit TransferFunctionCanvas(CurveSubject subject = CurveSubject::value, QWidget* parent = nullptr);

  void setTransferFunction(const TransferFunction& function);
  /// Shows every value of another range; a histogram without counts stands for no volume.
  void setHistogram(const Histogram& histogram);
  void setUnit(const QString& unit);
  void setMarkedValue(std::optional<double> value);
  void setPinnedValue(std::optional<double> value);
  void setFineLowOpacities(bool fine);
  /// A sentence in the middle of the plot; empty for none. Without a histogram the plot has its own.
  void setHint(const QString& hint);

  CurveSubject subject() const { return m_subject; }
  const TransferFunction& transferFunction() const { return m_function; }
  const PointIndices& selected() const { return m_selected; }
  PlotTransform transform() const;
  QString unit() const { return m_unit; }

  /// Decimals that tell neighbouring pixels apart.
  int shownDecimals() const;

  /// The smallest step of a value that matters to the data: 1 HU for CT.
  double valueUnit() const;

  /// Shows every value of the volume and every point again.
  void resetView();

  void selectPoints(const PointIndices& indices);
  void selectAll();
  void deleteSelected();

  /// Replaces the function as one edit of the user's, from the controls beside the plot.
  void edit(const TransferFunction& function, const Gesture& gesture);

  QSize sizeHint() const override { return {720, 220}; }
  QSize minimumSizeHint() const override { return {240, 120}; }

signals:
  void transferFunctionEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);
  void valueHovered(std::optional<double> value);
  void selectionChanged();
  /// The user wants to type numbers (Enter).
  void numbersRequested();
  /// The user wants colour and numbers of a point in a pop-up (double click).
  void pointDetailsRequested(std::size_t index);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;

private:
  ValueRange fullRange() const;
  CanvasPicture picture();
  void showView(const ValueRange& visible);
  bool isSelected(std::size_t index) const;
  QString textOf(double value) const;

  void pressLeft(const QMouseEvent& event);
  void pressPoint(std::size_t index, const QMouseEvent& event);
  void pressCurve(const QPointF& position);
  void beginDrag(CurveDrag::Kind kind, const QPointF& position);
  void continueDrag(const QMouseEvent& event);
  void endDrag();
  void cancelDrag();
  void addPoint(const QPointF& position);
  void hover(const QPointF& position);
  void showMenu(const QPoint& position);
  void addPointActions(QMenu& menu, std::size_t index);

  bool isOwnKey(const QKeyEvent& event) const;
  bool selectionKey(const QKeyEvent& event);
  bool nudgeKey(const QKeyEvent& event);

  CurveSubject m_subject;
  TransferFunction m_function;
  Histogram m_histogram;
  QString m_unit;
  QString m_hint;
  ValueRange m_visible{0.0, 1.0};
  std::optional<double> m_markedValue;
  std::optional<double> m_pinnedValue;
  bool m_fineLowOpacities = false;

  PointIndices m_selected;
  CurveDrag m_drag;
  CurveHit m_hovered;
  std::optional<double> m_hoveredValue;
  std::optional<std::size_t>
      m_addedByPress; ///< so that a double click on the curve does not also open details
  std::uint64_t m_keyGestureId = 0;
  bool m_spaceHeld = false;

  struct HistogramCache {
    PlotTransform transform;
    QColor color;
    double devicePixelRatio = 0.0;
    bool operator==(const HistogramCache&) const = default;
  };
  HistogramCache m_histogramKey;
  QPixmap m_histogramPicture;
};

} // namespace limn
