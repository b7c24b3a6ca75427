// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Gesture.h"
#include "widgets/curve/canvas/CurveInput.h"
#include "widgets/curve/picture/CanvasPicture.h"
#include "widgets/curve/picture/CurveEdits.h"
#include "widgets/curve/picture/HistogramPicture.h"

#include <QWidget>

#include <optional>

namespace limn {

struct CanvasPicture;

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
  /// How high the histogram stands; logarithmic at first.
  void setHistogramScale(HistogramScale scale) {
    m_histogram.setScale(scale);
    update();
  }
  void setUnit(const QString& unit) { setShown(m_plot.unit, unit); }
  void setMark(const std::optional<ValueMark>& mark) { setShown(m_mark, mark); }
  void setPinnedValue(std::optional<double> value) {
    setShown(m_pinnedValue, value);
    emit pinChanged();
  }
  void setFineLowOpacities(bool fine) { setShown(m_fineLowOpacities, fine); }
  /// A sentence in the middle of the plot; empty for none. Without a histogram the plot has its own.
  void setHint(const QString& hint) { setShown(m_hint, hint); }

  CurveSubject subject() const { return m_plot.subject; }
  const TransferFunction& transferFunction() const { return m_plot.function; }
  const PointIndices& selected() const { return m_plot.selected; }
  const QString& unit() const { return m_plot.unit; }
  const CurvePlot& plot() const { return m_plot; }
  bool hasPin() const { return m_pinnedValue.has_value(); }
  const std::optional<ValueMark>& mark() const { return m_mark; }
  std::optional<double> pinnedValue() const { return m_pinnedValue; }
  PlotTransform transform() const;

  /// What it shows, as a value.
  CanvasPicture picture();

  /// Decimals that tell neighbouring pixels apart.
  int shownDecimals() const;

  /// Shows every value of the volume and every point again.
  void resetView();

  void selectPoints(const PointIndices& indices);

  /// Replaces the function as one edit of the user's, from the controls beside the plot.
  void edit(const TransferFunction& function, const Gesture& gesture);

  /// An act of the user's in the plot; no id is one of its own.
  void apply(const CurveChange& change, std::optional<std::uint64_t> gestureId = std::nullopt);

  /// Adds a point at a place in the plot.
  void addPoint(const QPointF& position);

  /// Nothing is under the pointer until it moves over the plot again: what lay over it is closed, or the
  /// volume is another one.
  void forgetPointer();

  /// Takes one point in hand, and scrolls it into view.
  void takeInHand(std::size_t index);

  /// Moves a point as an act of the user's, within its reach; not during a drag.
  void placePoint(std::size_t index, double value, double opacity);

  /// The point that keys go to: the first in hand while the plot has the focus.
  std::optional<std::size_t> focusedPoint() const;

  QSize sizeHint() const override { return {720, 220}; }
  QSize minimumSizeHint() const override { return {240, 120}; }

signals:
  void transferFunctionEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);
  void valueHovered(std::optional<double> value);
  void selectionChanged();
  void pinChanged();
  /// The user wants to type numbers (Enter).
  void numbersRequested();
  /// The user wants colour and numbers of a point, and of all that are in hand with it, in a pop-up (double
  /// click).
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
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;

private:
  template <class Value>
  void setShown(Value& shown, const Value& value) {
    shown = value;
    update();
  }
  void revealSelected();

  bool isDragging() const { return m_drag.kind != CurveDrag::Kind::none; }
  void press(const CurveHit& hit, const QMouseEvent& event);
  void pressCurve(const QPointF& position);
  void begin(const CurveDrag& drag);
  void continueDrag(const QMouseEvent& event);
  void endDrag();
  void cancelDrag();

  void hover(const QPointF& position);
  void setHoveredValue(std::optional<double> value);
  void doKey(CurveKey key, const QKeyEvent& event);
  bool isOwnKey(const QKeyEvent& event) const;
  void nudge(const QKeyEvent& event);

  CurvePlot m_plot;
  HistogramCache m_histogram;
  QString m_hint;
  ValueRange m_visible{0.0, 1.0};
  std::optional<ValueMark> m_mark;
  std::optional<double> m_pinnedValue;
  bool m_fineLowOpacities = false;

  CurveDrag m_drag;
  CurveHit m_hovered;
  std::optional<double> m_hoveredValue;
  std::optional<std::size_t>
      m_addedByPress;          ///< so that a double click on the curve does not also open details
  PointIndices m_inHandBefore; ///< a click took one of several points: they, for the second one of two
  // What the last arrow key left; the next one along the same axis goes on from it as one gesture.
  struct Nudged {
    std::uint64_t gestureId = 0;
    bool isAcross = false;
    TransferFunction function;
    PointIndices selected;
  } m_nudged;
  bool m_spaceHeld = false;
};

} // namespace limn
