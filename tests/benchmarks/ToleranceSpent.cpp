// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a tolerance is spent, and what finding its steps costs: for each volume, its best-fitting
// preset, classic and enhanced, at 1 and at half a level, 512², drawn by the CPU engine on all threads. The
// error is that to a picture four rungs finer, whose own is a sixteenth.
//
// limn_tolerance_spent VOLUME...
#include "accuracy/ImageError.h"
#include "accuracy/Tolerance.h"
#include "cpu/CpuRenderer.h"
#include "io/VolumeReader.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "scene/light/Shading.h"
#include "scene/presets/PresetFit.h"
#include "scene/steps/LocalSteps.h"
#include "support/Places.h"

#include <chrono>
#include <cstdio>

namespace limn {
namespace {

constexpr glm::ivec2 size(512, 512);

double now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(time).count();
}

std::vector<Preset> builtInPresets() {
  std::vector<Preset> all;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::sourceFolder() / "app/core/sources/presets"))
    if (entry.path().extension() == ".json")
      all.push_back(parsePreset(readTextFile(entry.path()), entry.path().filename().string()));
  return all;
}

void measure(const std::string& name, const Scene& scene) {
  CpuRenderer renderer;
  const DrawScene draw = [&](const Scene& drawn, const glm::ivec2& pixels) {
    return renderer.render(drawn, pixels);
  };
  draw(scene, glm::ivec2(64)); // what is made once for a volume
  const double start = now();
  const WithinTolerance found = withinTolerance(scene, size, draw, StepControl::cells);
  const double searched = now();
  const Image picture = draw(found.scene, size);
  const double drawn = now();
  Scene finer = found.scene;
  finer.quality.fineness = *finer.quality.fineness + 8.0;
  finer.quality.earlyTermination = 1.0;
  const double error = imageError(picture, draw(finer, size)).p99_9;
  const double tolerance = *scene.quality.toleranceLevels;
  std::printf("%s, %s, %g: %s; true error %.3f, %.2f of it; search %.0f ms, picture %.0f ms, %.2f\n",
              name.c_str(), nameOf(scene.shading.model), tolerance, describe(found).english().c_str(), error,
              error / tolerance, searched - start, drawn - searched, (searched - start) / (drawn - searched));
}

void measureAll(const char* path) {
  Scene scene;
  scene.volume = readVolume(path);
  scene.camera = defaultCamera(scene.volume->grid());
  scene = withPreset(scene, bestFitting(builtInPresets(), *scene.volume), true);
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced})
    for (const double levels : {1.0, 0.5}) {
      scene.shading.model = model;
      scene.quality.toleranceLevels = levels;
      measure(std::filesystem::path(path).filename().string(), scene);
    }
}

} // namespace
} // namespace limn

int main(int count, char** arguments) {
  try {
    for (int i = 1; i < count; ++i)
      limn::measureAll(arguments[i]);
  } catch (const limn::Error& error) {
    std::fprintf(stderr, "limn_tolerance_spent: %s\n", error.what());
    return 1;
  }
}
