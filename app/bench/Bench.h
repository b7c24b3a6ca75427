// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/Contender.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// What one renderer took for one scene at one step.
struct BenchRow {
  std::string program;
  std::string renderer;
  std::string scene;
  glm::ivec2 size{0};
  double stepVoxels = 0.0;
  std::string effects;          ///< in the program, in words; empty where there is no choice
  std::vector<FrameCost> views; ///< one turn, in the same order for every row of a scene
  double firstMs = 0.0;         ///< upload, preparation, shader and first frame
  std::optional<double> editMs; ///< median from a moved control point to the picture; absent without points
  double peakMb = 0.0;          ///< resident above what was before the first frame
};

/// The view `index` of `count` on a full turn of the camera about its own up, the first as the scene has it.
Scene turned(const Scene& scene, int index, int count);

/// The scene with its middle control point a little fainter, by another amount for each index; nothing for a
/// function without points.
std::optional<Scene> edited(const Scene& scene, int index);

/// Draws a scene with every contender in turn: each afresh and after an edit for first frame and memory, then
/// `frames` views of one turn, then as many edits, renderer after renderer for each view and edit, so that
/// what disturbs the machine disturbs all. `advance` is called after every picture and may throw.
std::vector<BenchRow> benchRows(const std::string& name, const Scene& scene,
                                const std::vector<std::unique_ptr<Contender>>& contenders, int frames,
                                const std::function<void()>& advance);

/// The pictures that benchRows draws with each contender.
inline int picturesPerRow(int frames) {
  return 2 + 2 * frames;
}

} // namespace limn
