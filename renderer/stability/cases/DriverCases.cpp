// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GpuTimer.h"
#include "gl/PictureTarget.h"
#include "scene/steps/RayFrame.h"
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <random>

namespace limn {
namespace {

// A driver's time of a picture as a share of what the clock sees around it; infinite where it is none.
double shareOfClock(GpuTimer& timer, const std::function<void()>& draw) {
  const auto start = std::chrono::steady_clock::now();
  const double ms = timer.measureMs(draw);
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  return ms > 0.0 ? ms / wall.count() : std::numeric_limits<double>::infinity();
}

std::vector<Finding> glTimers(Workbench& bench) {
  constexpr glm::ivec2 size{128, 128};
  const Scene scene = wholeVolume(smoothVolume(32), ShadingModel::classic, 0.0, 100.0, {0.6, 0.64, 0.48});
  const FloatTarget target(size);
  const auto draw = [&] { bench.rays().draw(scene, size, {{0, 0}, size}); };
  draw();
  GpuTimer timer;
  std::vector<Finding> findings;
  if (timer.method() == GpuTimer::Method::timerQuery)
    findings.push_back(atMost("gl", "the driver's timer query", shareOfClock(timer, draw), 1.5,
                              "its time as a share of the clock's: more than nothing and no longer"));
  else
    findings.push_back(notApplicable("gl", "the driver's timer query", timer.description()));
  timer.calibrate(draw);
  findings.push_back(
      atMost("gl", "the timer that the program uses", shareOfClock(timer, draw), 1.5,
             "its time as a share of the clock's: more than nothing and no longer; " + timer.description()));
  return findings;
}

std::vector<Finding> timers(Workbench& bench) {
  std::vector<Finding> findings;
  if (bench.hasOpenGl())
    findings = glTimers(bench);
  else
    findings.push_back(notApplicable("gl", "", "There is no OpenGL whose timer could be read."));
  for (const char* engine : {"reference", "slices"})
    findings.push_back(notApplicable(engine, "", "It is timed by the clock alone."));
  return findings;
}

// Cameras that are likely to divide nothing by nothing: places on the lattice of the voxels, inside, far away
// and at the target, any up, any field of view.
struct RandomViews {
  std::mt19937 generator{47};

  double share() { return generator() / 4294967295.0; }
  double within(double low, double high) { return low + share() * (high - low); }
  double magnitude(double low, double high) { return std::pow(10.0, within(low, high)); }

  glm::dvec3 place(double scale) {
    const bool isOnLattice = generator() % 2 == 0;
    const double reach = magnitude(-3.0, 6.0);
    glm::dvec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = isOnLattice ? scale * 0.5 * (static_cast<double>(generator() % 65) - 32.0)
                            : scale * reach * within(-1.0, 1.0);
    return p;
  }

  Grid grid() {
    const glm::ivec3 dims(1 + generator() % 33, 1 + generator() % 33, 1 + generator() % 33);
    const double scale = magnitude(-6.0, 6.0);
    return centredGrid(dims, scale * glm::dvec3(1.0, magnitude(-1.0, 1.0), magnitude(-1.0, 1.0)));
  }

  Camera camera(double scale) {
    Camera camera;
    camera.projection =
        generator() % 2 == 0 ? Camera::Projection::perspective : Camera::Projection::orthographic;
    camera.position = place(scale);
    camera.target = generator() % 16 == 0 ? camera.position : place(scale);
    camera.up = generator() % 8 == 0 ? camera.target - camera.position : place(1.0);
    camera.fovYDeg = generator() % 2 == 0 ? within(1.0, 179.0) : magnitude(-4.0, 0.0);
    camera.heightMm = scale * magnitude(-3.0, 4.0);
    return camera;
  }
};

bool isFinite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

int wrongRays(int cameras) {
  RandomViews views;
  int wrong = 0;
  for (int i = 0; i < cameras; ++i) {
    const Grid grid = views.grid();
    const glm::ivec2 size(1 + views.generator() % 2000, 1 + views.generator() % 2000);
    const RayFrame frame = rayFrame(views.camera(grid.spacingMm.x), grid, size);
    const FramedRay ray = framedRay(frame, static_cast<int>(views.generator() % size.x),
                                    static_cast<int>(views.generator() % size.y), size);
    const RaySpan span = spanInBox(ray, croppedBox(grid, CropBox{}));
    bool isRight = isFinite(ray.anchor) && isFinite(ray.direction) && std::isfinite(ray.eye);
    if (!span.isEmpty()) {
      const double length = span.end - span.begin;
      const int count = sampleCount(length, smallestSpacingMm(grid) * views.magnitude(-9.0, 3.0));
      isRight = isRight && std::isfinite(length) && count >= 1 && count <= mostSamples;
      // No chord is longer than the diagonal; a thousandth for rays from far away.
      isRight = isRight && length <= 1.001 * boxDiagonalMm(grid);
    }
    wrong += !isRight;
  }
  return wrong;
}

std::vector<Finding> randomCameras(Workbench& bench) {
  std::vector<Finding> findings = {
      atMost("cpp", "rays of 100000 random cameras", wrongRays(100000), 0.0,
             "rays that are not finite, longer than the box, or of fewer than 1 or more than 60000 samples")};
  RandomViews views;
  std::vector<Scene> scenes;
  for (int i = 0; i < 100; ++i) {
    const Grid grid = views.grid();
    const auto volume = volumeOf(grid, [](int a, int b, int c) { return (a * 7 + b * 5 + c * 3) % 11; });
    scenes.push_back(wholeVolume(volume, ShadingModel::none, 0.0, 10.0));
    scenes.back().camera = views.camera(grid.spacingMm.x);
  }
  findings.push_back(withOpenGl(bench, "gl", "samples of 100 random cameras", [&] {
    int counts = 0;
    for (const Scene& scene : scenes)
      for (const int count : bench.rays().sampleCounts(scene, {8, 8}))
        counts += count < 0 || count > mostSamples;
    return atMost("gl", "samples of 100 random cameras", counts, 0.0,
                  "pixels of fewer than 0 or more than 60000");
  }));
  findings += inEachEngine(bench, "pictures of 100 random cameras", {},
                           "pixels that are not finite or outside 0..1", [&scenes](const Draw& draw) {
                             int unsound = 0;
                             for (const Scene& scene : scenes)
                               unsound += unsoundPixels(draw(scene, {8, 8}));
                             return unsound;
                           });
  return findings;
}

} // namespace

std::vector<HardCase> driverCases() {
  return {
      {"H45", "The timer of the graphics card counts more than nothing and no more than the clock", timers},
      {"H47", "No camera makes a ray endless or its number of samples meaningless", randomCameras}};
}

} // namespace limn
