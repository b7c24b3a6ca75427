// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presets/ThumbnailDesk.h"

#include "app/document/Session.h"
#include "scene/framing/Framing.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/presets/PresetModel.h"

#include <algorithm>
#include <utility>

namespace limn {
namespace {

// The next gesture is often near, and the engines are tried once after the first picture.
constexpr int afterRefinementMs = 300;
// Refinement may take a minute; pictures of a second go beside it.
constexpr int besideRefinementMs = 3000;

constexpr double pictureAspect = static_cast<double>(largeThumbnailWidth) / largeThumbnailHeight;

double seenHeightMm(const Camera& camera) {
  const double distance = camera.projection == Camera::Projection::perspective
                              ? glm::length(camera.target - camera.position)
                              : 1.0;
  return 2.0 * halfHeight(camera) * distance;
}

} // namespace

bool seeAlike(const Camera& a, const Camera& b) {
  constexpr double turned = 0.978; // cos 12°
  const CameraBasis first = basisOf(a);
  const CameraBasis second = basisOf(b);
  const double height = seenHeightMm(a);
  const double size = seenHeightMm(b) / height;
  return a.projection == b.projection && glm::dot(first.forward, second.forward) > turned &&
         glm::dot(first.up, second.up) > turned && size > 0.8 && size < 1.25 &&
         glm::length(a.target - b.target) < height / 6.0;
}

ThumbnailDesk::ThumbnailDesk(Partners with, QObject* parent)
    : QObject(parent), m_with(std::move(with)), m_worker(new ThumbnailWorker) {
  m_wait.setSingleShot(true);
  connect(&m_wait, &QTimer::timeout, this, &ThumbnailDesk::begin);
  connect(m_worker, &ThumbnailWorker::drawn, this, &ThumbnailDesk::receive);
  connect(m_worker, &ThumbnailWorker::finished, this, [this](int order) {
    if (order != m_order)
      return;
    m_phase = Phase::complete;
    emit completed();
  });
  connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
  m_worker->moveToThread(&m_thread);
  m_thread.start();
}

ThumbnailDesk::~ThumbnailDesk() {
  stop();
  m_thread.quit();
  m_thread.wait();
}

void ThumbnailDesk::noteState(const PictureState& state) {
  if (!state.resting)
    return stop();
  if (m_phase != Phase::moving && m_phase != Phase::waiting)
    return;
  m_phase = Phase::waiting;
  const int patience = state.refines ? besideRefinementMs : afterRefinementMs;
  if (!m_wait.isActive() || m_wait.remainingTime() > patience)
    m_wait.start(patience);
}

void ThumbnailDesk::showScene(const Scene& scene) {
  if (scene.volume == m_volume)
    return;
  stop();
  m_volume = scene.volume;
  m_shown.clear();
  m_with.browser.clearPictures();
  QMetaObject::invokeMethod(m_worker, &ThumbnailWorker::forget);
}

void ThumbnailDesk::notePresets() {
  if (m_phase == Phase::drawing || m_phase == Phase::complete)
    begin();
}

void ThumbnailDesk::drawNow() {
  if (m_phase == Phase::complete)
    emit completed();
  else if (m_phase != Phase::drawing)
    begin();
}

void ThumbnailDesk::stop() {
  m_phase = Phase::moving;
  m_wait.stop();
  m_worker->end(++m_order);
}

void ThumbnailDesk::begin() {
  if (!m_volume)
    return;
  m_wait.stop();
  m_wanted = missing();
  m_phase = Phase::drawing;
  m_worker->end(++m_order);
  const QSize size = QSize(largeThumbnailWidth, largeThumbnailHeight) * m_with.browser.devicePixelRatioF();
  QMetaObject::invokeMethod(m_worker, [worker = m_worker, order = m_order, wanted = m_wanted, size] {
    worker->draw(order, wanted, size);
  });
}

// What the list does not show yet.
std::vector<Thumbnail> ThumbnailDesk::missing() {
  Scene base = m_with.session.scene();
  base.camera = cameraOf(base);
  base.quality = {};
  std::vector<Thumbnail> wanted;
  for (const Preset& preset : m_with.presets()) {
    const QString name = QString::fromStdString(preset.name);
    Thumbnail one{name, withPreset(base, preset, true)};
    const auto found = m_shown.find(name);
    if (found == m_shown.end() || found->second != one.scene)
      wanted.push_back(std::move(one));
  }
  return wanted;
}

Camera ThumbnailDesk::cameraOf(const Scene& scene) {
  const Grid& grid = scene.volume->grid();
  const IndexBox box = croppedBox(grid, scene.crop);
  // A picture of another shape than the view's would cut what that shows.
  const Camera inView = refitted(scene.camera, grid, box, m_with.aspect(), pictureAspect);
  // From farther off than the whole there would be specks.
  const Camera whole = framed(scene.camera, grid, box, pictureAspect);
  const Camera& seen = seenHeightMm(inView) > seenHeightMm(whole) ? whole : inView;
  if (m_shown.empty() || !seeAlike(m_camera, seen))
    m_camera = seen;
  return m_camera;
}

void ThumbnailDesk::receive(int order, const QString& name, const QImage& picture, bool showsNothing) {
  if (order != m_order)
    return;
  const auto found = std::ranges::find(m_wanted, name, &Thumbnail::name); // orders are not changed
  m_shown[name] = found->scene;
  m_with.browser.setPicture(name, picture, showsNothing);
}

} // namespace limn
