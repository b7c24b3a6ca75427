// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/sources/SceneSource.h"
#include "scene/volume/Histogram.h"
#include "widgets/controls/BackgroundWork.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>

namespace limn {

/// Loads scenes on a worker thread, one at a time; starting another cancels the one under way. Signals come
/// on the thread the loader lives in.
class VolumeLoader : public QObject {
  Q_OBJECT

public:
  explicit VolumeLoader(QObject* parent = nullptr);

  /// `before` runs first, on the worker thread.
  void start(const QString& source, const SourceOptions& options, std::function<void()> before = {});
  void cancel();
  bool isLoading() const { return m_work.isRunning(); }

signals:
  void progressed(double fraction, const QString& what);
  void loaded(const limn::LoadedScene& scene, const limn::Histogram& histogram);
  /// The folder holds several series and none was chosen.
  void seriesFound(const QString& source, const std::shared_ptr<const limn::DicomFolder>& dicom);
  void failed(const QString& source, const QString& sentence);
  /// Beside failed: the scene could be read, its volume was not found where it is expected.
  void volumeMissing(const QString& source, const QString& expected);
  void cancelled();

private:
  QString m_source;
  BackgroundWork m_work;
};

} // namespace limn
