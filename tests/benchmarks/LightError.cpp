// SPDX-License-Identifier: GPL-3.0-or-later
// How far pictures whose light is found along few paths, or looked up on nodes, lie from those whose light is
// found along a thousand (which lie within a level of the reference, CpuTravellingLight.found*): volumes with
// scene files of their own, each under three lights from above left (shadows of 5° softness, occlusion of
// 15 mm, both), drawn by the CPU engine on all threads. Told are errors in levels and times of the processor,
// at rest (spread), while something moves (moving), and on fine and coarse nodes: of finding these, and of a
// picture beside one without light on its way. Held fixed: a view from a little aside of the whole grid,
// 160², steps of half a voxel, no pre-integration.
//
// limn_light_error VOLUME SCENE [VOLUME SCENE]...
#include "accuracy/ImageError.h"
#include "cpu/CpuRenderer.h"
#include "io/VolumeReader.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "support/TravellingScenes.h"

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>

namespace limn {
namespace {

constexpr glm::ivec2 size(160, 160);

struct Detail {
  LightDetail light;
  const char* name;
};
constexpr Detail details[] = {{LightDetail::spread, "spread"},
                              {LightDetail::moving, "moving"},
                              {LightDetail::fine, "fine"},
                              {LightDetail::coarse, "coarse"}};

double processorMs(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

Scene sceneOf(const char* volume, const char* file) {
  Scene scene = readSceneFile(file).scene;
  scene.volume = readVolume(volume);
  scene.camera = orbited(defaultCamera(scene.volume->grid()), 0.5, 0.3);
  scene.shading.lightDirection = glm::dvec3(0.6, -0.7, 1.0);
  scene.shading.lightAxes = LightAxes::camera;
  scene.shading.shadow = {0.85, 5.0};
  scene.shading.occlusion = {0.8, 15.0};
  scene.quality.stepVoxels = 0.5;
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

void measure(const char* what, Scene scene) {
  scene.quality.light = LightDetail::sampled;
  const Image exact = CpuRenderer().render(scene, size);
  for (const Detail& detail : details) {
    scene.quality.light = detail.light;
    const Scene plain = test::withoutTravel(scene);
    CpuRenderer renderer;
    renderer.render(plain, size);
    const double plainMs = processorMs([&] { renderer.render(plain, size); });
    const double firstMs = processorMs([&] { renderer.render(scene, size); });
    Image image;
    const double againMs = processorMs([&] { image = renderer.render(scene, size); });
    const ImageError error = imageError(image, exact);
    std::printf(
        "  %-9s %-6s 99.9th %6.2f  mean %5.2f  largest %6.1f levels; nodes %6.0f ms, picture %5.1f ms "
        "of %5.1f\n",
        what, detail.name, error.p99_9, error.mean, error.largest, firstMs - againMs, againMs, plainMs);
  }
}

void measureAll(const char* volume, const char* file) {
  const Scene both = sceneOf(volume, file);
  std::printf("%s, %zu voxels\n", std::filesystem::path(file).stem().c_str(), both.volume->voxelCount());
  Scene shadow = both, occlusion = both;
  shadow.shading.occlusion = {};
  occlusion.shading.shadow = {};
  measure("shadow", shadow);
  measure("occlusion", occlusion);
  measure("both", both);
}

} // namespace
} // namespace limn

int main(int count, char** arguments) {
  if (count < 3 || count % 2 == 0) {
    std::fprintf(stderr, "limn_light_error VOLUME SCENE [VOLUME SCENE]...\n");
    return 2;
  }
  try {
    for (int i = 1; i < count; i += 2)
      limn::measureAll(arguments[i], arguments[i + 1]);
  } catch (const limn::Error& error) {
    std::fprintf(stderr, "limn_light_error: %s\n", error.what());
    return 1;
  }
}
