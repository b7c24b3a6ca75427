// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/EvaluationCosts.h"

#include "accuracy/ImageError.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/steps/LocalSteps.h"

#include <algorithm>
#include <cmath>

namespace limn::test {
namespace {

// Below the smallest error told, so that it is enclosed.
constexpr double enough = 0.04;
constexpr double mostFineness = 16.0;
constexpr double shortestStep = 1.0 / 64.0;

void leaveNothingElseToErr(Scene& scene) {
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.earlyTermination = 1.0;
  scene.quality.jitter = false;
}

EvaluationCost costOf(const ReferencePicture& picture, const std::vector<glm::dvec4>& exact) {
  double sum = 0.0, rays = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    if (exact[i].a >= 1.0 / 510.0) { // what shows at all
      sum += picture.samples[i];
      rays += 1.0;
    }
  return {imageError(picture.pixels, exact).p99_9, sum / std::max(rays, 1.0)};
}

} // namespace

std::vector<glm::dvec4> exactByCells(Scene scene, const glm::ivec2& size) {
  leaveNothingElseToErr(scene);
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = Fineness::most - 4.0;
  return renderReference(scene, size).pixels;
}

std::vector<EvaluationCost> evaluationCosts(Scene scene, const glm::ivec2& size, EvaluationWay way,
                                            const std::vector<glm::dvec4>& exact) {
  leaveNothingElseToErr(scene);
  std::vector<EvaluationCost> costs;
  const auto isEnough = [&](ToTolerance toTolerance) {
    costs.push_back(
        costOf(renderReference(scene, size, 0, {}, Limiting::clampOrKnee, {}, toTolerance), exact));
    return costs.back().error < enough;
  };
  if (way == EvaluationWay::equalSteps) {
    scene.quality.toleranceLevels.reset();
    scene.quality.fineness.reset();
    for (double step = 2.0; step >= shortestStep; step /= 2.0) {
      scene.quality.stepVoxels = step;
      if (isEnough(ToTolerance::byCells))
        break;
    }
    return costs;
  }
  scene.quality.toleranceLevels = 1.0;
  for (double fineness = 0.0; fineness <= mostFineness; fineness += 1.0) {
    scene.quality.fineness = fineness;
    if (isEnough(way == EvaluationWay::cells ? ToTolerance::byCells : ToTolerance::byLocalSteps))
      break;
  }
  return costs;
}

double evaluationsFor(const std::vector<EvaluationCost>& costs, double error) {
  for (std::size_t i = 0; i + 1 < costs.size(); ++i) {
    const EvaluationCost &coarse = costs[i], &fine = costs[i + 1];
    if (coarse.error < error || fine.error > error || !(fine.error > 0.0) || coarse.error == fine.error)
      continue;
    const double w = std::log(coarse.error / error) / std::log(coarse.error / fine.error);
    return std::exp(std::lerp(std::log(coarse.evaluations), std::log(fine.evaluations), w));
  }
  return std::nan("");
}

double slopeOf(const std::vector<EvaluationCost>& costs) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const double error : toldErrors) {
    const double evaluations = evaluationsFor(costs, error);
    if (std::isnan(evaluations))
      continue;
    const double u = std::log(evaluations), v = std::log(error);
    n += 1.0, x += u, y += v, xx += u * u, xy += u * v;
  }
  return n < 3.0 ? std::nan("") : (n * xy - x * y) / (n * xx - x * x);
}

} // namespace limn::test
