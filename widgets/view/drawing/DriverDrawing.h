// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "widgets/view/drawing/ViewDrawing.h"

namespace limn {

class DriverRecovery;
class GlCanvas;

/// Pictures that the graphics driver draws, in turns of the window's event loop, on a widget with an OpenGL
/// context of its own. What fails is `recovery`'s to mend.
class DriverDrawing : public ViewDrawing {
  Q_OBJECT

public:
  DriverDrawing(MakeEngine makeEngine, DriverRecovery& recovery, QWidget& view);
  ~DriverDrawing() override;

  QWidget& canvas() override;
  void measureEffects() override { m_loop.measureEffects(); }
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

} // namespace limn
