// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/ViewOrder.h"
#include "widgets/view/pictures/PictureLoop.h"

#include <QWidget>

namespace limn {

/// What the pictures of a view are, and how they are put together.
PictureOrder pictureOrderOf(const ViewOrder& order);

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

  /// What is to be seen from now on; an equal order draws nothing.
  void show(const ViewOrder& order);

  /// Measures at rest what the effects of the last picture cost, or no longer.
  virtual void measureEffects(bool measures) = 0;

  virtual std::optional<RestingPicture> resting(int side) const = 0; ///< absent before it is complete
  /// The gradient moduli with which a side was lit; empty before it was drawn.
  virtual GradientScale gradientScaleOf(int side) const = 0;

  /// What there is of the order at this moment.
  PictureState state() const { return stateTold(drawn().state, m_order); }
  ViewNews news() const;

signals:
  void told(const limn::ViewNews& news); ///< in a turn of its own

protected:
  virtual const ViewNews& drawn() const = 0;
  virtual void drawOrder(const PictureOrder& order) = 0;
  const ViewOrder& order() const { return m_order; }
  OverlaySource overlaySource() const { return {m_order, state()}; }
  void tell() { emit told(news()); }

private:
  ViewOrder m_order;
};

} // namespace limn
