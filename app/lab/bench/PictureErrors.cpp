// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/bench/PictureErrors.h"

#include "accuracy/times/Timing.h"
#include "cpu/CpuRenderer.h"
#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "scene/PictureFigures.h"
#include "scene/ProjectionFacts.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"

#include <algorithm>

namespace limn {
namespace {

constexpr double finenessOfExact = 9.0;
constexpr double litStepOfExact = 0.125; // in voxels

// Light that travels is followed along as many paths as a picture at rest has, in fine steps: a tolerance
// would ask for so many that a picture takes minutes.
Scene exactly(Scene scene) {
  scene.quality.earlyTermination = 1.0;
  scene.quality.jitter = false;
  if (hasTravellingLight(scene)) {
    scene.quality.toleranceLevels.reset();
    scene.quality.stepVoxels = litStepOfExact;
    scene.quality.light = LightDetail::sampled;
    return scene;
  }
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = finenessOfExact;
  return scene;
}

bool isOfLimn(const Contender& contender) {
  return contender.program() == "limn-gl" || contender.program() == "limn-cpu";
}

} // namespace

BytePicture pictureOf(Contender& contender) {
  const ScratchFolder folder;
  contender.save(folder.path() / "picture.png");
  return readBytes(folder.path() / "picture.png");
}

PictureErrors::PictureErrors(const Scene& scene, const std::vector<std::unique_ptr<Contender>>& contenders,
                             int threads)
    : m_background(scene.image.background) {
  CpuRenderer renderer(threads, CpuRenderer::Tolerance::stepsFirst);
  const glm::ivec2 size(scene.image.width, scene.image.height);
  Scene exact = exactly(scene);
  m_exact = renderer.render(exact, size);
  exact.shading.twoSided = true;
  if (std::ranges::any_of(contenders, [](const auto& one) { return one->lightsBothSides(); }))
    m_exactOfBothSides = renderer.render(exact, size);
}

double PictureErrors::meanError(Contender& contender, const Scene& scene) const {
  contender.draw(scene);
  const BytePicture picture = pictureOf(contender);
  const Image& wanted = contender.lightsBothSides() ? m_exactOfBothSides : m_exact;
  if (picture.size != wanted.size)
    throw Error(Error::Kind::other, "The picture of " + contender.program() + " has another size.");
  double sum = 0.0;
  int channels = 0;
  for (int y = 0; y < wanted.size.y; ++y)
    for (int x = 0; x < wanted.size.x; ++x) {
      const glm::vec4& exact = wanted.at(x, y);
      if (!isCovered(exact))
        continue;
      const std::uint8_t* pixel = picture.bytes.data() + 3 * (std::ptrdiff_t{y} * wanted.size.x + x);
      for (int channel = 0; channel < 3; ++channel, ++channels)
        sum +=
            std::abs(pixel[channel] -
                     255.0 * std::clamp(exact[channel] + (1.0 - exact.a) * m_background[channel], 0.0, 1.0));
    }
  return channels > 0 ? sum / channels : 0.0;
}

std::vector<ErrorAndTime> errorCurve(Contender& contender, const Scene& scene, const PictureErrors& errors,
                                     int frames) {
  std::vector<ErrorAndTime> curve;
  const auto measure = [&](const Scene& one) {
    // Another step may be another program, or other data.
    contender.drawFirst(one);
    const double error = errors.meanError(contender, one);
    std::vector<FrameCost> costs;
    costs.reserve(static_cast<std::size_t>(frames));
    for (int i = 0; i < frames; ++i)
      costs.push_back(contender.draw(one));
    curve.push_back({error, timingOf(processorTimes(costs)).median});
  };
  Scene one = scene;
  for (const double step : {2.0, 1.0, 0.5, 0.25}) {
    one.quality.stepVoxels = step;
    measure(one);
  }
  if (!isOfLimn(contender) || !integrates(scene.projection))
    return curve;
  one.quality.stepVoxels = scene.quality.stepVoxels;
  one.quality.toleranceLevels = 1.0;
  for (const double fineness : {0.0, 1.0, 2.0, 3.0, 4.0}) {
    one.quality.fineness = fineness;
    measure(one);
  }
  return curve;
}

std::vector<EqualErrorRow> equalErrorRows(const std::string& name, const Scene& scene,
                                          const std::vector<std::unique_ptr<Contender>>& contenders,
                                          const PictureErrors& errors, int frames,
                                          const std::function<void()>& advance) {
  const auto rival = std::ranges::find(contenders, "vtk-gpu", [](const auto& one) { return one->program(); });
  Contender& yardstick = rival == contenders.end() ? *contenders.front() : **rival;
  std::vector<std::vector<ErrorAndTime>> curves;
  for (const auto& contender : contenders) {
    curves.push_back(errorCurve(*contender, scene, errors, frames));
    advance();
  }
  std::vector<EqualErrorRow> rows;
  for (const double step : {1.0, 0.5}) {
    Scene one = scene;
    one.quality.stepVoxels = step;
    yardstick.drawFirst(one);
    const double error = errors.meanError(yardstick, one);
    std::optional<double> yardstickMs;
    for (std::size_t i = 0; i < contenders.size(); ++i)
      if (contenders[i].get() == &yardstick)
        yardstickMs = timeAtError(curves[i], error);
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      EqualErrorRow row{name, contenders[i]->program(), error, timeAtError(curves[i], error),
                        {},   yardstick.program()};
      if (row.cpuMs && yardstickMs)
        row.gain = *yardstickMs / *row.cpuMs;
      rows.push_back(row);
    }
  }
  return rows;
}

} // namespace limn
