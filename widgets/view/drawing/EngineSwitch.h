// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngines.h"
#include "widgets/view/drawing/ViewDrawing.h"
#include "widgets/view/failure/DriverRecovery.h"

namespace limn {

/// Has one of two engines draw a view, and lets the processor take the driver's place where that fails or has
/// no room for the volume.
class EngineSwitch : public QObject {
  Q_OBJECT

public:
  /// `orders.canDraw` need not know of failures. `engine` draws at first; one that `engines` lacks is never
  /// asked.
  EngineSwitch(DrawingEngines engines, ViewEngine engine, ViewOrders orders, QWidget& view);
  ~EngineSwitch() override;

  /// Lets an engine draw, for a reason that is told with the pictures; nothing happens where there is none.
  void choose(ViewEngine engine, const QString& reason);
  ViewEngine engine() const { return m_engine; }
  ViewDrawing& drawing() const { return *m_drawing; }

  /// Asks the driver again that the processor stands in for, if it does.
  void retryDriver();
  /// What failed may work now: something else is to be shown.
  void retry() { m_recovery.retry(); }
  /// Another volume: nothing that failed of the last one counts.
  void forget();

  /// Gives up getting a volume ready: nothing is drawn until it is tried again or something else is shown.
  void cancelPreparing();

  void setRefines(bool refines);
  void setMovingMs(double ms);

  PictureState state() const;
  /// Why nothing can be drawn; empty while drawing works.
  const QString& problem() const { return m_recovery.sentence(); }
  /// Why the processor draws in place of a driver that failed, and what that wrote; empty where it does not.
  const QString& driverFailure() const { return m_driverFailure; }
  const QString& failureDetails() const { return m_recovery.details(); }

signals:
  /// How far a volume is got ready for drawing, 0..1, where that takes long; 1 once that has ended.
  void preparing(double fraction);
  void replaced(); ///< another drawing, with another canvas, is to be laid out
  void redrawNeeded();
  void stateChanged(const limn::PictureState& state);
  void effectsChanged(const std::vector<limn::EffectRow>& rows, const QString& picture);
  void timesChanged(const limn::EffectTimes& times);
  void failed(const QString& sentence);        ///< nothing is drawn until something else is to be shown
  void errorOccurred(const QString& sentence); ///< drawing goes on
  void restored(const QString& sentence);      ///< drawing had failed, and works again
  void engineChanged(limn::ViewEngine engine); ///< by itself

private:
  void draw(ViewEngine engine);
  ViewDrawing* makeDriverDrawing();
  ViewDrawing* makeProcessorDrawing();
  bool letProcessorDraw(QString& reason, const QString& sentence);
  void giveUpDriver();
  void standIn();

  DrawingEngines m_engines;
  ViewOrders m_orders;
  QWidget& m_view;
  DriverRecovery m_recovery;
  ViewEngine m_engine;
  ViewDrawing* m_drawing = nullptr;
  bool m_refines = true;
  std::optional<double> m_movingMs; ///< where it was set
  QString m_reason;
  QString m_driverFailure;
  QString m_tooLarge; ///< why the processor draws this volume
};

} // namespace limn
