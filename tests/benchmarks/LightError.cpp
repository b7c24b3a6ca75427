// SPDX-License-Identifier: GPL-3.0-or-later
// How far pictures whose light is looked up on a grid lie from those whose light is found for each sample
// (which lie within a third of a level of the reference, CpuTravellingLight.found*): volumes with scenes of
// their own, each under three lights (shadows of 5° softness, occlusion of 15 mm, both) from above left, seen
// from a little aside, drawn by the CPU engine on all threads. Told are error and processor time of what
// stands at rest and while something moves, with what a picture without light on its way takes. Held fixed:
// size (160²), steps of half a voxel, no pre-integration.
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
#include <fstream>

namespace limn {
namespace {

constexpr glm::ivec2 size(160, 160);

double processorMs(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}


Image sampledOf(Scene scene, const std::string& name) {
  const char* folder = std::getenv("LIGHT_CACHE");
  const std::string path = std::string(folder ? folder : "") + "/" + name + ".raw";
  if (folder && std::filesystem::exists(path)) {
    Image image;
    image.size = size;
    image.pixels.resize(static_cast<std::size_t>(size.x) * size.y);
    std::ifstream(path, std::ios::binary).read(reinterpret_cast<char*>(image.pixels.data()), std::streamsize(image.pixels.size() * sizeof(glm::vec4)));
    return image;
  }
  scene.quality.light = LightDetail::sampled;
  CpuRenderer renderer;
  Image image;
  const double ms = processorMs([&] { image = renderer.render(scene, size); });
  std::printf("  sampled in %.0f ms\n", ms);
  if (folder)
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(image.pixels.data()), std::streamsize(image.pixels.size() * sizeof(glm::vec4)));
  return image;
}

void measure(const char* volume, const char* file) {
  Scene scene = readSceneFile(file).scene;
  scene.volume = readVolume(volume);
  scene.camera = orbited(defaultCamera(scene.volume->grid()), 0.5, 0.3);
  scene.shading.lightDirection = glm::dvec3(0.6, -0.7, 1.0);
  scene.shading.lightAxes = LightAxes::camera;
  scene.quality.stepVoxels = 0.5;
  scene.quality.preintegrated = Preintegration::never;
  const std::string name = std::filesystem::path(file).stem();
  std::printf("%s, %zu voxels\n", name.c_str(), scene.volume->voxelCount());
  for (const char* what : {"shadow", "occlusion", "both"}) {
    Scene lit = scene;
    if (what[0] != 'o')
      lit.shading.shadow = {0.85, 5.0};
    if (what[0] != 's')
      lit.shading.occlusion = {0.8, 15.0};
    if (const char* only = std::getenv("LIGHT_ONLY"); only && only[0] != what[0])
      continue;
    const Image exact = sampledOf(lit, name + "-" + what);
    CpuRenderer renderer;
    const double plain = processorMs([&] { renderer.render(test::withoutTravel(lit), size); });
    for (const LightDetail detail : {LightDetail::fine, LightDetail::coarse}) {
      if (detail == LightDetail::coarse && std::getenv("LIGHT_FINE"))
        continue;
      lit.quality.light = detail;
      CpuRenderer own;
      own.render(test::withoutTravel(lit), size);
      const double plainAgain = processorMs([&] { own.render(test::withoutTravel(lit), size); });
      const double first = processorMs([&] { own.render(lit, size); });
      Image image;
      const double again = processorMs([&] { image = own.render(lit, size); });
      const ImageError error = imageError(image, exact);
      std::printf("  %-9s %-6s 99.9th %6.2f mean %5.2f largest %6.1f  nodes %6.0f ms, picture %6.0f ms of %5.0f (%.2f)\n", what,
                  detail == LightDetail::fine ? "fine" : "coarse", error.p99_9, error.mean, error.largest,
                  first - again, again, plainAgain, again / plainAgain);
    }
    (void)plain;
  }
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
      limn::measure(arguments[i], arguments[i + 1]);
  } catch (const limn::Error& error) {
    std::fprintf(stderr, "limn_light_error: %s\n", error.what());
    return 1;
  }
}
