// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/drawing/PictureWorker.h"

#include <QThread>

namespace limn {

/// Pictures that the processor draws on a thread of its own; Qt paints them, so that no OpenGL is needed and
/// the event loop is never held. What is seen is the last picture drawn, also while another is asked for.
class ProcessorDrawing : public ViewDrawing {
  Q_OBJECT

public:
  /// `makeEngine` makes one that draws in memory.
  ProcessorDrawing(MakeEngine makeEngine, ViewOrders orders, QWidget& view);
  ~ProcessorDrawing() override;

  QWidget& canvas() override;
  void restart() override;
  void arrangeAnew() override;
  void resume() override;
  void stop() override;
  void forget() override;
  void forgetSpeed() override;
  void forgetEffects() override;
  void measureEffects() override;
  void setRefines(bool refines) override;
  void setMovingMs(double ms) override;
  void endPreparing() override;
  const PictureState& state() const override { return m_state; }
  std::optional<RestingPicture> resting(int side) const override;
  GradientScale gradientScaleOf(int side) const override;

signals:
  void failed(const QString& sentence); ///< nothing is drawn until something else is to be shown

private:
  class Canvas;
  void askSoon();
  void ask();
  void receive();
  void paint(QPainter& painter);

  ViewOrders m_orders;
  Canvas* m_canvas;
  QThread m_thread;
  PictureWorker* m_worker; ///< on the thread
  int m_number = 0;        ///< of the last order
  int m_forgotten = -1;    ///< the last order for the volume before
  QTimer m_askTimer;       ///< several changes of one turn are one order
  PictureDelivery m_delivery;
  PictureState m_state;
};

} // namespace limn
