// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/ChanceCheck.h"

#include "scene/effects/EffectPlan.h"
#include "scene/volume/Volume.h"

#include <QThreadPool>

#include <atomic>
#include <exception>

namespace limn {

struct ChanceCheck::Job {
  Scene scene;
  std::shared_ptr<const Image> image;
  std::optional<ErrorByChance> error;
  bool isTold = false;
  std::atomic<bool> isDone = false, isCancelled = false;

  // A picture of which nothing is found out keeps its estimate.
  void run(const MakePrecise& makePrecise) {
    try {
      error = errorByChance(scene, *image, makePrecise([this] { return isCancelled.load(); }));
    } catch (const std::exception&) {
    }
    scene = {};
    isDone = true;
  }
};

void ChanceCheck::reset() {
  for (const std::shared_ptr<Job>& job : m_jobs)
    job->isCancelled = true;
  m_jobs.clear();
}

void ChanceCheck::follow(std::span<const SidePicture> sides) {
  for (std::size_t i = 0; i < m_jobs.size() && i < sides.size(); ++i)
    if (m_jobs[i]->image != sides[i].picture().image)
      return reset();
}

std::shared_ptr<ChanceCheck::Job> ChanceCheck::begin(const SidePicture& side) const {
  auto job = std::make_shared<Job>();
  job->scene = side.shownScene();
  job->image = side.picture().image;
  // What lies on disk would be read once more, against the picture's own reading; light that travels would
  // take minutes.
  if (!job->image || !job->scene.volume || job->scene.volume->room() || hasTravellingLight(job->scene)) {
    job->isDone = true;
    return job;
  }
  QThreadPool::globalInstance()->start([job, makePrecise = m_makePrecise] { job->run(makePrecise); });
  return job;
}

RestTurn ChanceCheck::step(std::span<const SidePicture> sides) {
  if (!m_makePrecise)
    return RestTurn::nothing;
  if (!m_jobs.empty() && !m_jobs.back()->isDone)
    return RestTurn::waiting;
  if (!m_jobs.empty() && !std::exchange(m_jobs.back()->isTold, true))
    return RestTurn::worked;
  if (m_jobs.size() == sides.size())
    return RestTurn::nothing;
  m_jobs.push_back(begin(sides[m_jobs.size()]));
  return RestTurn::worked;
}

std::optional<ErrorByChance> ChanceCheck::error(int side) const {
  const auto index = static_cast<std::size_t>(side);
  return index < m_jobs.size() && m_jobs[index]->isDone ? m_jobs[index]->error : std::nullopt;
}

} // namespace limn
