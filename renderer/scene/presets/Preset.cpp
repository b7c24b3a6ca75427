// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/Preset.h"

#include "scene/ProjectionFacts.h"
#include "scene/volume/Volume.h"

namespace limn {

Preset presetOf(const Scene& scene, const std::string& name) {
  Preset preset;
  preset.name = name;
  if (scene.volume)
    preset.modality = scene.volume->info().modality;
  preset.transferFunction = scene.transferFunction;
  preset.gradientOpacity = scene.gradientOpacity;
  preset.shading = scene.shading;
  preset.projection = scene.projection;
  if (showsSurface(scene.projection))
    preset.isovalue = scene.isovalue;
  return preset;
}

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
