// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/LookController.h"

#include "app/asking/FileDialogs.h"
#include "app/asking/LookFiles.h"
#include "app/panels/presets/PresetController.h"
#include "app/window/WindowContext.h"
#include "io/AtomicFile.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/presets/PresetModel.h"

#include <QFileInfo>
#include <QStatusBar>

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

LookController::LookController(WindowContext& context, PresetController& presets)
    : QObject(&context.window), m_context(context), m_presets(presets), m_store(context.folders.presets) {
  const QAction* import = context.actions.add(
      QStringLiteral("importLooks"),
      {.text = tr("&Import…"),
       .place = {Menu::preset, 2, 1},
       .toolTip = tr("Makes presets of your own from files of Limn or another program.")});
  const QAction* write = context.actions.add(
      QStringLiteral("exportLook"),
      {.text = tr("&Export…"),
       .place = {Menu::preset, 2, 2},
       .toolTip = tr("Writes the curve and the light that are shown as a file of Limn or another program."),
       .needsVolume = true});
  connect(import, &QAction::triggered, this, &LookController::askForLooks);
  connect(write, &QAction::triggered, this, &LookController::exportShown);
  connect(&presets, &PresetController::exportRequested, this, &LookController::exportPreset);
  connect(&m_work, &BackgroundWork::failed, this, [this](const QString& sentence) {
    m_context.notes.sayFailure(sentence);
    importFiles({});
  });
}

void LookController::askForLooks() {
  importFiles(askForPaths(&m_context.window,
                          {.title = tr("Import looks"), .filters = readLookFilters(), .isMany = true},
                          m_context.settings));
}

void LookController::importFiles(const QStringList& paths) {
  m_waiting << paths;
  if (m_waiting.isEmpty() || m_work.isRunning())
    return;
  m_work.start([this, paths = std::exchange(m_waiting, {}), target = targetOf(m_context.session),
                store = m_store](const Effort&) {
    return BackgroundWork::Deliver([this, import = importLooks(paths, target, store)] {
      show(import);
      importFiles({});
    });
  });
}

void LookController::show(const LookImport& import) {
  m_presets.refresh();
  if (import.files.size() == 1 && import.presets.size() == 1)
    m_presets.use(import.presets.front());
  tell(import);
}

void LookController::tell(const LookImport& import) {
  const std::vector<LookReportEntry>& entries = import.files;
  const QStringList& kept = import.presets;
  const auto refused = std::ranges::count_if(entries, &LookReportEntry::isRefused);
  if (!m_refusal.isEmpty() && m_context.messages.sentence() == m_refusal)
    m_context.messages.hide();
  m_refusal.clear();
  if (entries.size() == 1 && refused == 1) {
    m_refusal = entries.front().sentences.back();
    m_context.messages.show(MessageBar::Kind::error, m_refusal);
    return;
  }
  const QString imported = tr("Presets imported: %1").arg(kept.size());
  if (std::ranges::all_of(entries, [](const LookReportEntry& entry) { return entry.sentences.isEmpty(); })) {
    m_context.window.statusBar()->showMessage(
        kept.size() == 1 ? tr("Imported \"%1\"").arg(kept.front()) : imported, statusMs);
    return;
  }
  const QString summary = refused == 0 ? imported : tr("%1. Files refused: %2").arg(imported).arg(refused);
  report(tr("Imported looks"), tr("%1. What became of each file:").arg(summary), entries);
}

void LookController::exportShown() {
  const QString name = m_presets.nameShown();
  askWhereToExport(presetOf(m_context.session.scene(), name.toStdString()));
}

void LookController::exportPreset(const QString& name) {
  for (const Preset& preset : m_presets.fittedPresets())
    if (preset.name == name.toStdString())
      return askWhereToExport(preset);
}

void LookController::askWhereToExport(const Preset& preset) {
  const QString path =
      askWhereToSave(&m_context.window,
                     {tr("Export the look"), asFileName(presetWords(QString::fromStdString(preset.name))),
                      writtenLookFilters(m_context.settings.lookEnding())},
                     m_context.settings);
  if (path.isEmpty())
    return;
  if (const LookFormat* format = writtenLookFormat(QFileInfo(path).fileName().toStdString()))
    m_context.settings.setLookEnding(QString::fromStdString(format->endings.front()));
  write(preset, path);
}

void LookController::write(const Preset& preset, const QString& path) {
  const std::filesystem::path target(path.toStdString());
  WrittenLook written;
  const auto writeFile = [&] {
    written = lookAs(target, preset, targetOf(m_context.session));
    writeFileAtomically(target, written.text);
  };
  if (m_context.notes.attempt(writeFile, path) && !written.changes.empty())
    report(tr("Exported look"),
           tr("The file was written. What it holds otherwise than shown, or not at all:"),
           {{QFileInfo(path).fileName(), tr("written"), sentencesOf(written.changes), false}});
}

void LookController::report(const QString& title, const QString& summary,
                            const std::vector<LookReportEntry>& entries) {
  auto* dialog = new LookReport(title, summary, entries, &m_context.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

} // namespace limn
