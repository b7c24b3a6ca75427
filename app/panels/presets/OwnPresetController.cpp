// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/OwnPresetController.h"

#include "app/panels/presets/NameDialog.h"
#include "app/window/WindowContext.h"
#include "scene/basics/Error.h"
#include "scene/presets/PresetFit.h"
#include "widgets/Translated.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/presets/PresetModel.h"

#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <optional>

namespace limn {

OwnPresetController::OwnPresetController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_store(context.folders.presets) {
  const QAction* save = context.actions.add(
      QStringLiteral("savePreset"),
      {.text = tr("&Save as preset…"), .place = {Menu::preset, 1, 2}, .needsVolume = true});
  connect(save, &QAction::triggered, this, &OwnPresetController::askForName);
}

const Preset* OwnPresetController::find(const QString& name) const {
  const auto found = std::ranges::find(m_presets, name.toStdString(), &Preset::name);
  return found == m_presets.end() ? nullptr : &*found;
}

void OwnPresetController::read() {
  PresetStore::Contents own = m_store.read();
  m_presets = std::move(own.presets);
  emit listed();
  if (!own.problems.empty())
    m_context.messages.show(MessageBar::Kind::error, translated(own.problems.front()));
}

void OwnPresetController::readEdited(const QString& name) {
  const Preset* known = find(name);
  if (!known)
    return;
  try {
    if (m_store.find(known->name) != *known)
      read();
  } catch (const Error&) {
    read(); // and say why
  }
}

void OwnPresetController::askForName() {
  if (!m_context.session.scene().volume)
    return;
  const QString inUse = QString::fromStdString(m_context.document.presetInUse().name);
  const QString proposed = inUse.isEmpty() ? tr("My preset")
                           : find(inUse)   ? inUse
                                           : tr("My %1").arg(presetWords(inUse));
  ask(
      tr("Save as preset"), tr("Name:"), proposed, [this](const QString& name) { save(name); },
      [this](const QString& name) { return refusal(name); });
}

void OwnPresetController::ask(const QString& title, const QString& label, const QString& name,
                              const std::function<void(const QString&)>& answer,
                              const std::function<QString(const QString&)>& refusal) {
  auto* dialog = new NameDialog(title, label, name, refusal, &m_context.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QInputDialog::textValueSelected, this,
          [answer](const QString& entered) { answer(entered.trimmed()); });
  dialog->open();
}

// Why a preset of the user's own cannot be called so; empty: it can.
QString OwnPresetController::refusal(const QString& name) const {
  if (name.isEmpty())
    return tr("A preset needs a name.");
  const std::string known = name.toStdString();
  if (std::ranges::any_of(builtInPresets(), [&](const Preset& preset) { return preset.name == known; }))
    return tr("\"%1\" is a built-in preset; choose another name.").arg(name);
  try {
    m_store.requireFits(known);
  } catch (const Error& error) {
    return translated(error.sentence());
  }
  return {};
}

void OwnPresetController::save(const QString& name) {
  const QString question = tr("There is a preset \"%1\" already. Replace it by what is shown?").arg(name);
  if (find(name) && !mayReplace(question))
    return;
  const Scene& shown = m_context.session.scene();
  Preset preset = withoutSmoothingOfSlices(presetOf(shown, name.toStdString()), shown.volume->grid());
  // Values without a unit mean something beside those of their own volume alone.
  if (!looksLikeHounsfield(*shown.volume))
    preset.landmarks = landmarksOf(m_context.document.histogram());
  std::optional<Preset> replaced;
  if (const Preset* before = find(name)) {
    replaced = *before;
    preset.note = before->note;
    preset.folder = before->folder;
  }
  const auto write = [&] {
    m_store.save(preset);
    m_context.session.adoptPreset(preset);
    read();
    emit kept(name);
    if (replaced)
      offerBack(*replaced, tr("\"%1\" was replaced by what is shown.").arg(name), tr("Take the old one back"),
                false);
  };
  m_context.notes.attempt(write);
}

// Names are typed with ease, so it is asked; all the same what was is brought back by one click.
bool OwnPresetController::mayReplace(const QString& question) {
  QMessageBox box(QMessageBox::Question, tr("Replace preset"), question, QMessageBox::Cancel,
                  &m_context.window);
  box.setObjectName(QStringLiteral("replacePreset"));
  const QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::AcceptRole);
  box.setDefaultButton(QMessageBox::Cancel); // Enter loses nothing
  box.exec();
  return box.clickedButton() == replace;
}

void OwnPresetController::offerBack(const Preset& preset, const QString& sentence, const QString& label,
                                    bool isFavourite) {
  const auto bringBack = [this, preset, isFavourite] {
    m_context.notes.attempt([&] {
      m_store.save(preset);
      if (isFavourite)
        m_context.settings.setFavourite(preset.name, true);
      m_context.messages.show(MessageBar::Kind::note,
                              tr("\"%1\" is as it was before.").arg(QString::fromStdString(preset.name)));
      read(); // which may say what could not be read
    });
  };
  m_context.messages.show(MessageBar::Kind::warning, sentence, {}, {label, bringBack});
}

void OwnPresetController::remove(const QString& name) {
  const Preset* known = find(name);
  if (!known)
    return;
  const Preset removed = *known;
  try {
    m_store.remove(removed.name);
    const bool isFavourite = m_context.settings.favourites().contains(removed.name);
    if (isFavourite)
      m_context.settings.setFavourite(removed.name, false);
    read();
    offerBack(removed, tr("\"%1\" was deleted.").arg(name), tr("Bring it back"), isFavourite);
  } catch (const Error& error) {
    m_context.messages.show(MessageBar::Kind::error, translated(error.sentence()));
  }
}

void OwnPresetController::rename(const QString& name) {
  const auto give = [this, name](const QString& entered) {
    const Preset* found = find(name);
    if (entered == name || !found)
      return;
    m_context.notes.attempt([&] {
      Preset renamed = *found;
      renamed.name = entered.toStdString();
      m_store.save(renamed);
      m_store.remove(name.toStdString());
      if (m_context.settings.favourites().contains(name.toStdString())) {
        m_context.settings.setFavourite(name.toStdString(), false);
        m_context.settings.setFavourite(renamed.name, true);
      }
      if (Preset inUse = m_context.session.preset(); inUse.name == name.toStdString()) {
        inUse.name = renamed.name;
        m_context.session.adoptPreset(inUse);
      }
      read();
      emit kept(entered); // a search for the former name would hide it
    });
  };
  const auto refused = [this, name](const QString& entered) {
    const QString sentence = entered == name ? QString() : refusal(entered);
    return sentence.isEmpty() && entered != name && find(entered)
               ? tr("There is a preset \"%1\" already; choose another name.").arg(entered)
               : sentence;
  };
  ask(tr("Rename preset"), tr("New name:"), name, give, refused);
}

void OwnPresetController::change(const QString& name, const std::function<void(Preset&)>& edit) {
  const Preset* found = find(name);
  if (!found)
    return;
  Preset changed = *found;
  edit(changed);
  m_context.notes.attempt([&] {
    m_store.save(changed);
    read();
  });
}

void OwnPresetController::editNote(const QString& name) {
  const Preset* preset = find(name);
  if (!preset)
    return;
  ask(tr("Note of \"%1\"").arg(name), tr("What it shows, in one sentence:"),
      QString::fromStdString(preset->note), [this, name](const QString& note) {
        change(name, [&](Preset& changed) { changed.note = note.toStdString(); });
      });
}

void OwnPresetController::moveTo(const QString& name, const QString& folder) {
  change(name, [&](Preset& changed) { changed.folder = folder.toStdString(); });
}

void OwnPresetController::moveToNewFolder(const QString& name) {
  ask(tr("New folder"), tr("Folder for \"%1\":").arg(name), {},
      [this, name](const QString& folder) { moveTo(name, folder); });
}

void OwnPresetController::duplicate(const Preset& preset) {
  ask(
      tr("Duplicate preset"), tr("Name of the copy:"),
      tr("%1 copy").arg(presetWords(QString::fromStdString(preset.name))),
      [this, preset](const QString& entered) { keepCopy(preset, entered); },
      [this](const QString& entered) { return refusal(entered); });
}

void OwnPresetController::keepCopy(Preset copy, const QString& name) {
  std::optional<Preset> replaced;
  if (const Preset* before = find(name))
    replaced = *before;
  const QString question = tr("There is a preset \"%1\" already. Replace it by the copy?").arg(name);
  if (replaced && !mayReplace(question))
    return;
  copy.name = name.toStdString();
  m_context.notes.attempt([&] {
    m_store.save(copy);
    read();
    emit kept(name);
    if (replaced)
      offerBack(*replaced, tr("\"%1\" was replaced by a copy.").arg(name), tr("Take the old one back"),
                false);
  });
}

} // namespace limn
