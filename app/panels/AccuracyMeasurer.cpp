// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/AccuracyMeasurer.h"

#include "scene/basics/Error.h"
#include "scene/light/Gradient.h"

#include <algorithm>
#include <tuple>

namespace limn {
namespace {

// What the exact picture depends on: not the step, and not where rays may end.
Scene withoutQuality(Scene scene) {
  scene.quality = {};
  return scene;
}

// One that cannot keep its tolerance comes first: that is to be told.
bool needsFinerSteps(const WithinTolerance& a, const WithinTolerance& b) {
  const auto rank = [](const WithinTolerance& found) {
    const Quality& quality = found.scene.quality;
    return std::tuple(found.holds, -quality.fineness.value_or(0.0), quality.stepVoxels);
  };
  return rank(a) < rank(b);
}

} // namespace

/// One piece of work on its thread.
class AccuracyMeasurer::Job {
public:
  Job(AccuracyMeasurer& owner, const BackgroundWork::Line& line, std::shared_ptr<const Exact> exact,
      Engine rays)
      : m_owner(owner), m_line(line), m_exact(std::move(exact)),
        m_renderers(0, line.effort.isCancelled, rays) {}

  RealRenderers& renderers() { return m_renderers; }

  /// Tells progress from one part of the whole to another.
  ReportProgress progress(double from, double to) {
    return [this, from, to](double fraction, const Message& doing) {
      if (m_line.effort.isCancelled())
        throw Cancelled();
      m_line.report(from + fraction * (to - from), doing);
    };
  }

  /// The exact picture of a scene, drawn unless it was drawn last.
  const ConvergedPicture& exactPicture(const Scene& scene, const glm::ivec2& size, double share) {
    if (m_exact && m_exact->scene == withoutQuality(scene) && m_exact->size == size)
      return m_exact->picture;
    m_exact = std::make_shared<const Exact>(
        Exact{withoutQuality(scene), size,
              convergedPicture(withoutQuality(scene), size, m_renderers.precisely(), progress(0.0, share))});
    m_line.tell([&owner = m_owner, exact = m_exact] { owner.m_exact = exact; });
    return m_exact->picture;
  }

private:
  AccuracyMeasurer& m_owner;
  const BackgroundWork::Line& m_line;
  std::shared_ptr<const Exact> m_exact;
  RealRenderers m_renderers;
};

AccuracyMeasurer::AccuracyMeasurer(QObject* parent) : QObject(parent) {
  connect(&m_work, &BackgroundWork::progressed, this, &AccuracyMeasurer::progressed);
  connect(&m_work, &BackgroundWork::failed, this,
          [this](const QString& why) { emit failed(tr("The accuracy cannot be measured. %1").arg(why)); });
}

void AccuracyMeasurer::forgetOthersThan(const std::shared_ptr<const Volume>& volume) {
  if (m_exact && m_exact->scene.volume != volume)
    m_exact.reset();
}

void AccuracyMeasurer::measure(const QString& name, const Scene& scene, const glm::ivec2& size) {
  start([this, name = name.toStdString(), scene, size](Job& job) -> BackgroundWork::Deliver {
    const double steepest = steepness(*scene.volume);
    const ConvergedPicture& exact = job.exactPicture(scene, size, 0.5);
    MeasuredAccuracy accuracy{measureAccuracy(name, scene, size, pointsToMeasure(scene, steepest), exact,
                                              job.renderers(), job.progress(0.5, 1.0)),
                              scene, steepest};
    return [this, accuracy = std::move(accuracy)] { emit measured(accuracy); };
  });
}

void AccuracyMeasurer::compare(const Scene& scene, const glm::ivec2& size) {
  start([this, scene, size](Job& job) -> BackgroundWork::Deliver {
    const ConvergedPicture& exact = job.exactPicture(scene, size, 0.95);
    ComparedPicture compared;
    compared.point.stepVoxels = scene.quality.stepVoxels;
    compared.point.toleranceLevels = scene.quality.toleranceLevels;
    compared.reference = exact.facts;
    if (exact.facts.converged) {
      const Image picture = job.renderers().render(scene, size);
      compared.error = imageError(picture, exact.pixels);
      compared.map = errorMap(picture, exact.pixels);
    }
    return [this, compared = std::move(compared)] { emit this->compared(compared); };
  });
}

void AccuracyMeasurer::findSteps(const std::vector<Scene>& scenes, const glm::ivec2& size) {
  start([this, scenes, size](Job& job) -> BackgroundWork::Deliver {
    const ReportProgress progress = job.progress(0.0, 1.0);
    const double usualPictures = 8.0 * static_cast<double>(scenes.size());
    int pictures = 0;
    // Some eight small pictures of each are commonly needed; how many is not known before.
    const DrawScene draw = [&](const Scene& tried, const glm::ivec2& pixels) {
      progress(1.0 - usualPictures / (usualPictures + pictures++),
               Message::tr("Looking for the steps that are needed"));
      return job.renderers().render(tried, pixels);
    };
    std::vector<WithinTolerance> found;
    found.reserve(scenes.size());
    for (const Scene& scene : scenes)
      found.push_back(withinTolerance(scene, size, draw));
    const WithinTolerance finest = *std::min_element(found.begin(), found.end(), needsFinerSteps);
    return [this, finest] { emit stepsFound(finest); };
  });
}

void AccuracyMeasurer::start(std::function<BackgroundWork::Deliver(Job& job)> task) {
  m_work.start(
      [this, exact = m_exact, rays = m_rays, task = std::move(task)](const BackgroundWork::Line& line) {
        Job job(*this, line, exact, rays);
        return task(job);
      });
}

} // namespace limn
