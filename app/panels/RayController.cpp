// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/RayController.h"

#include "app/window/WindowContext.h"
#include "reference/ProfileAlong.h"
#include "scene/regions/LabelAt.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/ray/RayPanel.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

namespace limn {
namespace {

// The label that each sample lies in.
std::vector<QString> labelsAlong(const RayProfile& profile, const Scene& scene) {
  std::vector<QString> labels;
  if (scene.keep.kind != Region::Kind::labels)
    return labels;
  for (const RayProfile::Sample& sample : profile.samples)
    labels.push_back(QString::fromStdString(
        labelNameAt(scene.keep, worldToIndex(scene.volume->grid(), placeAt(profile, sample.depthMm)))));
  return labels;
}

ProfileNames namesOf(const Scene& scene, const std::optional<RayProfile>& profile) {
  const Volume& volume = *scene.volume;
  return {QString::fromStdString(volume.info().unit),
          volume.info().spacingKnown ? RayController::tr("mm") : QString(), valueDecimals(volume),
          profile ? labelsAlong(*profile, scene) : std::vector<QString>()};
}

bool hasSlices(const PlaneSettings& planes) {
  return planes.layout != PlaneLayout::pictureOnly;
}

} // namespace

RayController::RayController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_panel(*new RayPanel(&context.window)) {
  context.docks.add({.title = tr("Ra&y"),
                     .name = "rayDock",
                     .content = &m_panel,
                     .area = Qt::RightDockWidgetArea,
                     .isHiddenAtFirst = true});
  connect(&context.view.input(), &ViewInput::rayRead, this, &RayController::follow);
  connect(&context.session, &Session::planesChanged, this, &RayController::followCrosshair);
  connect(&m_panel, &RayPanel::shown, this, &RayController::show);
  connect(&m_panel, &RayPanel::placeChosen, this, &RayController::placeChosen);
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
  // Gradients are measured as a picture that needs them is drawn.
  connect(&context.view, &CompareView::told, this, [this] {
    if (m_context.view.scene().volume && m_panel.isVisible() &&
        m_context.view.input().scaleOfSide(m_side) != m_scale)
      show();
  });
}

void RayController::follow(const Ray& ray, int side) {
  const Scene& scene = m_context.view.scene();
  // Any place on it will do; the one nearest to the camera's target stays in sight while that turns.
  const double t = glm::dot(scene.camera.target - ray.origin, ray.direction);
  m_through = ray.origin + t * ray.direction;
  m_side = side;
  show();
}

void RayController::followCrosshair() {
  const PlaneSettings& planes = m_context.session.planes();
  if (!hasSlices(planes) || planes.crosshairMm == m_crosshair)
    return;
  m_crosshair = planes.crosshairMm;
  if (m_crosshair)
    m_through = m_crosshair;
  show();
}

void RayController::showScene(const Scene& scene) {
  if (scene.volume != m_volume) {
    m_volume = scene.volume;
    m_through.reset();
    m_side = 0;
  }
  show();
}

std::optional<Ray> RayController::ray() const {
  const Scene& scene = m_context.view.scene();
  const PlaneSettings& planes = m_context.session.planes();
  const glm::dvec3 atFirst =
      hasSlices(planes) ? crosshairOf({scene.volume, {}, {}, {}, planes, {}}) : scene.camera.target;
  return rayThroughPlace(scene.camera, m_through.value_or(atFirst));
}

std::optional<double> RayController::crosshairDepth(const RayProfile& profile) const {
  const PlaneSettings& planes = m_context.session.planes();
  if (!hasSlices(planes) || !planes.crosshairMm)
    return std::nullopt;
  const double depth = glm::dot(*planes.crosshairMm - profile.entryMm, profile.direction);
  const double beside = glm::length(*planes.crosshairMm - placeAt(profile, depth));
  const bool isOnRay = beside <= smallestSpacingMm(m_context.view.scene().volume->grid()) / 2.0;
  return isOnRay && depth >= 0.0 && depth <= profile.lengthMm ? std::optional(depth) : std::nullopt;
}

void RayController::show() {
  // Not the session's scene: the view may be told of that later.
  const Scene& scene = m_context.view.scene();
  std::optional<RayProfile> profile;
  const bool isSeen = m_panel.isVisible();
  if (scene.volume && isSeen) {
    m_scale = m_context.view.input().scaleOfSide(m_side);
    if (const std::optional<Ray> through = ray())
      profile = profileAlong(m_context.view.sceneOfSide(m_side), m_scale, *through);
  }
  const std::optional<double> half = profile ? halfLightDepth(*profile) : std::nullopt;
  m_context.view.setHalfMark(half ? std::optional(placeAt(*profile, *half)) : std::nullopt);
  if (isSeen)
    m_panel.setProfile(profile,
                       scene.volume ? namesOf(m_context.view.sceneOfSide(m_side), profile) : ProfileNames{},
                       profile ? crosshairDepth(*profile) : std::nullopt);
}

} // namespace limn
