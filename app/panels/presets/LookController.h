// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/presets/PresetStore.h"
#include "io/looks/Look.h"
#include "widgets/controls/BackgroundWork.h"

#include <QDialog>
#include <QObject>
#include <QStringList>

#include <vector>

namespace limn {

class PresetController;
struct WindowContext;

/// What became of a file, and a sentence for each thing that is no longer as it was.
struct LookReportEntry {
  QString file;
  QString outcome; ///< "imported as "Bones"", "refused"
  QStringList sentences;
  bool isRefused = false;
};

/// Shows what changed or was lost when looks were imported or exported. Its text can be selected, by mouse
/// and keys, and copied as a whole. Never modal.
class LookReport : public QDialog {
  Q_OBJECT

public:
  LookReport(const QString& title, const QString& summary, const std::vector<LookReportEntry>& entries,
             QWidget* parent);

  /// All that it says, as it is copied.
  const QString& plainText() const { return m_plainText; }

private:
  QString m_plainText;
};

/// What became of files that were imported.
struct LookImport {
  std::vector<LookReportEntry> files;
  QStringList presets; ///< by what they are called now
};

/// Makes presets of the user's own from files. Nothing that the user has is replaced, what is there already
/// is not kept twice, and a file that cannot be read or kept does not keep others from it. Without a target a
/// look over fractions of a volume's range is refused: a list of presets is no place for what shows nothing
/// anywhere.
LookImport importLooks(const QStringList& paths, const std::optional<LookTarget>& target,
                       const PresetStore& store);

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
  /// Asks where to write the look that is shown, with the model of its picture: of two the right one's.
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
