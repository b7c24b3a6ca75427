// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Session.h"

#include "app/document/ChangeText.h"
#include "scene/presets/PresetFit.h"
#include "widgets/properties/ProjectionSection.h"

#include <QUndoCommand>

namespace limn {

bool haveSameVoxels(const std::shared_ptr<const Volume>& a, const std::shared_ptr<const Volume>& b) {
  return a == b || (a && b && a->sharesVoxelsWith(*b));
}

Scene withProjection(Scene scene, Projection projection, const Histogram& histogram) {
  scene.projection = projection;
  if (!usesIsovalue(projection) || !scene.volume)
    return scene;
  const ValueRange& range = scene.volume->range();
  const bool isForeign = scene.isovalue == Scene{}.isovalue && !looksLikeHounsfield(*scene.volume);
  if (isForeign || scene.isovalue <= range.lowest || scene.isovalue >= range.highest)
    scene.isovalue = landmarksOf(histogram).object;
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

/// Replaces scene and preset in use, keeping the camera of the moment. Each cut has a map of labels of its
/// own, a byte or two for each voxel: steps hold them packed. Where the volume lies otherwise from now on,
/// what was measured stays on its tissue.
class SceneEdit : public QUndoCommand {
public:
  SceneEdit(Session& session, const Scene& scene, const Preset& preset, const Gesture& gesture)
      : QUndoCommand(gesture.text), m_session(session),
        m_before(stateOf(session, session.m_scene, session.m_preset, session.m_measurements)),
        m_after(stateOf(session, scene, preset, measuredIn(session, scene.volume))), m_gesture(gesture) {
    setText(changeText(m_before.scene, m_after.scene, m_gesture));
  }

  // Every command may meet every other; whether they merge is decided by the gesture below.
  int id() const override { return 1; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto* later = static_cast<const SceneEdit*>(other);
    if (later->m_gesture.id != m_gesture.id)
      return false;
    m_after = later->m_after;
    m_gesture = later->m_gesture;
    setText(changeText(m_before.scene, m_after.scene, m_gesture)); // from where the gesture began
    setObsolete(m_before.labels == m_after.labels &&
                withCameraOf(m_before.scene, m_after.scene) == m_after.scene);
    return true;
  }

  void undo() override { show(m_before); }
  void redo() override { show(m_after); }

private:
  struct State {
    Scene scene; // without its labels
    std::shared_ptr<const PackedLabels> labels;
    Preset preset;
    std::vector<Measurement> measurements;
  };

  static State stateOf(Session& session, Scene scene, const Preset& preset,
                       std::vector<Measurement> measurements) {
    std::shared_ptr<const PackedLabels> labels = session.packed(scene.keep.labels);
    scene.keep.labels.reset();
    return {std::move(scene), std::move(labels), preset, std::move(measurements)};
  }

  static std::vector<Measurement> measuredIn(const Session& session,
                                             const std::shared_ptr<const Volume>& volume) {
    const std::shared_ptr<const Volume>& before = session.m_scene.volume;
    return before && haveSameVoxels(before, volume)
               ? measurementsMoved(session.m_measurements, before->grid(), volume->grid())
               : std::vector<Measurement>();
  }

  void show(const State& state) {
    m_session.m_preset = state.preset;
    Scene scene = withCameraOf(state.scene, m_session.scene());
    scene.keep.labels = state.labels ? state.labels->map() : nullptr;
    m_session.replace(scene);
    if (m_before.scene.volume != m_after.scene.volume)
      m_session.replaceMeasurements(state.measurements);
  }

  static Scene withCameraOf(Scene scene, const Scene& other) {
    scene.camera = other.camera;
    return scene;
  }

  Session& m_session;
  State m_before;
  State m_after;
  Gesture m_gesture; ///< the last that was merged
};

/// Replaces what was measured, and nothing else.
class MeasurementsEdit : public QUndoCommand {
public:
  using Measurements = std::vector<Measurement>;

  MeasurementsEdit(Session& session, const Measurements& after, const Gesture& gesture)
      : QUndoCommand(gesture.text), m_session(session), m_before(session.m_measurements), m_after(after),
        m_gesture(gesture.id) {}

  int id() const override { return 2; } // merges with none of the scene's

  bool mergeWith(const QUndoCommand* other) override {
    const auto* later = static_cast<const MeasurementsEdit*>(other);
    if (later->m_gesture != m_gesture)
      return false;
    m_after = later->m_after;
    setText(later->text());
    setObsolete(m_before == m_after);
    return true;
  }

  void undo() override { m_session.replaceMeasurements(m_before); }
  void redo() override { m_session.replaceMeasurements(m_after); }

private:
  Session& m_session;
  Measurements m_before;
  Measurements m_after;
  std::uint64_t m_gesture;
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

Session::Session(QObject* parent, std::size_t mostLabelBytes)
    : QObject(parent), m_mostLabelBytes(mostLabelBytes) {
  m_undo.setUndoLimit(mostSteps);
}

void Session::open(const LoadedScene& loaded, const Preset& preset) {
  m_undo.clear();
  m_undo.setClean(); // an empty stack that was told to be unclean stays so
  m_preset = preset;
  m_volumePath = loaded.volumePath;
  // Before the scene is told, or those of another volume would be looked up in it.
  const bool isOther = loaded.measurements != m_measurements;
  m_measurements = loaded.measurements;
  replace(loaded.scene);
  if (isOther)
    emit measurementsChanged(m_measurements);
  replaceViews(loaded.views);
}

void Session::edit(const Scene& next, const Gesture& gesture) {
  if (next == m_scene)
    return;
  m_undo.push(new SceneEdit(*this, next, m_preset, gesture));
}

void Session::edit(const Scene& next, const Preset& preset, const Gesture& gesture) {
  if (next != m_scene || preset != m_preset)
    m_undo.push(new SceneEdit(*this, next, preset, gesture));
}

void Session::usePreset(const Preset& preset, const Gesture& gesture) {
  const Scene next = withPreset(m_scene, preset, true);
  if (next == m_scene)
    adoptPreset(preset);
  else
    m_undo.push(new SceneEdit(*this, next, preset, gesture));
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

void Session::setMeasurements(const std::vector<Measurement>& measurements, const Gesture& gesture) {
  if (measurements != m_measurements)
    m_undo.push(new MeasurementsEdit(*this, measurements, gesture));
}

void Session::replaceMeasurements(const std::vector<Measurement>& measurements) {
  if (measurements == m_measurements)
    return;
  m_measurements = measurements;
  emit measurementsChanged(m_measurements);
}

std::shared_ptr<const PackedLabels> Session::packed(const std::shared_ptr<const LabelMap>& map) {
  if (!map)
    return {};
  std::erase_if(m_packed, [](const auto& known) { return known.expired(); });
  for (const auto& known : m_packed)
    if (const auto labels = known.lock(); labels->isOf(map))
      return labels;
  const auto labels =
      std::make_shared<const PackedLabels>(map, m_scene.volume ? m_scene.volume->room() : nullptr);
  m_packed.push_back(labels);
  putOldLabelsAside();
  return labels;
}

// Who undoes comes to the latest first.
void Session::putOldLabelsAside() const {
  std::size_t bytes = 0;
  for (auto known = m_packed.rbegin(); known != m_packed.rend(); ++known)
    if (const auto labels = known->lock()) {
      bytes += labels->bytesInMemory();
      if (bytes > m_mostLabelBytes)
        labels->putAside(m_aside);
    }
}

std::size_t Session::labelBytes() const {
  std::size_t bytes = 0;
  for (const auto& known : m_packed)
    if (const auto labels = known.lock())
      bytes += labels->bytesInMemory();
  return bytes;
}

void Session::setViews(const std::vector<NamedView>& views, const QString& what) {
  if (views != m_views)
    m_undo.push(new ViewsEdit(*this, views, what));
}

void Session::replaceViews(const std::vector<NamedView>& views) {
  m_views = views;
  emit viewsChanged(m_views);
}

void Session::tellBeside() {
  emit planesChanged(m_planes);
  emit measurementsChanged(m_measurements);
  emit viewsChanged(m_views);
}

void Session::replace(const Scene& scene) {
  m_scene = scene;
  emit sceneChanged(m_scene);
}

} // namespace limn
