// SPDX-License-Identifier: GPL-3.0-or-later
// How physical light comes into being in the window: scene files in physical light, 512², drawn by the CPU
// engine on all threads as the window draws them, as far as 10 s of each thread go. Told are every picture on
// the way, in how many pixels, with how many paths and what standard error; what stands after 3 s; how long
// nobody asks whether to end; paths per second; and what an error of 1 level RMS takes. Times are those of
// the processor over the number of threads: what the clock shows on a machine that does nothing else.
//
// limn_path_time VOLUME SCENE...
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "io/VolumeReader.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "scene/light/LightPresets.h"
#include "support/JudgedTime.h"
#include "widgets/view/pictures/PictureScreen.h"
#include "widgets/view/pictures/Pictures.h"

#include <QThread>

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>
#include <vector>

namespace limn {
namespace {

constexpr glm::ivec2 size(512, 512);
constexpr double longestS = 10.0;
constexpr double usableS = 3.0;
constexpr double turnMs = 12.0;

double clockS() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// What all threads took, shared out among as many as the processor has.
double processorS() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return (seconds(usage.ru_utime) + seconds(usage.ru_stime)) /
         std::max(1u, std::thread::hardware_concurrency());
}

// How long the thread that draws works at most until it asks whether to end.
struct Asking {
  double last = test::threadMs();
  double longestMs = 0.0;
  bool ask() {
    const double now = test::threadMs();
    longestMs = std::max(longestMs, now - last);
    last = now;
    return false;
  }
};

// How fast paths are, and how long until 1 level by the law of 1/n.
void tellRate(const Scene& scene) {
  constexpr int paths = 8;
  Scene drawn = scene;
  drawn.quality.paths = paths;
  CpuRenderer renderer;
  renderer.makeReady(scene, {});
  const double start = processorS();
  const Image image = renderer.render(drawn, size);
  const double seconds = processorS() - start;
  const PathFigures figures = *renderer.pathFigures(drawn, size);
  const auto covered = std::ranges::count_if(image.pixels, [](const glm::vec4& p) { return p.a > 0.0f; });
  std::printf("  %.2f million paths a second; %d paths of %ld pixels: %.1f levels RMS, %.2f s; 1 level after "
              "%.0f s and %.0f paths\n",
              1e-6 * paths * static_cast<double>(covered) / seconds, paths, static_cast<long>(covered),
              *figures.rmsLevels, seconds, seconds * std::pow(*figures.rmsLevels, 2.0),
              paths * std::pow(*figures.rmsLevels, 2.0));
}

// What stands of the picture: its share of the width, and the paths of each pixel.
struct Shown {
  double scale = 0.0;
  int paths = 0;
  bool operator==(const Shown&) const = default;
};

Shown shownOf(const Pictures& pictures) {
  const SideState side = pictures.state().sides[0];
  return {side.imageScale, side.paths->paths};
}

// The standard error of a picture that stood on the way, drawn again.
void tellError(const Scene& scene, const Shown& shown, double seconds) {
  Scene drawn = withStep(scene, (shown.scale < 1.0 ? 2.0 : 1.0) * scene.quality.stepVoxels);
  drawn.quality.paths = shown.paths;
  const glm::ivec2 pixels = sizeAt({shown.scale, 1.0}, size);
  CpuRenderer renderer;
  renderer.render(drawn, pixels);
  const PathFigures figures = *renderer.pathFigures(drawn, pixels);
  std::printf("  %6.2f s: %d × %d pixels, %d paths, %.1f levels RMS\n", seconds, pixels.x, pixels.y,
              shown.paths, figures.rmsLevels.value_or(-1.0));
}

void measure(const std::string& name, const Scene& scene) {
  std::printf("%s\n", name.c_str());
  Asking asking;
  Pictures pictures(makeCpuEngine(), makeMemoryScreen([&asking] { return asking.ask(); }));
  pictures.makeReady(scene, {}, 1e9);
  const double start = processorS(), clock = clockS();
  pictures.want({scene}, size);
  pictures.drawCoarsely(InteractionQuality::levelCount - 1, {});
  std::vector<std::pair<double, Shown>> stages{{processorS() - start, shownOf(pictures)}};
  std::printf("  first picture after %.0f ms (%.0f on this clock)\n", 1e3 * stages[0].first,
              1e3 * (clockS() - clock));
  asking = {};
  const auto note = [&] {
    if (const Shown shown = shownOf(pictures); shown != stages.back().second)
      stages.emplace_back(processorS() - start, shown);
  };
  while (!pictures.refine(turnMs))
    note();
  note();
  while (processorS() - start < longestS) {
    const RestTurn turn = pictures.workAtRest(true, turnMs);
    if (turn == RestTurn::nothing)
      break;
    if (turn == RestTurn::waiting)
      QThread::yieldCurrentThread(); // a thread of the pool compares
    note();
  }
  std::printf("  longest work without asking whether to end: %.1f ms\n", asking.longestMs);
  const Shown* usable = nullptr;
  for (const auto& [seconds, shown] : stages) {
    tellError(scene, shown, seconds);
    if (seconds <= usableS)
      usable = &shown;
  }
  std::printf("  after %.0f s there stand %d paths at %.2f of the width\n", usableS, usable->paths,
              usable->scale);
  tellRate(scene);
}

void measureAll(const char* volume, int count, char** scenes) {
  const auto voxels = readVolume(volume);
  for (int i = 0; i < count; ++i) {
    Scene scene = readSceneFile(scenes[i]).scene;
    scene.volume = voxels;
    scene.camera = defaultCamera(voxels->grid());
    scene.shading = withLight(scene.shading, LightPreset::physical);
    measure(std::filesystem::path(scenes[i]).stem().string(), scene);
  }
}

} // namespace
} // namespace limn

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "limn_path_time VOLUME SCENE...\n");
    return 2;
  }
  try {
    limn::measureAll(arguments[1], count - 2, arguments + 2);
  } catch (const limn::Error& error) {
    std::fprintf(stderr, "limn_path_time: %s\n", error.what());
    return 1;
  }
}
