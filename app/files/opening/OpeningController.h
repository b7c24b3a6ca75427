// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/OpenDocument.h"
#include "app/document/Settings.h"
#include "widgets/controls/BackgroundWork.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>

class QMenu;

namespace limn {

class RecentMenu;
struct WindowContext;

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
  void volumeMissing(const QString& source, const QString& expected, limn::NamedBy by);
  /// Beside failed: the same of a file of labels, or it cannot be shown with the volume.
  void labelsMissing(const QString& source, const QString& expected);
  void cancelled();

private:
  QString m_source;
  BackgroundWork m_work;
};

/// Asks what to open, or offers what was opened before, and reads it; what cannot be read as it is, it asks
/// more about: which series, where the volume is, how far its voxels lie apart.
class OpeningController : public QObject {
  Q_OBJECT

public:
  /// `before` tells what is done on the worker thread before anything is read.
  OpeningController(WindowContext& context, std::function<std::function<void()>()> before);

  const VolumeLoader& loader() const { return m_loader; }

  /// Starts loading a volume, DICOM folder, scene, session or Limn picture; looks alone are not for it to
  /// open (looksChosen).
  void open(const QString& source, const SourceOptions& options = {});
  void openSample() { open(QStringLiteral("sample")); }
  /// Starts loading a session that Limn kept.
  void restore(const QString& session);
  void cancel() { m_loader.cancel(); }

  /// With which what is open can be read once more, in another way.
  SourceOptions optionsNow() const;

  void askForFile();
  void askForFolder();
  /// Asks how far the voxels of what is shown lie apart, `spacingMm` at present, and reads it again.
  void askForSpacing(const Request& shown, const glm::dvec3& spacingMm);

  /// Adds to what was opened before; `label` names nobody. `volume` is where its voxels lie, or a built-in
  /// name; `series` the number of one that was chosen, 0 where none was.
  void remember(const QString& path, const QString& label, const std::string& volume, int series = 0);
  /// Somebody goes on with what is open: that something else could not be opened is no longer said.
  void leaveFailure();

signals:
  void looksChosen(const QStringList& paths);
  void loaded(const limn::LoadedScene& loaded, const limn::Histogram& histogram,
              const limn::Request& request);

private:
  SourceOptions withKnownVolumes(SourceOptions options) const;
  void addActions();
  void connectLoader();
  void connectEmptyPanel();
  /// What was opened before, latest first, in words that name nobody.
  QStringList recentTexts();
  void clearRecent();
  void removeRecent(const QString& path);
  /// Opens one of these, from 0 on.
  void openRecent(int number);
  void start(const Request& request, const QString& what);
  void sayFailure(const QString& source, const QString& sentence);
  void locateVolume(const QString& scene);
  void locateLabels(const QString& scene, const QString& expected);
  void openWithoutLabels(const QString& scene);
  void findSeries(const QString& source, const std::shared_ptr<const DicomFolder>& dicom);
  void chooseSeries(const QString& source, const std::shared_ptr<const DicomFolder>& dicom, int chosen);
  void readSeries(const QString& source, const std::shared_ptr<const DicomFolder>& dicom, int number);
  void readWithSpacing(const Request& shown, const QString& entered);
  void refreshRecent();
  /// The next dialog begins where what was opened just now lies, however it was opened.
  void rememberFolder();

  WindowContext& m_context;
  QMenu* m_recent; ///< of what was opened before
  RecentMenu* m_entries;
  std::function<std::function<void()>()> m_before;
  VolumeLoader m_loader;
  QString m_failure;    ///< why nothing was opened; empty once that does not matter
  Request m_requested;  ///< last; it may still load, or have failed
  RecentSource m_again; ///< what was opened before and is opened again; without a path where it is not
};

} // namespace limn
