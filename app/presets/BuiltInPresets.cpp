// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presets/PresetStore.h"

#include "io/scenefile/SceneFile.h"

#include <QFile>

#include <cassert>

// Resources of a static library are registered by hand; the macro must stand outside any namespace.
static void registerPresetResources() {
  Q_INIT_RESOURCE(presets);
}

namespace limn {

std::vector<Preset> builtInPresets() {
  registerPresetResources();
  std::vector<Preset> presets;
  for (const char* name : {"ct_bone", "ct_skin_and_bone", "ct_soft_tissue", "ct_angiography", "ct_lung",
                           "ct_bone_surface", "ct_maximum", "ct_xray", "mr_head", "mr_glass"}) {
    QFile file(QStringLiteral(":/presets/%1.json").arg(QLatin1String(name)));
    const bool opened = file.open(QIODevice::ReadOnly);
    assert(opened);
    (void)opened;
    presets.push_back(parsePreset(file.readAll().toStdString(), name));
  }
  return presets;
}

} // namespace limn
