// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/light/Gradient.h"
#include "scene/steps/RayProfile.h"

#include <QObject>

#include <optional>

namespace limn {

class CompareView;
class RayPanel;
class Session;

/// Shows in the ray's panel what one ray of the picture meets, as long as the panel is seen: the ray that was
/// probed last, or on which the slices' crosshair was put since; before either the one through the crosshair,
/// without slices that through the middle of the picture. It stays on its place while scene and camera
/// change.
class RayDesk : public QObject {
  Q_OBJECT

public:
  struct Parts {
    Session& session;
    CompareView& view;
    RayPanel& panel;
  };

  RayDesk(const Parts& parts, QObject* parent);

  /// To be told once the view shows the scene.
  void showScene(const Scene& scene);

  /// Reads the ray again, because the pictures show something else.
  void show();

private:
  void follow(const Ray& ray, int side);
  void followCrosshair();
  std::optional<Ray> ray() const;
  std::optional<double> crosshairDepth(const RayProfile& profile) const;

  Parts m_parts;
  std::shared_ptr<const Volume> m_volume;
  std::optional<glm::dvec3> m_through; ///< a place on the ray, world
  int m_side = 0;                      ///< of the pictures, whose ray it is
  std::optional<glm::dvec3> m_crosshair;
  GradientScale m_scale; ///< with which the ray was read
};

} // namespace limn
