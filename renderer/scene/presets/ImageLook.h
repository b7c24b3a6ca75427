// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Preset.h"
#include "scene/volume/Histogram.h"

namespace limn {

/// How a single image is shown: from black to white, opaque and unlit, because an image has no surface that
/// light could show. In Hounsfield units over the window of soft tissue (-160..240 HU) where the image
/// reaches into it, else between its 0.5 % and 99.5 % quantiles.
Preset imageLook(const Volume& volume, const Histogram& histogram);

} // namespace limn
