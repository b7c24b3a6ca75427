// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Session.h"

#include "scene/presets/PresetFit.h"
#include "widgets/properties/ProjectionSection.h"

#include <QUndoCommand>

namespace limn {

Scene withProjection(Scene scene, Projection projection, const Histogram& histogram) {
  scene.projection = projection;
  if (!usesIsovalue(projection) || !scene.volume)
    return scene;
  const ValueRange& range = scene.volume->range();
  const bool isForeign = scene.isovalue == Scene{}.isovalue && !looksLikeHounsfield(*scene.volume);
  if (isForeign || scene.isovalue <= range.lowest || scene.isovalue >= range.highest)
    scene.isovalue = objectThreshold(histogram);
  return scene;
}

Camera withProjection(Camera camera, Camera::Projection projection) {
  if (projection == camera.projection)
    return camera;
  // What half the height is called depends on the projection.
  if (projection == Camera::Projection::orthographic)
    camera.heightMm = 2.0 * halfHeight(camera) * glm::length(camera.target - camera.position);
  camera.projection = projection;
  if (projection == Camera::Projection::perspective)
    camera.position = camera.target - basisOf(camera).forward * (camera.heightMm / 2.0 / halfHeight(camera));
  return camera;
}

/// Replaces scene and preset in use, keeping the camera of the moment.
class SceneEdit : public QUndoCommand {
public:
  struct State {
    Scene scene;
    Preset preset;
  };

  SceneEdit(Session& session, State after, const Gesture& gesture)
      : QUndoCommand(gesture.text), m_session(session), m_before{session.m_scene, session.m_preset},
        m_after(std::move(after)), m_gesture(gesture.id) {}

  // Every command may meet every other; whether they merge is decided by the gesture below.
  int id() const override { return 1; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto* later = static_cast<const SceneEdit*>(other);
    if (later->m_gesture != m_gesture)
      return false;
    m_after = later->m_after;
    setText(later->text());
    setObsolete(withCameraOf(m_before.scene, m_after.scene) == m_after.scene);
    return true;
  }

  void undo() override { show(m_before); }
  void redo() override { show(m_after); }

private:
  void show(const State& state) {
    m_session.m_preset = state.preset;
    m_session.replace(withCameraOf(state.scene, m_session.scene()));
  }

  static Scene withCameraOf(Scene scene, const Scene& other) {
    scene.camera = other.camera;
    return scene;
  }

  Session& m_session;
  State m_before;
  State m_after;
  std::uint64_t m_gesture;
};

/// Replaces the distance measured in the slices, and nothing else that they show.
class DistanceEdit : public QUndoCommand {
public:
  using Distance = std::optional<MeasuredDistance>;

  DistanceEdit(Session& session, const Distance& before, const Distance& after)
      : QUndoCommand(!before  ? QObject::tr("measure distance")
                     : !after ? QObject::tr("remove distance")
                              : QObject::tr("change distance")),
        m_session(session), m_before(before), m_after(after) {}

  void undo() override { show(m_before); }
  void redo() override { show(m_after); }

private:
  void show(const Distance& distance) {
    PlaneSettings settings = m_session.planes();
    settings.distance = distance;
    m_session.setPlanes(settings);
  }

  Session& m_session;
  Distance m_before;
  Distance m_after;
};

/// Replaces the named views, and nothing else.
class ViewsEdit : public QUndoCommand {
public:
  ViewsEdit(Session& session, std::vector<NamedView> after, const QString& text)
      : QUndoCommand(text), m_session(session), m_before(session.m_views), m_after(std::move(after)) {}

  void undo() override { m_session.replaceViews(m_before); }
  void redo() override { m_session.replaceViews(m_after); }

private:
  Session& m_session;
  std::vector<NamedView> m_before;
  std::vector<NamedView> m_after;
};

Session::Session(QObject* parent) : QObject(parent) {}

void Session::open(const LoadedScene& loaded, const Preset& preset) {
  m_undo.clear();
  m_preset = preset;
  m_volumePath = loaded.volumePath;
  replace(loaded.scene);
  replaceViews(loaded.views);
}

void Session::edit(const Scene& next, const Gesture& gesture) {
  if (next == m_scene)
    return;
  m_undo.push(new SceneEdit(*this, {next, m_preset}, gesture));
}

void Session::usePreset(const Preset& preset, const Gesture& gesture) {
  const Scene next = withPreset(m_scene, preset, true);
  if (next == m_scene)
    adoptPreset(preset);
  else
    m_undo.push(new SceneEdit(*this, {next, preset}, gesture));
}

void Session::setCamera(const Camera& camera) {
  if (camera == m_scene.camera)
    return;
  Scene next = m_scene;
  next.camera = camera;
  replace(next);
}

void Session::setPlanes(const PlaneSettings& settings) {
  if (settings == m_planes)
    return;
  m_planes = settings;
  emit planesChanged(m_planes);
}

void Session::noteDistance(const std::optional<MeasuredDistance>& before) {
  if (before != m_planes.distance)
    m_undo.push(new DistanceEdit(*this, before, m_planes.distance));
}

void Session::setViews(const std::vector<NamedView>& views, const QString& what) {
  if (views != m_views)
    m_undo.push(new ViewsEdit(*this, views, what));
}

void Session::replaceViews(const std::vector<NamedView>& views) {
  m_views = views;
  emit viewsChanged(m_views);
}

void Session::replace(const Scene& scene) {
  m_scene = scene;
  emit sceneChanged(m_scene);
}

} // namespace limn
