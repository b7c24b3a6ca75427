// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/Refinement.h"

#include "accuracy/ErrorEstimate.h"
#include "accuracy/Tolerance.h"
#include "engine/DrawingEngine.h"
#include "scene/ProjectionFacts.h"
#include "scene/effects/EffectPlan.h"
#include "widgets/view/pictures/ErrorProbe.h"
#include "widgets/view/pictures/InteractionQuality.h"
#include "widgets/view/pictures/RestWork.h"
#include "widgets/view/pictures/StepSearch.h"

#include <QThreadPool>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <limits>
#include <utility>

namespace limn {

struct Refinement::Job {
  std::shared_ptr<const Image> before; ///< of twice the step, where the step was halved
  std::shared_ptr<const Image> image;
  Scene scene;
  FinishedPicture picture;
  ImageError halving, earlyEnds;
  std::exception_ptr problem;
  std::atomic<bool> isDone = false;

  void run() {
    try {
      if (before)
        halving = imageError(*image, *before);
      earlyEnds = errorOfEarlyEnds(*image, scene);
      picture = finished(image, scene.image.background);
    } catch (...) {
      problem = std::current_exception();
    }
    isDone = true;
  }
};

namespace {

// Errors can be controlled where light is added up and, cell by cell, everywhere; a scene that asks for its
// own tolerance has had its steps. With light that travels a tolerance takes minutes: who wants it asks for
// it.
bool mayControlErrors(const SidePicture& side, bool goesByCells) {
  return (goesByCells || integrates(side.scene().projection)) && !side.scene().quality.toleranceLevels &&
         !hasTravellingLight(side.scene());
}

bool mayControlAll(DrawingEngine& engine, std::span<const SidePicture> sides) {
  const bool goesByCells = engine.facts(sides.front().scene()).goesByCells;
  return std::ranges::all_of(sides,
                             [&](const SidePicture& side) { return mayControlErrors(side, goesByCells); });
}

// What steps may cost where light is looked up on a grid, levels: half of what that is off by, where it is
// known.
double besideLight(const ImageError& ofGrid) {
  constexpr double usualError = 4.0;
  return std::max(halfALevel, 0.5 * (ofGrid.p99_9 > 0.0 ? ofGrid.p99_9 : usualError));
}

bool haveTravellingLight(std::span<const SidePicture> sides) {
  return std::ranges::any_of(sides, [](const SidePicture& side) { return hasTravellingLight(side.scene()); });
}

bool hasPaths(const SidePicture& side) {
  return isPhysical(side.scene());
}

} // namespace

bool isResolved(DrawingEngine& engine, const Scene& scene) {
  if (isPhysical(scene)) // paths miss nothing
    return true;
  const DrawingFacts facts = engine.facts(scene);
  return stepSeesFunction(scene, facts.steepestPerMm, facts.plan.effects.has(Effect::preintegration));
}

RestTurn Refinement::step(DrawingEngine& engine, std::span<SidePicture> sides,
                          const std::vector<std::optional<ErrorEstimate>>& rough, double budgetMs) {
  if (m_end || sides.empty())
    return RestTurn::nothing;
  if (!m_road || m_looser)
    return chooseRoad(engine, sides, rough, budgetMs);
  if (std::ranges::none_of(sides, &SidePicture::isFiner))
    return begin(engine, sides);
  return advance(engine, sides, budgetMs);
}

RestTurn Refinement::completeLight(DrawingEngine& engine, std::span<SidePicture> sides, double budgetMs) {
  if (std::ranges::none_of(sides, &SidePicture::lacksLight))
    return RestTurn::nothing;
  if (std::ranges::any_of(sides,
                          [&](const SidePicture& side) { return engine.isFindingLight(side.scene()); }))
    return RestTurn::waiting;
  if (!sides.front().isFiner()) {
    m_road = Road::light;
    m_sides.clear();
    m_sides.resize(sides.size());
    for (SidePicture& side : sides)
      side.beginFiner(side.finishedQuality(), side.completeMs().value_or(0.0));
    return RestTurn::worked;
  }
  return advance(engine, sides, budgetMs);
}

RestTurn Refinement::advance(DrawingEngine& engine, std::span<SidePicture> sides, double budgetMs) {
  if (compileOne(engine, sides) || drawStrips(engine, sides, budgetMs) || readOne(sides))
    return RestTurn::worked;
  if (!std::ranges::all_of(m_sides, [](const Side& side) { return !side.job || side.job->isDone.load(); }))
    return RestTurn::waiting;
  return adoptAll(engine, sides);
}

RestTurn Refinement::chooseRoad(DrawingEngine& engine, std::span<SidePicture> sides,
                                const std::vector<std::optional<ErrorEstimate>>& rough, double budgetMs) {
  if (std::ranges::any_of(sides, hasPaths)) {
    m_road = Road::paths;
    m_sides.resize(sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
      m_lastMs += sides[i].completeMs().value_or(0.0);
      // What was followed before tells its error at once.
      if (hasPaths(sides[i]) && sides[i].shownPaths() > 1)
        m_sides[i].paths = engine.pathFigures(sides[i].scene(), sides[i].size());
    }
    return RestTurn::worked;
  }
  if (!m_search)
    beginSearch(engine, sides);
  if (m_search) {
    const RestTurn turn = m_search->step(engine, *m_sheet, budgetMs);
    if (turn != RestTurn::finished)
      return turn;
    m_needed = m_search->found();
    m_search.reset();
  }
  if (m_looser)
    return endTightening();
  m_lastMs = 0.0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double ms = sides[i].completeMs().value_or(0.0);
    m_lastMs += ms;
    // What needs no search takes about as long as what is there.
    if (i < m_needed.size() && m_needed[i].expectedMs == 0.0)
      m_needed[i].expectedMs = ms;
  }
  const double step = sides.front().finishedQuality().stepVoxels;
  const double halvingMs = msOfHalvings(rough, step, m_lastMs, smallestStepVoxels);
  const bool isShorter = isToleranceShorter(m_needed, halvingMs, patienceMs);
  m_road = isShorter ? Road::tolerance : Road::halving;
  for (double later = step / 2.0; !isShorter && later >= smallestStepVoxels; later /= 2.0)
    m_toPrepare.push_back(later);
  m_sides.resize(sides.size());
  if (!isShorter)
    measureFilter(engine, sides);
  return RestTurn::worked;
}

void Refinement::beginSearch(DrawingEngine& engine, std::span<SidePicture> sides) {
  if (!mayControlAll(engine, sides))
    return;
  const DrawingFacts facts = engine.facts(sides.front().scene());
  std::vector<Scene> scenes;
  for (const SidePicture& side : sides)
    scenes.push_back(side.scene());
  m_search.emplace(scenes, sides.front().size(), m_tolerance, m_stripMs,
                   facts.goesByCells ? StepControl::cells : StepControl::local, facts.filterBits);
}

bool Refinement::tighten(DrawingEngine& engine, std::span<const SidePicture> sides) {
  const bool isByStep = m_end == RefinementEnd::withinHalfALevel || m_end == RefinementEnd::smallestStep;
  if (!isByStep || m_tightenings == mostTightenings || !mayControlAll(engine, sides))
    return false;
  ++m_tightenings;
  m_tolerance /= 4.0;
  m_looser = std::exchange(m_end, std::nullopt);
  return true;
}

// The steps are found. By whichever road the pictures came so far, these count their filter.
RestTurn Refinement::endTightening() {
  constexpr double howeverLong = std::numeric_limits<double>::infinity();
  const std::optional<RefinementEnd> before = std::exchange(m_looser, std::nullopt);
  if (!isToleranceShorter(m_needed, howeverLong, patienceMs - m_spentMs)) {
    m_tightenings = mostTightenings;
    m_end = before;
    return RestTurn::finished;
  }
  m_road = Road::tolerance;
  for (Side& side : m_sides)
    side.ofFilter = {};
  return RestTurn::worked;
}

// By small pictures, and only where the driver's weights or a grid of light are coarse: no smaller step mends
// what they add.
void Refinement::measureFilter(DrawingEngine& engine, std::span<SidePicture> sides) {
  if (haveTravellingLight(sides) && !engine.facts(sides.front().scene()).findsLightOfSamples)
    return;
  const DrawScene draw = [&](const Scene& scene, const glm::ivec2& size) {
    m_sheet->resize(size);
    m_sheet->draw(engine, scene, {{0, 0}, size});
    return m_sheet->read();
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const glm::ivec2 size = smallerSize(sides[i].size(), ErrorProbe::longest);
    m_sides[i].ofFilter =
        errorOfFilter(sides[i].shownScene(), size, draw, engine.facts(sides[i].shownScene()).filterBits,
                      size == sides[i].size());
  }
}

RestTurn Refinement::begin(DrawingEngine& engine, std::span<SidePicture> sides) {
  return m_road == Road::paths       ? beginPaths(sides)
         : m_road == Road::tolerance ? beginTolerance(sides)
                                     : beginHalving(engine, sides);
}

// Follow as many again. A picture beside it whose light is not physical stays as it is.
RestTurn Refinement::beginPaths(std::span<SidePicture> sides) {
  bool isEnough = true;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (hasPaths(sides[i])) {
      const std::optional<PathFigures>& paths = m_sides[i].paths;
      isEnough = isEnough && paths && paths->rmsLevels && *paths->rmsLevels <= toleranceLevels;
    }
  if (isEnough)
    m_end = RefinementEnd::withinHalfALevel;
  else if (m_spentMs + 2.0 * m_lastMs > pathPatienceMs)
    m_end = RefinementEnd::patience;
  if (m_end)
    return RestTurn::finished;
  for (SidePicture& side : sides) {
    if (!hasPaths(side))
      continue;
    Quality quality = side.finishedQuality();
    const double ms = side.completeMs().value_or(0.0);
    quality.paths = std::min(2 * quality.paths.value_or(1), mostPaths);
    side.beginFiner(quality, *quality.paths > 2 ? 2.0 * ms : ms);
  }
  return RestTurn::worked;
}

// One pass brings them there.
RestTurn Refinement::beginTolerance(std::span<SidePicture> sides) {
  if (m_needed.empty()) {
    m_end = RefinementEnd::withinHalfALevel;
    return RestTurn::finished;
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
    sides[i].beginFiner(m_needed[i].quality, m_needed[i].expectedMs);
  return RestTurn::worked;
}

// Halve the step, unless the pictures are good enough or nothing would be gained.
RestTurn Refinement::beginHalving(DrawingEngine& engine, std::span<SidePicture> sides) {
  const double step = sides.front().finishedQuality().stepVoxels / 2.0;
  m_end = endBefore(engine, sides, step);
  if (m_end)
    return RestTurn::finished;
  for (SidePicture& side : sides)
    side.beginFiner(withStep(side.scene(), step).quality, 2.0 * side.completeMs().value_or(0.0));
  return RestTurn::worked;
}

std::optional<RefinementEnd> Refinement::endBefore(DrawingEngine& engine, std::span<SidePicture> sides,
                                                   double step) const {
  if (isWithinTarget(engine, sides))
    return haveTravellingLight(sides) ? RefinementEnd::gridOfLight : RefinementEnd::withinHalfALevel;
  if (step < smallestStepVoxels)
    return RefinementEnd::smallestStep;
  for (const SidePicture& side : sides)
    if (!engine.facts(withStep(side.scene(), step)).takesAllSamples)
      return RefinementEnd::sampleLimit;
  if (m_spentMs + 2.0 * m_lastMs > patienceMs)
    return RefinementEnd::patience;
  return std::nullopt;
}

bool Refinement::isWithinTarget(DrawingEngine& engine, std::span<SidePicture> sides) const {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double target =
        hasTravellingLight(sides[i].scene()) ? besideLight(m_sides[i].ofFilter) : halfALevel;
    const double ofFilter = hasTravellingLight(sides[i].scene()) ? 0.0 : m_sides[i].ofFilter.p99_9;
    if (m_sides[i].halvings.empty() || m_sides[i].steps.p99_9 + ofFilter > target ||
        !isResolved(engine, sides[i].shownScene()))
      return false;
  }
  return true;
}

// A smaller step may call for another program: some drivers compile when something is drawn, so one pixel is
// drawn in a turn of its own. For all passes before the first, so that none of them stalls in its middle.
bool Refinement::compileOne(DrawingEngine& engine, std::span<SidePicture> sides) {
  for (; !m_toPrepare.empty(); m_toPrepare.pop_back())
    for (SidePicture& side : sides)
      if (side.prepareFiner(engine, m_toPrepare.back()))
        return true;
  return false;
}

bool Refinement::drawStrips(DrawingEngine& engine, std::span<SidePicture> sides, double budgetMs) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  bool hasDrawn = false;
  for (;;) {
    const auto done = [](const SidePicture& side) {
      return side.isFiner() ? side.finerSchedule().fraction() : 1.0;
    };
    SidePicture& next = *std::ranges::min_element(sides, {}, done);
    if (!next.isFiner())
      return hasDrawn;
    if (next.finerSchedule().complete())
      return hasDrawn;
    const double spentMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    if (hasDrawn && spentMs + next.finerSchedule().predictedMs() > budgetMs)
      return true;
    next.drawFinerStrip(engine);
    hasDrawn = true;
  }
}

// The engine holds of each pixel all its paths: of rows that the pass has drawn, more. An estimate that
// chance makes larger tells of the estimate and not of the picture, which only gets better.
void Refinement::judgePass(DrawingEngine& engine, std::span<const SidePicture> sides) {
  if (m_road != Road::paths)
    return;
  for (std::size_t i = 0; i < m_sides.size(); ++i) {
    const std::optional<PathFigures> told = m_sides[i].onTheWay ? m_sides[i].onTheWay : m_sides[i].paths;
    if (!sides[i].isFiner() || !told || !estimateOf(*told))
      continue;
    std::optional<PathFigures> now = engine.pathFigures(sides[i].finerScene(), sides[i].size());
    if (!now || !estimateOf(*now))
      continue;
    now->rmsLevels = std::min(*now->rmsLevels, *told->rmsLevels);
    now->p99_9Levels = std::min(*now->p99_9Levels, *told->p99_9Levels);
    m_sides[i].onTheWay = now;
  }
}

bool Refinement::readOne(std::span<SidePicture> sides) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (m_sides[i].job || !sides[i].isFiner())
      continue;
    auto job = std::make_shared<Job>();
    if (m_road == Road::halving)
      job->before = sides[i].picture().image;
    job->image = std::make_shared<const Image>(sides[i].readFiner());
    job->scene = sides[i].finerScene();
    m_sides[i].job = job;
    QThreadPool::globalInstance()->start([job] { job->run(); });
    return true;
  }
  return false;
}

RestTurn Refinement::adoptAll(DrawingEngine& engine, std::span<SidePicture> sides) {
  m_lastMs = 0.0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::shared_ptr<Job> job = std::move(m_sides[i].job);
    if (!job) // its picture stayed as it is
      continue;
    if (job->problem)
      std::rethrow_exception(job->problem);
    if (m_road == Road::light) {
      sides[i].adoptFiner(std::move(job->picture));
      continue;
    }
    if (job->before) {
      m_sides[i].halvings.push_back(job->halving);
      m_sides[i].steps = errorAfterHalvings(m_sides[i].halvings);
    } else if (m_road == Road::tolerance) {
      m_sides[i].steps = m_needed[i].estimate;
    }
    if (m_road != Road::paths)
      m_sides[i].whole = (hasTravellingLight(job->scene) ? withLight : withFilter)(
          withEarlyEnds(m_sides[i].steps, job->earlyEnds), m_sides[i].ofFilter);
    else
      m_sides[i].paths = engine.pathFigures(sides[i].finerScene(), sides[i].size());
    m_sides[i].onTheWay.reset();
    m_lastMs += sides[i].finerSchedule().spentMs();
    sides[i].adoptFiner(std::move(job->picture));
  }
  m_spentMs += m_lastMs;
  if (m_road == Road::tolerance) // done
    m_needed.clear();
  if (m_road == Road::light) // what follows begins anew
    m_road.reset();
  return RestTurn::finished;
}

void Refinement::leavePass(std::span<SidePicture> sides) {
  for (SidePicture& side : sides)
    side.leaveFiner();
  for (Side& side : m_sides) {
    side.job.reset();
    side.onTheWay.reset();
  }
  m_search.reset();
}

std::optional<PathFigures> Refinement::paths(int side) const {
  const auto index = static_cast<std::size_t>(side);
  return index < m_sides.size() ? m_sides[index].paths : std::nullopt;
}

std::optional<PathFigures> Refinement::pathsOnTheWay(int side) const {
  const auto index = static_cast<std::size_t>(side);
  return index < m_sides.size() ? m_sides[index].onTheWay : std::nullopt;
}

std::optional<ErrorEstimate> Refinement::estimate(int side) const {
  const auto index = static_cast<std::size_t>(side);
  return index < m_sides.size() ? m_sides[index].whole : std::nullopt;
}

} // namespace limn
