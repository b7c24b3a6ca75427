// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/times/Timing.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// What one renderer took for one scene at one step, or why it drew nothing.
struct BenchRow {
  std::string program;
  std::string renderer;
  std::string scene;
  glm::ivec2 size{0};
  double stepVoxels = 0.0;
  std::string missing;          ///< one sentence; where there is one, no figure below means anything
  std::string effects;          ///< in the program, in words; empty where there is no choice
  std::vector<FrameCost> views; ///< one turn, in the same order for every row of a scene
  double firstMs = 0.0;         ///< upload, preparation, shader and first frame
  double firstCpuMs = 0.0;      ///< the same of all threads
  std::optional<double> editMs; ///< median from a moved control point to the picture; absent without points
  double peakMb = 0.0;          ///< resident above what was before the first frame
  double meanError = 0.0;       ///< of the first view, 8-bit levels over the covered pixels
};

} // namespace limn
