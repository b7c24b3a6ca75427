// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// Many times as a reader wants them.
struct Timing {
  double median = 0.0;
  double least = 0.0;
  double most = 0.0;
  bool operator==(const Timing&) const = default;
};

/// At least one time; of an even number the median is the mean of the middle two.
Timing timingOf(std::vector<double> times);

/// What one picture cost.
struct FrameCost {
  double ms = 0.0;    ///< on the clock, until the picture is finished
  double cpuMs = 0.0; ///< of all threads
};

/// The wall times and the processor times of frames.
std::vector<double> wallTimes(const std::vector<FrameCost>& frames);
std::vector<double> processorTimes(const std::vector<FrameCost>& frames);

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

/// One picture of a renderer: its mean error in 8-bit levels and what it took of all threads.
struct ErrorAndTime {
  double meanError = 0.0;
  double cpuMs = 0.0;
};

/// The least processor time in which a renderer comes within an error: of pictures of several steps, by
/// linear interpolation between the logarithms of neighbours. Its coarsest picture where that is closer
/// already; absent where none is close enough.
std::optional<double> timeAtError(std::vector<ErrorAndTime> curve, double meanError);

/// Programs compared where they err alike.
struct EqualErrorRow {
  std::string scene;
  std::string program;
  double meanError = 0.0;      ///< levels
  std::optional<double> cpuMs; ///< absent: it never comes so close
  std::optional<double> gain;  ///< how many times faster than the yardstick; absent without either's time
  std::string yardstick;
};

} // namespace limn
