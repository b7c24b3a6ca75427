// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/light/Gradient.h"
#include "scene/steps/RayProfile.h"

#include <QObject>

#include <optional>

namespace limn {

class RayPanel;
struct WindowContext;

/// Shows in the ray's panel what one ray of the picture meets, as long as the panel is seen: the ray that was
/// probed last, or on which the slices' crosshair was put since; before either the one through the crosshair,
/// without slices that through the middle of the picture. It stays on its place while scene and camera
/// change.
class RayController : public QObject {
  Q_OBJECT

public:
  explicit RayController(WindowContext& context);

  /// Reads the ray again, because the pictures show something else.
  void show();

signals:
  /// A place on the ray was chosen, world.
  void placeChosen(const glm::dvec3& worldMm);

private:
  void showScene(const Scene& scene);
  void follow(const Ray& ray, int side);
  void followCrosshair();
  std::optional<Ray> ray() const;
  std::optional<double> crosshairDepth(const RayProfile& profile) const;

  WindowContext& m_context;
  RayPanel& m_panel;
  std::shared_ptr<const Volume> m_volume;
  std::optional<glm::dvec3> m_through; ///< a place on the ray, world
  int m_side = 0;                      ///< of the pictures, whose ray it is
  std::optional<glm::dvec3> m_crosshair;
  GradientScale m_scale; ///< with which the ray was read
};

} // namespace limn
