// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/SceneSource.h"
#include "scene/volume/Histogram.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace limn {

/// Loads scenes on a worker thread, one at a time; starting another cancels the one under way. Signals come
/// on the thread the loader lives in.
class VolumeLoader : public QObject {
  Q_OBJECT

public:
  explicit VolumeLoader(QObject* parent = nullptr);
  ~VolumeLoader() override;

  /// `before` runs first, on the worker thread.
  void start(const QString& source, const SourceOptions& options, std::function<void()> before = {});
  void cancel();
  bool isLoading() const { return m_job != nullptr; }

signals:
  void progressed(double fraction, const QString& what);
  void loaded(const limn::LoadedScene& scene, const limn::Histogram& histogram);
  /// The folder holds several series and none was chosen.
  void seriesFound(const QString& source, const std::vector<limn::SeriesSummary>& series);
  void failed(const QString& source, const QString& sentence);
  /// Beside failed: the scene could be read, its volume was not found where it is expected.
  void volumeMissing(const QString& source, const QString& expected);
  void cancelled();

private:
  struct Job {
    std::atomic<bool> isCancelled{false};
  };
  void run(const std::shared_ptr<Job>& job, const QString& source, const SourceOptions& options,
           const std::function<void()>& before);
  template <class Function>
  void deliver(const std::shared_ptr<Job>& job, Function&& function);

  std::shared_ptr<Job> m_job; ///< the load whose results count; null at rest
  std::vector<std::jthread> m_threads;
};

} // namespace limn
