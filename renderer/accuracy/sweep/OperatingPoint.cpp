// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/OperatingPoint.h"

#include <cmath>
#include <cstdio>

namespace limn {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

const char* methodOf(Engine engine) {
  switch (engine) {
  case Engine::rayCaster:
  case Engine::cpu:
    return "rays";
  case Engine::slices:
  case Engine::slicesBackToFront:
    return "slices";
  case Engine::reference:
    break;
  }
  return "double precision";
}

bool isTwiceAsCoarse(const OperatingPoint& before, const OperatingPoint& after) {
  return after.paths ? before.paths && *after.paths == 2 * *before.paths
                     : before.stepVoxels == 2.0 * after.stepVoxels;
}

// Whether `other` makes a point needless.
bool beats(const MeasuredPoint& other, const MeasuredPoint& point) {
  const bool isNoWorse = other.error.p99_9 <= point.error.p99_9 && other.ms.median <= point.ms.median;
  const bool isBetter = other.error.p99_9 < point.error.p99_9 || other.ms.median < point.ms.median;
  return isNoWorse && isBetter;
}

} // namespace

Scene atPoint(Scene scene, const OperatingPoint& point) {
  scene.quality.stepVoxels = point.stepVoxels;
  scene.quality.preintegrated = point.preintegrated ? Preintegration::always : Preintegration::never;
  scene.quality.earlyTermination = point.earlyTermination;
  scene.quality.jitter = false;
  scene.quality.toleranceLevels = point.toleranceLevels;
  scene.quality.fineness.reset();
  scene.quality.ownWeights = false;
  scene.quality.paths = point.paths;
  return scene;
}

std::string familyOf(const OperatingPoint& point) {
  if (!point.rival.empty())
    return point.rival == "vtk-gpu"          ? "VTK's GPU mapper"
           : point.rival == "vtk-fixedpoint" ? "VTK's fixed-point caster"
                                             : point.rival;
  if (point.paths)
    return "random paths";
  std::string family = methodOf(point.engine);
  if (point.toleranceLevels)
    family += ", error-controlled";
  if (point.preintegrated)
    family += ", pre-integrated";
  if (point.gradients == GradientSource::precomputed)
    family += ", stored gradients";
  if (point.earlyTermination != 0.998)
    family +=
        point.earlyTermination < 1.0 ? ", ends at " + number(point.earlyTermination) : ", never ends early";
  if (point.imageScale != 1.0)
    family += ", " + number(100.0 * point.imageScale) + " % of the pixels each way";
  return family;
}

std::string stepOf(const OperatingPoint& point) {
  if (point.paths)
    return std::to_string(*point.paths) + (*point.paths == 1 ? " path" : " paths");
  if (point.toleranceLevels)
    return "within " + number(*point.toleranceLevels) +
           (*point.toleranceLevels == 1.0 ? " level" : " levels");
  const double parts = 1.0 / point.stepVoxels;
  if (parts > 1.0 && parts == std::floor(parts))
    return "step 1/" + number(parts);
  return "step " + number(point.stepVoxels);
}

void markPareto(std::vector<MeasuredPoint>& points) {
  for (MeasuredPoint& point : points) {
    point.isPareto = true;
    for (const MeasuredPoint& other : points)
      point.isPareto = point.isPareto && !beats(other, point);
  }
}

void findOrders(std::vector<MeasuredPoint>& points) {
  for (MeasuredPoint& point : points)
    for (const MeasuredPoint& coarser : points)
      if (!point.point.toleranceLevels && familyOf(coarser.point) == familyOf(point.point) &&
          isTwiceAsCoarse(coarser.point, point.point) && point.error.mean > 0.0 && coarser.error.mean > 0.0)
        point.order = std::log2(coarser.error.mean / point.error.mean);
}

const MeasuredPoint* fastestWithin(const std::vector<MeasuredPoint>& points, double levels) {
  const MeasuredPoint* best = nullptr;
  for (const MeasuredPoint& point : points)
    if (point.error.p99_9 <= levels && (!best || point.ms.median < best->ms.median))
      best = &point;
  return best;
}

const MeasuredPoint* mostAccurateWithin(const std::vector<MeasuredPoint>& points, double ms) {
  const MeasuredPoint* best = nullptr;
  for (const MeasuredPoint& point : points)
    if (point.ms.median <= ms && (!best || point.error.p99_9 < best->error.p99_9))
      best = &point;
  return best;
}

} // namespace limn
