// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <array>
#include <vector>

namespace limn::test {

/// How the reference finds the light of a ray. What error-controlled pictures took before cells were local
/// steps, which OpenGL still takes.
enum class EvaluationWay { cells, localSteps, equalSteps };

/// What a picture errs by and what it took.
struct EvaluationCost {
  double error = 0.0;       ///< levels, the 99.9th percentile
  double evaluations = 0.0; ///< mean of the rays that meet something
};

/// The errors of which evaluations are told, levels.
inline constexpr std::array toldErrors{8.0, 4.0, 2.0, 1.0, 0.5, 0.1, 0.05};

/// The picture against which the others err: cell by cell with the finest fineness, whose own error is a
/// thousandth of the smallest that is told. Premultiplied RGBA, rows from the top.
std::vector<glm::dvec4> exactByCells(Scene scene, const glm::ivec2& size);

/// Pictures of a scene in double precision, each finer than the one before, until one errs by less than the
/// smallest error told. Rays never end early and steps are sampled, so that nothing but the way errs.
std::vector<EvaluationCost> evaluationCosts(Scene scene, const glm::ivec2& size, EvaluationWay way,
                                            const std::vector<glm::dvec4>& exact);

/// The evaluations of an error, on the line in logarithms between the two pictures whose errors enclose it;
/// not a number beyond them.
double evaluationsFor(const std::vector<EvaluationCost>& costs, double error);

/// Of the line of least squares through the errors told, logarithm of the error over that of the
/// evaluations: −2 where twice as many leave a quarter. Not a number where fewer than three are enclosed.
double slopeOf(const std::vector<EvaluationCost>& costs);

} // namespace limn::test
