// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/accuracy/AccuracyMeasurer.h"

#include "scene/basics/Error.h"
#include "scene/light/Gradient.h"
#include "widgets/Translated.h"

#include <QMetaObject>

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
  Job(AccuracyMeasurer& owner, std::shared_ptr<Work> work, std::shared_ptr<const Exact> exact, RaysBy rays)
      : m_owner(owner), m_work(std::move(work)), m_exact(std::move(exact)),
        m_renderers(
            0, [this] { return m_work->isCancelled.load(); }, rays) {}

  RealRenderers& renderers() { return m_renderers; }

  /// Tells progress from one part of the whole to another.
  ReportProgress progress(double from, double to) {
    return [this, from, to](double fraction, const Message& doing) {
      if (m_work->isCancelled)
        throw Cancelled();
      tell([fraction = from + fraction * (to - from), doing](AccuracyMeasurer& owner) {
        emit owner.progressed(fraction, translated(doing));
      });
    };
  }

  /// The exact picture of a scene, drawn unless it was drawn last.
  const ConvergedPicture& exactPicture(const Scene& scene, const glm::ivec2& size, double share) {
    if (m_exact && m_exact->scene == withoutQuality(scene) && m_exact->size == size)
      return m_exact->picture;
    m_exact = std::make_shared<const Exact>(
        Exact{withoutQuality(scene), size,
              convergedPicture(withoutQuality(scene), size, m_renderers.precisely(), progress(0.0, share))});
    tell([exact = m_exact](AccuracyMeasurer& owner) { owner.m_exact = exact; });
    return m_exact->picture;
  }

  /// Does something on the owner's thread unless the work has been ended.
  template <class Word>
  void tell(Word word) {
    tell(m_owner, m_work, std::move(word));
  }

  template <class Word>
  static void tell(AccuracyMeasurer& owner, const std::shared_ptr<Work>& work, Word word) {
    QMetaObject::invokeMethod(
        &owner,
        [&owner, work, word] {
          if (owner.m_work == work)
            word(owner);
        },
        Qt::QueuedConnection);
  }

private:
  AccuracyMeasurer& m_owner;
  std::shared_ptr<Work> m_work;
  std::shared_ptr<const Exact> m_exact;
  RealRenderers m_renderers;
};

AccuracyMeasurer::AccuracyMeasurer(QObject* parent) : QObject(parent) {}

AccuracyMeasurer::~AccuracyMeasurer() {
  cancel();
}

void AccuracyMeasurer::cancel() {
  if (m_work)
    m_work->isCancelled = true;
  m_work.reset();
}

void AccuracyMeasurer::forgetOthersThan(const std::shared_ptr<const Volume>& volume) {
  if (m_exact && m_exact->scene.volume != volume)
    m_exact.reset();
}

void AccuracyMeasurer::measure(const QString& name, const Scene& scene, const glm::ivec2& size) {
  start([name = name.toStdString(), scene, size](Job& job) {
    const double steepest = steepness(*scene.volume);
    const ConvergedPicture& exact = job.exactPicture(scene, size, 0.5);
    MeasuredAccuracy accuracy{measureAccuracy(name, scene, size, pointsToMeasure(scene, steepest), exact,
                                              job.renderers(), job.progress(0.5, 1.0)),
                              scene, steepest};
    job.tell([accuracy = std::move(accuracy)](AccuracyMeasurer& owner) {
      owner.m_work.reset();
      emit owner.measured(accuracy);
    });
  });
}

void AccuracyMeasurer::compare(const Scene& scene, const glm::ivec2& size) {
  start([scene, size](Job& job) {
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
    job.tell([compared = std::move(compared)](AccuracyMeasurer& owner) {
      owner.m_work.reset();
      emit owner.compared(compared);
    });
  });
}

void AccuracyMeasurer::findSteps(const std::vector<Scene>& scenes, const glm::ivec2& size) {
  start([scenes, size](Job& job) {
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
    job.tell([finest](AccuracyMeasurer& owner) {
      owner.m_work.reset();
      emit owner.stepsFound(finest);
    });
  });
}

template <class Task>
void AccuracyMeasurer::start(Task task) {
  cancel();
  m_work = std::make_shared<Work>();
  m_thread = std::jthread(
      [this, work = m_work, exact = m_exact, rays = m_rays, task = std::move(task),
       sorry = tr("The accuracy cannot be measured. %1")](std::jthread before) {
        if (before.joinable())
          before.join();
        const auto fail = [&](const QString& sentence) {
          Job::tell(*this, work, [sentence](AccuracyMeasurer& owner) {
            owner.m_work.reset();
            emit owner.failed(sentence);
          });
        };
        try {
          Job job(*this, work, exact, rays);
          task(job);
        } catch (const Cancelled&) { // nobody waits for it
        } catch (const std::exception& error) {
          fail(sorry.arg(translated(error)));
        }
      },
      std::move(m_thread));
}

} // namespace limn
