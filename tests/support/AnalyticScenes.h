// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/scenes/SimpleScenes.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace limn::test {

using limn::boxOf;
using limn::columnOf;
using limn::constantFunction;
using limn::extinctionPoint;
using limn::rayThrough;
using limn::smallUnitMm;
using limn::stepFor;

/// One ray of a scene with a closed form: mostly a picture of one pixel whose ray runs through the box's
/// centre.
struct AnalyticRay {
  std::string id;   ///< of the case
  std::string what; ///< which of its settings
  Scene scene;
  glm::ivec2 size{1}; ///< of the picture
  std::size_t pixel = 0;
  std::optional<double> alpha; ///< expected; what is absent is not stated by the case
  std::optional<glm::dvec3> color;
  double tolerance = 0.0;   ///< of the double-precision reference
  double glTolerance = 0.0; ///< of a renderer in floats
  /// Fewer samples for a renderer in floats, whose tolerance they meet; 0: the scene's own step.
  double glStepVoxels = 0.0;
};

/// One ray through voxels that only approximate a field: its error falls with their size.
struct RefinedRay {
  std::string id;
  std::string what;
  /// The ray through voxels of an edge length in mm, whose lattice is shifted by a part (0..1) of a voxel.
  std::function<Scene(double voxelMm, const glm::dvec3& shift)> scene;
  int channel = 3;       ///< of the pixel, which shows the figure: alpha
  double expected = 0.0; ///< of the field
  double coarsestMm = 0.0;
  static constexpr int halvings = 2; ///< "two consecutive halvings" (HARD_CASES section 6)
  int lattices = 0;                  ///< to average over
  double lowestOrder = 0.0; ///< the band in which log2 of the ratio of mean errors must lie at every halving
  double highestOrder = 0.0;
  std::optional<double> finestError; ///< the mean error at the finest, where it is known, to 5 %
  std::optional<double> finestLimit; ///< which the mean error at the finest must not exceed
};

/// The cases of balls, shells and blobs (C1 to C4), which no grid holds exactly.
std::vector<RefinedRay> refinedRays(const nlohmann::json& one);

/// The sphere of isosurfaces (J5), which no grid holds exactly.
std::vector<RefinedRay> refinedSurfaces(const nlohmann::json& one);

/// The cases of kind `render` of analytic_cases.json that a grid holds exactly.
std::vector<AnalyticRay> analyticRays(const nlohmann::json& cases);

/// Parts of the above, by group.
std::vector<AnalyticRay> homogeneousRays(const nlohmann::json& one);
std::vector<AnalyticRay> rampRays(const nlohmann::json& one);
std::vector<AnalyticRay> layerRays(const nlohmann::json& one);
std::vector<AnalyticRay> shadingRays(const nlohmann::json& one);
std::vector<AnalyticRay> projectionRays(const nlohmann::json& one);
std::vector<AnalyticRay> preintegratedRays(const nlohmann::json& one);

/// The largest of samples of 1 - 4(t - top)² at the centres of as many voxels over 1 mm.
Scene parabolaUnderMip(double top, int samples);

/// A ray with the id and the tolerances of its case.
AnalyticRay rayOf(const nlohmann::json& one, std::string what, Scene scene);

double expectedOf(const nlohmann::json& one, const char* key);

} // namespace limn::test
