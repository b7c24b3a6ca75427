// SPDX-License-Identifier: GPL-3.0-or-later
// What error-controlled steps gain: the time of a picture that is within one level of the converged one, in
// error-controlled and in equal steps. Held fixed: volume, preset, model, default camera, size, early
// termination at 1/8 level, no pre-integration. Times are of the whole process (every thread of a software
// driver), the least of five pictures after one that is not counted; errors do not depend on the machine.
//
// limn_local_step_gain VOLUME PRESET.json classic|enhanced|robust|none [SIZE]
#include "accuracy/sweep/ConvergedPicture.h"
#include "gl/HeadlessContext.h"
#include "io/VolumeReader.h"
#include "io/scenefile/SceneFile.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "scene/light/Shading.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Histogram.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <numeric>

namespace limn {
namespace {

struct Measured {
  double p99_9 = 0.0;
  double ms = 0.0;
};

double processMs() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Measured measured(RayCaster& caster, const Scene& scene, const glm::ivec2& size, const PrecisePixels& exact,
                  const char* what, double value) {
  const ImageError error = imageError(caster.render(scene, size), exact);
  double least = 1e30;
  for (int i = 0; i < 5; ++i) {
    const double start = processMs();
    caster.render(scene, size);
    least = std::min(least, processMs() - start);
  }
  const std::vector<int> samples = caster.sampleCounts(scene, size);
  std::printf("%-10s %-8.4g p99.9 %7.3f  mean %7.4f  largest %7.2f  %8.1f ms  %7.1f samples a pixel\n", what,
              value, error.p99_9, error.mean, error.largest, least,
              std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size()));
  return {error.p99_9, least};
}

// Where a curve from coarse to fine last comes below one level, by interpolation between logarithms.
double msAtOneLevel(const std::vector<Measured>& curve) {
  for (std::size_t i = curve.size() - 1; i > 0; --i) {
    const Measured& fine = curve[i];
    const Measured& coarse = curve[i - 1];
    if (coarse.p99_9 <= 1.0 || fine.p99_9 > 1.0)
      continue;
    const double w = std::log(coarse.p99_9) / std::log(coarse.p99_9 / fine.p99_9);
    return std::exp(std::lerp(std::log(coarse.ms), std::log(fine.ms), w));
  }
  return std::nan("");
}

Scene sceneOf(const char* volume, const char* preset, const std::string& model) {
  std::map<std::string, ShadingModel> models;
  for (const ShadingModel one : localModels)
    models.emplace(nameOf(one), one);
  Scene scene;
  scene.volume = readVolume(volume);
  scene.camera = defaultCamera(scene.volume->grid());
  scene = withPreset(scene, fittedTo(parsePreset(readTextFile(preset), preset), histogramOf(*scene.volume),
                                     scene.volume->grid()));
  scene.shading.model = models.at(model);
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.earlyTermination = 1.0 - 0.125 / 255.0;
  return scene;
}

void redraw(const Scene& scene, const glm::ivec2& size, const std::vector<std::uint8_t>& wanted,
            PrecisePixels& pixels) {
  ReferencePicture picture{size, std::move(pixels), std::vector<int>(wanted.size(), 0)};
  redrawReference(picture, scene, wanted);
  pixels = std::move(picture.pixels);
}

void run(const Scene& base, const glm::ivec2& size) {
  const ConvergedPicture exact = convergedPicture(base, size, redraw);
  std::printf("converged: %s, last change %.3f levels\n", exact.facts.converged ? "yes" : "no",
              exact.facts.lastChangeLevels);
  const HeadlessContext context;
  RayCaster caster;
  std::vector<Measured> equal;
  for (int k = 2; k <= 10; ++k) {
    Scene scene = base;
    scene.quality.stepVoxels = std::exp2(-0.5 * k);
    equal.push_back(measured(caster, scene, size, exact.pixels, "step", scene.quality.stepVoxels));
  }
  std::vector<Measured> local;
  for (int fineness = 1; fineness <= 8; ++fineness) {
    Scene scene = base;
    scene.quality.toleranceLevels = 1.0;
    scene.quality.fineness = fineness;
    local.push_back(measured(caster, scene, size, exact.pixels, "fineness", fineness));
  }
  std::printf("at one level: %.0f ms in equal steps, %.0f ms in error-controlled ones: %.2f times\n",
              msAtOneLevel(equal), msAtOneLevel(local), msAtOneLevel(equal) / msAtOneLevel(local));
}

} // namespace
} // namespace limn

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: %s VOLUME PRESET.json MODEL [SIZE]\n", argv[0]);
    return 2;
  }
  try {
    const int size = argc > 4 ? std::atoi(argv[4]) : 256;
    limn::run(limn::sceneOf(argv[1], argv[2], argv[3]), {size, size});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
