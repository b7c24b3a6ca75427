// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/OpenDocument.h"
#include "app/opening/VolumeLoader.h"

#include <QWidget>

class QAction;
class QMenu;

namespace limn {

class MessageBar;
class Settings;

/// Asks what to open, or offers what was opened before, and reads it; what cannot be read as it is, it asks
/// more about: which series, where the volume is, how far its voxels lie apart.
class OpeningDesk : public QObject {
  Q_OBJECT

public:
  /// Names of files are shown where `showsPatient` is checked. `recent` is the menu of what was opened
  /// before. `before` tells what is done on the worker thread before anything is read; `memory` is how much
  /// of it volumes may take where a request does not say.
  OpeningDesk(Settings& settings, const QAction& showsPatient, QMenu& recent, MessageBar& messages,
              std::function<std::function<void()>()> before, const std::optional<MemoryBudget>& memory,
              QWidget& window);

  const VolumeLoader& loader() const { return m_loader; }

  /// Starts loading a volume, DICOM folder, scene, session or Limn picture; looks alone are not for it to
  /// open (looksChosen).
  void open(const QString& source, const SourceOptions& options = {});
  void openSample() { open(QStringLiteral("sample")); }
  /// Starts loading a session that Limn kept.
  void restore(const QString& session);
  void cancel() { m_loader.cancel(); }

  void askForFile();
  void askForFolder();
  /// Asks how far the voxels of what is shown lie apart, `spacingMm` at present, and reads it again.
  void askForSpacing(const Request& shown, const glm::dvec3& spacingMm);

  /// Adds to what was opened before; `label` names nobody. `volume` is where its voxels lie, or a built-in
  /// name.
  void remember(const QString& path, const QString& label, const std::string& volume);
  /// What was opened before, latest first, in words that name nobody.
  QStringList recentTexts();
  void clearRecent();
  /// Opens one of these, from 0 on.
  void openRecent(int number);

  /// Somebody goes on with what is open: that something else could not be opened is no longer said.
  void leaveFailure();

signals:
  void recentChanged(const QStringList& texts);
  void looksChosen(const QStringList& paths);
  /// Something is read, or asked about no longer; `fraction` 0..1, or less than 0 where it is unknown.
  void progressed(double fraction, const QString& what);
  void ended();
  /// After ended.
  void loaded(const limn::LoadedScene& loaded, const limn::Histogram& histogram,
              const limn::Request& request);

private:
  void start(const Request& request, const QString& what);
  void locateVolume(const QString& scene);
  void chooseSeries(const QString& source, const std::vector<SeriesSummary>& series);
  void readWithSpacing(const Request& shown, const QString& entered);
  void refreshRecent();

  Settings& m_settings;
  const QAction& m_showsPatient;
  QMenu& m_recent;
  MessageBar& m_messages;
  std::function<std::function<void()>()> m_before;
  std::optional<MemoryBudget> m_memory;
  QWidget& m_window;
  VolumeLoader m_loader;
  QString m_failure;   ///< why nothing was opened; empty once that does not matter
  Request m_requested; ///< last; it may still load, or have failed
};

} // namespace limn
