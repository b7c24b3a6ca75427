// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "widgets/view/drawing/ViewDrawing.h"

#include <QThread>

#include <atomic>
#include <mutex>

namespace limn {

/// What there is of an order so far.
struct PictureDelivery {
  int number = 0;       ///< of the order
  int measurements = 0; ///< of what effects cost that were begun
  QImage frame;         ///< what is to be seen, in device pixels
  Camera camera;        ///< from which that was drawn
  ViewNews news;
  std::vector<GradientScale> scales;   ///< one for each side
  std::vector<RestingPicture> resting; ///< one for each side once all are complete; empty before
};

/// Draws pictures with an engine that computes in memory, in the event loop of a thread of its own, where it
/// must be moved to before the first order. What is not said to be for any thread is called there.
class PictureWorker : public QObject {
  Q_OBJECT

public:
  explicit PictureWorker(MakeEngine makeEngine, MakePrecise makePrecise = {});
  ~PictureWorker() override;

  /// From any thread: asks for pictures instead of whatever was asked for before. What is being drawn at rest
  /// is dropped; a coarse picture is drawn to its end, so that there is something to see. Getting a volume
  /// ready ends where another one, or another attempt, is asked for. Deliveries carry the number.
  void ask(PictureOrder order, int number);
  /// From any thread: what there is of the order, if that is more than was taken before.
  std::optional<PictureDelivery> take();
  /// From any thread: ends what is being drawn or got ready, before the thread ends.
  void interrupt() { m_isInterrupted = m_endsPreparing = true; }

  /// From any thread: measures what the effects of the last picture cost, or no longer. What is being drawn
  /// at rest gives way and goes on after that.
  void measureEffects(bool measures);

signals:
  void delivered(); ///< there is something to take

private:
  void begin();
  void beginMeasuring(bool measures);
  void guard(const PictureContext::Work& work);
  void show();
  void deliver();

  PictureLoop m_loop;
  int m_number = 0;       ///< of the order that is being drawn
  int m_measurements = 0; ///< that were begun
  QImage m_frame;
  Camera m_camera;         ///< of the frame
  QString m_failure;       ///< why nothing is drawn; empty while drawing works
  bool m_isCoarse = false; ///< a coarse picture is being drawn

  std::atomic<bool> m_isInterrupted = false;
  std::atomic<bool> m_endsPreparing = false;
  std::mutex m_mutex;
  PictureOrder m_last;                       ///< guarded; asked for last
  int m_lastNumber = 0;                      ///< guarded
  bool m_isWoken = false;                    ///< guarded; `begin` is to come
  std::optional<PictureDelivery> m_delivery; ///< guarded
};

/// Pictures that the processor draws on a thread of its own; Qt paints them, so that no OpenGL is needed and
/// the event loop is never held. What is seen is the last picture drawn, also while another is asked for.
class ProcessorDrawing : public ViewDrawing {
  Q_OBJECT

public:
  /// `makeEngine` makes one that draws in memory.
  ProcessorDrawing(MakeEngine makeEngine, MakePrecise makePrecise, QWidget& view);
  ~ProcessorDrawing() override;

  QWidget& canvas() override;
  void measureEffects(bool measures) override;
  std::optional<RestingPicture> resting(int side) const override;
  GradientScale gradientScaleOf(int side) const override;

protected:
  const ViewNews& drawn() const override { return m_delivery.news; }
  void drawOrder(const PictureOrder& order) override;

private:
  class Canvas;
  void receive();
  void noteMeasuring();
  void paint(QPainter& painter);

  Canvas* m_canvas;
  QThread m_thread;
  PictureWorker* m_worker; ///< on the thread
  PictureOrder m_pictures; ///< the last order
  int m_number = 0;        ///< of its pictures: the same asks only to put them together otherwise
  int m_measurements = 0;  ///< of what effects cost that were asked for, or ended
  bool m_measures = false; ///< the last was asked for
  int m_forgotten = -1;    ///< the last order for the volume before
  QTimer m_askTimer;       ///< several changes of one turn are one order
  PictureDelivery m_delivery;
};

} // namespace limn
