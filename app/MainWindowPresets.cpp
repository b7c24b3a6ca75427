// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/BuiltInPresets.h"
#include "scene/Error.h"
#include "scene/PresetFit.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/scene/ProjectionSection.h"

#include <QInputDialog>

#include <algorithm>

namespace limn {

void MainWindow::refreshPresets() {
  const PresetStore::Contents own = m_presetStore.read();
  m_presets->setPresets(builtInPresets(), own.presets);
  if (!own.problems.empty())
    showError(QString::fromStdString(own.problems.front()));
}

void MainWindow::applyPreset(const QString& name) {
  const std::vector<Preset> presets = allPresets(m_presetStore);
  const auto found = std::find_if(presets.begin(), presets.end(),
                                  [&](const Preset& preset) { return preset.name == name.toStdString(); });
  if (found == presets.end() || !m_session.scene().volume)
    return;
  const bool isBuiltIn = found - presets.begin() < static_cast<std::ptrdiff_t>(builtInPresets().size());
  // Own presets were shaped on data like this; built-in ones fit themselves to it.
  const Preset preset = isBuiltIn ? fittedTo(*found, m_histogram) : *found;
  m_preset = preset;
  m_session.edit(withPreset(m_session.scene(), preset, true),
                 {nextGestureId(), tr("use preset %1").arg(name)});
  // A preset that changes nothing is in use as well.
  m_presets->setCurrent(name);
}

void MainWindow::applyWindowPreset(int number) {
  if (!m_session.scene().volume)
    return;
  if (number == 0) {
    m_session.setTransferFunction(automaticRamp(m_histogram), {nextGestureId(), tr("use the full range")});
    return;
  }
  const std::vector<Preset> presets = allPresets(m_presetStore);
  if (static_cast<std::size_t>(number) <= presets.size())
    applyPreset(QString::fromStdString(presets[static_cast<std::size_t>(number - 1)].name));
}

void MainWindow::savePreset() {
  if (!m_session.scene().volume)
    return;
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Save as preset"));
  dialog->setLabelText(tr("Name (a preset of the same name is replaced):"));
  dialog->setOkButtonText(tr("Save"));
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& entered) {
    const QString name = entered.trimmed();
    const std::vector<Preset> builtIn = builtInPresets();
    const bool isTaken = std::any_of(builtIn.begin(), builtIn.end(),
                                     [&](const Preset& preset) { return preset.name == name.toStdString(); });
    if (name.isEmpty() || isTaken) {
      showError(isTaken ? tr("\"%1\" is a built-in preset; choose another name.").arg(name)
                        : tr("A preset needs a name."));
      return;
    }
    const Scene& scene = m_session.scene();
    Preset preset;
    preset.name = name.toStdString();
    preset.modality = scene.volume->info().modality;
    preset.transferFunction = scene.transferFunction;
    preset.gradientOpacity = scene.gradientOpacity;
    preset.shading = scene.shading;
    preset.projection = scene.projection;
    if (usesIsovalue(scene.projection))
      preset.isovalue = scene.isovalue;
    try {
      m_presetStore.save(preset);
      refreshPresets();
      m_preset = preset;
      m_presets->setCurrent(name);
      noteSaved();
    } catch (const Error& error) {
      showSaveError(QString::fromStdString(error.what()));
    }
  });
  dialog->open();
}

void MainWindow::deletePreset(const QString& name) {
  try {
    m_presetStore.remove(name.toStdString());
    refreshPresets();
  } catch (const Error& error) {
    showError(QString::fromStdString(error.what()));
  }
}

} // namespace limn
