// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ImageError.h"
#include "accuracy/times/Timing.h"
#include "engine/Engine.h"
#include "scene/Scene.h"

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// Where the gradient of a sample comes from: six fetches of the volume, or one of a texture made before.
enum class GradientSource { onTheFly, precomputed };

/// Everything by which a picture of one scene can be had faster or closer to the exact one.
struct OperatingPoint {
  Engine engine =
      Engine::rayCaster;   ///< `rayCaster` stands for the CPU engine, too, where that casts the rays
  double stepVoxels = 0.5; ///< in units of the smallest spacing; unused under a tolerance
  std::optional<double> toleranceLevels; ///< error-controlled steps instead of equal ones, > 0
  bool preintegrated = false;
  double earlyTermination = 0.998;
  GradientSource gradients = GradientSource::onTheFly;
  double imageScale = 1.0; ///< of width and height while drawing, 0 < s ≤ 1; enlarged afterwards
  /// Of physical light, how many of each pixel: in place of steps, which are then those of its alpha.
  std::optional<int> paths{};
  std::string rival = {}; ///< another library's renderer that drew it, such as "vtk-gpu"; empty: Limn's
  bool operator==(const OperatingPoint&) const = default;
};

/// The scene drawn at a point; under a tolerance its fineness is still to be found (accuracy/Tolerance).
/// Renderer, gradients and image scale are no part of a scene.
Scene atPoint(Scene scene, const OperatingPoint& point);

/// What stays when only the step or the tolerance changes, in words: a curve of the chart.
std::string familyOf(const OperatingPoint& point);

/// Step, tolerance or paths in words: "step 1/4", "within 1 level" or "64 paths".
std::string stepOf(const OperatingPoint& point);

/// A point with what it brought and what it took.
struct MeasuredPoint {
  OperatingPoint point;
  ImageError error;    ///< to the converged picture
  Timing ms;           ///< of a whole picture
  double peakMb = 0.0; ///< of memory beyond what was in use before, in which it was drawn
  /// log2 of the mean error's ratio to that at twice the step, or at half the paths, same family.
  std::optional<double> order;
  bool isPareto = false; ///< no other point is at least as fast and at least as accurate
  bool operator==(const MeasuredPoint&) const = default;
};

/// How far the picture itself has converged that errors are measured against (DEFINITION section 9).
struct ReferenceFacts {
  bool converged = false;
  double stepVoxels = 0.0;        ///< the last step; of error-controlled ones that of the fineness itself
  std::optional<double> fineness; ///< of error-controlled steps
  double lastChangeLevels = 0.0;  ///< 99.9th percentile of the change by the last halving
  double lastMeanChange = 0.0;    ///< mean of that change, levels
  bool isInFloats = false;        ///< drawn in single precision
  /// There is none: errors are the standard errors of random paths (DEFINITION section 12).
  bool isByChance{};
  bool operator==(const ReferenceFacts&) const = default;
};

/// The points that no other one beats: marks those, by 99.9th percentile and median time.
void markPareto(std::vector<MeasuredPoint>& points);

/// Fills in the orders within families whose steps halve, or whose paths double.
void findOrders(std::vector<MeasuredPoint>& points);

/// The fastest point whose 99.9th percentile is at most `levels`; null where none is.
const MeasuredPoint* fastestWithin(const std::vector<MeasuredPoint>& points, double levels);

/// The most accurate point that takes at most `ms` (median); null where none does.
const MeasuredPoint* mostAccurateWithin(const std::vector<MeasuredPoint>& points, double ms);

} // namespace limn
