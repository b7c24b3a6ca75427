// SPDX-License-Identifier: GPL-3.0-or-later
// What each preset's default picture takes: as the window shows a volume with it at first, 512², drawn by the
// CPU engine. Processor time of all threads, which waits for nobody, the least of some pictures: every preset
// is drawn once before any is drawn again, so that what else a machine does meets all alike. Builds on older
// commits, too, to compare with them; presets that those cannot read are passed over there.
//
// limn_preset_times ROUNDS FOLDER_OF_PRESETS VOLUME...
#include "cpu/CpuRenderer.h"
#include "io/VolumeReader.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Histogram.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

namespace limn {
namespace {

constexpr glm::ivec2 size(512, 512);

double processMs() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::vector<Preset> presetsIn(const char* folder) {
  std::vector<Preset> presets;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json")
      continue;
    try {
      presets.push_back(parsePreset(readTextFile(entry.path()), entry.path().filename().string()));
    } catch (const Error& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
  }
  std::ranges::sort(presets, {}, &Preset::name);
  return presets;
}

void measure(const char* path, const std::vector<Preset>& presets, int rounds) {
  Scene scene;
  scene.volume = readVolume(path);
  scene.camera = defaultCamera(scene.volume->grid());
  const Histogram histogram = histogramOf(*scene.volume);
  std::vector<Scene> scenes;
  for (const Preset& preset : presets)
    scenes.push_back(withPreset(scene, fittedTo(preset, histogram, scene.volume->grid())));
  CpuRenderer renderer;
  std::vector<double> least(presets.size(), 1e30);
  for (int round = 0; round <= rounds; ++round)
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      renderer.render(scenes[i], glm::ivec2(8)); // what is made once for a function
      const double start = processMs();
      renderer.render(scenes[i], size);
      if (round > 0) // the first makes what is made once for a volume
        least[i] = std::min(least[i], processMs() - start);
    }
  const std::string volume = std::filesystem::path(path).filename().string();
  for (std::size_t i = 0; i < presets.size(); ++i)
    std::printf("%s\t%s\t%.1f\n", volume.c_str(), presets[i].name.c_str(), least[i]);
}

} // namespace
} // namespace limn

int main(int count, char** arguments) {
  try {
    if (count < 4 || std::atoi(arguments[1]) < 1) {
      std::fprintf(stderr, "limn_preset_times ROUNDS FOLDER_OF_PRESETS VOLUME...\n");
      return 2;
    }
    const std::vector<limn::Preset> presets = limn::presetsIn(arguments[2]);
    for (int i = 3; i < count; ++i)
      limn::measure(arguments[i], presets, std::atoi(arguments[1]));
  } catch (const limn::Error& error) {
    std::fprintf(stderr, "limn_preset_times: %s\n", error.what());
    return 1;
  }
}
