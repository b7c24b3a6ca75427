// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/framing/Framing.h"

#include <QObject>

#include <optional>

namespace limn {

/// Keeps the camera fitted to what is visible (DEFINITION section 8): pictures that change their shape show
/// as much as before. A camera that came with its scene stays until something is done, and no edit of curve,
/// crop or kept region moves it: who works must not lose what is under the pointer.
class CameraFit : public QObject {
  Q_OBJECT

public:
  explicit CameraFit(QObject* parent) : QObject(parent) {}

  /// The scene as it is shown from now on; before the pictures of another volume have a shape, no shape is
  /// compared.
  void setScene(const Scene& scene);

  /// The shape of a picture, width over height, as it is from now on.
  void setAspect(double aspect);

  /// The pictures stand as they are meant to: from now on the camera follows their shape.
  void settle();

  /// What the scene's pictures are framed on.
  const VisibleVoxels& visible();

signals:
  void cameraEdited(const limn::Camera& camera);

private:
  Scene m_scene;
  std::optional<VisibleVoxels> m_visible; ///< of the scene; none: not looked for yet
  double m_aspect = 1.0;
  std::optional<double> m_settledAspect; ///< to which the camera belongs
};

} // namespace limn
