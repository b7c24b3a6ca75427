// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/LookController.h"

#include "app/asking/FileDialogs.h"
#include "app/panels/presets/PresetController.h"
#include "app/window/WindowContext.h"
#include "io/AtomicFile.h"
#include "io/reading/ReadError.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/view/CompareView.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QStatusBar>
#include <QTextEdit>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace limn {
namespace {

QString htmlOf(const LookReportEntry& entry) {
  QString html =
      QStringLiteral("<p><b>%1</b> – %2</p>").arg(entry.file.toHtmlEscaped(), entry.outcome.toHtmlEscaped());
  if (entry.sentences.isEmpty())
    return html;
  html += QStringLiteral("<ul>");
  for (const QString& sentence : entry.sentences)
    html += QStringLiteral("<li>%1</li>").arg(sentence.toHtmlEscaped());
  return html + QStringLiteral("</ul>");
}

QString textOf(const LookReportEntry& entry) {
  QString text = QStringLiteral("%1 – %2\n").arg(entry.file, entry.outcome);
  for (const QString& sentence : entry.sentences)
    text += QStringLiteral("  • %1\n").arg(sentence);
  return text;
}

/// Whether a look is another one over another range of values.
bool isRelative(const std::string& text, const std::string& name) {
  const std::vector<ReadLook> low = parseLooks(text, name, LookTarget{0.0, 1.0, 1.0});
  const std::vector<ReadLook> high = parseLooks(text, name, LookTarget{1.0, 3.0, 1.0});
  return !std::ranges::equal(low, high, [](const ReadLook& a, const ReadLook& b) {
    return a.preset.transferFunction == b.preset.transferFunction;
  });
}

std::vector<ReadLook> looksIn(const QString& path, const std::optional<LookTarget>& target) {
  const std::string name = QFileInfo(path).fileName().toStdString();
  const std::string text = lookText(path.toStdString());
  if (!target && isRelative(text, name))
    failReading(name, Message::tr("its values are fractions of a volume's range"),
                Message::tr("open the volume that it is for, then import it again"));
  return parseLooks(text, name, target);
}

struct NamedRemarks {
  QString look;
  QStringList remarks;
};

/// Each remark on a file's looks once; of several it says which it is on.
QStringList remarksOnFile(const std::vector<NamedRemarks>& looks) {
  QStringList all, told;
  for (const NamedRemarks& look : looks)
    all << look.remarks;
  all.removeDuplicates();
  for (const QString& remark : all) {
    QStringList names;
    for (const NamedRemarks& look : looks)
      if (look.remarks.contains(remark))
        names << look.look;
    const bool isOnAll = names.size() == static_cast<qsizetype>(looks.size());
    told << (looks.size() == 1 ? remark
             : isOnAll         ? QObject::tr("All of them: %1").arg(remark)
                               : QObject::tr("%1: %2").arg(names.join(QObject::tr(", ")), remark));
  }
  return told;
}

/// Keeps looks beside the presets that there are.
class LookKeeper {
public:
  explicit LookKeeper(const PresetStore& store) : m_store(store) {
    for (Preset& preset : allPresets(store))
      m_presets.emplace(preset.name, std::move(preset));
  }

  /// Imports a file; `kept` receives the names of its presets.
  LookReportEntry keep(const QString& path, const std::optional<LookTarget>& target, QStringList& kept) {
    LookReportEntry entry{QFileInfo(path).fileName(), {}, {}, false};
    QStringList names, renamings, refusal;
    std::vector<NamedRemarks> looks;
    try {
      for (const ReadLook& look : looksIn(path, target)) {
        names << keepLook(look.preset, renamings);
        looks.push_back({names.back(), {}});
        for (const Message& change : look.changes)
          looks.back().remarks << translated(change);
      }
    } catch (const Error& error) {
      entry.isRefused = true;
      refusal << translated(error.sentence());
    }
    entry.sentences = remarksOnFile(looks) + renamings + refusal;
    entry.outcome = names.isEmpty() ? QObject::tr("not imported")
                                    : QObject::tr("imported as %1").arg(names.join(QObject::tr(", ")));
    kept << names;
    return entry;
  }

private:
  QString keepLook(Preset look, QStringList& sentences) {
    const std::string wanted = look.name;
    auto present = m_presets.find(look.name);
    for (int number = 2; present != m_presets.end() && present->second != look; ++number) {
      look.name = wanted + " " + std::to_string(number);
      present = m_presets.find(look.name);
    }
    if (present == m_presets.end()) {
      m_store.find(look.name); // a file that cannot be read is not replaced either: this throws
      m_store.save(look);
      m_presets.emplace(look.name, look);
    }
    if (look.name != wanted)
      sentences << QObject::tr("There is another preset \"%1\" already, so that this one is called \"%2\".")
                       .arg(QString::fromStdString(wanted), QString::fromStdString(look.name));
    return QString::fromStdString(look.name);
  }

  const PresetStore& m_store;
  std::map<std::string, Preset> m_presets; ///< by name
};

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

LookReport::LookReport(const QString& title, const QString& summary,
                       const std::vector<LookReportEntry>& entries, QWidget* parent)
    : QDialog(parent), m_plainText(summary + QLatin1Char('\n')) {
  setObjectName(QStringLiteral("lookReport"));
  setWindowTitle(title);
  auto* heading = new QLabel(summary, this);
  heading->setWordWrap(true);
  QString html;
  for (const LookReportEntry& entry : entries) {
    html += htmlOf(entry);
    m_plainText += textOf(entry);
  }
  auto* text = new QTextEdit(this);
  text->document()->setDocumentMargin(8.0);
  text->document()->setIndentWidth(16.0);
  text->setHtml(html);
  text->setReadOnly(true);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  text->setTabChangesFocus(true);
  text->setAccessibleName(tr("What changed"));
  auto* buttons = new QDialogButtonBox(this);
  QPushButton* copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
  QPushButton* close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
  copy->setAutoDefault(false);
  close->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->addWidget(heading);
  column->addWidget(text, 1);
  column->addWidget(buttons);
  connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(m_plainText); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  close->setFocus();
  resize(560, 340);
}

LookImport importLooks(const QStringList& paths, const std::optional<LookTarget>& target,
                       const PresetStore& store) {
  LookImport import;
  LookKeeper keeper(store);
  for (const QString& path : paths)
    import.files.push_back(keeper.keep(path, target, import.presets));
  return import;
}

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
       .toolTip =
           tr("Writes the curve and the light that are shown, of two pictures the right one's, as a file "
              "of Limn or another program."),
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
    return BackgroundWork::Deliver([this, paths, import = importLooks(paths, target, store)] {
      const auto taken = std::ranges::find(import.files, false, &LookReportEntry::isRefused);
      if (taken != import.files.end())
        rememberFolderOf(paths[taken - import.files.begin()], m_context.settings);
      show(import);
      importFiles({});
    });
  });
}

void LookController::show(const LookImport& import) {
  m_presets.refresh();
  if (!import.presets.isEmpty())
    m_presets.browser().reveal(import.presets.front());
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
  // The view may show the preview of another look.
  Scene shown = m_context.session.scene();
  shown.shading.model = m_context.view.scenesOfSides().back().shading.model;
  const QString name = m_presets.nameShown();
  askWhereToExport(presetOf(shown, name.toStdString()));
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
