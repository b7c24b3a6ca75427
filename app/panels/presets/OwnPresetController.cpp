// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/OwnPresetController.h"

#include "app/window/WindowContext.h"
#include "scene/basics/Error.h"
#include "scene/light/GradientSmoothing.h"
#include "scene/presets/PresetFit.h"
#include "widgets/Translated.h"
#include "widgets/controls/MessageBar.h"

#include <QDialogButtonBox>
#include <QInputDialog>
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
  const QString proposed = inUse.isEmpty() ? tr("My preset") : find(inUse) ? inUse : tr("My %1").arg(inUse);
  ask(tr("Save as preset"), tr("Name:"), proposed, [this](const QString& name) { save(name); });
}

void OwnPresetController::ask(const QString& title, const QString& label, const QString& name,
                              const std::function<void(const QString&)>& answer) {
  auto* dialog = new QInputDialog(&m_context.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  dialog->setLabelText(label);
  dialog->setTextValue(name);
  dialog->setOkButtonText(tr("Save"));
  const auto* buttons = dialog->findChild<QDialogButtonBox*>();
  connect(dialog, &QInputDialog::textValueChanged, buttons, [buttons](const QString& entered) {
    buttons->button(QDialogButtonBox::Ok)->setEnabled(!entered.trimmed().isEmpty());
  });
  connect(dialog, &QInputDialog::textValueSelected, this,
          [answer](const QString& entered) { answer(entered.trimmed()); });
  dialog->open();
}

// A name of a preset of the user's own; says why not.
bool OwnPresetController::mayBeCalled(const QString& name) const {
  const bool isTaken = std::ranges::any_of(
      builtInPresets(), [&](const Preset& preset) { return preset.name == name.toStdString(); });
  if (name.isEmpty() || isTaken)
    m_context.messages.show(MessageBar::Kind::error,
                            isTaken ? tr("\"%1\" is a built-in preset; choose another name.").arg(name)
                                    : tr("A preset needs a name."));
  return !name.isEmpty() && !isTaken;
}

void OwnPresetController::save(const QString& name) {
  if (!mayBeCalled(name))
    return;
  if (find(name) && !mayReplace(name))
    return;
  Preset preset = presetOf(m_context.session.scene(), name.toStdString());
  // Values without a unit mean something beside those of their own volume alone.
  if (const auto& volume = m_context.session.scene().volume; !looksLikeHounsfield(*volume))
    preset.landmarks = landmarksOf(m_context.document.histogram());
  // What opening sets belongs to the slices of the volume.
  if (const Grid& grid = m_context.session.scene().volume->grid();
      preset.shading && preset.shading->gradientSmoothing == smoothingOfSlices(grid))
    preset.shading->gradientSmoothing = 0.0;
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
bool OwnPresetController::mayReplace(const QString& name) {
  QMessageBox box(QMessageBox::Question, tr("Replace preset"),
                  tr("There is a preset \"%1\" already. Replace it by what is shown?").arg(name),
                  QMessageBox::Cancel, &m_context.window);
  box.setObjectName(QStringLiteral("replacePreset"));
  const QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::AcceptRole);
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
      read();
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
    if (entered == name || !found || !mayBeCalled(entered))
      return;
    if (find(entered))
      return m_context.messages.show(
          MessageBar::Kind::error, tr("There is a preset \"%1\" already; choose another name.").arg(entered));
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
  ask(tr("Rename preset"), tr("New name:"), name, give);
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
  const auto keep = [this, copy = preset](const QString& entered) mutable {
    if (!mayBeCalled(entered))
      return;
    copy.name = entered.toStdString();
    m_context.notes.attempt([&] {
      m_store.save(copy);
      read();
      emit kept(entered);
    });
  };
  ask(tr("Duplicate preset"), tr("Name of the copy (a preset of the same name is replaced):"),
      tr("%1 copy").arg(QString::fromStdString(preset.name)), keep);
}

} // namespace limn
