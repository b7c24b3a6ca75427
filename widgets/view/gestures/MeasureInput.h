// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"
#include "widgets/view/overlay/MeasureMarks.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <QObject>
#include <QPointF>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

class QMouseEvent;

namespace limn {

/// The handle of a measurement that a press at a point of the view, logical pixels, takes hold of.
std::optional<MeasureHandle> measureHandleUnder(const OverlaySource& source, const QPointF& point);

/// What the pointer asks of measurements in a view: leads their handles, sets places with clicks, and draws
/// from one place to the next with drags. It knows no measurement: what is asked for is said by signals.
class MeasureInput : public QObject {
  Q_OBJECT

public:
  using Shown = std::function<OverlaySource()>; ///< what stands in the view at present
  MeasureInput(QObject* parent, Shown shown);

  /// Whether a drag that begins on this ray of the picture of a side measures; else it does what the tool
  /// does without. None does at first.
  using DrawsFrom = std::function<bool(const Ray& ray, int side)>;
  void setDrawsFrom(DrawsFrom drawsFrom) { m_drawsFrom = std::move(drawsFrom); }

  /// False where what the pointer does here is no matter of measurements. `isTool`: a tool that measures is
  /// in hand.
  bool press(const OverlaySource& source, const QMouseEvent& event, bool isTool);
  bool move(const QPointF& point);
  bool release(const QMouseEvent& event);

  bool isHolding() const { return m_held || m_drawn; } ///< a handle, or what a drag draws
  void click(const QPointF& point);                    ///< a place shall be what is seen there
  bool cancel();                                       ///< what is held; false where nothing is
  void drop();                                         ///< what is being measured
  void remove();                                       ///< that, or else the measurement in hand
  void forgetDrawn() { m_drawn.reset(); }
  void forget(); ///< of another volume

signals:
  /// A place of the measurement of the tool in hand shall be what is seen along this ray of the picture of a
  /// side.
  void placeRequested(const limn::Ray& ray, int side);
  /// The next place of the measurement that a drag has begun shall be shown there, until it is let go.
  void stretched(const limn::Ray& ray, int side);
  /// A handle of a measurement was taken; it is led by the gesture of this id. The same with a ray along
  /// which it shall lie, or that it shall lie again where it was.
  void taken(const limn::MeasureHandle& handle, std::uint64_t gesture);
  void led(const limn::Ray& ray, int side);
  void left();
  void removed(); ///< the one that is being drawn shall be dropped, or else the one in hand deleted
  void dropped(); ///< the one that is being drawn shall be dropped

private:
  using Said = void (MeasureInput::*)(const Ray& ray, int side);
  bool say(Said said, const QPointF& point);
  bool take(const OverlaySource& source, const QPointF& point);
  bool begin(const OverlaySource& source, const QPointF& point);
  void stretch(const QPointF& point);

  // A measurement that is drawn from where the button went down.
  struct Drawn {
    QPointF from;
    bool hasMoved = false; ///< else it is a click
  };

  Shown m_shown;
  DrawsFrom m_drawsFrom = [](const Ray&, int) { return false; };
  std::optional<MeasureHandle> m_held; ///< that is being led
  std::optional<Drawn> m_drawn;
};

} // namespace limn
