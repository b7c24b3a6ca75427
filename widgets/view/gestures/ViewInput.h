// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Gradient.h"
#include "widgets/view/gestures/CameraHistory.h"
#include "widgets/view/gestures/MeasureInput.h"
#include "widgets/view/gestures/Probe.h"
#include "widgets/view/gestures/ViewCommands.h"
#include "widgets/view/gestures/ViewDrag.h"
#include "widgets/view/overlay/CutLine.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <QCursor>
#include <QObject>
#include <QPoint>

#include <functional>
#include <optional>
#include <vector>

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
    std::function<const VisibleVoxels&()> visible; ///< on which views are framed
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

  /// The line that is being drawn to cut along, and the end of it.
  const std::optional<CutLine>& cutLine() const { return m_line; }
  void forgetLine() { m_line.reset(); }

  /// Whether lines take away what they go around, or all else.
  void setLinesRemoveInside(bool isInside);
  /// Whether the wheel widens and narrows a piece that was picked; else it zooms.
  void setWheelIsForPiece(bool isForPiece) { m_wheelIsForPiece = isForPiece; }

  /// What it asks of measurements.
  MeasureInput& measures() const { return *m_measures; }

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
  /// The same of the turned box, while one stands over the pictures.
  void turnedBoxEdited(const limn::CropBox& crop, const limn::Gesture& gesture);
  void wipeEdited(double fraction);
  /// What lies under the pointer while Shift is held; nothing when it ends or hits nothing.
  void probed(const std::optional<limn::Probe>& probe);
  /// The ray that is probed, whatever it meets, of the picture of a side.
  void rayRead(const limn::Ray& ray, int side);
  /// What is seen along this ray of the picture of a side shall be the centre of turns.
  void turnAboutRequested(const limn::Ray& ray, int side);
  /// A line was closed that goes around something: its corners in halves of the picture's height from its
  /// middle, y up, and the picture's width over height.
  void lineClosed(const std::vector<glm::dvec2>& polygon, double aspect);
  /// The connected piece that is seen along this ray of the picture of a side shall be picked.
  void pieceRequested(const limn::Ray& ray, int side);
  /// The picked piece's range shall be so many notches narrower, or wider; `onlyAbove`: its upper end.
  void pieceNarrowed(double notches, bool onlyAbove);
  void cameraReset();
  /// What can be done with what is seen along a ray of the picture of a side; no ray: beside the pictures.
  void menuRequested(const std::optional<limn::Ray>& ray, int side, const QPoint& at);
  void pinRequested(double value);
  /// Where that value is, world millimetres.
  void placePinned(const glm::dvec3& worldMm);
  void modelsRequested(int position); ///< of which the label was clicked
  void everythingRequested();         ///< the note was clicked that tells what a region hides
  void maximiseRequested();
  void windowPresetRequested(int number); ///< 0 the full range, 1..9 the presets
  void swapRequested();
  void toolChanged(limn::ViewTool tool);

private:
  void ask(const ViewEdit& edit, const Gesture& gesture);
  void cancelDrag(const Scene& shown);
  void showCursor(const std::optional<CropHandle>& handle);
  void hover(const QMouseEvent& event);
  void uncut(const Comparison& shown, CropFace face);
  void askForCrop(const CropBox& crop, const Gesture& gesture);
  std::optional<Probe> probeAt(const OverlaySource& source, const QPointF& point) const;
  void lookFromFace(const OverlaySource& source, std::size_t face);
  void obeyClick(ViewClick click, const QPointF& point);
  bool drawLine(const OverlaySource& source, const QMouseEvent& event);
  void closeLine();
  void showProbe(const std::optional<Probe>& probe, const OverlaySource& source, const QPointF& point);

  QWidget* m_view;
  Facts m_facts;
  MeasureInput* m_measures;
  ViewTool m_tool = ViewTool::rotate;
  std::optional<ViewDrag> m_drag;
  std::optional<CutLine> m_line;
  bool m_linesRemoveInside = true;
  bool m_wheelIsForPiece = false;
  Hovered m_hovered;
  GestureRuns m_runs;              ///< of wheel and keys
  std::optional<ReadValue> m_read; ///< under the pointer, while Shift is held
};

} // namespace limn
