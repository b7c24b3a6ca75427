// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngines.h"
#include "widgets/view/drawing/ViewDrawing.h"

#include <atomic>
#include <mutex>

namespace limn {

/// Pictures to draw, and how to put them together.
struct PictureOrder {
  int number = 0; ///< of the pictures: the same number asks only to put them together otherwise
  PictureRequest request;
  Pictures::Arrangement arrangement;
  glm::dvec3 background{0.0};
};

/// What there is of an order so far.
struct PictureDelivery {
  int number = 0;
  QImage frame; ///< what is to be seen, in device pixels
  PictureState state;
  std::vector<GradientScale> scales;   ///< one for each side
  std::vector<RestingPicture> resting; ///< one for each side once all are complete; empty before
};

/// Draws pictures with an engine that computes in memory, in the event loop of a thread of its own, where it
/// must be moved to before the first order. What is not said to be for any thread is called there.
class PictureWorker : public QObject {
  Q_OBJECT

public:
  explicit PictureWorker(MakeEngine makeEngine);
  ~PictureWorker() override;

  /// From any thread: asks for pictures instead of whatever was asked for before. What is being drawn at rest
  /// is dropped; a coarse picture is drawn to its end, so that there is something to see.
  void ask(PictureOrder order);
  /// From any thread: draws nothing more until it is asked or told to go on; what was asked for before and
  /// not begun is dropped.
  void rest();
  /// From any thread: what there is of the order, if that is more than was taken before.
  std::optional<PictureDelivery> take();
  /// From any thread: ends what is being drawn at rest.
  void interrupt() { m_isInterrupted = true; }
  /// From any thread: ends getting a volume ready, too, which another order does not.
  void endPreparing() { m_endsPreparing = true; }

  void goOn();
  void forget() { m_loop.forget(); }
  void forgetSpeed() { m_loop.forgetSpeed(); }
  void forgetEffects() { m_loop.forgetEffects(); }
  void measureEffects() { m_loop.measureEffects(); }
  void setRefines(bool refines) { m_loop.setRefines(refines); }
  void setMovingMs(double ms) { m_loop.setMovingMs(ms); }

signals:
  void preparing(double fraction); ///< how far a volume is got ready, 0..1
  void delivered();                ///< there is something to take
  void effectsChanged(const std::vector<limn::EffectRow>& rows, const QString& picture);
  void timesChanged(const limn::EffectTimes& times);
  void completed();
  void restFailed(const QString& sentence);
  void failed(const QString& sentence); ///< nothing is drawn until it is asked anew

private:
  void wake();
  void begin();
  void guard(const PictureContext::Work& work);
  void show();
  void deliver();

  PictureLoop m_loop;
  PictureOrder m_order; ///< that is being drawn
  QImage m_frame;
  bool m_canDraw = false;
  bool m_isCoarse = false; ///< a coarse picture is being drawn

  std::atomic<bool> m_isInterrupted = false;
  std::atomic<bool> m_endsPreparing = false;
  std::mutex m_mutex;
  std::optional<PictureOrder> m_next;        ///< guarded
  bool m_restsFirst = false;                 ///< guarded; before `m_next`, if there is one
  bool m_isWoken = false;                    ///< guarded; `begin` is to come
  std::optional<PictureDelivery> m_delivery; ///< guarded
};

} // namespace limn
