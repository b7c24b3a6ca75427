// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/LocalSteps.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double muchMore = 8.0;
constexpr double muchLess = 0.25;

} // namespace

double stepOfRung(double rung) {
  return 2.0 * std::exp2(-0.5 * rung);
}

int wholeRungs(double fineness) {
  return static_cast<int>(std::floor(fineness));
}

double ladderScale(double fineness) {
  return std::exp2(-(fineness - std::floor(fineness)) / rungsPerHalving);
}

std::optional<double> finenessOf(const Quality& quality) {
  if (!quality.toleranceLevels)
    return std::nullopt;
  return quality.fineness.value_or(usualFineness(*quality.toleranceLevels));
}

Quality withSteps(Quality quality, double stepVoxels) {
  if (const std::optional<double> fineness = finenessOf(quality)) {
    const double halvings = std::log2(quality.stepVoxels / stepVoxels);
    const double finer = *fineness + rungsPerHalving * halvings;
    quality.fineness = std::clamp(finer, Fineness::least, Fineness::most);
  }
  quality.stepVoxels = stepVoxels;
  return quality;
}

double usualFineness(double toleranceLevels) {
  // An error of one level at 4, and errors fall with the square of the step: one rung halves them.
  const double wanted = 4.0 - std::log2(toleranceLevels);
  return std::clamp(wanted, Fineness::least, Fineness::most);
}

double mostChange(double fineness) {
  return 0.075 * std::exp2(-fineness);
}

int coarserBehind(double transmittance) {
  return static_cast<int>(std::floor(-2.0 / 3.0 * std::log2(std::max(transmittance, 1e-6))));
}

int refinedRung(int rung, double change, double limit) {
  const int halvings = change > muchMore * limit ? 2 : 1;
  return std::min(rung + halvings * rungsPerHalving, finestRung);
}

int relaxedRung(int rung, int blockRung, double change, double limit) {
  return change < muchLess * limit ? std::max(rung - rungsPerHalving, blockRung) : rung;
}

double pieceOf(double rest, double step) {
  if (rest <= step)
    return rest;
  return rest < 1.5 * step ? 0.5 * rest : step;
}

} // namespace limn
