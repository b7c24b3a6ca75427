// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/CrosshairController.h"

#include "app/window/WindowContext.h"
#include "reference/ProfileAlong.h"
#include "scene/ProjectionFacts.h"
#include "widgets/Gesture.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QStatusBar>

#include <algorithm>
#include <array>

namespace limn {
namespace {

constexpr int openingToldForMs = 6000;

// Along an axis of the grid, as a fraction of the volume (DEFINITION section 7).
double fractionAlong(const Grid& grid, int axis, const glm::dvec3& placeMm) {
  return (worldToIndex(grid, placeMm)[axis] + 0.5) / grid.dims[axis];
}

} // namespace

CropFace faceTowards(const Camera& camera, const Grid& grid, const glm::dvec3& placeMm) {
  const std::optional<Ray> ray = rayThroughPlace(camera, placeMm);
  const glm::dvec3 away = ray ? ray->direction : basisOf(camera).forward;
  const glm::dvec3 along = glm::transpose(grid.direction) * away;
  const glm::dvec3 size = glm::abs(along);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return {axis, along[axis] < 0.0};
}

CropBox openedAt(const CropBox& crop, const Grid& grid, CropFace face, const glm::dvec3& placeMm) {
  const double place = fractionAlong(grid, face.axis, placeMm);
  const double is = placeOf(crop, face);
  return withFaceAt(crop, grid, face, face.isUpper ? std::min(is, place) : std::max(is, place));
}

bool isHidden(const Scene& scene, const GradientScale& scale, const glm::dvec3& placeMm) {
  const bool canHide = composites(scene.projection) || showsSurface(scene.projection);
  const std::optional<Ray> ray = rayThroughPlace(scene.camera, placeMm);
  if (!canHide || !ray)
    return false;
  const std::optional<RayProfile> profile = profileAlong(scene, scale, *ray);
  const std::optional<double> half = profile ? halfLightDepth(*profile) : std::nullopt;
  // What lies within a voxel of it is seen at it: values between voxels are made of both.
  const double voxel = glm::length(scene.volume->grid().spacingMm);
  return half && *half + voxel < glm::dot(placeMm - profile->entryMm, profile->direction);
}

CrosshairController::CrosshairController(WindowContext& context)
    : QObject(&context.window), m_context(context),
      m_action(context.actions.add(QStringLiteral("cutOpen"), {.text = tr("Cut o&pen to the crosshair"),
                                                               .shortcut = Qt::Key_O,
                                                               .icon = QStringLiteral("cut-open"),
                                                               .isCheckable = true})) {
  // A letter belongs to whatever has the focus: this one to picture and slices.
  m_action->setShortcutContext(Qt::WidgetShortcut);
  context.view.addAction(m_action);
  for (const PatientPlane plane : patientPlanes)
    context.planes.view(plane)->addAction(m_action);
  context.planes.addButton(*m_action);
  connect(m_action, &QAction::triggered, this, &CrosshairController::ask);
  connect(&context.session, &Session::planesChanged, this, &CrosshairController::follow);
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
  // Gradients are measured as a picture that needs them is drawn, and previews are no scene of the session's.
  connect(&context.view, &CompareView::told, this, &CrosshairController::look);
  showAction();
}

bool CrosshairController::hasSlices() const {
  return m_context.session.scene().volume && m_context.session.planes().layout != PlaneLayout::pictureOnly;
}

glm::dvec3 CrosshairController::crosshair() const {
  return crosshairOf({m_context.session.scene().volume, {}, {}, {}, m_context.session.planes(), {}});
}

CropBox CrosshairController::openedNow(const CropBox& before, CropFace face) const {
  return openedAt(before, m_context.session.scene().volume->grid(), face, crosshair());
}

// From the side that it was opened from already, or where no slices are left to tell the place, it is closed.
void CrosshairController::ask() {
  const Scene& scene = m_context.session.scene();
  if (scene.volume) {
    const CropFace face = faceTowards(scene.camera, scene.volume->grid(), crosshair());
    if (m_opening && (m_opening->face == face || !hasSlices()))
      close();
    else if (hasSlices())
      openFrom(face);
  }
  showAction(); // which the click has checked, whatever came of it
}

void CrosshairController::openFrom(CropFace face) {
  const Scene& scene = m_context.session.scene();
  const CropBox before = m_opening ? m_opening->before : scene.crop;
  const CropBox crop = openedNow(before, face);
  if (crop == before) {
    m_context.window.statusBar()->showMessage(
        tr("Nothing lies before the crosshair on this side, so nothing was cut."), openingToldForMs);
    return;
  }
  m_opening = Opening{scene.volume, before, face, crop, m_opening ? m_opening->gesture : nextGestureId()};
  m_context.session.setCrop(crop, {m_opening->gesture, tr("cut open to the crosshair")});
  m_context.window.statusBar()->showMessage(
      tr("Cut open to the crosshair, %1. The cut goes with the crosshair; Esc closes it.")
          .arg(cropFaceName(*scene.volume, face)),
      openingToldForMs);
}

bool CrosshairController::close() {
  if (!m_opening)
    return false;
  const Opening closed = *m_opening;
  m_opening.reset();
  // The same gesture: undo sees that nothing is left of it.
  m_context.session.setCrop(closed.before, {closed.gesture, tr("close the cut")});
  showAction();
  return true;
}

void CrosshairController::follow() {
  if (m_opening && m_opening->volume == m_context.session.scene().volume) {
    m_opening->crop = openedNow(m_opening->before, m_opening->face);
    m_context.session.setCrop(m_opening->crop, {m_opening->gesture, tr("cut open to the crosshair")});
  }
  showAction();
  look();
}

void CrosshairController::showScene(const Scene& scene) {
  if (m_opening && (scene.volume != m_opening->volume || scene.crop != m_opening->crop))
    m_opening.reset();
  showAction();
  look();
}

void CrosshairController::showAction() {
  m_action->setChecked(m_opening.has_value());
  m_action->setEnabled(hasSlices() || m_opening);
  m_action->setToolTip(
      hasSlices() ? tr("<p>Cuts away what lies before the slices' crosshair in the picture, on the side that "
                       "faces you most (O). Again, or Esc: as it was.</p>")
                  : tr("There must be slices beside the picture, which have the crosshair: View ▸ Slices."));
}

// Not the session's scene: the view may be told of that later.
void CrosshairController::look() {
  Looked now;
  if (m_context.view.scene().volume && hasSlices()) {
    now.placeMm = crosshair();
    now.sides = m_context.view.scenesOfSides();
    for (std::size_t side = 0; side < now.sides.size(); ++side)
      now.scales.push_back(m_context.view.input().scaleOfSide(static_cast<int>(side)));
  }
  if (now == m_looked)
    return;
  m_looked = now;
  std::array<bool, 2> hidden{};
  for (std::size_t side = 0; side < now.sides.size(); ++side)
    hidden.at(side) = isHidden(now.sides[side], now.scales[side], *now.placeMm);
  m_context.view.setMark(now.placeMm, hidden);
}

} // namespace limn
