// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presets/LookDesk.h"

#include "app/Settings.h"
#include "app/document/Session.h"
#include "app/opening/OpenDialog.h"
#include "app/presets/LookFiles.h"
#include "app/presets/PresetDesk.h"
#include "app/saving/SaveDialog.h"
#include "app/saving/SaveNotes.h"
#include "app/window/MessageBar.h"
#include "io/AtomicFile.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"
#include "widgets/presets/PresetWords.h"

#include <QFileInfo>
#include <QStatusBar>
#include <QWidget>

#include <algorithm>

namespace limn {
namespace {

constexpr int statusMs = 6000;

// A slash would name a folder.
QString asFileName(QString presetName) {
  return presetName.replace(QLatin1Char('/'), QLatin1Char('-'));
}

std::optional<LookTarget> targetOf(const Session& session) {
  const std::shared_ptr<const Volume>& volume = session.scene().volume;
  return volume ? std::optional(lookTargetOf(*volume)) : std::nullopt;
}

QStringList sentencesOf(const std::vector<Message>& changes) {
  QStringList sentences;
  for (const Message& change : changes)
    sentences << translated(change);
  return sentences;
}

} // namespace

LookDesk::LookDesk(PresetStore store, const Partners& partners)
    : QObject(&partners.window), m_store(std::move(store)), m_with(partners) {
  connect(&m_work, &BackgroundWork::failed, this, [this](const QString& sentence) {
    m_with.notes.sayFailure(sentence);
    importFiles({});
  });
}

void LookDesk::askForLooks() {
  importFiles(askForPaths(&m_with.window,
                          {.title = tr("Import looks"), .filters = readLookFilters(), .isMany = true},
                          m_with.settings));
}

void LookDesk::importFiles(const QStringList& paths) {
  m_waiting << paths;
  if (m_waiting.isEmpty() || m_work.isRunning())
    return;
  m_work.start([this, paths = std::exchange(m_waiting, {}), target = targetOf(m_with.session),
                store = m_store](const Effort&) {
    return BackgroundWork::Deliver([this, import = importLooks(paths, target, store)] {
      show(import);
      importFiles({});
    });
  });
}

void LookDesk::show(const LookImport& import) {
  m_with.presets.refresh();
  if (import.files.size() == 1 && import.presets.size() == 1)
    m_with.presets.use(import.presets.front());
  tell(import);
}

void LookDesk::tell(const LookImport& import) {
  const std::vector<LookReportEntry>& entries = import.files;
  const QStringList& kept = import.presets;
  const auto refused = std::ranges::count_if(entries, &LookReportEntry::isRefused);
  if (!m_refusal.isEmpty() && m_with.messages.sentence() == m_refusal)
    m_with.messages.hide();
  m_refusal.clear();
  if (entries.size() == 1 && refused == 1) {
    m_refusal = entries.front().sentences.back();
    m_with.messages.show(MessageBar::Kind::error, m_refusal);
    return;
  }
  const QString imported = tr("Presets imported: %1").arg(kept.size());
  if (std::ranges::all_of(entries, [](const LookReportEntry& entry) { return entry.sentences.isEmpty(); })) {
    m_with.status.showMessage(kept.size() == 1 ? tr("Imported \"%1\"").arg(kept.front()) : imported,
                              statusMs);
    return;
  }
  const QString summary = refused == 0 ? imported : tr("%1. Files refused: %2").arg(imported).arg(refused);
  report(tr("Imported looks"), tr("%1. What became of each file:").arg(summary), entries);
}

void LookDesk::exportShown() {
  const QString name = m_with.presets.nameShown();
  askWhereToExport(presetOf(m_with.session.scene(), name.toStdString()));
}

void LookDesk::exportPreset(const QString& name) {
  for (const Preset& preset : m_with.presets.fittedPresets())
    if (preset.name == name.toStdString())
      return askWhereToExport(preset);
}

void LookDesk::askWhereToExport(const Preset& preset) {
  const QString path =
      askWhereToSave(&m_with.window,
                     {tr("Export the look"), asFileName(presetWords(QString::fromStdString(preset.name))),
                      writtenLookFilters(m_with.settings.lookEnding())},
                     m_with.settings);
  if (path.isEmpty())
    return;
  if (const LookFormat* format = writtenLookFormat(QFileInfo(path).fileName().toStdString()))
    m_with.settings.setLookEnding(QString::fromStdString(format->endings.front()));
  write(preset, path);
}

void LookDesk::write(const Preset& preset, const QString& path) {
  const std::filesystem::path target(path.toStdString());
  WrittenLook written;
  const auto writeFile = [&] {
    written = lookAs(target, preset, targetOf(m_with.session));
    writeFileAtomically(target, written.text);
  };
  if (m_with.notes.attempt(writeFile, path) && !written.changes.empty())
    report(tr("Exported look"),
           tr("The file was written. What it holds otherwise than shown, or not at all:"),
           {{QFileInfo(path).fileName(), tr("written"), sentencesOf(written.changes), false}});
}

void LookDesk::report(const QString& title, const QString& summary,
                      const std::vector<LookReportEntry>& entries) {
  auto* dialog = new LookReport(title, summary, entries, &m_with.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

} // namespace limn
