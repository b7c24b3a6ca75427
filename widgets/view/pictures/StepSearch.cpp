// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/StepSearch.h"

#include "engine/DrawingEngine.h"
#include "scene/steps/LocalSteps.h"
#include "widgets/view/pictures/PictureScreen.h"

#include <QThreadPool>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

namespace limn {

struct StepSearch::Job {
  std::shared_ptr<ToleranceSearch> search;
  Image image;
  std::exception_ptr problem;
  std::atomic<bool> isDone = false;

  void run() {
    try {
      search->give(std::move(image));
    } catch (...) {
      problem = std::current_exception();
    }
    isDone = true;
  }
};

StepSearch::StepSearch(const std::vector<Scene>& scenes, const glm::ivec2& size, double levels,
                       double stripMs, StepControl control, int filterBits)
    : m_size(size), m_levels(levels), m_stripMs(stripMs) {
  for (Scene scene : scenes) {
    scene.quality.toleranceLevels = levels;
    scene.quality.fineness.reset();
    m_sides.emplace_back().search = std::make_shared<ToleranceSearch>(scene, size, control, filterBits);
  }
}

RestTurn StepSearch::step(DrawingEngine& engine, PictureSheet& sheet, double budgetMs) {
  for (Side& side : m_sides) {
    if (side.job) {
      if (!side.job->isDone)
        return RestTurn::waiting;
      if (const std::exception_ptr problem = std::exchange(side.job, nullptr)->problem)
        std::rethrow_exception(problem);
    }
    if (side.search->wanted())
      return draw(side, engine, sheet, budgetMs);
  }
  return RestTurn::finished;
}

RestTurn StepSearch::draw(Side& side, DrawingEngine& engine, PictureSheet& sheet, double budgetMs) const {
  using Clock = std::chrono::steady_clock;
  const auto [scene, size] = *side.search->wanted();
  sheet.resize(size);
  // One pixel first: what is compiled or gathered for it is no measure of the pictures to come.
  if (side.warmWith != scene.quality.ownWeights) {
    side.warmWith = scene.quality.ownWeights;
    sheet.draw(engine, scene, {size / 2, {1, 1}});
    return RestTurn::worked;
  }
  if (!side.schedule)
    side.schedule.emplace(size, m_stripMs);
  TileSchedule& schedule = *side.schedule;
  const auto start = Clock::now();
  const auto msSinceStart = [&] {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  };
  double before = 0.0;
  do {
    sheet.draw(engine, scene, schedule.next());
    const double now = msSinceStart();
    schedule.finished(now - std::exchange(before, now));
  } while (!schedule.complete() && before + schedule.predictedMs() <= budgetMs);
  if (!schedule.complete())
    return RestTurn::worked;
  const double pixels = static_cast<double>(size.x) * size.y;
  side.taken.push_back({finenessOf(scene.quality).value_or(0.0), pixels, schedule.spentMs()});
  side.schedule.reset();
  side.job = std::make_shared<Job>();
  side.job->search = side.search;
  side.job->image = sheet.read();
  QThreadPool::globalInstance()->start([job = side.job] { job->run(); });
  return RestTurn::worked;
}

// From the largest of the small pictures, and of those the one whose steps are nearest.
double StepSearch::expectedMs(const Side& side) const {
  if (side.taken.empty())
    return 0.0;
  const double fineness = finenessOf(side.search->found().scene.quality).value_or(0.0);
  const Taken& nearest = *std::ranges::min_element(side.taken, {}, [&](const Taken& taken) {
    return std::pair(-taken.pixels, std::abs(taken.fineness - fineness));
  });
  const double pixels = static_cast<double>(m_size.x) * m_size.y;
  return nearest.ms * pixels / nearest.pixels * std::exp2((fineness - nearest.fineness) / rungsPerHalving);
}

std::vector<NeededSteps> StepSearch::found() const {
  std::vector<NeededSteps> needed;
  for (const Side& side : m_sides) {
    const WithinTolerance& found = side.search->found();
    // Where little of a picture is covered, percentiles of small ones scatter by up to half: the tolerance
    // that is kept is what can be promised. Errors of such steps fall with the square of the step.
    const double levels = std::max(found.estimateLevels, m_levels);
    const ErrorEstimate estimate{levels, found.meanLevels, 2.0};
    needed.push_back({found.scene.quality, estimate, expectedMs(side), found.holds});
  }
  return needed;
}

double msOfHalvings(const std::vector<std::optional<ErrorEstimate>>& rough, double stepVoxels,
                    double pictureMs, double smallestStepVoxels) {
  constexpr double never = std::numeric_limits<double>::infinity();
  double halvings = 1.0; // the first one tells how large the error is
  for (const std::optional<ErrorEstimate>& estimate : rough) {
    if (!estimate)
      return never;
    const double needed = std::log2(std::max(estimate->p99_9, halfALevel) / halfALevel) / estimate->order;
    halvings = std::max(halvings, std::ceil(needed));
  }
  if (stepVoxels * std::exp2(-halvings) < smallestStepVoxels)
    return never;
  return pictureMs * (std::exp2(halvings + 1.0) - 2.0);
}

bool isToleranceShorter(const std::vector<NeededSteps>& needed, double halvingMs, double patienceMs) {
  double ms = 0.0;
  for (const NeededSteps& steps : needed) {
    if (!steps.holds)
      return false;
    ms += steps.expectedMs;
  }
  return !needed.empty() && ms < halvingMs && ms <= patienceMs;
}

} // namespace limn
