// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/Tolerance.h"

#include "accuracy/ErrorEstimate.h"
#include "scene/LabelLooks.h"
#include "scene/ProjectionFacts.h"
#include "scene/effects/EffectPlan.h"
#include "scene/steps/BlockWalk.h"
#include "scene/steps/LocalSteps.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

namespace limn {
namespace {

// Pictures that are compared have a share of the pixels, and so many at least. First some that are near the
// steps wanted are found; then their error, whose 99.9th percentile scatters by 7 to 8 % with so many pixels.
struct Sample {
  double share;
  double fewest;
  double most = 1e9;
};
constexpr Sample rough{1.0 / 50.0, 72.0 * 72.0};
constexpr Sample fine{1.0 / 14.0, 128.0 * 128.0};
constexpr Sample fineByCells{1.0 / 8.0, 128.0 * 128.0};

// Fewer pixels than these have no percentile to speak of.
constexpr double singleRays = 64.0 * 64.0;

// What an estimate from so few may lie below the error of the whole picture, measured on the shared data sets
// and the analytic scenes (tests/accuracy/ToleranceTest.cpp).
constexpr double safety = 1.2;

// The same of pictures found cell by cell, which are compared with one that is all but exact, so that the few
// pixels alone are to blame: at 512² some 33 lie beyond the percentile, whose place scatters by 17 % and its
// value, as errors fall off by a power of about two, by 9 %. A whole picture tells its own.
constexpr double safetyOfSample = 1.2;
constexpr double safetyOfWhole = 1.02;

// So much finer than a picture is the one that tells its error cell by cell: its own is a sixty-fourth.
constexpr double nearlyExact = 6.0;

// The same of what a driver's filter adds. Along an axis of the grid a picture of other pixels has all its
// samples rounded by another part of the 2^-(b+1) voxel at most: commonly by half of that, and the next
// picture by all of it. Seen: 1.9 times (tests/raycaster/FilterWeightsTest.cpp).
constexpr double safetyOfFilter = 2.0;

// What few paths, or a grid of light, add is compared in so many pixels, because many paths take long. A
// handful of them lies beyond the percentile, which is told from the half of a hundredth that is off most
// instead.
constexpr Sample ofLight{1.0 / 20.0, 112.0 * 112.0, 192.0 * 192.0};
constexpr double shareOfTail = 0.005;

// What that tells is 0.90 to 1.04 of the whole picture's figure on average, of eleven scenes of four volumes
// (85² of 256² pixels, at all their places): in the middle of both it lies no farther off on either side than
// 7 %. From a whole hundredth it would tell 0.83 to 1.01.
constexpr double tailOfLight = 1.03;

// The share of the tolerance that rays which end early may take.
constexpr double shareOfTermination = 0.125;

// The share that a driver's filter may take. Steps that are left no less than half take up to √2 times as
// many samples, one unit of fineness; eight voxels fetched for each sample cost more.
constexpr double shareOfFilter = 0.5;

// After so many pictures the coarsest that is fine enough will do. Cell by cell coarse ones cost little.
constexpr int mostTries = 4;
constexpr int mostTriesByCells = 8;

// Errors of few pixels fall in jumps: between rungs so near another picture tells nothing.
constexpr double nearestRungs = 1.0 / 8.0;

// How far below the bound an error may lie before coarser steps are looked for.
constexpr double wellSpent = 0.85;
constexpr double wellSpentByCells = 0.9;

glm::ivec2 comparedSize(const glm::ivec2& size, const Sample& sample) {
  const double pixels = static_cast<double>(size.x) * size.y;
  const double scale =
      std::min(1.0, std::sqrt(std::clamp(sample.share * pixels, sample.fewest, sample.most) / pixels));
  return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * scale)), glm::ivec2(1));
}

// A fineness is told in sixteenths.
double rounded(double rung) {
  return std::round(16.0 * rung) / 16.0;
}

// The qualities that are tried: rung by rung, a fineness or, where steps are equal, the step of that rung.
class Ladder {
public:
  Ladder(const Scene& scene, StepControl control)
      : m_quality(scene.quality), m_isLocal(control != StepControl::equal && integrates(scene.projection)),
        m_isByCells(control == StepControl::cells && m_isLocal),
        m_mostFineness(hasTravellingLight(scene) ? mostLitFineness : Fineness::most),
        m_start(startFor(*scene.quality.toleranceLevels)),
        m_isEqual(!m_isLocal || (!m_isByCells && showsSurface(scene.projection))) {
    const Quality& quality = scene.quality;
    const double tolerance = *quality.toleranceLevels;
    m_quality.jitter = false;
    if (quality.earlyTermination < 1.0)
      m_quality.earlyTermination =
          std::max(quality.earlyTermination, 1.0 - shareOfTermination * tolerance / 255.0);
    m_quality.fineness.reset();
    m_quality.ownWeights = false;
    if (!m_isLocal)
      m_quality.toleranceLevels.reset();
  }

  // From here on.
  void weighInFloats() { m_quality.ownWeights = true; }

  bool isLocal() const { return m_isLocal; }
  bool isByCells() const { return m_isByCells; }
  int last() const { return m_isLocal ? static_cast<int>(m_mostFineness) : 16; }
  double start() const { return m_start; }

  // Equal steps from 2 voxels on.
  Quality at(double rung) const {
    Quality quality = m_quality;
    if (m_isLocal)
      quality.fineness = rung;
    if (m_isEqual)
      quality.stepVoxels = stepOfRung(rung);
    return quality;
  }

private:
  // Equal steps begin with a quarter of a voxel.
  double startFor(double tolerance) const {
    return m_isLocal ? std::max(rounded(usualFineness(tolerance)), 2.0) : 6.0;
  }

  Quality m_quality;
  bool m_isLocal, m_isByCells;
  double m_mostFineness;
  double m_start;
  bool m_isEqual;
};

struct Found {
  double rung = 0.0;
  double error = 0.0; // levels, of the 99.9th percentile
  double mean = 0.0;
};

// The pictures drawn so far, by rung, and the errors that they tell of.
class Comparison {
public:
  Comparison(const Scene& scene, const glm::ivec2& size, const DrawScene& draw, const Ladder& ladder)
      : m_scene(scene), m_size(size), m_draw(draw), m_ladder(ladder) {}

  bool isWhole(const glm::ivec2& size) const { return m_size == size; }
  bool isOfSingleRays() const { return double(m_size.x) * m_size.y < singleRays; }

  const Image& picture(double rung) {
    auto found = m_pictures.find(rung);
    if (found == m_pictures.end()) {
      m_scene.quality = m_ladder.at(rung);
      found = m_pictures.emplace(rung, m_draw(m_scene, m_size)).first;
    }
    return found->second;
  }

  // What the driver's filter adds to a picture, from the same one with own weights.
  ImageError ofFilter(double rung) {
    const Image& filtered = picture(rung);
    m_scene.quality = m_ladder.at(rung);
    m_scene.quality.ownWeights = true;
    return imageError(filtered, m_draw(m_scene, m_size));
  }

  void forget() { m_pictures.clear(); }

  // The error of a picture from one that is some rungs finer: an error that falls with the square of the step
  // is nearly all of their difference. A finer one that is there serves again.
  Found errorOf(double rung) {
    if (m_ladder.isByCells()) {
      const ImageError error = imageError(picture(rung), picture(exactFor(rung)));
      return {rung, error.p99_9, error.mean};
    }
    const double finer = finerThan(rung);
    const ImageError difference = imageError(picture(rung), picture(finer));
    const double left = std::exp2(rung - finer);
    // Equal steps may err by the step itself. Of error-controlled ones errors hardly add up at the
    // percentile: over the shared data sets a quarter of what is left in the finer picture is missed.
    const double missed = m_ladder.isLocal() ? 1.0 + 0.25 * left : 1.0 / (1.0 - std::sqrt(left));
    return {rung, missed * difference.p99_9, missed * difference.mean};
  }

  // The error left in the finer one of two pictures whose steps differ by half.
  double errorBehind(double rung) {
    const ImageError halving = imageError(picture(rung), picture(rung + rungsPerHalving));
    std::optional<ImageError> before;
    if (rung >= rungsPerHalving)
      before = imageError(picture(rung - rungsPerHalving), picture(rung));
    return errorAfterHalving(halving, before).p99_9;
  }

  // The error of a picture: how far it lies from a finer one, and that one's own.
  double error(double rung, double finer, double errorOfFiner) {
    return imageError(picture(rung), picture(finer)).p99_9 + errorOfFiner;
  }

private:
  // The picture that is all but exact beside another; one serves several.
  double exactFor(double rung) {
    if (rung + nearlyExact - 2.0 > m_exact)
      m_exact = std::min(rung + nearlyExact, double(m_ladder.last()));
    return m_exact;
  }

  // Which finer picture to compare with: one already drawn, where there is one that is finer by enough.
  double finerThan(double rung) const {
    const double usual = m_ladder.isLocal() ? 2.0 : 4.0;
    const double least = m_ladder.isLocal() ? 1.5 : 3.0;
    const auto found = m_pictures.lower_bound(rung + least);
    const bool isThere = found != m_pictures.end() && found->first <= rung + usual + 2.0;
    return isThere ? found->first : std::min(rung + usual, double(m_ladder.last()));
  }

  Scene m_scene;
  glm::ivec2 m_size;
  const DrawScene& m_draw;
  const Ladder& m_ladder;
  double m_exact = 0.0;
  std::map<double, Image> m_pictures;
};

// By how many rungs the error halves, from two errors; commonly by one.
double rungsToHalve(const Found& a, const Found& b) {
  const double halvings = std::log2(std::max(a.error, 1e-9) / std::max(b.error, 1e-9));
  return std::clamp((b.rung - a.rung) / (halvings == 0.0 ? 1e-9 : halvings), 0.5, 2.0);
}

// Whether what comes of light is found by little more than what shows: the ray caster's filter has no such
// scenes.
bool isLightRough(const Scene& scene) {
  return hasTravellingLight(scene) && !scene.quality.toleranceLevels &&
         scene.quality.light != LightDetail::sampled;
}

// The coarsest steps that keep the bound, parts of rungs included; the finest where none do. Errors of whole
// pictures change evenly with the steps: what is up to `near` rungs finer than a picture whose error is
// known, or a little coarser, need not be drawn.
Found search(Comparison& comparison, const Ladder& ladder, double bound, double start, double near) {
  const double last = ladder.last() - rungsPerHalving;
  const double enough = ladder.isByCells() ? wellSpentByCells : wellSpent;
  const double aim = 0.5 * (1.0 + enough) * bound;
  std::optional<Found> before, best;
  double tooCoarse = -1.0;
  double rung = std::min(start, last);
  const int most = ladder.isByCells() ? mostTriesByCells : mostTries;
  for (int tries = 1;; ++tries) {
    const Found found = comparison.errorOf(rung);
    const bool isFineEnough = found.error <= bound;
    if (isFineEnough ? found.error >= enough * bound || rung <= 0.0 : rung >= last)
      return found;
    if (isFineEnough && (!best || found.rung < best->rung))
      best = found;
    if (!isFineEnough)
      tooCoarse = std::max(tooCoarse, found.rung);
    // Errors that jump would have it go on.
    if (best && (tries >= most || best->rung - tooCoarse <= nearestRungs))
      return *best;
    const double perHalving = before ? rungsToHalve(*before, found) : 1.0;
    const double missing = perHalving * std::log2(std::max(found.error, 1e-3 * bound) / aim);
    if (missing <= near && missing >= -0.4 * near && rung + missing >= 0.0 && rung + missing <= last)
      return {rounded(rung + missing), aim, found.mean * aim / std::max(found.error, 1e-3 * bound)};
    // Where errors fall slowly, longer and longer strides come to an end.
    const double stride = std::clamp(missing, -4.0, 4.0);
    rung = std::clamp(rounded(rung + (isFineEnough ? stride : std::max(stride, 0.25 * tries))), 0.0, last);
    if (best && tooCoarse >= 0.0 && (rung <= tooCoarse || rung >= best->rung))
      rung = rounded(0.5 * (tooCoarse + best->rung));
    before = found;
  }
}

// By how much pictures of few pixels may tell too little.
ImageError scaled(ImageError error, double factor) {
  error.p99_9 *= factor;
  error.mean *= factor;
  return error;
}

// Of single rays the mean is taken to be as large.
Found ofSingleRays(double rung, double error) {
  return {rung, error, error};
}

// The coarsest whole rung from which on all keep the bound. Found cell by cell, a single ray is exact with
// the last.
Found searchFromFinest(Comparison& comparison, const Ladder& ladder, double bound) {
  const int last = ladder.last();
  Found found = ofSingleRays(last, 0.0);
  for (int rung = last - 1; rung >= 0; --rung) {
    const double error = comparison.error(rung, last, 0.0);
    if (error > bound)
      break;
    found = ofSingleRays(rung, error);
  }
  return found;
}

// The coarsest whole rung that keeps the bound, with the error of the finer picture counted: of single rays
// two pictures may agree by chance.
Found searchCarefully(Comparison& comparison, const Ladder& ladder, double bound) {
  if (ladder.isByCells())
    return searchFromFinest(comparison, ladder, bound);
  const int last = ladder.last() - rungsPerHalving;
  for (int rung = std::min(static_cast<int>(std::ceil(ladder.start())), last);;) {
    const int finer = rung + rungsPerHalving;
    const double errorOfFiner = comparison.errorBehind(rung);
    Found found = ofSingleRays(rung, comparison.error(rung, finer, errorOfFiner));
    if (found.error <= bound) {
      // A coarser one may do.
      while (found.rung > 0) {
        const double error = comparison.error(found.rung - 1, finer, errorOfFiner);
        if (error > bound)
          break;
        found = ofSingleRays(found.rung - 1, error);
      }
      return found;
    }
    if (rung == last)
      return ofSingleRays(finer, errorOfFiner);
    // Errors fall with the step at least: by half in two rungs, commonly in one.
    const double halvings = std::log2(found.error / bound);
    rung = std::min(rung + std::clamp(static_cast<int>(std::ceil(halvings)), 1, 4), last);
  }
}

bool resolvesFunction(const Scene& scene) {
  const double smallest = smallestSpacingMm(scene.volume->grid());
  const std::vector<TransferFunction> functions = labelLooks(scene).functions;
  if (std::all_of(functions.begin(), functions.end(), [smallest](const TransferFunction& function) {
        return bandsToResolve(function, smallest).empty();
      }))
    return true;
  return blockSteps(scene, blockFacts(*scene.volume)).resolvesFunction;
}

Message levelsText(double levels) {
  return (levels == 1.0 ? Message::tr("%1 level") : Message::tr("%1 levels"))
      .arg(Message::rounded(levels, 2));
}

Message whyNot(double tolerance, double error, bool resolves) {
  if (!resolves)
    return Message::tr(
               "The tolerance of %1 cannot be kept: a peak or valley of the transfer function is so narrow "
               "that even the finest step may miss it; make it wider.")
        .arg(levelsText(tolerance));
  return Message::
      tr("The tolerance of %1 cannot be kept: the finest step comes within about %2; make the steps of the "
         "transfer function less steep, or allow that many levels.")
          .arg(levelsText(tolerance), levelsText(error));
}

// A surface is met exactly: the light on its way to it is off alone, by less the more paths it comes along.
WithinTolerance surfaceInLight(const Scene& scene, const glm::ivec2& size, const DrawScene& draw) {
  const double tolerance = *scene.quality.toleranceLevels;
  const double last = mostLitFineness - rungsPerHalving;
  const auto drawn = [&](double fineness) {
    Scene finer = scene;
    finer.quality.fineness = fineness;
    return draw(finer, size);
  };
  WithinTolerance found{scene, 0.0, 0.0, false, {}};
  found.scene.quality.jitter = false;
  for (double fineness = std::min(usualFineness(tolerance), last); !found.holds; ++fineness) {
    const ImageError error = scaled(imageError(drawn(fineness), drawn(fineness + rungsPerHalving)), safety);
    found.scene.quality.fineness = fineness;
    found.estimateLevels = error.p99_9;
    found.meanLevels = error.mean;
    found.holds = error.p99_9 <= tolerance;
    if (fineness + 1.0 > last)
      break;
  }
  if (!found.holds)
    found.sentence = whyNot(tolerance, found.estimateLevels, true);
  return found;
}

} // namespace

Message describe(const WithinTolerance& found) {
  const Quality& quality = found.scene.quality;
  const bool isLit = hasTravellingLight(found.scene);
  if (quality.fineness && !isLit && !integrates(found.scene.projection))
    return Message::tr("exact but for rounding, found cell by cell");
  if (quality.fineness && isLit)
    return Message::tr("estimated within %1, with steps and paths of light of fineness %2")
        .arg(levelsText(found.estimateLevels), Message::rounded(*quality.fineness, 3));
  const Message steps =
      quality.fineness
          ? Message::tr("error-controlled steps of fineness %1").arg(Message::rounded(*quality.fineness, 3))
          : (quality.stepVoxels == 1.0 ? Message::tr("equal steps of %1 voxel")
                                       : Message::tr("equal steps of %1 voxels"))
                .arg(Message::rounded(quality.stepVoxels, 3));
  return (quality.ownWeights ? Message::tr("estimated within %1, with %2 and own weights between voxels")
                             : Message::tr("estimated within %1, with %2"))
      .arg(levelsText(found.estimateLevels), steps);
}

ImageError errorOfFilter(const Scene& scene, const glm::ivec2& size, const DrawScene& draw, int filterBits,
                         bool isWhole) {
  if (isLightRough(scene)) {
    Scene sampled = scene;
    sampled.quality.light = LightDetail::sampled;
    const glm::ivec2 compared = comparedSize(size, ofLight);
    const Image looked = draw(scene, compared), exact = draw(sampled, compared);
    if (isWhole && compared == size)
      return imageError(looked, exact);
    ImageError error = errorByTail(looked, precise(exact), shareOfTail);
    error.p99_9 *= tailOfLight;
    return error;
  }
  if (filterBits >= mostFilterBits || scene.quality.ownWeights)
    return {};
  Scene own = scene;
  own.quality.ownWeights = true;
  const glm::ivec2 compared = comparedSize(size, fine);
  return scaled(imageError(draw(scene, compared), draw(own, compared)), safetyOfFilter);
}

WithinTolerance withinTolerance(const Scene& scene, const glm::ivec2& size, const DrawScene& draw,
                                StepControl control, int filterBits) {
  assert(scene.quality.toleranceLevels);
  // What all but exact light takes serves no comparison: a fineness more is twice as many paths.
  if (control == StepControl::cells && integrates(scene.projection) && hasTravellingLight(scene))
    control = StepControl::local;
  const double tolerance = *scene.quality.toleranceLevels;
  if (control == StepControl::cells && showsSurface(scene.projection) && !integrates(scene.projection) &&
      hasTravellingLight(scene))
    return surfaceInLight(scene, comparedSize(size, fine), draw);
  if (control == StepControl::cells && !integrates(scene.projection)) {
    WithinTolerance exact{scene, 0.0, 0.0, true, {}};
    exact.scene.quality.jitter = false;
    exact.scene.quality.fineness = usualFineness(tolerance); // any
    return exact;
  }
  Ladder ladder(scene, control);
  const double termination = scene.quality.earlyTermination < 1.0 ? shareOfTermination * tolerance : 0.0;
  Comparison comparison(scene, comparedSize(size, ladder.isByCells() ? fineByCells : fine), draw, ladder);
  // Of a picture, errors of the step show at edges and those of early ends in opaque tissue: its percentile
  // is that of the larger ones. Of a single ray they add.
  const bool isOfSingleRays = comparison.isOfSingleRays();
  const double added = isOfSingleRays ? termination : 0.0;
  const double factor = !ladder.isByCells()        ? safety
                        : comparison.isWhole(size) ? safetyOfWhole
                                                   : safetyOfSample;
  double bound = (tolerance - added) / factor;
  ImageError filter;
  Found found;
  if (isOfSingleRays) {
    if (filterBits < mostFilterBits)
      ladder.weighInFloats();
    found = searchCarefully(comparison, ladder, bound);
  } else {
    Comparison roughly(scene, comparedSize(size, rough), draw, ladder);
    const double near = search(roughly, ladder, bound, ladder.start(), 1.0).rung;
    if (filterBits < mostFilterBits)
      filter = scaled(comparison.ofFilter(near), safetyOfFilter);
    if (filter.p99_9 > shareOfFilter * tolerance) {
      ladder.weighInFloats();
      comparison.forget();
      filter = {};
    }
    bound -= filter.p99_9 / factor;
    found = search(comparison, ladder, bound, near, ladder.isByCells() ? 0.1 : 0.3);
  }

  WithinTolerance result{scene,
                         std::max(factor * found.error + added, termination) + filter.p99_9,
                         factor * found.mean + filter.mean,
                         found.error <= bound,
                         {}};
  result.scene.quality = ladder.at(found.rung);
  const bool resolves = !ladder.isLocal() || ladder.isByCells() || resolvesFunction(scene);
  result.holds = result.holds && resolves;
  if (!result.holds)
    result.sentence = whyNot(tolerance, result.estimateLevels, resolves);
  return result;
}

} // namespace limn
