// SPDX-License-Identifier: GPL-3.0-or-later
// What an error costs in evaluations a ray, whoever draws: cell by cell, in local steps and in equal ones, by
// the reference in double, for every lighting model. The error is the 99.9th percentile against the picture
// cell by cell with the finest fineness, whose own is a thousandth of the smallest told; the evaluations of
// an error lie on the line between two pictures in logarithms.
//
// limn_error_by_evaluations PIXELS VOLUME PRESET.json [VOLUME PRESET.json ...]
#include "accuracy/ImageError.h"
#include "io/VolumeReader.h"
#include "io/scenefile/SceneFile.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "scene/light/Shading.h"
#include "scene/presets/PresetFit.h"
#include "scene/steps/LocalSteps.h"
#include "scene/volume/Histogram.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace limn {
namespace {

constexpr double toldErrors[] = {8.0, 4.0, 2.0, 1.0, 0.5, 0.1, 0.05};
constexpr double enough = 0.04;

struct Cost {
  double error = 0.0;       // levels, 99.9th percentile
  double evaluations = 0.0; // mean of the rays that meet something
};

Cost costOf(const ReferencePicture& picture, const std::vector<glm::dvec4>& exact) {
  double sum = 0.0, rays = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    if (exact[i].a >= 1.0 / 510.0) {
      sum += picture.samples[i];
      rays += 1.0;
    }
  return {imageError(picture.pixels, exact).p99_9, sum / std::max(rays, 1.0)};
}

// The evaluations of an error, between the two pictures whose errors enclose it; not a number beyond them.
double evaluationsFor(const std::vector<Cost>& costs, double error) {
  for (std::size_t i = 0; i + 1 < costs.size(); ++i) {
    const Cost &coarse = costs[i], &fine = costs[i + 1];
    if (coarse.error < error || fine.error > error || !(fine.error > 0.0) || coarse.error == fine.error)
      continue;
    const double w = std::log(coarse.error / error) / std::log(coarse.error / fine.error);
    return std::exp(std::lerp(std::log(coarse.evaluations), std::log(fine.evaluations), w));
  }
  return std::nan("");
}

// Of the line through errors of 8 to 0.05 level by least squares, logarithm over logarithm.
double slopeOf(const std::vector<Cost>& costs) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const double error : toldErrors) {
    const double evaluations = evaluationsFor(costs, error);
    if (std::isnan(evaluations))
      continue;
    const double u = std::log(evaluations), v = std::log(error);
    n += 1.0, x += u, y += v, xx += u * u, xy += u * v;
  }
  return n < 3.0 ? std::nan("") : (n * xy - x * y) / (n * xx - x * x);
}

void tell(const char* way, const std::vector<Cost>& costs) {
  std::printf("| %s |", way);
  for (const double error : toldErrors) {
    const double evaluations = evaluationsFor(costs, error);
    std::isnan(evaluations) ? std::printf(" – |") : std::printf(" %.0f |", evaluations);
  }
  std::printf(" %.2f |\n", slopeOf(costs));
  std::fflush(stdout);
}

void measure(const Scene& base, const glm::ivec2& size) {
  Scene scene = base;
  const auto draw = [&](ToTolerance way) {
    return renderReference(scene, size, 0, {}, Limiting::clampOrKnee, {}, way);
  };
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = Fineness::most - 4.0;
  const std::vector<glm::dvec4> exact = draw(ToTolerance::byCells).pixels;
  for (const ToTolerance way : {ToTolerance::byCells, ToTolerance::byLocalSteps}) {
    std::vector<Cost> costs;
    for (double fineness = 0.0; fineness <= 14.0; fineness += 1.0) {
      scene.quality.fineness = fineness;
      costs.push_back(costOf(draw(way), exact));
      if (costs.back().error < enough)
        break;
    }
    tell(way == ToTolerance::byCells ? "cell by cell" : "local steps", costs);
  }
  scene.quality.toleranceLevels.reset();
  scene.quality.fineness.reset();
  std::vector<Cost> costs;
  for (double step = 2.0; step >= 1.0 / 64.0; step /= 2.0) {
    scene.quality.stepVoxels = step;
    costs.push_back(costOf(draw(ToTolerance::byCells), exact));
    if (costs.back().error < enough)
      break;
  }
  tell("equal steps", costs);
}

void measureAll(const char* volume, const char* preset, const glm::ivec2& size) {
  Scene scene;
  scene.volume = readVolume(volume);
  scene.camera = defaultCamera(scene.volume->grid());
  const Preset look = parsePreset(readTextFile(preset), preset);
  scene = withPreset(scene, fittedTo(look, histogramOf(*scene.volume), scene.volume->grid()));
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.earlyTermination = 1.0;
  for (const ShadingModel model : localModels) {
    scene.shading.model = model;
    std::printf("\n%s, %s, %s\n", std::filesystem::path(volume).filename().string().c_str(),
                look.name.c_str(), nameOf(model));
    std::printf("| way | 8 | 4 | 2 | 1 | 0.5 | 0.1 | 0.05 level | slope |\n");
    measure(scene, size);
  }
}

} // namespace
} // namespace limn

int main(int count, char** arguments) {
  try {
    const int pixels = count > 1 ? std::atoi(arguments[1]) : 0;
    if (pixels < 1 || count < 4 || count % 2 != 0) {
      std::fprintf(stderr, "limn_error_by_evaluations PIXELS VOLUME PRESET.json [VOLUME PRESET.json ...]\n");
      return 2;
    }
    for (int i = 2; i + 1 < count; i += 2)
      limn::measureAll(arguments[i], arguments[i + 1], glm::ivec2(pixels));
  } catch (const limn::Error& error) {
    std::fprintf(stderr, "limn_error_by_evaluations: %s\n", error.what());
    return 1;
  }
}
