// SPDX-License-Identifier: GPL-3.0-or-later
// What slices cost beside the ray caster: processor time of one picture of each in turn, and their ratio.
// Held fixed: 384², default camera, the same scene and step. The ray caster as it is, and with early
// termination and empty-space skipping off, which slices cannot do: the price of blending alone. One warm-up,
// then five turns; medians of the processor time of all cores, which other programs on the machine disturb
// least on a software driver; on a GPU read the wall time. Not part of the test command.
#include "gl/HeadlessContext.h"
#include "raycaster/RayCaster.h"
#include "scene/volume/Phantom.h"
#include "slices/SliceRenderer.h"
#include "support/Heads.h"
#include "support/TestData.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>

namespace limn {
namespace {

constexpr glm::ivec2 pictureSize{384, 384};
constexpr int turns = 5;

struct Times {
  std::vector<double> wallMs;
  std::vector<double> coresMs;
};

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void measure(const std::function<void()>& work, Times& times) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t before = std::clock();
  work();
  times.coresMs.push_back(1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  times.wallMs.push_back(
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
}

void compare(const char* what, Scene scene) {
  scene.quality.earlyTermination = Quality{}.earlyTermination;
  scene.quality.preintegrated = Preintegration::never;
  Scene whole = scene;
  whole.quality.earlyTermination = 1.0;
  RayCaster caster;
  RayCaster plain(RayCaster::EmptySpace::sampled);
  SliceRenderer forwards(BlendOrder::frontToBack);
  SliceRenderer backwards(BlendOrder::backToFront);
  struct Row {
    const char* name;
    std::function<void()> work;
    Times times;
  };
  std::array<Row, 4> rows{{{"ray caster", [&] { caster.render(scene, pictureSize); }, {}},
                           {"ray caster, every sample", [&] { plain.render(whole, pictureSize); }, {}},
                           {"slices, front to back", [&] { forwards.render(scene, pictureSize); }, {}},
                           {"slices, back to front", [&] { backwards.render(scene, pictureSize); }, {}}}};
  for (Row& row : rows)
    row.work();
  for (int turn = 0; turn < turns; ++turn)
    for (Row& row : rows)
      measure(row.work, row.times);
  const double unit = medianOf(rows[0].times.coresMs);
  std::printf("%s\n", what);
  for (const Row& row : rows)
    std::printf("  %-26s %8.0f ms of cores, %8.0f ms wall, ratio %5.2f\n", row.name,
                medianOf(row.times.coresMs), medianOf(row.times.wallMs), medianOf(row.times.coresMs) / unit);
}

} // namespace
} // namespace limn

int main() {
  using namespace limn;
  const HeadlessContext context;
  const bool isReal = std::filesystem::exists(test::sharedFolder() / test::ctHeadFile);
  const auto volume = isReal ? test::ctHead() : phantomVolume({.spacingMm = 1.0});
  std::printf("%s, %s, %d x %d\n", rendererName().c_str(), isReal ? "CT head" : "phantom", pictureSize.x,
              pictureSize.y);
  for (const double step : {1.0, 0.5}) {
    char what[80];
    Scene scene = test::headScene(volume, ShadingModel::classic);
    scene.quality.stepVoxels = step;
    std::snprintf(what, sizeof(what), "skin, muscle and bone, classic, step %.1f", step);
    compare(what, scene);
    scene.transferFunction = test::boneOnly();
    scene.shading.model = ShadingModel::enhanced;
    std::snprintf(what, sizeof(what), "bone, enhanced, step %.1f", step);
    compare(what, scene);
  }
}
