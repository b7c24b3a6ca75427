// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ImageError.h"
#include "accuracy/sweep/AccuracySweep.h"
#include "accuracy/sweep/OperatingPoint.h"

#include <QString>

#include <optional>
#include <vector>

namespace limn {

/// What was measured, and of what.
struct MeasuredAccuracy {
  AccuracyReport report;
  Scene scene;                ///< as measured; its quality does not matter
  double steepestPerMm = 0.0; ///< of its volume (SceneFacts), which decides on automatic pre-integration
  glm::ivec2 timedSize{0};    ///< pixels for which its times are told; 0: those of the report
};

/// The same with its times told for a picture of `size` pixels: a ray takes as long in a larger picture.
MeasuredAccuracy timedFor(MeasuredAccuracy measured, const glm::ivec2& size);

/// The points that the dial offers, from fast to exact, with everything but the step as the scene has it. The
/// last one has error-controlled steps where the projection integrates. None of physical light.
std::vector<OperatingPoint> dialPoints(const Scene& scene, double steepestPerMm);

/// The points that the window measures for a scene: those of its dial, another tolerance or finer steps, and
/// where that makes a difference the same steps with the curve averaged between samples or not.
std::vector<OperatingPoint> pointsToMeasure(const Scene& scene, double steepestPerMm);

/// At which point a scene is drawn; absent with jitter, which no point has.
std::optional<OperatingPoint> pointOf(const Scene& scene, double steepestPerMm);

/// Whether a scene can be drawn at a point in the window: by rays, with as many pixels as it has.
bool isOfTheWindow(const OperatingPoint& point);

/// The quality with which a scene is drawn at a point of the window. What was automatic stays so where it
/// leads to the same. Under a tolerance the fineness is still to be found (accuracy/Tolerance).
Quality qualityAt(const OperatingPoint& point, const Scene& scene, double steepestPerMm);

/// Whether errors measured for one scene hold for another: they differ in nothing but camera, size of the
/// written picture and quality.
bool holdsFor(const Scene& measured, const Scene& shown);

/// The error that was measured of the picture that a scene shows (99.9th percentile, levels; where it cannot
/// be told from none, what is certain): of the same content from the same camera at a measured point. Absent
/// where there is none.
std::optional<double> levelsMeasuredOf(const Scene& shown, const MeasuredAccuracy& measured);

/// The index of a point among measured ones.
std::optional<std::size_t> indexOf(const OperatingPoint& point, const std::vector<MeasuredPoint>& points);

/// A picture compared with the exact one, pixel by pixel.
struct ComparedPicture {
  OperatingPoint point; ///< of the picture
  ReferenceFacts reference;
  std::optional<ImageError> error; ///< where it is known: the exact picture has converged, two paths meet
  ErrorMap map;                    ///< empty where the exact picture has not converged
};

/// What a point's error is known to be: "0.66 levels", "less than 0.012 levels", "unknown".
QString pointErrorText(const MeasuredPoint& point, const ReferenceFacts& reference);

/// "step 1/4 voxel" or "exact to half a level", with what else sets the point apart.
QString pointText(const OperatingPoint& point);

/// What a curve of the chart has in common, in a clinician's words: "equal steps, curve averaged"; families
/// that the window does not draw keep the name they have in reports.
QString familyText(const OperatingPoint& point);

/// "Step 1/4 voxel: within 0.66 levels, 48 ms."
QString pointSentence(const MeasuredPoint& point, const ReferenceFacts& reference);

/// All numbers of a point as a small table, rich text.
QString pointToolTip(const MeasuredPoint& point, const AccuracyReport& report);

} // namespace limn
