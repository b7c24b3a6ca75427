// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/AccuracySamples.h"

#include <cmath>

namespace limn {
namespace {

// Of error and time beside plain rays.
struct Factors {
  double error = 1.0;
  double time = 1.0;
  double leastError = 0.0;
};

Factors factorsOf(const OperatingPoint& point) {
  if (point.engine == Engine::reference)
    return {1.0, 60.0, 0.0};
  if (point.engine == Engine::slices)
    return {2.2, 2.4, 0.05};
  if (point.preintegrated)
    return {0.45, 1.5, 0.0};
  if (point.gradients == GradientSource::precomputed)
    return {1.1, 0.7, 0.35};
  if (point.earlyTermination < 0.99)
    return {1.0, 0.93, 3.0};
  if (point.imageScale < 1.0)
    return {1.0, 0.3, 9.0};
  return {1.0, point.earlyTermination == 1.0 ? 1.25 : 1.0, 0.0};
}

} // namespace

AccuracyReport sampleReport(const std::vector<OperatingPoint>& points) {
  AccuracyReport report;
  report.scene = "Sample head";
  report.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
  report.machine = "2 cores";
  report.size = {512, 384};
  report.reference = {true, 1.0 / 256.0, 0.004, 0.0002};
  for (const OperatingPoint& point : points) {
    const Factors factors = factorsOf(point);
    MeasuredPoint measured;
    measured.point = point;
    double levels = factors.leastError + factors.error * 10.4 * point.stepVoxels * point.stepVoxels;
    double ms = factors.time * (12.0 + 9.0 / point.stepVoxels);
    if (point.toleranceLevels) {
      levels = 0.8 * *point.toleranceLevels;
      ms = 30.0 + 20.0 / *point.toleranceLevels;
    }
    measured.error = {6.0 * levels, levels, 0.05 * levels, 0.2 * levels, 0.01 * levels};
    measured.ms = {ms, 0.95 * ms, 1.1 * ms};
    report.points.push_back(measured);
  }
  findOrders(report.points);
  markPareto(report.points);
  return report;
}

AccuracyReport samplePathReport() {
  AccuracyReport report;
  report.scene = "Sample head";
  report.renderer = "CPU engine (AVX2, 2 threads)";
  report.machine = "2 cores";
  report.size = {224, 168};
  report.reference.converged = report.reference.isByChance = true;
  for (int paths = 4; paths <= 128; paths *= 2) {
    MeasuredPoint measured;
    measured.point.paths = paths;
    const double levels = (paths == 4 ? 88.0 : 80.0) / std::sqrt(paths);
    const double ms = 50.0 * paths;
    measured.error = {2.0 * levels, levels, 0.2 * levels, 0.3 * levels, 0.1};
    measured.ms = {ms, ms, ms};
    report.points.push_back(measured);
  }
  findOrders(report.points);
  markPareto(report.points);
  return report;
}

} // namespace limn
