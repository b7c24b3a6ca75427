// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/ViewGeometry.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/pictures/PictureLoop.h"

#include <QWidget>

namespace limn {

/// What a view wants to see, asked for when it is drawn or painted.
struct ViewOrders {
  std::function<bool()> canDraw; ///< seen, something to show, and nothing has failed
  std::function<PictureRequest()> request;
  std::function<Pictures::Arrangement()> arrangement;
  std::function<glm::dvec3()> background;
  std::function<ViewGeometry()> geometry;
  std::function<std::optional<Overlay>()> overlay; ///< what stands above the pictures; absent: nothing
};

/// A picture of a view, complete.
struct RestingPicture {
  std::shared_ptr<const Image> image; ///< premultiplied, without background
  QImage bytes;                       ///< over the background, rounded as a file is
  Quality quality;                    ///< it was drawn with
};

/// What a picture at rest holds.
RestingPicture restingPicture(const SidePicture& side);

/// Draws and shows the pictures of a view on a canvas of its own: on the graphics card (DriverDrawing) or on
/// the processor (ProcessorDrawing).
class ViewDrawing : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  /// What is painted on, a child of the view; the pointer goes through it.
  virtual QWidget& canvas() = 0;

  /// Something else is to be shown: what was drawn is stale.
  virtual void restart() = 0;
  /// The same pictures are to be put together otherwise.
  virtual void arrangeAnew() = 0;
  /// Goes on with what is done at rest, after it paused unseen.
  virtual void resume() = 0;
  /// Does nothing more until something else is to be shown.
  virtual void stop() = 0;
  virtual void forget() = 0;        ///< another volume: nothing that was told holds any more
  virtual void forgetSpeed() = 0;   ///< another kind of picture
  virtual void forgetEffects() = 0; ///< there is nothing to tell the effects of
  virtual void measureEffects() = 0;
  virtual void setRefines(bool refines) = 0;
  virtual void setMovingMs(double ms) = 0; ///< drawing time of a frame while something moves, > 0

  virtual const PictureState& state() const = 0;
  virtual std::optional<RestingPicture> resting(int side) const = 0; ///< absent before it is complete
  /// The gradient moduli with which a side was lit; empty before it was drawn.
  virtual GradientScale gradientScaleOf(int side) const = 0;

  /// Gives up getting a volume ready; nothing is drawn until something is asked for anew.
  virtual void endPreparing() = 0;

signals:
  /// How far a volume is got ready for drawing, 0..1, where that takes long; 1 once that has ended.
  void preparing(double fraction);
  void stateChanged(const limn::PictureState& state);
  void effectsChanged(const std::vector<limn::EffectRow>& rows, const QString& picture);
  void timesChanged(const limn::EffectTimes& times);
  void completed(); ///< every picture, at its scene's step
  /// Something that is done at rest failed; the pictures stay.
  void restFailed(const QString& sentence);
};

} // namespace limn
