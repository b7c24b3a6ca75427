// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/ConvergedPicture.h"

namespace limn {

/// What a sweep needs of the renderers. Every function may throw Error; Error::Kind::usage says that a
/// renderer cannot draw this scene at this point.
struct SweepRenderers {
  /// Draws a whole picture of `atPoint(scene, point)` and returns when its pixels are there.
  std::function<void(const Scene& scene, const OperatingPoint& point, const glm::ivec2& size)> draw;
  /// The picture that was drawn last.
  std::function<Image()> picture;
  /// The most memory, MB, that a picture takes beyond what was in use before, everything made anew.
  std::function<double(const Scene& scene, const OperatingPoint& point, const glm::ivec2& size)> peakMb;
};

/// What one decision about accuracy costs beside the others of its group, all else being equal.
struct DecisionCost {
  std::string group; ///< "look-up table"
  std::string name;  ///< "8 bits, 256 entries"
  bool isDefault = false;
  ImageError error;     ///< at the scene's step
  ImageError fineError; ///< at 1/8 voxel, where the step hides less
  Timing ms;
  double timesDefault = 1.0; ///< the time over that of the program's own decisions, drawn in turn with it
  double extraMb = 0.0;      ///< of memory beside the default's
  std::string remark;        ///< empty, or a sentence
  bool operator==(const DecisionCost&) const = default;
};

/// Error against time of a scene: values that can be shown and saved.
struct AccuracyReport {
  std::string scene;    ///< a name for people
  std::string renderer; ///< e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string machine;
  glm::ivec2 size{0};
  double smallestSpacingMm = 1.0; ///< of the volume, to tell steps in mm
  ReferenceFacts reference;
  std::vector<MeasuredPoint> points;
  std::vector<DecisionCost> decisions;
  std::vector<std::string> remarks; ///< a sentence each, such as which points could not be drawn and why
  bool operator==(const AccuracyReport&) const = default;
};

/// The points worth measuring of a scene: every renderer at steps that halve, and each other decision at a
/// few of them.
std::vector<OperatingPoint> usualPoints();

/// A few points that take a second or two: equal steps and two tolerances of the ray caster.
std::vector<OperatingPoint> fewPoints();

/// The points and one that somebody asked for, where it stands among those of its family, from coarse to
/// fine.
std::vector<OperatingPoint> withPoint(std::vector<OperatingPoint> points, const OperatingPoint& asked);

/// Draws the scene at every point, compares with the converged picture, takes times in rounds over all points
/// (so that a machine that grows slower slows them alike), and fills in `points`, with orders and Pareto
/// marks, and `remarks` of the report. Seven pictures a point where they are quick, two where they take
/// longer than a second.
void measurePoints(AccuracyReport& report, const Scene& scene, const std::vector<OperatingPoint>& points,
                   const PrecisePixels& converged, const SweepRenderers& renderers,
                   const ReportProgress& progress = {});

/// A picture enlarged to `size` by linear interpolation between pixel centres, its outermost pixels kept.
Image enlarged(const Image& image, const glm::ivec2& size);

} // namespace limn
