// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/picture/RayDesk.h"

#include "app/document/Session.h"
#include "reference/ProfileAlong.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneText.h"
#include "widgets/ray/RayPanel.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

namespace limn {
namespace {

ProfileNames namesOf(const Volume& volume) {
  return {QString::fromStdString(volume.info().unit),
          volume.info().spacingKnown ? RayDesk::tr("mm") : QString(), valueDecimals(volume)};
}

bool hasSlices(const PlaneSettings& planes) {
  return planes.layout != PlaneLayout::pictureOnly;
}

} // namespace

RayDesk::RayDesk(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
  connect(&parts.view.input(), &ViewInput::rayRead, this, &RayDesk::follow);
  connect(&parts.session, &Session::planesChanged, this, &RayDesk::followCrosshair);
  connect(&parts.panel, &RayPanel::shown, this, &RayDesk::show);
  // Gradients are measured as a picture that needs them is drawn.
  connect(&parts.view, &CompareView::pictureStateChanged, this, [this] {
    if (m_parts.view.scene().volume && m_parts.panel.isVisible() &&
        m_parts.view.input().scaleOfSide(m_side) != m_scale)
      show();
  });
}

void RayDesk::follow(const Ray& ray, int side) {
  const Scene& scene = m_parts.view.scene();
  // Any place on it will do; the one nearest to the camera's target stays in sight while that turns.
  const double t = glm::dot(scene.camera.target - ray.origin, ray.direction);
  m_through = ray.origin + t * ray.direction;
  m_side = side;
  show();
}

void RayDesk::followCrosshair() {
  const PlaneSettings& planes = m_parts.session.planes();
  if (!hasSlices(planes) || planes.crosshairMm == m_crosshair)
    return;
  m_crosshair = planes.crosshairMm;
  if (m_crosshair)
    m_through = m_crosshair;
  show();
}

void RayDesk::showScene(const Scene& scene) {
  if (scene.volume != m_volume) {
    m_volume = scene.volume;
    m_through.reset();
    m_side = 0;
  }
  show();
}

std::optional<Ray> RayDesk::ray() const {
  const Scene& scene = m_parts.view.scene();
  const PlaneSettings& planes = m_parts.session.planes();
  const glm::dvec3 atFirst =
      hasSlices(planes) ? crosshairOf({scene.volume, {}, {}, {}, planes, {}}) : scene.camera.target;
  return rayThroughPlace(scene.camera, m_through.value_or(atFirst));
}

std::optional<double> RayDesk::crosshairDepth(const RayProfile& profile) const {
  const PlaneSettings& planes = m_parts.session.planes();
  if (!hasSlices(planes) || !planes.crosshairMm)
    return std::nullopt;
  const double depth = glm::dot(*planes.crosshairMm - profile.entryMm, profile.direction);
  const double beside = glm::length(*planes.crosshairMm - placeAt(profile, depth));
  const bool isOnRay = beside <= smallestSpacingMm(m_parts.view.scene().volume->grid()) / 2.0;
  return isOnRay && depth >= 0.0 && depth <= profile.lengthMm ? std::optional(depth) : std::nullopt;
}

void RayDesk::show() {
  // Not the session's scene: the view may be told of that later.
  const Scene& scene = m_parts.view.scene();
  std::optional<RayProfile> profile;
  const bool isSeen = m_parts.panel.isVisible();
  if (scene.volume && isSeen) {
    m_scale = m_parts.view.input().scaleOfSide(m_side);
    if (const std::optional<Ray> through = ray())
      profile = profileAlong(m_parts.view.sceneOfSide(m_side), m_scale, *through);
  }
  const std::optional<double> half = profile ? halfLightDepth(*profile) : std::nullopt;
  m_parts.view.setHalfMark(half ? std::optional(placeAt(*profile, *half)) : std::nullopt);
  if (isSeen)
    m_parts.panel.setProfile(profile, scene.volume ? namesOf(*scene.volume) : ProfileNames{},
                             profile ? crosshairDepth(*profile) : std::nullopt);
}

} // namespace limn
