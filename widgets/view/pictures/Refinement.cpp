// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/Refinement.h"

#include "accuracy/ErrorEstimate.h"
#include "engine/DrawingEngine.h"

#include <QThreadPool>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>

namespace limn {

struct Refinement::Job {
  std::shared_ptr<const Image> before, image;
  Scene scene;
  FinishedPicture picture;
  ImageError halving, earlyEnds;
  std::exception_ptr problem;
  std::atomic<bool> isDone = false;

  void run() {
    try {
      halving = imageError(*image, *before);
      earlyEnds = errorOfEarlyEnds(*image, scene);
      picture = finished(image, scene.image.background);
    } catch (...) {
      problem = std::current_exception();
    }
    isDone = true;
  }
};

bool isResolved(DrawingEngine& engine, const Scene& scene) {
  const DrawingFacts facts = engine.facts(scene);
  return stepSeesFunction(scene, facts.steepestPerMm, facts.plan.effects.has(Effect::preintegration));
}

RestTurn Refinement::step(DrawingEngine& engine, std::span<SidePicture> sides, double budgetMs) {
  if (m_end || sides.empty())
    return RestTurn::nothing;
  if (!sides.front().isFiner())
    return begin(engine, sides);
  if (compileOne(engine, sides) || drawStrips(engine, sides, budgetMs) || readOne(sides))
    return RestTurn::worked;
  if (!std::all_of(m_sides.begin(), m_sides.end(), [](const Side& side) { return side.job->isDone.load(); }))
    return RestTurn::waiting;
  return adoptAll(sides);
}

// Halve the step, unless the pictures are good enough or nothing would be gained.
RestTurn Refinement::begin(DrawingEngine& engine, std::span<SidePicture> sides) {
  const double step = sides.front().finishedStepVoxels() / 2.0;
  if (m_sides.empty()) {
    for (const SidePicture& side : sides)
      m_lastMs += side.completeMs().value_or(0.0);
    for (double later = step; later >= smallestStepVoxels; later /= 2.0)
      m_toPrepare.push_back(later);
  }
  m_sides.resize(sides.size());
  m_end = endBefore(engine, sides, step);
  if (m_end)
    return RestTurn::finished;
  for (SidePicture& side : sides)
    side.beginFiner(step);
  return RestTurn::worked;
}

std::optional<RefinementEnd> Refinement::endBefore(DrawingEngine& engine, std::span<SidePicture> sides,
                                                   double step) const {
  if (isWithinTarget(engine, sides))
    return RefinementEnd::withinHalfALevel;
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
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (m_sides[i].halvings.empty() || m_sides[i].steps.p99_9 > halfALevel ||
        !isResolved(engine, withStep(sides[i].scene(), sides[i].finishedStepVoxels())))
      return false;
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
    SidePicture& next = *std::min_element(sides.begin(), sides.end(), [](const auto& a, const auto& b) {
      return a.finerSchedule().fraction() < b.finerSchedule().fraction();
    });
    if (next.finerSchedule().complete())
      return hasDrawn;
    const double spentMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    if (hasDrawn && spentMs + next.finerSchedule().predictedMs() > budgetMs)
      return true;
    next.drawFinerStrip(engine);
    hasDrawn = true;
  }
}

bool Refinement::readOne(std::span<SidePicture> sides) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (m_sides[i].job)
      continue;
    auto job = std::make_shared<Job>();
    job->before = sides[i].picture().image;
    job->image = std::make_shared<const Image>(sides[i].readFiner());
    job->scene = sides[i].scene();
    m_sides[i].job = job;
    QThreadPool::globalInstance()->start([job] { job->run(); });
    return true;
  }
  return false;
}

RestTurn Refinement::adoptAll(std::span<SidePicture> sides) {
  m_lastMs = 0.0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::shared_ptr<Job> job = std::move(m_sides[i].job);
    if (job->problem)
      std::rethrow_exception(job->problem);
    m_sides[i].halvings.push_back(job->halving);
    m_sides[i].steps = errorAfterHalvings(m_sides[i].halvings);
    m_sides[i].whole = withEarlyEnds(m_sides[i].steps, job->earlyEnds);
    m_lastMs += sides[i].finerSchedule().spentMs();
    sides[i].adoptFiner(std::move(job->picture));
  }
  m_spentMs += m_lastMs;
  return RestTurn::finished;
}

void Refinement::leavePass(std::span<SidePicture> sides) {
  for (SidePicture& side : sides)
    side.leaveFiner();
  for (Side& side : m_sides)
    side.job.reset();
}

std::optional<ErrorEstimate> Refinement::estimate(int side) const {
  const auto index = static_cast<std::size_t>(side);
  if (index >= m_sides.size() || m_sides[index].halvings.empty())
    return std::nullopt;
  return m_sides[index].whole;
}

} // namespace limn
