// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/gestures/CameraHistory.h"

#include <QObject>

#include <memory>

class QAction;

namespace limn {

class Volume;
struct Scene;
struct WindowContext;

/// From where the picture is seen: follows the gestures of the view, goes back to the camera before the last
/// of them and forward again, has turns go about a place that was pointed at until the camera is reset, and
/// chooses between a vanishing point and parallel rays. No undo steps.
class CameraController : public QObject {
  Q_OBJECT

public:
  explicit CameraController(WindowContext& context);

  /// From now on turns go about this place, world mm, or about the camera's target; says so.
  void turnAbout(const std::optional<glm::dvec3>& worldMm);

private:
  void addActions();
  void turnAboutSeen(const Ray& ray, int side);
  void move(const Camera& camera, std::uint64_t gesture);
  /// Goes to what the history gave; nothing where it gave nothing.
  void goTo(const std::optional<SeenFrom>& there);
  SeenFrom now() const;
  void showScene(const Scene& scene);
  void showSteps();

  WindowContext& m_context;
  CameraHistory m_history;
  std::shared_ptr<const Volume> m_volume; ///< of which the history tells
  QAction* m_orthographic = nullptr;
  QAction* m_back = nullptr;
  QAction* m_forward = nullptr;
};

} // namespace limn
