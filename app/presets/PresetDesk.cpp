// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presets/PresetDesk.h"

#include "app/Settings.h"
#include "app/document/OpenDocument.h"
#include "app/presets/PresetStore.h"
#include "app/saving/SaveNotes.h"
#include "app/window/MessageBar.h"
#include "scene/basics/Error.h"
#include "scene/presets/PresetFit.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/presets/PresetWords.h"

#include <QDialogButtonBox>
#include <QInputDialog>
#include <QPushButton>

#include <algorithm>

namespace limn {
namespace {

auto named(const std::vector<Preset>& presets, const QString& name) {
  return std::find_if(presets.begin(), presets.end(),
                      [&](const Preset& preset) { return preset.name == name.toStdString(); });
}

} // namespace

PresetDesk::PresetDesk(PresetStore store, const Partners& partners)
    : m_store(std::move(store)), m_with(partners) {}

void PresetDesk::refresh() {
  const PresetStore::Contents own = m_store.read();
  m_own = own.presets;
  showStanding();
  m_with.browser.setPresets(m_builtIn, m_own);
  if (!own.problems.empty())
    m_with.messages.show(MessageBar::Kind::error, translated(own.problems.front()));
  emit listed();
}

std::vector<Preset> PresetDesk::fittedPresets() const {
  std::vector<Preset> presets;
  for (const QString& name : m_with.browser.presets())
    presets.push_back(fitted(name).value());
  return presets;
}

void PresetDesk::showStanding() {
  PresetStanding standing;
  standing.favourites = m_with.settings.favourites();
  m_volume = m_with.session.scene().volume;
  if (m_volume)
    standing.fit = {m_volume->info().modality, firstLook(*m_volume, m_with.document.histogram()),
                    looksLikeHounsfield(*m_volume)};
  m_with.browser.setStanding(standing);
}

// A camera that moves ends no preview; any other change does.
void PresetDesk::goOnWithPreview() {
  if (m_previewed.isEmpty())
    return;
  const Scene& scene = m_with.session.scene();
  m_previewedFrom.camera = scene.camera;
  if (m_previewedFrom == scene)
    return preview(m_previewed);
  m_previewed.clear();
  m_previewedFrom = {};
}

void PresetDesk::markShown() {
  goOnWithPreview();
  if (m_with.session.scene().volume != m_volume)
    showStanding();
  const OpenDocument::PresetInUse preset = m_with.document.presetInUse();
  if (!m_saidOf.empty() && m_saidOf != preset.name && m_with.messages.sentence() == m_said)
    m_with.messages.hide(); // it was about another preset
  m_with.browser.setCurrent(QString::fromStdString(preset.name), preset.isModified);
}

const Preset* PresetDesk::find(const QString& name) const {
  for (const std::vector<Preset>* presets : {&m_builtIn, &m_own})
    if (const auto found = named(*presets, name); found != presets->end())
      return &*found;
  return nullptr;
}

bool PresetDesk::isBuiltIn(const QString& name) const {
  return named(m_builtIn, name) != m_builtIn.end();
}

// It means Hounsfield units, and what is open has others.
bool PresetDesk::isInOtherUnits(const Preset& preset) const {
  const std::shared_ptr<const Volume>& volume = m_with.session.scene().volume;
  return volume && isForHounsfield(preset) && !looksLikeHounsfield(*volume);
}

// Own presets were shaped on data like this; built-in ones fit themselves to it.
std::optional<Preset> PresetDesk::fitted(const QString& name) const {
  const Preset* found = find(name);
  if (!found)
    return std::nullopt;
  const std::shared_ptr<const Volume>& volume = m_with.session.scene().volume;
  return volume && isBuiltIn(name) ? fittedToValues(*found, *volume, m_with.document.histogram()) : *found;
}

// Somebody may have edited its file.
void PresetDesk::readAgain(const QString& name) {
  const auto known = named(m_own, name);
  if (known == m_own.end())
    return;
  try {
    if (m_store.find(known->name) != *known)
      refresh();
  } catch (const Error&) {
    refresh(); // and say why
  }
}

QString PresetDesk::nameShown() const {
  const OpenDocument::PresetInUse preset = m_with.document.presetInUse();
  const QString name = QString::fromStdString(preset.name);
  return name.isEmpty() ? tr("My preset") : preset.isModified ? tr("My %1").arg(name) : name;
}

void PresetDesk::use(const QString& name) {
  readAgain(name);
  const std::optional<Preset> preset = fitted(name);
  if (!preset || !m_with.session.scene().volume)
    return;
  show(*preset, tr("use preset %1").arg(presetWords(name)));
  if (const Preset known = *find(name); isInOtherUnits(known))
    isBuiltIn(name) ? sayHowItWasFitted(known) : offerToFit(known);
}

void PresetDesk::preview(const QString& name) {
  const Scene& scene = m_with.session.scene();
  if (!scene.volume)
    return;
  m_previewed = name;
  m_previewedFrom = name.isEmpty() ? Scene() : scene; // no volume is kept
  const std::optional<Preset> preset = fitted(name);
  emit previewed(preset ? withPreset(scene, *preset, true) : scene, preset ? preset->name : std::string());
}

void PresetDesk::compare(const QString& name) {
  if (const std::optional<Preset> preset = fitted(name); preset && m_with.session.scene().volume)
    emit compareRequested(*preset);
}

void PresetDesk::show(const Preset& preset, const QString& edit) {
  m_with.session.usePreset(preset, {nextGestureId(), edit});
  markShown(); // one that changes nothing is in use as well
}

void PresetDesk::sayHowItWasFitted(const Preset& preset) {
  const QString name = presetWords(QString::fromStdString(preset.name));
  const Landmarks to = landmarksOf(m_with.document.histogram());
  const auto number = [](double value) { return digitsNumber(value, 4); };
  const auto leaveIt = [this, preset, name, volume = m_with.session.scene().volume] {
    if (m_with.session.scene().volume == volume)
      show(preset, tr("use preset %1").arg(name));
  };
  say(tr("\"%1\" was fitted by this volume's own values: air lies at %2 (instead of %3 HU), tissue begins at "
         "%4 "
         "(%5 HU), the brightest is %6 (%7 HU).")
          .arg(name, number(to.background), number(hounsfieldLandmarks.background), number(to.object),
               number(hounsfieldLandmarks.object), number(to.brightest),
               number(hounsfieldLandmarks.brightest)),
      {tr("Use it as it is"), leaveIt});
}

void PresetDesk::offerToFit(const Preset& preset) {
  const auto fit = [this, preset, volume = m_with.session.scene().volume] {
    if (m_with.session.scene().volume != volume)
      return;
    show(fittedToValues(preset, *volume, m_with.document.histogram()),
         tr("fit preset %1").arg(presetWords(QString::fromStdString(preset.name))));
    sayHowItWasFitted(preset);
  };
  say(tr("\"%1\" is made for Hounsfield units, which this volume does not have: it may show nothing, or the "
         "wrong "
         "tissue.")
          .arg(presetWords(QString::fromStdString(preset.name))),
      {tr("Fit to this volume"), fit});
}

void PresetDesk::say(const QString& sentence, const MessageBar::Action& action) {
  m_said = sentence;
  m_saidOf = m_with.document.presetInUse().name;
  m_with.messages.show(MessageBar::Kind::warning, sentence, {}, action);
}

void PresetDesk::useNumber(int number) {
  if (!m_with.session.scene().volume)
    return;
  if (number == 0) {
    m_with.session.setTransferFunction(
        automaticRamp(m_with.document.histogram(), m_with.session.scene().volume->grid()),
        {nextGestureId(), tr("use the full range")});
    return;
  }
  if (const QStringList listed = m_with.browser.presets(); number <= listed.size())
    use(listed[number - 1]);
}

void PresetDesk::askForName() {
  if (!m_with.session.scene().volume)
    return;
  const QString inUse = QString::fromStdString(m_with.document.presetInUse().name);
  const std::vector<Preset> own = m_store.read().presets;
  const QString proposed = inUse.isEmpty()                  ? tr("My preset")
                           : named(own, inUse) != own.end() ? inUse
                                                            : tr("My %1").arg(inUse);
  ask(tr("Save as preset"), tr("Name (a preset of the same name is replaced):"), proposed,
      [this](const QString& name) { save(name); });
}

void PresetDesk::ask(const QString& title, const QString& label, const QString& name,
                     const std::function<void(const QString&)>& answer) {
  auto* dialog = new QInputDialog(&m_with.window);
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
bool PresetDesk::mayBeCalled(const QString& name) const {
  const bool isTaken = isBuiltIn(name);
  if (name.isEmpty() || isTaken)
    m_with.messages.show(MessageBar::Kind::error,
                         isTaken ? tr("\"%1\" is a built-in preset; choose another name.").arg(name)
                                 : tr("A preset needs a name."));
  return !name.isEmpty() && !isTaken;
}

void PresetDesk::save(const QString& name) {
  if (!mayBeCalled(name))
    return;
  Preset preset = presetOf(m_with.session.scene(), name.toStdString());
  std::optional<Preset> replaced;
  if (const auto before = named(m_own, name); before != m_own.end()) {
    replaced = *before;
    preset.note = before->note;
    preset.folder = before->folder;
  }
  const auto write = [&] {
    m_store.save(preset);
    refresh();
    m_with.session.adoptPreset(preset);
    markShown();
    m_with.browser.reveal(name);
    if (replaced)
      offerBack(*replaced, tr("\"%1\" was replaced by what is shown.").arg(name), tr("Take the old one back"),
                false);
  };
  m_with.notes.attempt(write);
}

// Nobody is asked before: what was is brought back by one click.
void PresetDesk::offerBack(const Preset& preset, const QString& sentence, const QString& label,
                           bool isFavourite) {
  const auto bringBack = [this, preset, isFavourite] {
    m_with.notes.attempt([&] {
      m_store.save(preset);
      if (isFavourite)
        m_with.settings.setFavourite(preset.name, true);
      refresh();
      markShown();
    });
  };
  say(sentence, {label, bringBack});
  m_saidOf.clear(); // it holds whatever is shown
}

void PresetDesk::remove(const QString& name) {
  const auto known = named(m_own, name);
  if (known == m_own.end())
    return;
  Preset removed = *known;
  try {
    m_store.remove(removed.name);
    const bool isFavourite = m_with.settings.favourites().contains(removed.name);
    if (isFavourite)
      m_with.settings.setFavourite(removed.name, false);
    refresh();
    offerBack(removed, tr("\"%1\" was deleted.").arg(name), tr("Bring it back"), isFavourite);
  } catch (const Error& error) {
    m_with.messages.show(MessageBar::Kind::error, translated(error.sentence()));
  }
}

void PresetDesk::rename(const QString& name) {
  const auto give = [this, name](const QString& entered) {
    const auto found = named(m_own, name);
    if (entered == name || found == m_own.end() || !mayBeCalled(entered))
      return;
    if (named(m_own, entered) != m_own.end())
      return m_with.messages.show(MessageBar::Kind::error,
                                  tr("There is a preset \"%1\" already; choose another name.").arg(entered));
    m_with.notes.attempt([&] {
      Preset renamed = *found;
      renamed.name = entered.toStdString();
      m_store.save(renamed);
      m_store.remove(name.toStdString());
      if (m_with.settings.favourites().contains(name.toStdString())) {
        m_with.settings.setFavourite(name.toStdString(), false);
        m_with.settings.setFavourite(renamed.name, true);
      }
      if (Preset inUse = m_with.session.preset(); inUse.name == name.toStdString()) {
        inUse.name = renamed.name;
        m_with.session.adoptPreset(inUse);
      }
      refresh();
      markShown();
    });
  };
  ask(tr("Rename preset"), tr("New name:"), name, give);
}

void PresetDesk::setFavourite(const QString& name, bool isFavourite) {
  m_with.settings.setFavourite(name.toStdString(), isFavourite);
  showStanding();
}

void PresetDesk::change(const QString& name, const std::function<void(Preset&)>& edit) {
  const auto found = named(m_own, name);
  if (found == m_own.end())
    return;
  Preset changed = *found;
  edit(changed);
  m_with.notes.attempt([&] {
    m_store.save(changed);
    refresh();
  });
}

void PresetDesk::editNote(const QString& name) {
  const Preset* preset = find(name);
  if (!preset)
    return;
  ask(tr("Note of \"%1\"").arg(name), tr("What it shows, in one sentence:"),
      QString::fromStdString(preset->note), [this, name](const QString& note) {
        change(name, [&](Preset& changed) { changed.note = note.toStdString(); });
      });
}

void PresetDesk::moveTo(const QString& name, const QString& folder) {
  change(name, [&](Preset& changed) { changed.folder = folder.toStdString(); });
}

void PresetDesk::moveToNewFolder(const QString& name) {
  ask(tr("New folder"), tr("Folder for \"%1\":").arg(name), {},
      [this, name](const QString& folder) { moveTo(name, folder); });
}

void PresetDesk::duplicate(const QString& name) {
  const std::optional<Preset> preset = fitted(name);
  if (!preset)
    return;
  const auto keep = [this, copy = *preset](const QString& entered) mutable {
    if (!mayBeCalled(entered))
      return;
    copy.name = entered.toStdString();
    m_with.notes.attempt([&] {
      m_store.save(copy);
      refresh();
      m_with.browser.reveal(entered);
    });
  };
  ask(tr("Duplicate preset"), tr("Name of the copy (a preset of the same name is replaced):"),
      tr("%1 copy").arg(name), keep);
}

} // namespace limn
