// SPDX-License-Identifier: GPL-3.0-or-later
// What pre-integrated steps gain over samples, by how fine the transfer function is: the measurement behind
// the rule of `stepResolvesFunction`. Held fixed: CT head, 128 x 128, default camera with a field of view of
// 18 degrees, no early termination; errors are means over covered channels in 8-bit levels against samples
// 1/64 voxel apart. Not part of the test command.
#include "gl/HeadlessContext.h"
#include "raycaster/RayCaster.h"
#include "scene/PictureFigures.h"
#include "scene/light/Gradient.h"
#include "support/Heads.h"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace limn {
namespace {

constexpr glm::ivec2 size{128, 128};
const glm::dvec3 color(1.0, 0.9, 0.8);

TransferFunction ramp(double width) {
  return {1.0, {{300.0 - width / 2.0, color, 0.0}, {300.0 + width / 2.0, color, 0.6}}};
}

TransferFunction band(double width) {
  return {1.0, {{300.0 - width / 2.0, color, 0.0}, {300.0, color, 0.5}, {300.0 + width / 2.0, color, 0.0}}};
}

double meanError(const Image& image, const Image& exact) {
  double sum = 0.0;
  std::size_t channels = 0;
  for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
    if (!isCovered(image.pixels[i]) && !isCovered(exact.pixels[i]))
      continue;
    for (int channel = 0; channel < 4; ++channel)
      sum += 255.0 * std::abs(image.pixels[i][channel] - exact.pixels[i][channel]);
    channels += 4;
  }
  return channels > 0 ? sum / static_cast<double>(channels) : 0.0;
}

struct Drawn {
  Image image;
  double ms = 0.0;
};

Drawn drawn(RayCaster& caster, Scene scene, Preintegration preintegrated) {
  scene.quality.preintegrated = preintegrated;
  caster.render(scene, size); // shader and tables
  const auto start = std::chrono::steady_clock::now();
  Image image = caster.render(scene, size);
  const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
  return {std::move(image), ms.count()};
}

void report(RayCaster& caster, Scene scene, const char* what, double width) {
  scene.quality.stepVoxels = 1.0 / 64.0;
  const Image exact = drawn(caster, scene, Preintegration::never).image;
  for (const double step : {1.0, 0.5}) {
    scene.quality.stepVoxels = step;
    const Drawn sampled = drawn(caster, scene, Preintegration::never);
    const Drawn integrated = drawn(caster, scene, Preintegration::always);
    const double error = meanError(sampled.image, exact);
    const double left = meanError(integrated.image, exact);
    std::printf(
        "%-5s %s of %3.0f HU, step %.1f: error %6.3f sampled, %6.3f pre-integrated (%.2f), time %.2f\n",
        scene.shading.model == ShadingModel::none ? "unlit" : "lit", what, width, step, error, left,
        left / error, integrated.ms / sampled.ms);
    std::fflush(stdout);
  }
}

} // namespace
} // namespace limn

int main() {
  using namespace limn;
  const HeadlessContext context;
  const auto volume = test::ctHead();
  std::printf("%s; the value commonly changes by up to %.0f HU a voxel\n", rendererName().c_str(),
              steepness(*volume) * smallestSpacingMm(volume->grid()));
  RayCaster caster;
  for (const ShadingModel model : {ShadingModel::none, ShadingModel::classic}) {
    Scene scene = test::headScene(volume, model);
    scene.camera.fovYDeg = 18.0;
    for (const double width : {400.0, 200.0, 100.0, 50.0, 0.0}) {
      scene.transferFunction = ramp(width);
      report(caster, scene, "edge", width);
    }
    for (const double width : {200.0, 100.0, 50.0, 20.0}) {
      scene.transferFunction = band(width);
      report(caster, scene, "band", width);
    }
  }
}
