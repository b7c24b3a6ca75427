// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/CameraController.h"

#include "app/window/WindowContext.h"
#include "reference/ProfileAlong.h"
#include "scene/framing/Framing.h"
#include "widgets/Gesture.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QStatusBar>

namespace limn {
namespace {

constexpr int saidForMs = 6000;

} // namespace

namespace {

TurnCentre placeAlong(const CompareView& view, const Ray& ray, int side,
                      std::optional<double> (*depthOf)(const RayProfile&)) {
  const Scene scene = view.sceneOfSide(side);
  if (scene.projection == Projection::average)
    return {{},
            QObject::tr("In an average every depth counts alike, so that there is no place to turn about.")};
  const std::optional<RayProfile> profile = profileAlong(scene, view.input().scaleOfSide(side), ray);
  if (const auto depth = profile ? depthOf(*profile) : std::nullopt)
    return {placeAt(*profile, *depth), {}};
  return {{}, noPlaceText()};
}

} // namespace

TurnCentre turnCentreAlong(const CompareView& view, const Ray& ray, int side) {
  return placeAlong(view, ray, side, halfLightDepth);
}

TurnCentre strongestAlong(const CompareView& view, const Ray& ray, int side) {
  return placeAlong(view, ray, side, strongestDepth);
}

QString noPlaceText() {
  return QObject::tr("Nothing is seen there.");
}

CameraController::CameraController(WindowContext& context) : QObject(&context.window), m_context(context) {
  addActions();
  connect(&context.view, &CompareView::cameraEdited, this, &CameraController::move);
  connect(&context.view, &CompareView::cameraFitted, this,
          [this](const Camera& camera) { m_context.document.fitCamera(camera); });
  connect(&context.view.input(), &ViewInput::turnAboutRequested, this, &CameraController::turnAboutSeen);
  connect(&context.view.input(), &ViewInput::cameraReset, this,
          [this] { m_context.view.setTurnsAbout(std::nullopt); });
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
}

// Back and forward stand in the menu of the standard views (OrientationController).
void CameraController::addActions() {
  m_orthographic =
      m_context.actions.add(QStringLiteral("orthographic"),
                            {.text = tr("&Orthographic"),
                             .place = {Menu::view, 2, 6},
                             .toolTip = tr("Parallel rays: sizes can be compared everywhere in the picture."),
                             .isCheckable = true,
                             .needsVolume = true});
  m_back = m_context.actions.add(
      QStringLiteral("cameraBack"),
      {.text = tr("Camera back"),
       .shortcut = QKeySequence(Qt::ALT | Qt::Key_Left),
       .toolTip = tr("Looks again from where it was before the last turn, move, zoom or view.")});
  m_forward =
      m_context.actions.add(QStringLiteral("cameraForward"),
                            {.text = tr("Camera forward"),
                             .shortcut = QKeySequence(Qt::ALT | Qt::Key_Right),
                             .toolTip = tr("Looks from where it was before \"Camera back\" was chosen.")});
  connect(m_orthographic, &QAction::triggered, this, [this](bool isChosen) {
    move(withProjection(m_context.session.scene().camera,
                        isChosen ? Camera::Projection::orthographic : Camera::Projection::perspective),
         nextGestureId());
  });
  connect(m_back, &QAction::triggered, this, [this] { goTo(m_history.back(now())); });
  connect(m_forward, &QAction::triggered, this, [this] { goTo(m_history.forward(now())); });
  showSteps();
}

void CameraController::turnAbout(const std::optional<glm::dvec3>& worldMm) {
  m_context.view.setTurnsAbout(worldMm);
  m_context.window.statusBar()->showMessage(
      worldMm ? tr("Turns go about what is seen there. R resets the camera and ends that.")
              : tr("Turns go about the middle of the view."),
      saidForMs);
}

void CameraController::turnAboutSeen(const Ray& ray, int side) {
  if (const TurnCentre centre = turnCentreAlong(m_context.view, ray, side); centre.placeMm)
    turnAbout(centre.placeMm);
  else
    m_context.window.statusBar()->showMessage(centre.reason, saidForMs);
}

SeenFrom CameraController::now() const {
  return {m_context.session.scene().camera, m_context.view.pictureAspect()};
}

void CameraController::move(const Camera& camera, std::uint64_t gesture) {
  m_history.note(now(), camera, gesture);
  m_context.session.setCamera(camera);
  showSteps();
}

void CameraController::goTo(const std::optional<SeenFrom>& there) {
  const Scene& scene = m_context.session.scene();
  if (!there || !scene.volume)
    return;
  const double aspect = m_context.view.pictureAspect();
  m_context.session.setCamera(
      there->aspect == aspect
          ? there->camera
          : refitted(there->camera, scene.volume->grid(), visibleVoxels(scene), there->aspect, aspect));
  showSteps();
}

void CameraController::showScene(const Scene& scene) {
  m_orthographic->setChecked(scene.camera.projection == Camera::Projection::orthographic);
  if (scene.volume == m_volume)
    return;
  m_volume = scene.volume;
  m_history.clear();
  m_context.view.setTurnsAbout(std::nullopt);
  showSteps();
}

CameraController::Memory CameraController::memory() const {
  return {m_history, m_context.view.turnsAbout()};
}

void CameraController::takeOver(const Memory& memory) {
  m_history = memory.history;
  m_context.view.setTurnsAbout(memory.turnsAboutMm);
  showSteps();
}

void CameraController::showSteps() {
  m_back->setEnabled(m_history.canGoBack());
  m_forward->setEnabled(m_history.canGoForward());
}

} // namespace limn
