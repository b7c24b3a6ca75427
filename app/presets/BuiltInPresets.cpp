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
  // Digit keys choose the first nine.
  for (const char* name : {"ct_bone_and_veil",
                           "ct_skin_and_bone",
                           "ct_bone",
                           "ct_soft_tissue",
                           "ct_muscle",
                           "ct_skin",
                           "ct_angiography",
                           "ct_heart",
                           "ct_coronary",
                           "ct_aorta",
                           "ct_liver",
                           "ct_chest",
                           "ct_lung",
                           "ct_lung_vessels",
                           "ct_airways",
                           "ct_fat",
                           "ct_teeth",
                           "ct_bone_surface",
                           "ct_maximum",
                           "ct_xray",
                           "mr_head",
                           "mr_t2",
                           "mr_pd",
                           "mr_brain",
                           "mr_glass",
                           "mr_maximum",
                           "vessels",
                           "surface",
                           "pet_hot",
                           "us_surface"}) {
    QFile file(QStringLiteral(":/presets/%1.json").arg(QLatin1String(name)));
    const bool opened = file.open(QIODevice::ReadOnly);
    assert(opened);
    (void)opened;
    presets.push_back(parsePreset(file.readAll().toStdString(), name));
  }
  return presets;
}

} // namespace limn
