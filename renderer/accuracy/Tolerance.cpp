// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/Tolerance.h"

#include "accuracy/ErrorEstimate.h"
#include "scene/ProjectionFacts.h"
#include "scene/steps/BlockSteps.h"
#include "scene/steps/LocalSteps.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <map>

namespace limn {
namespace {

// Pixels of the pictures that are compared: some 26 000 channels, of which 26 lie above the 99.9th
// percentile.
constexpr double comparedPixels = 128.0 * 128.0;

// What an estimate from so few may lie below the error of the whole picture, measured on the shared data sets
// and the analytic scenes (tests/accuracy/ToleranceTest.cpp).
constexpr double safety = 1.1;

// The share of the tolerance that rays which end early may take.
constexpr double shareOfTermination = 0.125;

glm::ivec2 comparedSize(const glm::ivec2& size) {
  const double scale = std::min(1.0, std::sqrt(comparedPixels / (static_cast<double>(size.x) * size.y)));
  return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * scale)), glm::ivec2(1));
}

// The qualities that are tried: rung by rung, a fineness or, where steps are equal, the step of that rung.
class Ladder {
public:
  Ladder(const Quality& quality, Projection projection, StepControl control)
      : m_quality(quality), m_isLocal(control == StepControl::local && integrates(projection)),
        m_start(startFor(*quality.toleranceLevels)),
        m_isEqual(!m_isLocal || projection == Projection::compositeIsosurface) {
    const double tolerance = *quality.toleranceLevels;
    m_quality.jitter = false;
    if (quality.earlyTermination < 1.0)
      m_quality.earlyTermination =
          std::max(quality.earlyTermination, 1.0 - shareOfTermination * tolerance / 255.0);
    m_quality.fineness.reset();
    if (!m_isLocal)
      m_quality.toleranceLevels.reset();
  }

  bool isLocal() const { return m_isLocal; }
  int last() const { return m_isLocal ? Fineness::most : 16; }
  int start() const { return m_start; }

  // Equal steps from 2 voxels on.
  Quality at(int rung) const {
    Quality quality = m_quality;
    if (m_isLocal)
      quality.fineness = rung;
    if (m_isEqual)
      quality.stepVoxels = stepOfRung(rung);
    return quality;
  }

private:
  // Equal steps begin with a quarter of a voxel.
  int startFor(double tolerance) const { return m_isLocal ? std::max(usualFineness(tolerance), 2) : 6; }

  Quality m_quality;
  bool m_isLocal;
  int m_start;
  bool m_isEqual;
};

// The pictures drawn so far, by rung, and the errors that they tell of.
class Comparison {
public:
  Comparison(const Scene& scene, const glm::ivec2& size, const DrawScene& draw, const Ladder& ladder)
      : m_scene(scene), m_size(comparedSize(size)), m_draw(draw), m_ladder(ladder) {}

  const Image& picture(int rung) {
    auto found = m_pictures.find(rung);
    if (found == m_pictures.end()) {
      m_scene.quality = m_ladder.at(rung);
      found = m_pictures.emplace(rung, m_draw(m_scene, m_size)).first;
    }
    return found->second;
  }

  // The error left in the finer one of two pictures whose steps differ by half.
  double errorBehind(int rung) {
    const ImageError halving = imageError(picture(rung), picture(rung + rungsPerHalving));
    std::optional<ImageError> before;
    if (rung >= rungsPerHalving)
      before = imageError(picture(rung - rungsPerHalving), picture(rung));
    return errorAfterHalving(halving, before).p99_9;
  }

  // The error of a picture: how far it lies from a finer one, and that one's own.
  double error(int rung, int finer, double errorOfFiner) {
    return imageError(picture(rung), picture(finer)).p99_9 + errorOfFiner;
  }

private:
  Scene m_scene;
  glm::ivec2 m_size;
  const DrawScene& m_draw;
  const Ladder& m_ladder;
  std::map<int, Image> m_pictures;
};

struct Found {
  int rung = 0;
  double error = 0.0;
};

// The coarsest rung that keeps the bound; the last one where none does.
Found search(Comparison& comparison, const Ladder& ladder, double bound) {
  const int last = ladder.last() - rungsPerHalving;
  for (int rung = std::min(ladder.start(), last);;) {
    const int finer = rung + rungsPerHalving;
    const double errorOfFiner = comparison.errorBehind(rung);
    Found found{rung, comparison.error(rung, finer, errorOfFiner)};
    if (found.error <= bound) {
      // A coarser one may do.
      while (found.rung > 0) {
        const double error = comparison.error(found.rung - 1, finer, errorOfFiner);
        if (error > bound)
          break;
        found = {found.rung - 1, error};
      }
      return found;
    }
    if (rung == last)
      return {finer, errorOfFiner};
    // Errors fall with the step at least: by half in two rungs, commonly in one.
    const double halvings = std::log2(found.error / bound);
    rung = std::min(rung + std::clamp(static_cast<int>(std::ceil(halvings)), 1, 4), last);
  }
}

bool resolvesFunction(const Scene& scene) {
  const double smallest = smallestSpacingMm(scene.volume->grid());
  if (bandsToResolve(scene.transferFunction, smallest).empty())
    return true;
  return blockSteps(blockFacts(*scene.volume), scene.transferFunction, smallest).resolvesFunction;
}

std::string levelsText(double levels) {
  char text[48];
  std::snprintf(text, sizeof text, "%.2g %s", levels, levels == 1.0 ? "level" : "levels");
  return text;
}

std::string whyNot(double tolerance, double error, bool resolves) {
  const std::string cannot = "The tolerance of " + levelsText(tolerance) + " cannot be kept: ";
  if (!resolves)
    return cannot + "a peak or valley of the transfer function is so narrow that even the finest step may "
                    "miss it; make it wider.";
  return cannot + "the finest step comes within about " + levelsText(error) +
         "; make the steps of the transfer function less steep, or allow that many levels.";
}

} // namespace

std::string describe(const WithinTolerance& found) {
  const Quality& quality = found.scene.quality;
  char steps[64];
  if (quality.fineness)
    std::snprintf(steps, sizeof steps, "error-controlled steps of fineness %d", *quality.fineness);
  else
    std::snprintf(steps, sizeof steps, "equal steps of %.3g voxels", quality.stepVoxels);
  return "estimated within " + levelsText(found.estimateLevels) + ", with " + steps;
}

WithinTolerance withinTolerance(const Scene& scene, const glm::ivec2& size, const DrawScene& draw,
                                StepControl control) {
  assert(scene.quality.toleranceLevels);
  const double tolerance = *scene.quality.toleranceLevels;
  const Ladder ladder(scene.quality, scene.projection, control);
  Comparison comparison(scene, size, draw, ladder);
  const double termination = scene.quality.earlyTermination < 1.0 ? shareOfTermination * tolerance : 0.0;
  const double bound = (tolerance - termination) / safety;
  const Found found = search(comparison, ladder, bound);

  WithinTolerance result{scene, safety * found.error + termination, found.error <= bound, {}};
  result.scene.quality = ladder.at(found.rung);
  const bool resolves = !ladder.isLocal() || resolvesFunction(scene);
  result.holds = result.holds && resolves;
  if (!result.holds)
    result.sentence = whyNot(tolerance, result.estimateLevels, resolves);
  return result;
}

} // namespace limn
