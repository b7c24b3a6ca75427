// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/opening/VolumeLoader.h"

#include "scene/basics/Error.h"
#include "widgets/Translated.h"

namespace limn {

// A disk that does not answer holds nothing up that lies on another.
VolumeLoader::VolumeLoader(QObject* parent) : QObject(parent), m_work(nullptr, BackgroundWork::Turn::atOnce) {
  connect(&m_work, &BackgroundWork::progressed, this, &VolumeLoader::progressed);
  connect(&m_work, &BackgroundWork::failed, this,
          [this](const QString& sentence) { emit failed(m_source, sentence); });
}

void VolumeLoader::start(const QString& source, const SourceOptions& options, std::function<void()> before) {
  m_source = source;
  m_work.start([this, source, options,
                before = std::move(before)](const BackgroundWork::Line& line) -> BackgroundWork::Deliver {
    if (before)
      before();
    const Progress progress{line.report, line.effort.isCancelled};
    try {
      SourceOptions asking = options;
      asking.asksForSeries = true;
      const LoadedScene scene = loadScene(source.toStdString(), asking, progress);
      const Histogram histogram = histogramOf(*scene.scene.volume, 1024, effortOf(progress, countingVoxels));
      return [this, scene, histogram] { emit loaded(scene, histogram); };
    } catch (const SeveralSeries& several) {
      return [this, source, dicom = several.dicom()] { emit seriesFound(source, dicom); };
    } catch (const VolumeMissing& error) {
      return [this, source, sentence = translated(error), expected = error.expected().string()] {
        emit failed(source, sentence);
        emit volumeMissing(source, QString::fromStdString(expected));
      };
    }
  });
}

void VolumeLoader::cancel() {
  if (!m_work.isRunning())
    return;
  m_work.cancel();
  emit cancelled();
}

} // namespace limn
