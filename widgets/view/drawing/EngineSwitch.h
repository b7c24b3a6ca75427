// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "widgets/view/drawing/DriverRecovery.h"
#include "widgets/view/drawing/ViewDrawing.h"

namespace limn {

class DriverRecovery;
class GlCanvas;

/// Pictures that the graphics driver draws, in turns of the window's event loop, on a widget with an OpenGL
/// context of its own. What fails is `recovery`'s to mend. Light that the driver's engine looks up the
/// processor's follows, once the pictures rest.
class DriverDrawing : public ViewDrawing {
  Q_OBJECT

public:
  DriverDrawing(const DrawingEngines& engines, DriverRecovery& recovery, QWidget& view);
  ~DriverDrawing() override;

  QWidget& canvas() override;
  void measureEffects(bool measures) override { m_loop.measureEffects(measures); }
  std::optional<RestingPicture> resting(int side) const override;
  GradientScale gradientScaleOf(int side) const override { return m_loop.gradientScaleOf(side); }

  /// Drops everything in the driver, and the context where it `isLost`; the next picture has it made anew.
  void rebuild(bool isLost);

signals:
  void contextRefused(); ///< the canvas was shown and has no OpenGL context

protected:
  const ViewNews& drawn() const override { return m_loop.news(); }
  void drawOrder(const PictureOrder& order) override { m_loop.show(order); }

private:
  friend class GlCanvas;
  void paint();
  void release();

  DriverRecovery& m_recovery;
  GlCanvas* m_canvas;
  PictureLoop& m_loop;
};

/// Has one of two engines draw a view, and lets the processor take the driver's place where that fails, has
/// no room for the volume, or cannot draw the scene: that one until it can.
class EngineSwitch : public QObject {
  Q_OBJECT

public:
  /// `engine` draws at first; one that `engines` lacks is never asked.
  EngineSwitch(DrawingEngines engines, Engine engine, QWidget& view);
  ~EngineSwitch() override;

  /// What is to be seen from now on; an equal order draws nothing. Of failures, attempts and the engine in
  /// use it need not know.
  void show(const ViewOrder& order);

  /// Lets an engine draw, for a reason that is told with the pictures; nothing happens where there is none.
  void choose(Engine engine, const QString& reason);
  Engine engine() const { return m_engine; }
  ViewDrawing& drawing() const { return *m_drawing; }

  /// Asks the driver again that the processor stands in for, if it does.
  void retryDriver();
  /// Tries again what failed.
  void retry();

  /// Gives up getting a volume ready: nothing is drawn until it is tried again or something else is shown.
  void cancelPreparing();

  /// Why nothing can be drawn; empty while drawing works.
  const QString& problem() const { return m_recovery.sentence(); }
  /// Why the processor draws in place of a driver that failed, and what that wrote; empty where it does not.
  const QString& driverFailure() const { return m_driverFailure; }
  const QString& failureDetails() const { return m_recovery.details(); }

signals:
  void replaced(); ///< another drawing, with another canvas, is to be laid out
  void told(const limn::ViewNews& news);
  void errorOccurred(const QString& sentence); ///< whether drawing goes on or not
  void restored(const QString& sentence);      ///< drawing had failed, and works again

private:
  void push();
  void tell();
  void take(const ViewNews& news);
  void draw(Engine engine);
  ViewDrawing* makeDriverDrawing();
  bool letProcessorDraw(QString& reason, const QString& sentence);
  void giveUpDriver();
  void standIn(bool isVolume);

  DrawingEngines m_engines;
  QWidget& m_view;
  DriverRecovery m_recovery;
  Engine m_engine;
  ViewOrder m_order;
  ViewNews m_news; ///< as told last
  int m_attempt = 0;
  ViewDrawing* m_drawing = nullptr;
  QString m_reason;
  QString m_driverFailure;
  QString m_tooLarge; ///< why the processor draws this volume, or this scene
  bool m_standsInForScene = false;
};

} // namespace limn
