// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/CameraHistory.h"

#include "widgets/Gesture.h"

namespace limn {

void CameraHistory::note(const SeenFrom& before, const Camera& after, std::uint64_t gesture) {
  if (before.camera == after)
    return;
  if (gesture == m_gesture && !m_before.empty()) {
    if (after != m_before.back().camera)
      return;
    m_before.pop_back();
    m_gesture = 0;
    return;
  }
  if (m_before.size() == mostSteps)
    m_before.erase(m_before.begin());
  m_before.push_back(before);
  m_after.clear();
  m_gesture = gesture;
}

std::optional<SeenFrom> CameraHistory::back(const SeenFrom& now) {
  if (m_before.empty())
    return std::nullopt;
  const SeenFrom there = m_before.back();
  m_before.pop_back();
  m_after.push_back(now);
  m_gesture = 0;
  return there;
}

std::optional<SeenFrom> CameraHistory::forward(const SeenFrom& now) {
  if (m_after.empty())
    return std::nullopt;
  const SeenFrom there = m_after.back();
  m_after.pop_back();
  m_before.push_back(now);
  m_gesture = 0;
  return there;
}

std::uint64_t GestureRuns::idOf(int cause, std::uint64_t timestampMs) {
  // A clock that was set back ends a run, too.
  const bool goesOn =
      m_id != 0 && cause == m_cause && timestampMs >= m_lastMs && timestampMs - m_lastMs <= longestPauseMs;
  if (!goesOn)
    m_id = nextGestureId();
  m_cause = cause;
  m_lastMs = timestampMs;
  return m_id;
}

} // namespace limn
