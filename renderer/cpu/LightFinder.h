// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/SceneData.h"
#include "scene/Scene.h"
#include "scene/light/LightGrid.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace limn {

/// What decides the light that comes to a scene's places, and nothing else of it: scenes that agree in it
/// share what is found. Its light stands still, whatever axes the scene's is told in.
Scene litPart(const Scene& scene);

/// Finds light that travels (DEFINITION section 11) on grids of nodes, for whoever draws elsewhere than on
/// the processor: the very nodes of the CPU engine. Keeps what it found last.
class LightFinder {
public:
  /// `threads` of the processor, 0: all.
  explicit LightFinder(int threads = 0);

  /// As finely as the scene's quality asks; nodes of fine detail that are there stand in for coarse ones.
  /// Nothing where no light travels. Throws Error; Cancelled.
  LightVolumes find(const Scene& scene, const std::function<bool()>& isCancelled = {});

private:
  cpu::SceneData m_data;
  Scene m_of; ///< the lit part of the scene that was asked for last, with its detail
  LightVolumes m_found;
};

/// Finds light on a thread of its own, so that whoever draws never waits: coarsely first, then, where fine
/// detail is asked for, finely. The two scenes asked for last count, so that pictures side by side are both
/// served, whatever they share; light that is found coarsely is found to its end, or a long drag would see
/// none, and fine light of one gives way to coarse light of the other.
class LightInBackground {
public:
  explicit LightInBackground(int threads = 0);
  ~LightInBackground();
  LightInBackground(const LightInBackground&) = delete;
  LightInBackground& operator=(const LightInBackground&) = delete;

  /// What is known by now: of this scene, or until that is found of one before, if of the same volume. Asks
  /// for what is missing. Throws what finding it threw.
  LightVolumes known(const Scene& scene);

  /// Whether what `known` gives for a scene is not yet all that its quality asks for.
  bool isFinding(const Scene& scene);

private:
  struct Known {
    Scene of; ///< a lit part
    LightVolumes light;
  };

  void work();
  void findNext(std::unique_lock<std::mutex>& lock);
  void want(const Scene& lit);
  const Known* exactly(const Scene& lit) const;
  const Known* instead(const Scene& lit) const;
  std::optional<Scene> missing() const;
  std::optional<Scene> missingCoarse() const;

  std::mutex m_mutex; ///< of all below but the finder
  std::condition_variable m_changed;
  std::deque<Scene> m_wanted; ///< lit parts, the last asked for first
  std::deque<Known> m_known;  ///< the last found first
  std::exception_ptr m_problem;
  bool m_ends = false;
  LightFinder m_finder; ///< of the thread alone
  std::thread m_thread;
};

} // namespace limn
