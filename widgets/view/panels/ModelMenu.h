// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Shading.h"

#include <functional>

class QPoint;
class QWidget;

namespace limn {

/// Offers the shading models at a place of the screen, the present one checked.
void popUpModels(QWidget* parent, const QPoint& at, ShadingModel present,
                 const std::function<void(ShadingModel)>& choose);

} // namespace limn
