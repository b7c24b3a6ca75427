// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/SavedSides.h"

#include "app/core/sources/BuiltInPresets.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/view/overlay/ViewOrder.h"

namespace limn {
namespace {

// Also of one that was remembered; the name over its picture says whether it was modified or moved onto the
// volume's values.
std::string nameInFile(const ComparedLook& look) {
  for (const Preset& preset : builtInPresets())
    if (presetWords(QString::fromStdString(preset.name)) == QString::fromStdString(look.names[0]) &&
        preset.transferFunction == look.shown.transferFunction)
      return preset.name;
  return lookWithoutName;
}

} // namespace

ShownSides savedSides(const Comparison& shown) {
  if (shown.layout == CompareLayout::single)
    return {};
  if (!shown.look)
    return {shown.layout, shown.models[0], shown.models[1], shown.wipe};
  const Scene left = sceneOfSide(shown, 0);
  return {shown.layout, left.shading.model, sceneOfSide(shown, 1).shading.model, shown.wipe,
          presetOf(left, nameInFile(*shown.look))};
}

} // namespace limn
