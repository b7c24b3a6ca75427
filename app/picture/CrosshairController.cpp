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
#include <utility>

namespace limn {
namespace {

constexpr int openingToldForMs = 6000;

// Of a voxel: the crosshair's own voxels stay, and are seen on the faces of the corner.
constexpr double keptOfVoxel = 0.25;

QString noSlicesText() {
  return CrosshairController::tr(
      "Choose a layout with slices first (View ▸ Slices): they have the crosshair.");
}

// The list without its last, which is the corner.
std::vector<Cut> withoutLast(std::vector<Cut> cuts) {
  cuts.pop_back();
  return cuts;
}

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

std::array<bool, 3> cornerTowards(const Camera& camera, const Grid& grid, const glm::dvec3& placeMm) {
  const std::optional<Ray> ray = rayThroughPlace(camera, placeMm);
  const glm::dvec3 away = ray ? ray->direction : basisOf(camera).forward;
  const glm::dvec3 along = glm::transpose(grid.direction) * away;
  return {along.x < 0.0, along.y < 0.0, along.z < 0.0};
}

// An octant is a rectangle seen along the third axis, as deep as the place lies.
Scissors cornerAt(const Grid& grid, const std::array<bool, 3>& corner, const glm::dvec3& placeMm) {
  const double beyond = boxDiagonalMm(grid);
  glm::dvec3 sides(0.0);
  for (int axis = 0; axis < 3; ++axis)
    sides[axis] = corner.at(static_cast<std::size_t>(axis)) ? 1.0 : -1.0;
  const glm::dvec3 edge = placeMm + grid.direction * (keptOfVoxel * sides * grid.spacingMm);
  Camera camera;
  camera.projection = Camera::Projection::orthographic;
  camera.target = edge;
  camera.position = edge + beyond * sides.z * grid.direction[2];
  camera.up = grid.direction[1];
  camera.heightMm = 2.0 * beyond;
  const CameraBasis basis = basisOf(camera);
  Scissors scissors{camera, 1.0, {}, true, glm::dvec2(0.0, beyond)};
  for (const glm::dvec2& end : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)}) {
    const glm::dvec3 away = end.x * sides.x * grid.direction[0] + end.y * sides.y * grid.direction[1];
    scissors.polygon.emplace_back(glm::dot(away, basis.right), glm::dot(away, basis.up));
  }
  return scissors;
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
                                                               .isCheckable = true})),
      m_cornerAction(context.actions.add(QStringLiteral("cutOpenCorner"),
                                         {.text = tr("Cut open the co&rner to the crosshair"),
                                          .shortcut = Qt::SHIFT | Qt::Key_O,
                                          .isCheckable = true})) {
  // A letter belongs to whatever has the focus: these to picture and slices.
  for (QAction* action : {m_action, m_cornerAction}) {
    action->setShortcutContext(Qt::WidgetShortcut);
    context.view.addAction(action);
    for (const PatientPlane plane : patientPlanes)
      context.planes.view(plane)->addAction(action);
  }
  context.planes.addButton(*m_action);
  connect(m_action, &QAction::triggered, this, &CrosshairController::ask);
  connect(m_cornerAction, &QAction::triggered, this, &CrosshairController::askForCorner);
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
    closeCorner();
    if (m_opening && (m_opening->face == face || !hasSlices()))
      closeFace();
    else if (hasSlices())
      openFrom(face);
    else
      m_context.window.statusBar()->showMessage(noSlicesText(), openingToldForMs);
  }
  showAction(); // which the click has checked, whatever came of it
}

void CrosshairController::askForCorner() {
  const Scene& scene = m_context.session.scene();
  if (scene.volume) {
    const std::array<bool, 3> corner = cornerTowards(scene.camera, scene.volume->grid(), crosshair());
    closeFace();
    if (m_corner && (m_corner->corner == corner || !hasSlices()))
      closeCorner();
    else if (hasSlices())
      openCorner(corner);
    else
      m_context.window.statusBar()->showMessage(noSlicesText(), openingToldForMs);
  }
  showAction();
}

void CrosshairController::openCorner(const std::array<bool, 3>& corner) {
  const Scene& scene = m_context.session.scene();
  if (!m_corner) {
    std::vector<Cut> asked = scene.keep.cuts;
    asked.emplace_back(); // becomes the corner
    m_corner = OpenCorner{scene.volume, corner, scene.keep.cuts, asked, nextGestureId()};
  }
  m_corner->corner = corner;
  cutCorner();
  m_context.window.statusBar()->showMessage(
      tr("The corner is cut open to the crosshair. The cut goes with the crosshair; Esc closes it."),
      openingToldForMs);
}

void CrosshairController::cutCorner() {
  const Scissors scissors = cornerAt(m_corner->volume->grid(), m_corner->corner, crosshair());
  m_corner->asked.back() = {scissors, true, tr("Cut open to the crosshair").toStdString()};
  emit cutsWanted(m_corner->asked, {m_corner->gesture, tr("cut the corner open to the crosshair")});
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
  const bool wasFace = closeFace();
  return closeCorner() || wasFace;
}

bool CrosshairController::closeCorner() {
  if (!m_corner)
    return false;
  const OpenCorner closed = *m_corner;
  m_corner.reset();
  emit cutsWanted(withoutLast(closed.asked), {closed.gesture, tr("close the cut")});
  showAction();
  return true;
}

bool CrosshairController::closeFace() {
  if (!m_opening)
    return false;
  const Opening closed = *m_opening;
  m_opening.reset();
  // The same gesture: undo sees that nothing is left of it.
  m_context.session.setCrop(closed.before, {closed.gesture, tr("close the cut")});
  showAction();
  return true;
}

void CrosshairController::describe(SessionDocument& session) const {
  if (m_opening)
    session.opening = CutOpening{m_opening->face.axis, m_opening->face.isUpper, m_opening->before, {}};
  else if (m_corner && m_context.session.scene().keep.cuts == m_corner->asked)
    session.opening = CutOpening{0, false, {}, m_corner->corner};
}

void CrosshairController::restore(const SessionDocument& session) {
  const Scene& scene = m_context.session.scene();
  if (!session.opening || !scene.volume)
    return;
  const CutOpening& opening = *session.opening;
  if (!opening.corner)
    m_opening =
        Opening{scene.volume, opening.before, {opening.axis, opening.isUpper}, scene.crop, nextGestureId()};
  else if (!scene.keep.cuts.empty() && std::holds_alternative<Scissors>(scene.keep.cuts.back().how))
    m_corner = OpenCorner{scene.volume, *opening.corner, scene.keep.cuts, scene.keep.cuts, nextGestureId()};
  showAction();
}

void CrosshairController::follow() {
  if (m_opening && m_opening->volume == m_context.session.scene().volume) {
    m_opening->crop = openedNow(m_opening->before, m_opening->face);
    m_context.session.setCrop(m_opening->crop, {m_opening->gesture, tr("cut open to the crosshair")});
  }
  if (m_corner && hasSlices() && m_corner->volume == m_context.session.scene().volume) {
    const Cut before = m_corner->asked.back();
    if (cornerAt(m_corner->volume->grid(), m_corner->corner, crosshair()) != std::get<Scissors>(before.how))
      cutCorner();
  }
  showAction();
  look();
}

void CrosshairController::showScene(const Scene& scene) {
  if (m_corner && scene.volume == m_corner->volume && scene.keep.cuts == m_corner->asked)
    m_corner->made = m_corner->asked;
  if (m_corner && (scene.volume != m_corner->volume || scene.keep.cuts != m_corner->made))
    m_corner.reset();
  if (m_opening && (scene.volume != m_opening->volume || scene.crop != m_opening->crop))
    m_opening.reset();
  showAction();
  look();
}

void CrosshairController::showAction() {
  m_action->setChecked(m_opening.has_value());
  // Without slices a click and its key say why there is nothing to cut to.
  const bool isOpen = m_context.session.scene().volume != nullptr;
  m_action->setEnabled(isOpen);
  m_cornerAction->setChecked(m_corner.has_value());
  m_cornerAction->setEnabled(isOpen);
  m_action->setToolTip(
      hasSlices() ? tr("<p>Cuts away what lies before the slices' crosshair in the picture, on the side that "
                       "faces you most (O). Again, or Esc: as it was.</p>")
                  : noSlicesText());
  m_cornerAction->setToolTip(
      hasSlices() ? tr("<p>Cuts away the corner that faces you, up to the slices' crosshair, so that three "
                       "slices are seen in the picture (Shift+O). Again, or Esc: as it was.</p>")
                  : m_action->toolTip());
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
