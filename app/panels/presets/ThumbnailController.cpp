// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/ThumbnailController.h"

#include "app/panels/presets/PresetController.h"
#include "app/window/WindowContext.h"
#include "cpu/CpuEngine.h"
#include "scene/framing/Framing.h"
#include "scene/regions/Reduction.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/pictures/PictureScreen.h"

#include <QImage>

#include <algorithm>
#include <exception>
#include <utility>

namespace limn {
namespace {

// The next gesture is often near, and the engines are tried once after the first picture.
constexpr int afterRefinementMs = 300;
// Refinement may take a minute; pictures of a second go beside it.
constexpr int besideRefinementMs = 3000;

constexpr double thumbnailAspect = static_cast<double>(largeThumbnailWidth) / largeThumbnailHeight;

double seenHeightMm(const Camera& camera) {
  const double distance = camera.projection == Camera::Projection::perspective
                              ? glm::length(camera.target - camera.position)
                              : 1.0;
  return 2.0 * halfHeight(camera) * distance;
}

// As many as a picture of some hundred pixels tells apart.
constexpr std::size_t mostVoxels = std::size_t{1} << 21;

// What is seen by nobody: a level of 255, nowhere more.
constexpr float leastAlpha = 1.0f / 255.0f;

// Others draw at the same time, for somebody who waits.
constexpr int threads = 1;

bool showsNothing(const Image& picture) {
  return std::ranges::none_of(picture.pixels, [](const glm::vec4& pixel) { return pixel.a > leastAlpha; });
}

} // namespace

ThumbnailPainter::ThumbnailPainter() = default;
ThumbnailPainter::~ThumbnailPainter() = default;

void ThumbnailPainter::draw(const std::vector<Thumbnail>& wanted, const QSize& size, const IsEnded& isEnded,
                            const Drawn& drawn) {
  const glm::ivec2 pixels(size.width(), size.height());
  for (const Thumbnail& one : wanted) {
    if (isEnded())
      throw Cancelled();
    try {
      const Scene scene = reducedScene(one.scene, isEnded);
      const std::optional<Image> picture = m_engine->draw(scene, pixels, {{0, 0}, pixels}, isEnded);
      drawn(one.name, overBackground(*picture, scene.image.background), showsNothing(*picture));
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception&) {
      // What this one shows is told where it is used; the list has the picture of its curve.
    }
  }
}

Scene ThumbnailPainter::reducedScene(const Scene& scene, const IsEnded& isEnded) {
  const glm::ivec3 reduction = reductionTo(scene.volume->grid(), mostVoxels);
  if (m_whole.lock() != scene.volume) {
    m_engine.reset(); // first: there may be no memory for two
    m_volume.reset();
    m_wholeKeep = {};
    m_keep = {};
    m_volume = reduced(scene.volume, reduction, {threads, isEnded, {}});
    m_whole = scene.volume;
    m_engine = makeCpuEngine(threads);
  }
  if (m_wholeKeep != scene.keep) {
    m_wholeKeep = scene.keep;
    m_keep = reduced(scene.keep, reduction);
  }
  Scene small = scene;
  small.volume = m_volume;
  small.keep = m_keep;
  small.quality = {};
  small.quality.stepVoxels = 1.0;
  small.quality.light = LightDetail::moving;
  small.quality.paths = 16; // of physical light, whose noise a small picture may show
  return small;
}

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

ThumbnailController::ThumbnailController(WindowContext& context, const PresetController& presets)
    : QObject(&context.window), m_context(context), m_presets(presets) {
  connect(&context.view, &CompareView::told, this, [this](const ViewNews& news) { noteState(news.state); });
  connect(&presets, &PresetController::listed, this, &ThumbnailController::notePresets);
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
  m_wait.setSingleShot(true);
  connect(&m_wait, &QTimer::timeout, this, &ThumbnailController::begin);
}

void ThumbnailController::noteState(const PictureState& state) {
  if (!state.resting)
    return stop();
  if (m_phase != Phase::moving && m_phase != Phase::waiting)
    return;
  m_phase = Phase::waiting;
  const int patience = state.refines ? besideRefinementMs : afterRefinementMs;
  if (!m_wait.isActive() || m_wait.remainingTime() > patience)
    m_wait.start(patience);
}

void ThumbnailController::showScene(const Scene& scene) {
  if (scene.volume == m_volume)
    return;
  stop();
  m_volume = scene.volume;
  m_object.reset();
  m_shown.clear();
  m_presets.browser().clearPictures();
  m_painter = std::make_shared<ThumbnailPainter>();
}

void ThumbnailController::notePresets() {
  if (m_phase == Phase::drawing || m_phase == Phase::complete)
    begin();
}

void ThumbnailController::drawNow() {
  if (m_phase == Phase::complete)
    emit completed();
  else if (m_phase != Phase::drawing)
    begin();
}

void ThumbnailController::stop() {
  m_phase = Phase::moving;
  m_wait.stop();
  m_work.cancel();
}

void ThumbnailController::begin() {
  if (!m_volume)
    return;
  m_wait.stop();
  m_phase = Phase::drawing;
  const Scene& scene = m_context.session.scene();
  if (!m_object || m_objectKeep != scene.keep || m_objectCrop != scene.crop)
    return findObject(scene);
  m_wanted = missing();
  const QSize size =
      QSize(largeThumbnailWidth, largeThumbnailHeight) * m_presets.browser().devicePixelRatioF();
  m_work.start([this, painter = m_painter, wanted = m_wanted,
                size](const BackgroundWork::Line& line) -> BackgroundWork::Deliver {
    painter->draw(wanted, size, line.effort.isCancelled,
                  [&](const QString& name, const QImage& picture, bool showsNothing) {
                    line.tell([this, name, picture, showsNothing] { receive(name, picture, showsNothing); });
                  });
    return [this] {
      m_phase = Phase::complete;
      emit completed();
    };
  });
}

// Whatever the curve shows of it: what is kept without the air around it.
void ThumbnailController::findObject(const Scene& scene) {
  Scene solid = scene;
  solid.projection = Projection::isosurface;
  solid.isovalue = landmarksOf(m_context.document.histogram()).object;
  m_work.start([this, solid](const BackgroundWork::Line& line) -> BackgroundWork::Deliver {
    const bool isOnDisk = solid.volume->room() != nullptr; // and not read for this
    VisibleVoxels found =
        isOnDisk ? allVoxelsOf(solid.volume->grid(), solid.crop) : visibleVoxels(solid, line.effort);
    return [this, solid, found = std::move(found)] {
      m_object = found;
      m_objectKeep = solid.keep;
      m_objectCrop = solid.crop;
      begin();
    };
  });
}

// What the list does not show yet.
std::vector<Thumbnail> ThumbnailController::missing() {
  Scene base = m_context.session.scene();
  base.camera = cameraOf(base);
  base.quality = {};
  std::vector<Thumbnail> wanted;
  for (const Preset& preset : m_presets.fittedPresets()) {
    const QString name = QString::fromStdString(preset.name);
    Thumbnail one{name, withPreset(base, m_presets.asUsed(preset), true)};
    const auto found = m_shown.find(name);
    if (found == m_shown.end() || found->second != one.scene)
      wanted.push_back(std::move(one));
  }
  return wanted;
}

// From the side that is looked from, all of it: what is enlarged are specks of colour, which nobody tells
// apart.
Camera ThumbnailController::cameraOf(const Scene& scene) {
  const Camera whole = framed(scene.camera, scene.volume->grid(), *m_object, thumbnailAspect);
  if (m_shown.empty() || !seeAlike(m_camera, whole))
    m_camera = whole;
  return m_camera;
}

void ThumbnailController::receive(const QString& name, const QImage& picture, bool showsNothing) {
  const auto found = std::ranges::find(m_wanted, name, &Thumbnail::name); // orders are not changed
  m_shown[name] = found->scene;
  m_presets.browser().setPicture(name, picture, showsNothing);
}

} // namespace limn
