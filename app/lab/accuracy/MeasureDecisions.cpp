// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/accuracy/MeasureDecisions.h"

#include "app/core/drawing/ProcessCost.h"
#include "app/lab/bench/Bench.h"
#include "gl/HeadlessContext.h"
#include "gl/PictureTarget.h"
#include "glsl/decisions/Decisions.h"
#include "raycaster/RayCaster.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double fineStepVoxels = 0.125;
constexpr int fewestTimes = 3;
constexpr int usualTimes = 7;
constexpr double quickMs = 400.0; ///< pictures that take longer are drawn the fewest times

// One way of taking a decision, ready to draw.
struct Way {
  RayCaster caster;
  double prepareMs = 0.0; ///< everything that is made before the first picture
  double editMs = 0.0;    ///< what is made anew when the transfer function changes

  Way(const Decisions& decisions, const Scene& scene)
      : caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, decisions) {
    prepareMs = costOf([&] { caster.prepare(scene), glFinish(); }).ms;
    editMs = costOf([&] { caster.prepare(edited(scene, 0).value_or(scene)), glFinish(); }).ms;
  }
};

// Mesa's and Google's drivers that draw without a graphics card.
bool drawsOnProcessor() {
  const std::string name = rendererName();
  for (const char* driver : {"llvmpipe", "softpipe", "SwiftShader"})
    if (name.find(driver) != std::string::npos)
      return true;
  return false;
}

// What tells pictures apart that differ by little: the least, because what else the machine does only ever
// adds, and of the processor's time where it is the processor that draws, because that waits for nobody.
double effortOf(const std::vector<FrameCost>& frames) {
  return timingOf(drawsOnProcessor() ? processorTimes(frames) : wallTimes(frames)).least;
}

class DecisionTimes {
public:
  DecisionTimes(const Scene& scene, const glm::ivec2& size, const PrecisePixels& converged)
      : m_scene(scene), m_size(size), m_converged(converged) {
    m_scene.quality.preintegrated = Preintegration::never;
    m_scene.quality.jitter = false;
    m_target.resize(size);
    m_own.emplace(Decisions{}, m_scene);
    m_ownError = errorOf(m_own->caster, m_scene);
    m_ownFineError = errorOf(m_own->caster, finely(m_scene));
  }

  EffectSet effects() { return m_own->caster.plan(m_scene).effects; }

  DecisionCost costOfVariant(const DecisionVariant& variant) {
    DecisionCost cost;
    cost.group = variant.group;
    cost.name = variant.name;
    cost.isDefault = variant.isDefault;
    Scene scene = m_scene;
    if (variant.earlyTermination)
      scene.quality.earlyTermination = *variant.earlyTermination;
    if (variant.decisions == Decisions{}) {
      measure(cost, variant, scene, m_own->caster);
      return cost;
    }
    Way way(variant.decisions, scene);
    measure(cost, variant, scene, way.caster);
    cost.extraMb = way.caster.volumeMb() - m_own->caster.volumeMb();
    cost.remark = remarkOn(variant.decisions, way);
    return cost;
  }

private:
  Scene finely(Scene scene) const {
    scene.quality.stepVoxels = std::min(scene.quality.stepVoxels, fineStepVoxels);
    scene.quality.earlyTermination = 1.0;
    return scene;
  }

  void measure(DecisionCost& cost, const DecisionVariant& variant, const Scene& scene, RayCaster& caster) {
    Scene fine = finely(scene);
    if (variant.earlyTermination)
      fine.quality.earlyTermination = *variant.earlyTermination;
    const bool isOwn = &caster == &m_own->caster;
    cost.error = isOwn && scene == m_scene ? m_ownError : errorOf(caster, scene);
    cost.fineError = isOwn && fine == finely(m_scene) ? m_ownFineError : errorOf(caster, fine);
    takeTimes(cost, scene, caster);
  }

  // Both pictures of a round see the same machine.
  void takeTimes(DecisionCost& cost, const Scene& scene, RayCaster& caster) {
    std::vector<FrameCost> own, frames;
    for (int round = 0; round < usualTimes; ++round) {
      if (round >= fewestTimes && frames.front().ms > quickMs)
        break;
      own.push_back(frameOf(m_own->caster, m_scene));
      frames.push_back(frameOf(caster, scene));
    }
    cost.ms = timingOf(wallTimes(frames));
    cost.timesDefault = effortOf(frames) / effortOf(own);
  }

  FrameCost frameOf(RayCaster& caster, const Scene& scene) {
    m_target.bind();
    return costOf([&] {
      caster.draw(scene, m_size, {{0, 0}, m_size});
      glFinish();
    });
  }

  ImageError errorOf(RayCaster& caster, const Scene& scene) {
    frameOf(caster, scene);
    return imageError(m_target.read(), m_converged);
  }

  std::string remarkOn(const Decisions& decisions, const Way& way) const {
    const auto more = [](double ms, double ownMs) {
      return std::to_string(std::lround(std::max(0.0, ms - ownMs))) + " ms";
    };
    if (decisions.volume == VolumeFormat::r8)
      return "Bytes hold nothing beyond the volume's range, so gradients at its faces come out too small.";
    const std::string made = "Made before the first picture in " + more(way.prepareMs, m_own->prepareMs);
    if (decisions.classification != ClassificationOrder::afterInterpolation)
      return made + ", and after every change of the transfer function in " +
             more(way.editMs, m_own->editMs) + ".";
    return storesGradients(decisions) ? made + "." : std::string();
  }

  Scene m_scene;
  glm::ivec2 m_size;
  const PrecisePixels& m_converged;
  PictureTarget m_target;
  std::optional<Way> m_own; ///< as this program decides
  ImageError m_ownError;
  ImageError m_ownFineError;
};

} // namespace

std::vector<DecisionCost> measureDecisions(const Scene& scene, const glm::ivec2& size,
                                           const PrecisePixels& converged, const ReportProgress& progress) {
  const auto tell = [&progress](double fraction, const Message& doing) {
    if (progress)
      progress(fraction, doing);
  };
  tell(0.0, "Measuring the program's own decisions");
  DecisionTimes measurement(scene, size, converged);
  const std::vector<DecisionVariant> variants = decisionVariants(scene, measurement.effects());
  std::vector<DecisionCost> costs;
  for (const DecisionVariant& variant : variants) {
    // The program's own decisions came first and count as one.
    tell((1.0 + static_cast<double>(costs.size())) / (1.0 + static_cast<double>(variants.size())),
         "Measuring " + variant.group + ": " + variant.name);
    costs.push_back(measurement.costOfVariant(variant));
  }
  return costs;
}

} // namespace limn
