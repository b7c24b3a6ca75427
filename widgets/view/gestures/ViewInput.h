// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/framing/Framing.h"
#include "scene/light/Gradient.h"
#include "widgets/view/gestures/CameraHistory.h"
#include "widgets/view/gestures/Probe.h"
#include "widgets/view/gestures/ViewDrag.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <QCursor>
#include <QObject>
#include <QPoint>

#include <functional>
#include <optional>
#include <variant>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;
class QWidget;

namespace limn {

/// What a key of the 3D view asks for.
namespace viewcommand {
struct LookFrom {
  StandardView view;
  bool operator==(const LookFrom&) const = default;
};
struct LookFromNearest { ///< the standard view nearest to the present one
  bool operator==(const LookFromNearest&) const = default;
};
struct Reset { ///< the camera of a freshly opened volume
  bool operator==(const Reset&) const = default;
};
struct Rotate { ///< in steps, as if the pointer were dragged right and down
  int right = 0;
  int down = 0;
  bool operator==(const Rotate&) const = default;
};
struct Zoom { ///< in notches of the wheel
  int notches = 0;
  bool operator==(const Zoom&) const = default;
};
struct UseTool {
  ViewTool tool;
  bool operator==(const UseTool&) const = default;
};
struct WindowPreset { ///< 0 is the full dynamic range, 1..9 the presets
  int number = 0;
  bool operator==(const WindowPreset&) const = default;
};
struct Swap { ///< show the other side while held
  bool operator==(const Swap&) const = default;
};
struct Cancel {
  bool operator==(const Cancel&) const = default;
};
struct ListShortcuts {
  bool operator==(const ListShortcuts&) const = default;
};
} // namespace viewcommand

using ViewCommand =
    std::variant<std::monostate, viewcommand::LookFrom, viewcommand::LookFromNearest, viewcommand::Reset,
                 viewcommand::Rotate, viewcommand::Zoom, viewcommand::UseTool, viewcommand::WindowPreset,
                 viewcommand::Swap, viewcommand::Cancel, viewcommand::ListShortcuts>;

/// The command of a key; monostate where the view does not use it. Slicer's keys choose the standard views
/// (End or keypad 1 anterior, with Shift posterior; PgDn or 3 left, right; Home or 7 superior, inferior;
/// Insert or 0 the nearest), and so do the letters A P L S I. R resets, as in VTK programs: the right side
/// is reached by Shift+PgDn.
ViewCommand commandOf(const QKeyEvent& event);

/// On what views are framed, asked only where one is wanted, and width over height of a picture.
struct ViewFrame {
  std::function<IndexBox()> visibleBox;
  double aspect = 1.0;
  std::optional<glm::dvec3> turnsAbout = {}; ///< world; absent: the target
};

/// The camera that a command asks for, of this volume; nothing where the command moves none.
std::optional<Camera> cameraAfter(const ViewCommand& command, const Camera& camera, const Volume& volume,
                                  const ViewFrame& frame);

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
  /// As a right click there does, logical pixels.
  void askForMenu(const QPointF& point);
  /// False where the command asks nothing of this view. `timestampMs` is when its key was pressed: presses in
  /// a row are one gesture. Without, it is a gesture of its own.
  bool obey(const ViewCommand& command, std::optional<std::uint64_t> timestampMs = {});

  void stopReading(); ///< the value under the pointer
  void forgetFace() { m_hovered.face.reset(); }
  void forget(); ///< drag and reading, of another volume

  void setTool(ViewTool tool);
  ViewTool tool() const { return m_tool; }

  /// What the pointer is over, or holds.
  Hovered hovered() const;
  std::optional<CropFace> heldFace() const;
  bool isTurning() const; ///< by a drag that has moved
  const std::optional<ReadValue>& reading() const { return m_read; }

  /// The gradient moduli with which a side was lit.
  GradientScale scaleOfSide(int side) const { return m_facts.scaleOfSide(side); }

signals:
  /// By the gesture of this id.
  void cameraEdited(const limn::Camera& camera, std::uint64_t gesture);
  void functionEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);
  void cropEdited(const limn::CropBox& crop, const limn::Gesture& gesture);
  void wipeEdited(double fraction);
  void probed(const std::optional<limn::Probe>& probe);
  /// The ray that is probed, whatever it meets, of the picture of a side.
  void rayRead(const limn::Ray& ray, int side);
  /// What is seen along this ray of the picture of a side shall be the centre of turns.
  void turnAboutRequested(const limn::Ray& ray, int side);
  void cameraReset();
  /// What can be done with what is seen along a ray of the picture of a side; no ray: beside the pictures.
  void menuRequested(const std::optional<limn::Ray>& ray, int side, const QPoint& at);
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
  void obeyClick(ViewClick click, const QPointF& point);
  void readRayAt(const OverlaySource& source, const QPointF& point);
  void showProbe(const std::optional<Probe>& probe, const QPointF& point);

  QWidget* m_view;
  Facts m_facts;
  ViewTool m_tool = ViewTool::rotate;
  std::optional<ViewDrag> m_drag;
  Hovered m_hovered;
  GestureRuns m_runs;              ///< of wheel and keys
  std::optional<ReadValue> m_read; ///< under the pointer, while Shift is held
};

} // namespace limn
