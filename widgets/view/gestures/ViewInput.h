// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Gradient.h"
#include "widgets/view/gestures/Probe.h"
#include "widgets/view/gestures/ViewDrag.h"
#include "widgets/view/gestures/ViewKeys.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <QCursor>
#include <QObject>

#include <functional>
#include <optional>

class QMouseEvent;
class QWheelEvent;
class QWidget;

namespace limn {

/// The pointer that tells what a drag of this kind does; the plain arrow for rotating. Seen on light and dark
/// pictures. Needs a QGuiApplication.
QCursor cursorOf(DragKind kind);

/// What pointer and keys ask of a view. Keeps what the pointer is over, holds and reads, and gives the view
/// its cursor and tool tip; everything else is said by signals.
class ViewInput : public QObject {
  Q_OBJECT

public:
  /// What an event is about: what stands in the view at present, the gradient moduli with which a side was
  /// lit.
  struct Facts {
    std::function<OverlaySource()> shown;
    std::function<GradientScale(int side)> scaleOfSide;
    std::function<IndexBox()> visibleBox; ///< on which views are framed
  };
  ViewInput(QWidget* view, Facts facts);

  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  void doubleClick(const QMouseEvent& event);
  void turnWheel(QWheelEvent& event);
  void leave();
  /// False where the command asks nothing of this view.
  bool obey(const ViewCommand& command);

  void stopReading(); ///< the value under the pointer
  void forgetFace() { m_hovered.face.reset(); }
  void forget(); ///< drag and reading, of another volume

  void setTool(ViewTool tool);
  ViewTool tool() const { return m_tool; }

  /// What the pointer is over, or holds.
  Hovered hovered() const;
  std::optional<CropFace> heldFace() const;
  const std::optional<ReadValue>& reading() const { return m_read; }

  /// The gradient moduli with which a side was lit.
  GradientScale scaleOfSide(int side) const { return m_facts.scaleOfSide(side); }

signals:
  void cameraEdited(const limn::Camera& camera);
  void functionEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);
  void cropEdited(const limn::CropBox& crop, const limn::Gesture& gesture);
  void wipeEdited(double fraction);
  void probed(const std::optional<limn::Probe>& probe);
  /// The ray that is probed, whatever it meets, of the picture of a side.
  void rayRead(const limn::Ray& ray, int side);
  void pinRequested(double value);
  void placePinned(const glm::dvec3& worldMm);
  void modelsRequested(int position); ///< of which the label was clicked
  void everythingRequested();         ///< of what a region hides
  void maximiseRequested();
  void windowPresetRequested(int number);
  void shortcutListRequested();
  void swapRequested();
  void toolChanged(limn::ViewTool tool);

private:
  void ask(const ViewEdit& edit, const Gesture& gesture);
  void cancelDrag(const Scene& shown);
  void showCursor(const std::optional<CropHandle>& handle);
  void hover(const QMouseEvent& event);
  void uncut(const Scene& shown, CropFace face);
  std::optional<Probe> probeAt(const OverlaySource& source, const QPointF& point) const;
  void readRayAt(const OverlaySource& source, const QPointF& point);
  void showProbe(const std::optional<Probe>& probe, const QPointF& point);

  QWidget* m_view;
  Facts m_facts;
  ViewTool m_tool = ViewTool::rotate;
  std::optional<ViewDrag> m_drag;
  Hovered m_hovered;
  std::optional<ReadValue> m_read; ///< under the pointer, while Shift is held
};

} // namespace limn
