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

#include <QInputDialog>
#include <QLocale>

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
  m_with.browser.setCurrent(QString::fromStdString(m_with.document.presetShown()));
}

void PresetDesk::use(const QString& name) {
  const Scene& scene = m_with.session.scene();
  const std::vector<Preset> presets = allPresets(m_store);
  const auto found = named(presets, name);
  if (found == presets.end() || !scene.volume)
    return;
  const bool isBuiltIn = found - presets.begin() < static_cast<std::ptrdiff_t>(builtInPresets().size());
  // Own presets were shaped on data like this; built-in ones fit themselves to it.
  show(isBuiltIn ? fittedTo(*found, m_with.document.histogram()) : *found, tr("use preset %1").arg(name));
  if (isForHounsfield(*found) && !looksLikeHounsfield(*scene.volume))
    offerToFit(*found);
}

void PresetDesk::show(const Preset& preset, const QString& edit) {
  m_with.document.use(preset);
  m_with.session.edit(withPreset(m_with.session.scene(), preset, true), {nextGestureId(), edit});
  // A preset that changes nothing is in use as well.
  m_with.browser.setCurrent(QString::fromStdString(preset.name));
}

void PresetDesk::offerToFit(const Preset& preset) {
  const QString name = QString::fromStdString(preset.name);
  const auto fit = [this, preset, name, volume = m_with.session.scene().volume] {
    if (m_with.session.scene().volume != volume)
      return;
    const Landmarks to = landmarksOf(m_with.document.histogram());
    show(fittedTo(withLandmarks(preset), m_with.document.histogram()), tr("fit preset %1").arg(name));
    const auto number = [](double value) { return QLocale().toString(value, 'g', 4); };
    m_with.messages.show(MessageBar::Kind::warning,
                         tr("\"%1\" was fitted by this volume's own values: air lies at %2 (instead of %3 "
                            "HU), tissue begins at "
                            "%4 (%5 HU), the brightest is %6 (%7 HU).")
                             .arg(name, number(to.background), number(hounsfieldLandmarks.background),
                                  number(to.object), number(hounsfieldLandmarks.object), number(to.brightest),
                                  number(hounsfieldLandmarks.brightest)));
  };
  m_with.messages.show(MessageBar::Kind::warning,
                       tr("\"%1\" is made for Hounsfield units, which this volume does not have: it may show "
                          "nothing, or the wrong tissue.")
                           .arg(name),
                       {}, {tr("Fit to this volume"), fit});
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
  auto* dialog = new QInputDialog(&m_with.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Save as preset"));
  dialog->setLabelText(tr("Name (a preset of the same name is replaced):"));
  dialog->setOkButtonText(tr("Save"));
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this](const QString& entered) { save(entered.trimmed()); });
  dialog->open();
}

void PresetDesk::save(const QString& name) {
  const std::vector<Preset> builtIn = builtInPresets();
  const bool isTaken = named(builtIn, name) != builtIn.end();
  if (name.isEmpty() || isTaken) {
    m_with.messages.show(MessageBar::Kind::error,
                         isTaken ? tr("\"%1\" is a built-in preset; choose another name.").arg(name)
                                 : tr("A preset needs a name."));
    return;
  }
  const Preset preset = presetOf(m_with.session.scene(), name);
  const auto write = [&] {
    m_store.save(preset);
    refresh();
    m_with.document.use(preset);
    m_with.browser.setCurrent(name);
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

} // namespace limn
