// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngines.h"
#include "widgets/view/drawing/ViewDrawing.h"

namespace limn {

class DriverRecovery;
class GlCanvas;

/// Pictures that the graphics driver draws, in turns of the window's event loop, on a widget with an OpenGL
/// context of its own. What fails is `recovery`'s to mend.
class DriverDrawing : public ViewDrawing {
  Q_OBJECT

public:
  DriverDrawing(MakeEngine makeEngine, ViewOrders orders, DriverRecovery& recovery, QWidget& view);
  ~DriverDrawing() override;

  QWidget& canvas() override;
  void restart() override;
  void arrangeAnew() override { canvas().update(); }
  void resume() override { m_loop.resume(); }
  void stop() override { m_loop.stop(); }
  void forget() override { m_loop.forget(); }
  void forgetSpeed() override { m_loop.forgetSpeed(); }
  void forgetEffects() override { m_loop.forgetEffects(); }
  void measureEffects() override { m_loop.measureEffects(); }
  void setRefines(bool refines) override { m_loop.setRefines(refines); }
  void setMovingMs(double ms) override { m_loop.setMovingMs(ms); }
  void endPreparing() override { m_loop.stop(); }
  const PictureState& state() const override { return m_loop.state(); }
  std::optional<RestingPicture> resting(int side) const override;
  GradientScale gradientScaleOf(int side) const override { return m_loop.gradientScaleOf(side); }

  /// Drops everything in the driver, and the context where it `isLost`; the next picture has it made anew.
  void rebuild(bool isLost);

signals:
  void contextRefused(); ///< the canvas was shown and has no OpenGL context

private:
  friend class GlCanvas;
  void paint();
  void release();

  ViewOrders m_orders;
  DriverRecovery& m_recovery;
  GlCanvas* m_canvas;
  PictureLoop& m_loop;
};

} // namespace limn
