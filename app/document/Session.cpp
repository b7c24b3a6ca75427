// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Session.h"

#include <QUndoCommand>

namespace limn {

/// Replaces the scene, keeping the camera of the moment.
class SceneEdit : public QUndoCommand {
public:
  SceneEdit(Session& session, Scene before, Scene after, const Gesture& gesture)
      : QUndoCommand(gesture.text), m_session(session), m_before(std::move(before)),
        m_after(std::move(after)), m_gesture(gesture.id) {}

  // Every command may meet every other; whether they merge is decided by the gesture below.
  int id() const override { return 1; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto* later = static_cast<const SceneEdit*>(other);
    if (later->m_gesture != m_gesture)
      return false;
    m_after = later->m_after;
    setText(later->text());
    setObsolete(withCameraOf(m_before, m_after) == m_after);
    return true;
  }

  void undo() override { m_session.replace(withCameraOf(m_before, m_session.scene())); }
  void redo() override { m_session.replace(withCameraOf(m_after, m_session.scene())); }

private:
  static Scene withCameraOf(Scene scene, const Scene& other) {
    scene.camera = other.camera;
    return scene;
  }

  Session& m_session;
  Scene m_before;
  Scene m_after;
  std::uint64_t m_gesture;
};

Session::Session(QObject* parent) : QObject(parent) {}

void Session::open(const LoadedScene& loaded) {
  m_undo.clear();
  m_volumePath = loaded.volumePath;
  replace(loaded.scene);
}

void Session::edit(const Scene& next, const Gesture& gesture) {
  if (next == m_scene)
    return;
  m_undo.push(new SceneEdit(*this, m_scene, next, gesture));
}

void Session::setCamera(const Camera& camera) {
  if (camera == m_scene.camera)
    return;
  Scene next = m_scene;
  next.camera = camera;
  replace(next);
}

void Session::replace(const Scene& scene) {
  m_scene = scene;
  emit sceneChanged(m_scene);
}

} // namespace limn
