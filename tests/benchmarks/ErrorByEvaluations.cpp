// SPDX-License-Identifier: GPL-3.0-or-later
// What an error costs in evaluations a ray, whoever draws: cell by cell, in local steps and, where asked for
// (they take minutes), in equal ones, by the reference in double, for every lighting model. Looks are
// presets, fitted to the volume, or scenes, whose own volume is not asked for. Both figures repeat to the bit
// on any machine.
//
// limn_error_by_evaluations PIXELS [--equal] VOLUME LOOK.json [VOLUME LOOK.json ...]
#include "accuracy/EvaluationCosts.h"
#include "io/VolumeReader.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "scene/light/Shading.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Histogram.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace limn {
namespace {

void tell(const std::string& what, const char* way, const std::vector<test::EvaluationCost>& costs) {
  std::printf("| %s | %s |", what.c_str(), way);
  for (const double error : test::toldErrors) {
    const double evaluations = test::evaluationsFor(costs, error);
    std::isnan(evaluations) ? std::printf(" |") : std::printf(" %.0f |", evaluations);
  }
  const double slope = test::slopeOf(costs);
  std::isnan(slope) ? std::printf(" |") : std::printf(" %.1f |", slope);
  std::printf(" %.2f for %.0f |\n", costs.front().error, costs.front().evaluations);
  std::fflush(stdout);
}

Scene looking(const std::string& volume, const std::string& look) {
  Scene scene;
  const std::string text = readTextFile(look);
  if (looksLikeScene(text)) {
    scene = parseScene(text, look).scene;
    scene.volume = readVolume(volume);
    scene.camera = defaultCamera(scene.volume->grid());
    return scene;
  }
  scene.volume = readVolume(volume);
  scene.camera = defaultCamera(scene.volume->grid());
  return withPreset(scene,
                    fittedTo(parsePreset(text, look), histogramOf(*scene.volume), scene.volume->grid()));
}

void measure(const std::string& volume, const std::string& look, const glm::ivec2& size, bool isEqualToo) {
  Scene scene = looking(volume, look);
  const std::string name = std::filesystem::path(look).stem().string();
  for (const ShadingModel model : localModels) {
    scene.shading.model = model;
    const std::vector<glm::dvec4> exact = test::exactByCells(scene, size);
    const std::string what = name + ", " + nameOf(model);
    using test::EvaluationWay;
    tell(what, "cells", test::evaluationCosts(scene, size, EvaluationWay::cells, exact));
    tell("", "local steps", test::evaluationCosts(scene, size, EvaluationWay::localSteps, exact));
    if (isEqualToo)
      tell("", "equal steps", test::evaluationCosts(scene, size, EvaluationWay::equalSteps, exact));
  }
}

} // namespace
} // namespace limn

int main(int count, char** arguments) {
  try {
    const int pixels = count > 1 ? std::atoi(arguments[1]) : 0;
    const bool isEqualToo = count > 2 && std::string(arguments[2]) == "--equal";
    const int first = isEqualToo ? 3 : 2;
    if (pixels < 1 || count < first + 2 || (count - first) % 2 != 0) {
      std::fprintf(stderr,
                   "limn_error_by_evaluations PIXELS [--equal] VOLUME LOOK.json [VOLUME LOOK.json ...]\n");
      return 2;
    }
    std::printf("| scene | way |");
    for (const double error : limn::test::toldErrors)
      std::printf(" %g |", error);
    std::printf(" slope | coarsest |\n");
    for (int i = first; i + 1 < count; i += 2)
      limn::measure(arguments[i], arguments[i + 1], glm::ivec2(pixels), isEqualToo);
  } catch (const limn::Error& error) {
    std::fprintf(stderr, "limn_error_by_evaluations: %s\n", error.what());
    return 1;
  }
}
