// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/LightBeside.h"

#include "accuracy/Tolerance.h"
#include "scene/effects/EffectPlan.h"
#include "scene/volume/Volume.h"
#include "widgets/view/pictures/ErrorProbe.h"
#include "widgets/view/pictures/RestWork.h"

#include <QThreadPool>

#include <algorithm>
#include <atomic>
#include <exception>
#include <utility>

namespace limn {

struct LightBeside::Job {
  Scene scene;
  glm::ivec2 size{0};
  std::optional<ErrorEstimate> estimate; ///< of the steps; once done, of all
  FinishedPicture picture;               ///< without an image where there is none
  bool hasReplaced = false;
  std::atomic<bool> isDone = false, isCancelled = false;

  void run(const MakeEngine& makeEngine) {
    try {
      draw(*makeEngine());
    } catch (const std::exception&) { // the picture on the grid stays, and what is said of it
      picture = {};
    }
    scene = {};
    isDone = true;
  }

  void draw(DrawingEngine& engine) {
    const auto isOver = [this] { return isCancelled.load(); };
    engine.makeReady(scene, Effort{0, isOver, {}});
    const DrawScene whole = [&](const Scene& drawn, const glm::ivec2& pixels) {
      return engine.draw(drawn, pixels, {{0, 0}, pixels}, isOver).value();
    };
    const auto image = std::make_shared<const Image>(whole(scene, size));
    if (estimate) {
      const glm::ivec2 smaller = smallerSize(size, ErrorProbe::longest);
      estimate = withLight(*estimate, errorOfFilter(scene, smaller, whole, mostFilterBits, smaller == size));
    }
    picture = finished(image, scene.image.background);
  }
};

void LightBeside::reset() {
  for (const std::shared_ptr<Job>& job : m_jobs)
    job->isCancelled = true;
  m_jobs.clear();
}

std::shared_ptr<LightBeside::Job> LightBeside::begin(DrawingEngine& engine, const SidePicture& side,
                                                     const std::optional<ErrorEstimate>& ofSteps) const {
  auto job = std::make_shared<Job>();
  job->scene = side.shownScene();
  // A volume on disk would be read once more, against the picture's own reading, and has its light looked up.
  if (!hasTravellingLight(job->scene) || isPhysical(job->scene) || job->scene.volume->room() ||
      engine.facts(job->scene).findsLightOfSamples) {
    job->scene = {};
    job->isDone = true;
    return job;
  }
  job->size = side.size();
  job->estimate = ofSteps;
  QThreadPool::globalInstance()->start([job, makeEngine = m_makeEngine] { job->run(makeEngine); });
  return job;
}

RestTurn LightBeside::step(DrawingEngine& engine, std::span<SidePicture> sides,
                           const std::vector<std::optional<ErrorEstimate>>& ofSteps) {
  if (!m_makeEngine)
    return RestTurn::nothing;
  if (isUnderWay())
    return RestTurn::waiting;
  if (hasNews()) {
    sides[m_jobs.size() - 1].replace(std::exchange(m_jobs.back()->picture, {}));
    m_jobs.back()->hasReplaced = true;
    return RestTurn::finished;
  }
  if (m_jobs.size() == sides.size())
    return RestTurn::nothing;
  m_jobs.push_back(begin(engine, sides[m_jobs.size()], ofSteps[m_jobs.size()]));
  return RestTurn::worked;
}

void LightBeside::leave() {
  if (!isUnderWay())
    return;
  m_jobs.back()->isCancelled = true;
  m_jobs.pop_back();
}

bool LightBeside::isPending(std::span<const SidePicture> sides) const {
  const auto toBegin = sides.subspan(std::min(m_jobs.size(), sides.size()));
  const auto isLit = [](const SidePicture& side) { return hasTravellingLight(side.scene()); };
  return m_makeEngine && (isUnderWay() || hasNews() || std::ranges::any_of(toBegin, isLit));
}

bool LightBeside::hasNews() const {
  return !m_jobs.empty() && m_jobs.back()->isDone && m_jobs.back()->picture.image;
}

bool LightBeside::isUnderWay() const {
  return !m_jobs.empty() && !m_jobs.back()->isDone;
}

bool LightBeside::hasReplaced(int side) const {
  const auto index = static_cast<std::size_t>(side);
  return index < m_jobs.size() && m_jobs[index]->hasReplaced;
}

std::optional<ErrorEstimate> LightBeside::estimate(int side) const {
  return hasReplaced(side) ? m_jobs[static_cast<std::size_t>(side)]->estimate : std::nullopt;
}

} // namespace limn
