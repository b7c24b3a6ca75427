// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/panels/presets/LookImport.h"
#include "widgets/controls/BackgroundWork.h"

#include <QObject>

namespace limn {

class PresetController;
struct WindowContext;

/// Makes presets of the user's own from files of Limn and other programs, and writes looks as such files.
/// What changes on the way is told: nothing in the status bar, one refusal in the message bar, the rest in a
/// report.
class LookController : public QObject {
  Q_OBJECT

public:
  /// `presets` lists what was imported.
  LookController(WindowContext& context, PresetController& presets);

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

  WindowContext& m_context;
  PresetController& m_presets;
  PresetStore m_store;
  BackgroundWork m_work;
  QStringList m_waiting; ///< to be imported next
  QString m_refusal;     ///< said of the last import; empty: none
};

} // namespace limn
