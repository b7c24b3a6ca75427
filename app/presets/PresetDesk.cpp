// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presets/PresetDesk.h"

#include "app/document/OpenDocument.h"
#include "app/presets/PresetStore.h"
#include "app/saving/SaveNotes.h"
#include "app/window/MessageBar.h"
#include "scene/basics/Error.h"
#include "scene/presets/PresetFit.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/ProjectionSection.h"

#include <QDialogButtonBox>
#include <QInputDialog>
#include <QLocale>
#include <QPushButton>

#include <algorithm>

namespace limn {
namespace {

auto named(const std::vector<Preset>& presets, const QString& name) {
  return std::find_if(presets.begin(), presets.end(),
                      [&](const Preset& preset) { return preset.name == name.toStdString(); });
}

Preset presetOf(const Scene& scene, const QString& name) {
  Preset preset;
  preset.name = name.toStdString();
  preset.modality = scene.volume->info().modality;
  preset.transferFunction = scene.transferFunction;
  preset.gradientOpacity = scene.gradientOpacity;
  preset.shading = scene.shading;
  preset.projection = scene.projection;
  if (usesIsovalue(scene.projection))
    preset.isovalue = scene.isovalue;
  return preset;
}

} // namespace

PresetDesk::PresetDesk(PresetStore store, const Partners& partners)
    : m_store(std::move(store)), m_with(partners) {}

void PresetDesk::refresh() {
  const PresetStore::Contents own = m_store.read();
  m_with.browser.setPresets(builtInPresets(), own.presets);
  if (!own.problems.empty())
    m_with.messages.show(MessageBar::Kind::error, QString::fromStdString(own.problems.front()));
}

void PresetDesk::markShown() {
  const OpenDocument::PresetInUse preset = m_with.document.presetInUse();
  m_with.browser.setCurrent(QString::fromStdString(preset.name), preset.isModified);
}

// Own presets were shaped on data like this; built-in ones fit themselves to it.
std::optional<Preset> PresetDesk::fitted(const QString& name) const {
  const std::vector<Preset> presets = allPresets(m_store);
  const auto found = named(presets, name);
  if (found == presets.end())
    return std::nullopt;
  const bool isBuiltIn = found - presets.begin() < static_cast<std::ptrdiff_t>(builtInPresets().size());
  return isBuiltIn && m_with.session.scene().volume ? fittedTo(*found, m_with.document.histogram()) : *found;
}

void PresetDesk::use(const QString& name) {
  const std::optional<Preset> preset = fitted(name);
  if (!preset || !m_with.session.scene().volume)
    return;
  if (!m_said.isEmpty() && m_with.messages.sentence() == m_said)
    m_with.messages.hide(); // it was about another preset
  show(*preset, tr("use preset %1").arg(name));
  if (isForHounsfield(*preset) && !looksLikeHounsfield(*m_with.session.scene().volume))
    offerToFit(*preset);
}

void PresetDesk::show(const Preset& preset, const QString& edit) {
  m_with.session.usePreset(preset, {nextGestureId(), edit});
  markShown(); // one that changes nothing is in use as well
}

void PresetDesk::offerToFit(const Preset& preset) {
  const QString name = QString::fromStdString(preset.name);
  const auto fit = [this, preset, name, volume = m_with.session.scene().volume] {
    if (m_with.session.scene().volume != volume)
      return;
    const Landmarks to = landmarksOf(m_with.document.histogram());
    show(fittedTo(withLandmarks(preset), m_with.document.histogram()), tr("fit preset %1").arg(name));
    const auto number = [](double value) { return QLocale().toString(value, 'g', 4); };
    say(tr("\"%1\" was fitted by this volume's own values: air lies at %2 (instead of %3 "
           "HU), tissue begins at "
           "%4 (%5 HU), the brightest is %6 (%7 HU).")
            .arg(name, number(to.background), number(hounsfieldLandmarks.background), number(to.object),
                 number(hounsfieldLandmarks.object), number(to.brightest),
                 number(hounsfieldLandmarks.brightest)));
  };
  say(tr("\"%1\" is made for Hounsfield units, which this volume does not have: it may show "
         "nothing, or the wrong tissue.")
          .arg(name),
      {tr("Fit to this volume"), fit});
}

void PresetDesk::say(const QString& sentence, const MessageBar::Action& action) {
  m_said = sentence;
  m_with.messages.show(MessageBar::Kind::warning, sentence, {}, action);
}

void PresetDesk::useNumber(int number) {
  if (!m_with.session.scene().volume)
    return;
  if (number == 0) {
    m_with.session.setTransferFunction(automaticRamp(m_with.document.histogram()),
                                       {nextGestureId(), tr("use the full range")});
    return;
  }
  const std::vector<Preset> presets = allPresets(m_store);
  if (static_cast<std::size_t>(number) <= presets.size())
    use(QString::fromStdString(presets[static_cast<std::size_t>(number - 1)].name));
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
  const std::vector<Preset> builtIn = builtInPresets();
  const bool isTaken = named(builtIn, name) != builtIn.end();
  if (name.isEmpty() || isTaken)
    m_with.messages.show(MessageBar::Kind::error,
                         isTaken ? tr("\"%1\" is a built-in preset; choose another name.").arg(name)
                                 : tr("A preset needs a name."));
  return !name.isEmpty() && !isTaken;
}

void PresetDesk::save(const QString& name) {
  if (!mayBeCalled(name))
    return;
  const Preset preset = presetOf(m_with.session.scene(), name);
  const auto write = [&] {
    m_store.save(preset);
    refresh();
    m_with.session.adoptPreset(preset);
    markShown();
  };
  m_with.notes.attempt(write);
}

void PresetDesk::remove(const QString& name) {
  try {
    m_store.remove(name.toStdString());
    refresh();
  } catch (const Error& error) {
    m_with.messages.show(MessageBar::Kind::error, QString::fromStdString(error.what()));
  }
}

void PresetDesk::rename(const QString& name) {
  const auto give = [this, name](const QString& entered) {
    const std::vector<Preset> own = m_store.read().presets;
    const auto found = named(own, name);
    if (entered == name || found == own.end() || !mayBeCalled(entered))
      return;
    if (named(own, entered) != own.end())
      return m_with.messages.show(MessageBar::Kind::error,
                                  tr("There is a preset \"%1\" already; choose another name.").arg(entered));
    m_with.notes.attempt([&] {
      Preset renamed = *found;
      renamed.name = entered.toStdString();
      m_store.save(renamed);
      m_store.remove(name.toStdString());
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
    });
  };
  ask(tr("Duplicate preset"), tr("Name of the copy (a preset of the same name is replaced):"),
      tr("%1 copy").arg(name), keep);
}

} // namespace limn
