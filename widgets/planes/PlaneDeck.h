// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneDrag.h"

#include <QWidget>

#include <array>

class QAction;

namespace limn {

class PlaneBar;
class PlaneView;

/// The picture and the slices beside it, as the settings lay them out: the picture alone, four equal places,
/// or one slice large with the picture and the other two in a column at its right. Without a volume there is
/// the picture alone.
class PlaneDeck : public QWidget {
  Q_OBJECT

public:
  /// Takes the picture, any widget, as its child.
  explicit PlaneDeck(QWidget& picture, QWidget* parent = nullptr);

  void setContent(const PlaneContent& content);

  /// What the left button does in every slice.
  void setTool(PlaneTool tool);
  PlaneTool tool() const { return m_tool; }
  /// As PlaneView has them.
  void setLinesRemoveInside(bool isInside);
  void setWheelIsForPiece(bool isForPiece);
  /// Whether in one of the slices something is begun, and neither finished nor given up.
  bool isDrawing() const;
  /// Ends what waits in one of them for its next click, as PlaneView does. Whether it took anything back.
  bool endLooseDrag();
  /// A button in the row above the slices, for something that is done elsewhere.
  void addButton(QAction& action);

  PlaneView* view(PatientPlane plane) const { return m_views[static_cast<std::size_t>(plane)]; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

signals:
  void settingsEdited(const limn::PlaneSettings& settings);
  void measurementsEdited(const limn::MeasurementsEdited& edited);
  void toolChanged(limn::PlaneTool tool);
  // As PlaneView says it (also what `onlyAbove` means), of the slice in a plane:
  void pieceRequested(const glm::dvec3& worldMm);
  void pieceNarrowed(double notches, bool onlyAbove);
  void cornersBegun(bool isBegun);
  void lineClosed(limn::PatientPlane plane, const limn::Scissors& scissors);
  void menuRequested(limn::PatientPlane plane, const glm::dvec3& worldMm, const QPoint& globalAt);

protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  PlaneView* drawingView() const;
  PlaneLayout shownLayout() const;
  void arrange();

  QWidget& m_picture;
  PlaneBar* m_bar;
  std::array<PlaneView*, 3> m_views{};
  PlaneContent m_content;
  PlaneTool m_tool = PlaneTool::crosshair;
};

/// Where picture and slices lie in a place of this size, logical pixels: the picture first, then the planes
/// in their order; empty where something is not shown.
std::array<QRect, 4> placesOf(const PlaneSettings& settings, const QRect& room);

} // namespace limn
