// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Shading.h"

#include <QString>

namespace limn {

/// The name of a shading model as the window shows it, translated.
QString modelName(ShadingModel model);

} // namespace limn
