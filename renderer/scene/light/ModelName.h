// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Shading.h"

#include <array>

namespace limn {

/// Every shading model, in the order in which they are offered.
inline constexpr std::array shadingModels{ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced,
                                          ShadingModel::robust};

/// The word for a model in scene files and on the command line.
inline const char* nameOf(ShadingModel model) {
  constexpr std::array names{"none", "classic", "enhanced", "robust"};
  return names[static_cast<std::size_t>(model)];
}

} // namespace limn
