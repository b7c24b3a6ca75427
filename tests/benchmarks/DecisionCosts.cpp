// SPDX-License-Identifier: GPL-3.0-or-later
// What each decision about accuracy costs, isolated one at a time: the table behind the program's defaults.
// Held fixed: 512 x 512, default camera, a built-in preset at the scene's own step, enhanced unless `classic`
// is asked for; errors in 8-bit levels against the converged picture of the reference. Not part of the test
// command.
//   limn_decision_costs VOLUME PRESET [classic]
#include "accuracy/sweep/ConvergedPicture.h"
#include "accuracy/sweep/FigureText.h"
#include "app/lab/accuracy/MeasureDecisions.h"
#include "app/presets/PresetStore.h"
#include "gl/HeadlessContext.h"
#include "io/VolumeReader.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Histogram.h"

#include <cstdio>

namespace limn {
namespace {

constexpr glm::ivec2 size{512, 512};

Scene sceneOf(const char* path, const std::string& name, ShadingModel model) {
  Scene scene;
  scene.volume = readVolume(path);
  scene.camera = defaultCamera(scene.volume->grid());
  for (const Preset& preset : builtInPresets())
    if (preset.name == name)
      scene = withPreset(scene, fittedTo(preset, histogramOf(*scene.volume), scene.volume->grid()));
  scene.shading.model = model;
  return scene;
}

void drawPrecisely(const Scene& scene, const glm::ivec2& pictureSize, const std::vector<std::uint8_t>& wanted,
                   PrecisePixels& pixels) {
  ReferencePicture picture{pictureSize, std::move(pixels), std::vector<int>(wanted.size())};
  redrawReference(picture, scene, wanted);
  pixels = std::move(picture.pixels);
}

void print(const DecisionCost& cost) {
  std::printf("%-20s %-40s %c %7.3f %7.2f %7.4f %7.2f %8.1f %5.2f %6.1f %s\n", cost.group.c_str(),
              cost.name.c_str(), cost.isDefault ? '*' : ' ', cost.error.mean, cost.error.p99_9,
              cost.fineError.mean, cost.fineError.p99_9, cost.ms.median, cost.timesDefault, cost.extraMb,
              cost.remark.c_str());
  std::fflush(stdout);
}

} // namespace
} // namespace limn

int main(int argc, char** argv) {
  using namespace limn;
  if (argc < 3)
    return 1;
  const bool isClassic = argc > 3 && std::string(argv[3]) == "classic";
  const HeadlessContext context;
  const Scene scene = sceneOf(argv[1], argv[2], isClassic ? ShadingModel::classic : ShadingModel::enhanced);
  const ConvergedPicture exact = convergedPicture(scene, size, drawPrecisely);
  std::printf("%s, %s, step %g; converged at %g voxel, last change %.3f (99.9th percentile), mean %.4f\n",
              rendererName().c_str(), argv[2], scene.quality.stepVoxels, exact.facts.stepVoxels,
              exact.facts.lastChangeLevels, exact.facts.lastMeanChange);
  std::printf("%-63s %7s %7s %7s %7s %8s %5s %6s\n", "* the program's own", "mean", "p99.9", "m 1/8", "p 1/8",
              "ms", "times", "MB");
  const std::vector<DecisionCost> costs = measureDecisions(scene, size, exact.pixels);
  for (const DecisionCost& cost : costs)
    print(cost);
  for (const std::string& sentence : verdictOn(costs))
    std::printf("%s\n", sentence.c_str());
}
