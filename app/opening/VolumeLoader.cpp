// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/opening/VolumeLoader.h"

#include "app/opening/SparseReports.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"

#include <QMetaObject>

#include <new>

namespace limn {

VolumeLoader::VolumeLoader(QObject* parent) : QObject(parent) {}

VolumeLoader::~VolumeLoader() {
  if (m_job)
    m_job->isCancelled = true;
  m_threads.clear(); // joins
}

// Runs `function` on the loader's own thread, unless another load has begun by then.
template <class Function>
void VolumeLoader::deliver(const std::shared_ptr<Job>& job, Function&& function) {
  QMetaObject::invokeMethod(
      this,
      [this, job, function = std::forward<Function>(function)] {
        if (job == m_job)
          function();
      },
      Qt::QueuedConnection);
}

void VolumeLoader::start(const QString& source, const SourceOptions& options, std::function<void()> before) {
  if (m_job)
    m_job->isCancelled = true;
  m_job = std::make_shared<Job>();
  m_threads.emplace_back([this, job = m_job, source, options, before = std::move(before)] {
    run(job, source, options, before);
  });
}

void VolumeLoader::cancel() {
  if (!m_job)
    return;
  m_job->isCancelled = true;
  m_job.reset();
  emit cancelled();
}

void VolumeLoader::run(const std::shared_ptr<Job>& job, const QString& source, const SourceOptions& options,
                       const std::function<void()>& before) {
  if (before)
    before();
  const auto fail = [&](const QString& sentence, const QString& missing = {}) {
    deliver(job, [this, source, sentence, missing] {
      m_job.reset();
      emit failed(source, sentence);
      if (!missing.isEmpty())
        emit volumeMissing(source, missing);
    });
  };
  Progress progress;
  progress.isCancelled = [job] { return job->isCancelled.load(); };
  progress.report = SparseReports([this, job](double fraction, const Message& what) {
    deliver(job, [this, fraction, what] { emit progressed(fraction, translated(what)); });
  });
  try {
    const std::string path = source.toStdString();
    if (!options.read.series && std::filesystem::is_directory(path)) {
      const std::vector<SeriesSummary> series = listSeries(path);
      if (series.size() > 1) {
        deliver(job, [this, source, series] {
          m_job.reset();
          emit seriesFound(source, series);
        });
        return;
      }
    }
    const LoadedScene scene = loadScene(path, options, progress);
    const Histogram histogram = histogramOf(*scene.scene.volume, 1024, effortOf(progress, countingVoxels));
    deliver(job, [this, scene, histogram] {
      m_job.reset();
      emit loaded(scene, histogram);
    });
  } catch (const Cancelled&) {
    // Whoever cancelled has already said so.
  } catch (const VolumeMissing& error) {
    fail(translated(error), QString::fromStdString(error.expected().string()));
  } catch (const Error& error) {
    fail(translated(error));
  } catch (const std::bad_alloc&) {
    fail(tr("There is not enough memory for this volume; close other programs or choose a smaller one."));
  } catch (const std::exception& error) {
    fail(tr("Reading failed unexpectedly: %1.").arg(translated(error)));
  }
}

} // namespace limn
