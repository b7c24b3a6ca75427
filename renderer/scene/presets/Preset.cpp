// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/Preset.h"

namespace limn {

Scene withPreset(const Scene& scene, const Preset& preset, bool keepModel) {
  Scene shown = scene;
  shown.transferFunction = preset.transferFunction;
  shown.gradientOpacity = preset.gradientOpacity;
  if (preset.shading)
    shown.shading = *preset.shading;
  if (keepModel)
    shown.shading.model = scene.shading.model;
  if (preset.projection)
    shown.projection = *preset.projection;
  if (preset.isovalue)
    shown.isovalue = *preset.isovalue;
  return shown;
}

} // namespace limn
