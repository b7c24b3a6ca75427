// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/controls/BackgroundWork.h"
#include "widgets/planes/PlaneDrag.h"
#include "widgets/planes/PlanePictures.h"
#include "widgets/view/overlay/CutLine.h"

#include <QTimer>
#include <QWidget>

namespace limn {

/// One slice of the volume in a plane of the patient, with crosshair, sides, scale and window. It changes
/// nothing: it asks for other settings, through its signal, and is given what became of them by setContent().
///
/// The left button does what the tool says: crosshair, window/level, or it measures; the right one always
/// drags the window and asks with a click for a menu, the middle one pans, the wheel leads through the
/// slices, with Ctrl it zooms. Keys: arrows, Page up and down, Home (middle), + − and F (all of the slice), 0
/// (full window) and 1 … 4 (those of tissues), C W X K D G E N and Esc (tools), Delete (the measurement in
/// hand). An angle is drawn from one end to its corner, then follows the pointer to its other end until a
/// click. What is begun waits while the pointer is elsewhere. A line to cut along is drawn as on the picture,
/// and lasts while the slice stays where it is.
class PlaneView : public QWidget {
  Q_OBJECT

public:
  explicit PlaneView(PatientPlane plane, QWidget* parent = nullptr);

  PatientPlane plane() const { return m_plane; }

  /// Shows a content; without a volume the view is black.
  void setContent(const PlaneContent& content);
  const PlaneContent& content() const { return m_content; }

  void setTool(PlaneTool tool);
  /// Whether lines of the scissors take away what they go around, or all else.
  void setLinesRemoveInside(bool isInside) { m_linesRemoveInside = isInside; }
  /// Whether the wheel widens and narrows a piece that was picked; else it leads through the slices.
  void setWheelIsForPiece(bool isForPiece) { m_wheelIsForPiece = isForPiece; }

  /// The line that is being drawn to cut along.
  const std::optional<CutLine>& cutLine() const { return m_line; }

  /// Whether a line or a drag is begun, and neither finished nor given up.
  bool isDrawing() const { return m_line || m_drag; }

  /// Takes back what was clicked once, but for an angle with both legs, which is over. Whether it took any.
  bool endLooseDrag();

  /// How the slice lies in the view; there is a volume.
  PlaneFrame frame() const;

  /// Goes so many slices on, to the head, the front or the left.
  void goOn(int slices);

  /// How often voxels were read for it.
  int readings() const { return m_pictures.readings(); }

  QSize sizeHint() const override { return {320, 240}; }
  QSize minimumSizeHint() const override { return {80, 60}; }

signals:
  void settingsEdited(const limn::PlaneSettings& settings);
  void measurementsEdited(const limn::MeasurementsEdited& edited);
  void toolRequested(limn::PlaneTool tool);
  /// The connected piece that holds this place shall be picked.
  void pieceRequested(const glm::dvec3& worldMm);
  /// The picked piece's range shall be so many notches narrower, or wider; `onlyAbove`: its upper end.
  void pieceNarrowed(double notches, bool onlyAbove);
  /// A line was closed that goes around something; these scissors cut through everything.
  void lineClosed(const limn::Scissors& scissors);
  /// A line is being drawn corner by corner from now on, or no longer.
  void cornersBegun(bool isBegun);
  /// What can be done with a place of the slice, by a right click on it or the key for menus at the
  /// crosshair.
  void menuRequested(const glm::dvec3& worldMm, const QPoint& globalAt);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  bool obey(int key, bool isFast);
  bool moveByKey(int key, int slices);
  bool chooseWindow(int number);
  void cancel();
  bool pressCut(const QMouseEvent& event);
  void closeLine();
  void forgetLine();
  bool obeyInLine(int key);
  bool releaseMeasure(const QPointF& point);
  void zoom(const QPointF& about, double factor);
  void showCursor(const QPointF& point);
  void look();
  void readAllPixels();
  void describe();
  bool isOnKeptLine(const QPoint& point) const;

  PatientPlane m_plane;
  PlaneContent m_content;
  PlaneTool m_tool = PlaneTool::crosshair;
  std::optional<PlaneZoom> m_zoom; ///< absent: all of the slice
  std::optional<PlaneDrag> m_drag;
  std::optional<CutLine> m_line;
  bool m_linesRemoveInside = true;
  bool m_wheelIsForPiece = false;
  int m_turned = 0; ///< of the wheel, less than a notch
  PlanePictures m_pictures;
  QTimer m_rest;            ///< runs while what is shown is coarse
  PlaneReading m_beingRead; ///< by `m_reading`
  BackgroundWork m_reading;
};

} // namespace limn
