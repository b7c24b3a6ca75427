// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/BackgroundWork.h"
#include "app/presets/LookImport.h"

#include <QObject>

class QStatusBar;

namespace limn {

class MessageBar;
class PresetDesk;
class SaveNotes;
class Session;
class Settings;

/// Makes presets of the user's own from files of Limn and other programs, and writes looks as such files.
/// What changes on the way is told: nothing in the status bar, one refusal in the message bar, the rest in a
/// report.
class LookDesk : public QObject {
  Q_OBJECT

public:
  /// What it works with; all outlive it.
  struct Partners {
    Session& session;
    PresetDesk& presets; ///< lists what was imported
    MessageBar& messages;
    SaveNotes& notes;
    Settings& settings;
    QStatusBar& status;
    QWidget& window; ///< over which is asked
  };

  LookDesk(PresetStore store, const Partners& partners);

  bool isBusy() const { return m_work.isRunning(); }

public slots:
  void askForLooks();
  /// Imports files, on a thread of its own; files named meanwhile are next. The look of a single one is
  /// applied to the volume that is open, as one step of the history.
  void importFiles(const QStringList& paths);
  /// Asks where to write the look that is shown.
  void exportShown();
  /// The same of a preset of the list.
  void exportPreset(const QString& name);

private:
  void show(const LookImport& import);
  void tell(const LookImport& import);
  void askWhereToExport(const Preset& preset);
  void write(const Preset& preset, const QString& path);
  void report(const QString& title, const QString& summary, const std::vector<LookReportEntry>& entries);

  PresetStore m_store;
  Partners m_with;
  BackgroundWork m_work;
  QStringList m_waiting; ///< to be imported next
  QString m_refusal;     ///< said of the last import; empty: none
};

} // namespace limn
