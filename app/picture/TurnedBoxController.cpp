// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/TurnedBoxController.h"

#include "app/window/WindowContext.h"
#include "planes/PlaneGrid.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QAction>
#include <QStatusBar>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int turnedToldForMs = 6000;

// Where a place lies in a box, as fractions along its axes.
glm::dvec3 fractionsIn(const Grid& box, const glm::dvec3& placeMm) {
  return (worldToIndex(box, placeMm) + 0.5) / glm::dvec3(box.dims);
}

// A rectangle of the box, seen along one of its axes, outside of which all goes.
Cut sideCut(const TurnedBox& box, int along, int across, int up) {
  const Grid& grid = box.grid;
  const glm::dvec3 size = boxSizeMm(grid);
  const double beyond = boxDiagonalMm(grid);
  Camera camera;
  camera.projection = Camera::Projection::orthographic;
  camera.target = boxCentreMm(grid);
  camera.position = camera.target - beyond * grid.direction[along];
  camera.up = grid.direction[up];
  camera.heightMm = 2.0 * beyond;
  const CameraBasis basis = basisOf(camera);
  Scissors scissors{camera, 1.0, {}, false, {}};
  const glm::dvec3 lower = box.crop.lower - 0.5, upper = box.crop.upper - 0.5;
  for (const glm::dvec2& corner :
       {glm::dvec2(lower[across], lower[up]), glm::dvec2(upper[across], lower[up]),
        glm::dvec2(upper[across], upper[up]), glm::dvec2(lower[across], upper[up])}) {
    const glm::dvec3 place =
        corner.x * size[across] * grid.direction[across] + corner.y * size[up] * grid.direction[up];
    scissors.polygon.emplace_back(glm::dot(place, basis.right) / beyond, glm::dot(place, basis.up) / beyond);
  }
  return {scissors, true, TurnedBoxController::tr("Turned box").toStdString()};
}

} // namespace

TurnedBox boxTurnedTo(const Camera& camera, const Scene& scene) {
  const Grid& volume = scene.volume->grid();
  const CameraBasis basis = basisOf(camera);
  TurnedBox turned;
  Grid& grid = turned.grid;
  grid.direction = glm::dmat3(basis.right, basis.forward, basis.up);
  glm::dvec3 first(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const ReachMm reach = reachAlong(volume, grid.direction[axis]);
    const double size = reach.last - reach.first;
    grid.dims[axis] = std::max(1, static_cast<int>(std::lround(size / smallestSpacingMm(volume))));
    grid.spacingMm[axis] = size / grid.dims[axis];
    first[axis] = reach.first + grid.spacingMm[axis] / 2.0;
  }
  grid.originMm = grid.direction * first;
  const CropBox kept = scene.crop == CropBox{} ? boxAroundBody(scene) : scene.crop;
  turned.crop = {glm::dvec3(1.0), glm::dvec3(0.0)};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::bvec3 isUpper(corner & 1, corner & 2, corner & 4);
    const glm::dvec3 fraction = glm::mix(kept.lower, kept.upper, isUpper);
    const glm::dvec3 at = fractionsIn(grid, indexToWorld(volume, fraction * glm::dvec3(volume.dims) - 0.5));
    turned.crop.lower = glm::clamp(glm::min(turned.crop.lower, at), 0.0, 1.0);
    turned.crop.upper = glm::clamp(glm::max(turned.crop.upper, at), 0.0, 1.0);
  }
  return turned;
}

std::vector<Cut> cutsOf(const TurnedBox& box) {
  const auto isCut = [&](int axis) { return box.crop.lower[axis] > 0.0 || box.crop.upper[axis] < 1.0; };
  std::vector<Cut> cuts;
  if (isCut(0) || isCut(2))
    cuts.push_back(sideCut(box, 1, 0, 2));
  if (isCut(1))
    cuts.push_back(sideCut(box, 2, 0, 1));
  return cuts;
}

TurnedBoxController::TurnedBoxController(WindowContext& context)
    : QObject(&context.window), m_context(context) {
  const QAction* turn = context.actions.add(
      QStringLiteral("turnCropBox"),
      {.text = tr("Turn the crop bo&x to this view"),
       .place = {Menu::view, 2, 9},
       .toolTip =
           tr("Puts a box over the picture that lies as the picture is seen now; what its faces, which "
              "are dragged, leave outside is cut away."),
       .needsVolume = true});
  connect(turn, &QAction::triggered, this, &TurnedBoxController::turn);
  connect(&context.view.input(), &ViewInput::turnedBoxEdited, this, &TurnedBoxController::cropTo);
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
}

void TurnedBoxController::turn() {
  const Scene& scene = m_context.session.scene();
  if (!scene.volume)
    return;
  m_turned = Turned{scene.volume, boxTurnedTo(scene.camera, scene), scene.keep.cuts, scene.keep.cuts,
                    scene.keep.cuts};
  m_context.view.setTurnedBox(m_turned->box);
  QAction& cropBox = m_context.actions.find("cropBox");
  cropBox.setChecked(true);
  // Put away, the box is the crop's again; what it cut stays.
  disconnect(m_putAway);
  m_putAway = connect(&cropBox, &QAction::toggled, this, [this](bool isShown) {
    if (!isShown)
      end();
  });
  m_context.window.statusBar()->showMessage(
      tr("The box lies as the picture does now. Its handles cut; the list of cuts has what they take."),
      turnedToldForMs);
}

void TurnedBoxController::cropTo(const CropBox& crop, const Gesture& gesture) {
  if (!m_turned)
    return;
  m_turned->box.crop = crop;
  m_context.view.setTurnedBox(m_turned->box);
  m_turned->asked = m_turned->before;
  const std::vector<Cut> own = cutsOf(m_turned->box);
  m_turned->asked.insert(m_turned->asked.end(), own.begin(), own.end());
  emit cutsWanted(m_turned->asked, gesture);
}

// The box is the crop's again once the list of cuts, or the volume, is another.
void TurnedBoxController::showScene(const Scene& scene) {
  if (!m_turned)
    return;
  if (scene.keep.cuts == m_turned->asked)
    m_turned->made = m_turned->asked;
  if (scene.volume == m_turned->volume && scene.keep.cuts == m_turned->made)
    return;
  end();
}

void TurnedBoxController::end() {
  disconnect(m_putAway);
  m_turned.reset();
  m_context.view.setTurnedBox(std::nullopt);
}

} // namespace limn
