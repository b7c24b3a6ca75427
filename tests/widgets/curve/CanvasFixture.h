// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/WidgetSamples.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace limn {

/// A shown plot of the sample function over the sample histogram, 1000 × 300 pixels, and everything it
/// emitted.
class CanvasFixture : public testing::Test {
protected:
  CanvasFixture() {
    m_canvas.resize(1000, 300);
    m_canvas.setUnit(QStringLiteral("HU"));
    m_canvas.setHistogram(sampleHistogram());
    m_canvas.setTransferFunction(sampleFunction());
    m_canvas.show();
    m_canvas.setFocus();
    QObject::connect(&m_canvas, &TransferFunctionCanvas::transferFunctionEdited, &m_canvas,
                     [this](const TransferFunction& function, const Gesture& gesture) {
                       m_edits.emplace_back(function, gesture);
                       m_canvas.setTransferFunction(function); // as a session echoes it
                     });
  }

  const std::vector<ControlPoint>& points() const { return m_canvas.transferFunction().points; }

  /// Pixel of a value and an opacity.
  QPoint pixel(double value, double opacity) const {
    return QPointF(xOfValue(m_canvas.transform(), value), yOfOpacity(m_canvas.transform(), opacity))
        .toPoint();
  }
  QPoint pixelOf(std::size_t i) const { return pixel(points()[i].value, points()[i].opacity); }

  /// A place with nothing near: above the curve, left of it.
  QPoint emptyPlace() const { return pixel(-600.0, 0.6); }

  QPoint barGrip() const {
    return curveBar(m_canvas.transform(), m_canvas.transferFunction())->grip.toPoint();
  }

  double perPixel() const { return valuePerPixel(m_canvas.transform()); }

  /// Presses at `from`, moves in `steps` to `to` without releasing. Modifiers hold during the moves only.
  void pressAndMove(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {},
                    Qt::MouseButton button = Qt::LeftButton, int steps = 4) {
    QTest::mousePress(&m_canvas, button, {}, from);
    moveTo(from, to, modifiers, button, steps);
  }

  void moveTo(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {},
              Qt::MouseButton button = Qt::LeftButton, int steps = 4) {
    for (int i = 1; i <= steps; ++i) {
      const QPointF at = QPointF(from) + QPointF(to - from) * i / steps;
      QMouseEvent event(QEvent::MouseMove, at, m_canvas.mapToGlobal(at), Qt::NoButton, button, modifiers);
      QApplication::sendEvent(&m_canvas, &event);
    }
  }

  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {},
            Qt::MouseButton button = Qt::LeftButton) {
    pressAndMove(from, to, modifiers, button);
    QTest::mouseRelease(&m_canvas, button, {}, to);
  }

  void wheel(const QPoint& at, int notches, Qt::KeyboardModifiers modifiers = {}) {
    QWheelEvent event(QPointF(at), QPointF(m_canvas.mapToGlobal(at)), QPoint(), QPoint(0, 120 * notches),
                      Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&m_canvas, &event);
  }

  /// All edits so far carry one id and it is not 0.
  void expectOneGesture() const {
    ASSERT_FALSE(m_edits.empty());
    for (const auto& [function, gesture] : m_edits)
      EXPECT_EQ(gesture.id, m_edits.front().second.id);
    EXPECT_NE(m_edits.front().second.id, 0u);
  }

  TransferFunctionCanvas m_canvas;
  std::vector<std::pair<TransferFunction, Gesture>> m_edits;
};

} // namespace limn
