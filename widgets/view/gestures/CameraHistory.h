// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace limn {

/// A camera with the shape of the picture for which it was chosen.
struct SeenFrom {
  Camera camera;
  double aspect = 1.0; ///< width over height, > 0
  bool operator==(const SeenFrom&) const = default;
};

/// From where one has looked before: one step for each gesture that moved the camera, a drag from press to
/// release, a run of notches, a standard view. No undo steps: what is edited stays, however one looks at it.
class CameraHistory {
public:
  /// More than these are forgotten, the oldest first.
  static constexpr std::size_t mostSteps = 64;

  /// The gesture of this id moves the camera from `before` to `after`. What belongs to the gesture noted last
  /// goes on with its step, and leaves none if it comes back to where that began (a drag that is cancelled).
  /// A new step ends the way forward.
  void note(const SeenFrom& before, const Camera& after, std::uint64_t gesture);

  /// The camera before the last step, or after the step that was taken back last; `now` is where one comes
  /// from. Nothing, and no change, where there is none.
  std::optional<SeenFrom> back(const SeenFrom& now);
  std::optional<SeenFrom> forward(const SeenFrom& now);

  bool canGoBack() const { return !m_before.empty(); }
  bool canGoForward() const { return !m_after.empty(); }

  /// Of another volume.
  void clear() { *this = {}; }

  bool operator==(const CameraHistory&) const = default;

private:
  std::vector<SeenFrom> m_before; ///< the latest last
  std::vector<SeenFrom> m_after;  ///< the next one last
  std::uint64_t m_gesture = 0;    ///< that made the latest step and may go on with it; 0: none
};

/// Turns of the wheel and key presses that follow one another are one gesture: the same cause again within
/// this time, as events tell it.
class GestureRuns {
public:
  static constexpr std::uint64_t longestPauseMs = 1000;

  /// The id of the gesture to which an event belongs. `cause` tells one kind of event from another.
  std::uint64_t idOf(int cause, std::uint64_t timestampMs);

private:
  std::uint64_t m_id = 0;
  int m_cause = 0;
  std::uint64_t m_lastMs = 0;
};

} // namespace limn
