// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Gesture.h"
#include "widgets/view/gestures/CameraHistory.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>

class QAction;

namespace limn {

class CompareView;
class Volume;
struct Scene;
struct WindowContext;

/// A place about which a picture can be turned, or why there is none.
struct TurnCentre {
  std::optional<glm::dvec3> placeMm; ///< world
  QString reason;                    ///< one sentence where there is no place
};

/// Where half of what a ray of the picture of `side` gives is gathered (halfLightDepth): what is seen there.
TurnCentre turnCentreAlong(const CompareView& view, const Ray& ray, int side);

/// The same of what gives most to the pixel (strongestDepth): what a click means.
TurnCentre strongestAlong(const CompareView& view, const Ray& ray, int side);

/// That nothing is seen where something was pointed at.
QString noPlaceText();

/// From where the picture is seen: follows the gestures of the view, goes back to the camera before the last
/// of them and forward again, has turns go about a place that was pointed at until the camera is reset, and
/// chooses between a vanishing point and parallel rays. No undo steps.
class CameraController : public QObject {
  Q_OBJECT

public:
  explicit CameraController(WindowContext& context);

  /// From now on turns go about this place, world mm, or about the camera's target; says so.
  void turnAbout(const std::optional<glm::dvec3>& worldMm);

  /// Looks from there, as one step that can be gone back.
  void lookAs(const Camera& camera) { move(camera, nextGestureId()); }

  /// From where one has looked, and the place that turns go about, for a window that takes this one's place.
  struct Memory {
    CameraHistory history;
    std::optional<glm::dvec3> turnsAboutMm; ///< world
  };
  Memory memory() const;
  /// Of the same volume, which is shown already.
  void takeOver(const Memory& memory);

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
