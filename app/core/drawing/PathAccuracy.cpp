// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/PathAccuracy.h"

#include "accuracy/sweep/FigureText.h"
#include "app/core/drawing/ProcessCost.h"
#include "cpu/CpuRenderer.h"

#include <algorithm>

namespace limn {
namespace {

constexpr int fewestPathsMeasured = 4;

ImageError errorOf(const PathFigures& figures) {
  ImageError error;
  error.rms = figures.rmsLevels.value_or(0.0);
  error.p99_9 = figures.p99_9Levels.value_or(0.0);
  error.mean = figures.meanLevels;
  error.largest = figures.largestLevels;
  error.shareOverOne = figures.shareOverOne;
  return error;
}

Scene withPaths(Scene scene, int paths) {
  scene.quality.paths = paths;
  return scene;
}

} // namespace

AccuracyReport measurePaths(const std::string& name, const Scene& scene, const glm::ivec2& size,
                            int mostPathsMeasured, const Effort& effort, const ReportProgress& progress) {
  CpuRenderer renderer(effort.threads);
  renderer.makeReady(scene, {effort.threads, effort.isCancelled, {}});
  AccuracyReport report;
  report.scene = name;
  report.renderer = renderer.name();
  report.machine = machineName();
  report.size = size;
  report.smallestSpacingMm = smallestSpacingMm(scene.volume->grid());
  report.reference.converged = report.reference.isByChance = true;
  double ms = 0.0;
  for (int paths = fewestPathsMeasured; paths <= mostPathsMeasured; paths *= 2) {
    if (progress)
      progress(double(paths / 2) / mostPathsMeasured, Message::tr("Following %1 paths a pixel").arg(paths));
    const Scene pass = withPaths(scene, paths);
    ms += costOf([&] { renderer.draw(pass, size, {{0, 0}, size}, effort.isCancelled); }).ms;
    MeasuredPoint point;
    point.point.paths = paths;
    point.point.stepVoxels = scene.quality.stepVoxels;
    point.error = errorOf(*renderer.pathFigures(pass, size));
    point.ms = {ms, ms, ms};
    report.points.push_back(point);
  }
  for (MeasuredPoint& point : report.points)
    point.peakMb = renderer.memoryMb();
  findOrders(report.points);
  markPareto(report.points);
  if (const Message law = lawOfPaths(report.points); !law.empty())
    report.remarks.push_back(law.english());
  return report;
}

PathErrors pathErrors(const Scene& scene, const glm::ivec2& size, const Effort& effort) {
  CpuRenderer renderer(effort.threads);
  renderer.draw(scene, size, {{0, 0}, size}, effort.isCancelled);
  return {errorOf(*renderer.pathFigures(scene, size)), {size, renderer.pathErrors(scene, size)}};
}

} // namespace limn
