// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"
#include "widgets/view/gestures/Probe.h"

#include <QObject>

#include <cstddef>
#include <optional>

class QMenu;
class QPoint;

namespace limn {

struct WindowContext;
enum class PatientPlane;

/// What can be done with what is seen in the picture, on a right click there: turn about it, copy its value,
/// go there in the slices, look from elsewhere, take its label in hand; on a slice what of that means
/// anything there, and the slice as a picture. What cannot be done is shown out of use, and says why.
class PictureMenu : public QObject {
  Q_OBJECT

public:
  /// Actions of cameras, views and crosshair (CameraController, OrientationController, ViewsController,
  /// CrosshairController) must have been registered.
  explicit PictureMenu(WindowContext& context);

signals:
  /// World mm; nothing: about the camera's target again.
  void turnAboutChosen(const std::optional<glm::dvec3>& worldMm);
  /// What hangs together with what is seen along a ray of the picture of a side.
  void pieceChosen(const limn::Ray& ray, int side);
  /// What hangs together with a place of a slice.
  void pieceInSliceChosen(const glm::dvec3& worldMm);
  void placeChosen(const glm::dvec3& worldMm);
  /// The slice in a plane as a picture, on the clipboard or in a file.
  void sliceCopyChosen(limn::PatientPlane plane);
  void sliceSaveChosen(limn::PatientPlane plane);
  /// The label at this place in the list.
  void labelChosen(std::size_t place);

private:
  void open(const std::optional<Ray>& ray, int side, const QPoint& at);
  void openOnSlice(PatientPlane plane, const glm::dvec3& worldMm, const QPoint& globalAt);
  QMenu* newMenu(const char* name);
  void addTurns(QMenu& menu, const std::optional<Ray>& ray, int side);
  void addCopying(QMenu& menu, const std::optional<Probe>& probe);
  void addSlice(QMenu& menu, PatientPlane plane);
  void addPlace(QMenu& menu, const std::optional<Probe>& probe);
  void addLabel(QMenu& menu, const std::optional<Probe>& probe);
  void addPiece(QMenu& menu, const std::optional<Ray>& ray, int side, bool isSeen);
  void addViews(QMenu& menu);

  WindowContext& m_context;
};

} // namespace limn
