// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/points/PointUse.h"

#include "accuracy/Tolerance.h"
#include "scene/ProjectionFacts.h"
#include "scene/effects/EffectPlan.h"

#include <algorithm>

namespace limn {
namespace {

const std::vector<double> dialSteps{2.0, 1.0, 0.5, 0.25, 0.125};

bool isPreintegrated(const Scene& scene, double steepestPerMm) {
  if (!scene.volume)
    return false;
  SceneFacts facts;
  facts.steepestPerMm = steepestPerMm;
  return requiredEffects(scene, facts).effects.has(Effect::preintegration);
}

Scene withStep(Scene scene, double stepVoxels) {
  Quality& quality = scene.quality;
  // A tolerance lets rays run further; equal steps go back to where they commonly end.
  if (quality.toleranceLevels)
    quality.earlyTermination = Quality{}.earlyTermination;
  quality.toleranceLevels.reset();
  quality.fineness.reset();
  quality.stepVoxels = stepVoxels;
  quality.jitter = false;
  return scene;
}

OperatingPoint exactPoint() {
  OperatingPoint point;
  point.toleranceLevels = exactToleranceLevels;
  return point;
}

void addOnce(std::vector<OperatingPoint>& points, const OperatingPoint& point) {
  if (std::find(points.begin(), points.end(), point) == points.end())
    points.push_back(point);
}

// A scene without the view of it.
Scene contentOf(Scene scene) {
  scene.camera = {};
  scene.image = {};
  scene.quality = {};
  return scene;
}

} // namespace

MeasuredAccuracy timedFor(MeasuredAccuracy measured, const glm::ivec2& size) {
  const glm::ivec2& drawn = measured.report.size;
  const double factor = double(size.x) * size.y / std::max(1.0, double(drawn.x) * drawn.y);
  for (MeasuredPoint& point : measured.report.points)
    for (double* ms : {&point.ms.median, &point.ms.least, &point.ms.most})
      *ms *= factor;
  measured.timedSize = size;
  return measured;
}

std::optional<OperatingPoint> pointOf(const Scene& scene, double steepestPerMm) {
  if (scene.quality.jitter)
    return std::nullopt;
  OperatingPoint point;
  // Under a tolerance neither the step nor pre-integration matters, and where rays end comes with it.
  point.toleranceLevels = scene.quality.toleranceLevels;
  if (point.toleranceLevels)
    return point;
  point.stepVoxels = scene.quality.stepVoxels;
  point.preintegrated = isPreintegrated(scene, steepestPerMm);
  point.earlyTermination = scene.quality.earlyTermination;
  return point;
}

std::vector<OperatingPoint> dialPoints(const Scene& scene, double steepestPerMm) {
  std::vector<OperatingPoint> points;
  points.reserve(dialSteps.size() + 1);
  for (const double step : dialSteps)
    points.push_back(*pointOf(withStep(scene, step), steepestPerMm));
  if (integrates(scene.projection))
    points.push_back(exactPoint());
  return points;
}

std::vector<OperatingPoint> pointsToMeasure(const Scene& scene, double steepestPerMm) {
  std::vector<OperatingPoint> points;
  const double earlyTermination = withStep(scene, 1.0).quality.earlyTermination;
  const bool hasTolerances = integrates(scene.projection);
  for (OperatingPoint point : fewPoints()) {
    // Where a tolerance gets closer in less time, finer steps than the dial's are not worth waiting for.
    const bool isFinerThanDial = !point.toleranceLevels && point.stepVoxels < dialSteps.back();
    if (hasTolerances ? isFinerThanDial : point.toleranceLevels.has_value())
      continue;
    if (!point.toleranceLevels)
      point.earlyTermination = earlyTermination;
    points.push_back(point);
  }
  for (const OperatingPoint& point : dialPoints(scene, steepestPerMm))
    addOnce(points, point);
  // Averaging the curve matters only to pictures that gather along the ray.
  Scene averaged = scene;
  averaged.quality.preintegrated = Preintegration::always;
  for (const OperatingPoint& point : dialPoints(averaged, steepestPerMm))
    addOnce(points, point);
  return points;
}

bool isOfTheWindow(const OperatingPoint& point) {
  return point.renderer == PointRenderer::rays && point.gradients == GradientSource::onTheFly &&
         point.imageScale == 1.0;
}

Quality qualityAt(const OperatingPoint& point, const Scene& scene, double steepestPerMm) {
  if (point.toleranceLevels) {
    Quality quality = scene.quality;
    quality.jitter = false;
    quality.toleranceLevels = point.toleranceLevels;
    quality.fineness.reset();
    return quality;
  }
  Scene drawn = withStep(scene, point.stepVoxels);
  drawn.quality.earlyTermination = point.earlyTermination;
  if (pointOf(drawn, steepestPerMm) != point)
    drawn.quality.preintegrated = point.preintegrated ? Preintegration::always : Preintegration::never;
  return drawn.quality;
}

bool holdsFor(const Scene& measured, const Scene& shown) {
  return contentOf(measured) == contentOf(shown);
}

std::optional<double> levelsMeasuredOf(const Scene& shown, const MeasuredAccuracy& measured) {
  const ReferenceFacts& reference = measured.report.reference;
  if (!reference.converged || !holdsFor(measured.scene, shown) || measured.scene.camera != shown.camera)
    return std::nullopt;
  const std::optional<OperatingPoint> point = pointOf(shown, measured.steepestPerMm);
  const std::optional<std::size_t> index = point ? indexOf(*point, measured.report.points) : std::nullopt;
  if (!index)
    return std::nullopt;
  return std::max(measured.report.points[*index].error.p99_9, leastP99_9(reference));
}

std::optional<std::size_t> indexOf(const OperatingPoint& point, const std::vector<MeasuredPoint>& points) {
  const auto found = std::find_if(points.begin(), points.end(),
                                  [&](const MeasuredPoint& measured) { return measured.point == point; });
  if (found == points.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - points.begin());
}

} // namespace limn
