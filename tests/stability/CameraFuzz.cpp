// SPDX-License-Identifier: GPL-3.0-or-later
#include "CameraFuzz.h"

#include "scene/steps/RayFrame.h"
#include "stability/scenes/RandomScene.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace limn::test {
namespace {

bool isFinite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isFinite(const RayFrame& frame) {
  return isFinite(frame.anchor) && isFinite(frame.anchorX) && isFinite(frame.anchorY) &&
         isFinite(frame.direction) && isFinite(frame.directionX) && isFinite(frame.directionY) &&
         std::isfinite(frame.tangentPerPixel) && std::isfinite(frame.anchorDistanceMm);
}

// What is wrong with a camera's rays; empty where nothing is.
std::string problemOf(Dice& dice, const Grid& grid, const Camera& camera, CameraFuzzReport& report) {
  const glm::ivec2 size(1 + dice.upTo(64), 1 + dice.upTo(64));
  const RayFrame frame = rayFrame(camera, grid, size);
  if (!isFinite(frame))
    return "a ray is not finite";
  const double step = smallestSpacingMm(grid) * dice.octaves(-20, 20);
  for (int ray = 0; ray < 8; ++ray) {
    const FramedRay framed = framedRay(frame, dice.upTo(size.x), dice.upTo(size.y), size);
    const RaySpan span = spanInBox(framed, croppedBox(grid, CropBox{}));
    ++report.rays;
    if (span.isEmpty())
      continue;
    ++report.hits;
    const int samples = sampleCount(span.end - span.begin, step);
    report.mostSamples = std::max(report.mostSamples, samples);
    if (!std::isfinite(span.begin) || !std::isfinite(span.end) || span.begin < framed.eye)
      return "the part of a ray in the box is not finite or begins behind the eye";
    if (samples < 1 || samples > mostSamples)
      return "a ray takes " + std::to_string(samples) + " samples";
  }
  return {};
}

} // namespace

CameraFuzzReport fuzzCameras(int cameras, std::uint64_t firstSeed) {
  CameraFuzzReport report;
  const auto start = std::chrono::steady_clock::now();
  for (; report.cameras < cameras && report.firstFailure.empty(); ++report.cameras) {
    Dice dice(firstSeed + static_cast<std::uint64_t>(report.cameras));
    const Grid grid = randomGrid(dice);
    const RandomCamera random = randomCamera(dice, grid);
    const std::string problem = problemOf(dice, grid, random.camera, report);
    if (!problem.empty())
      report.firstFailure = "Camera " +
                            std::to_string(firstSeed + static_cast<std::uint64_t>(report.cameras)) + " (" +
                            random.description + "): " + problem + ".";
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

} // namespace limn::test
