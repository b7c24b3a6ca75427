// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <memory>

namespace limn {

/// Skin faint, muscle fuller, bone dense: the transfer function of comparisons, HU.
TransferFunction skinMuscleBone();

/// A volume seen by the default camera under skinMuscleBone, step 0.25, without early termination.
Scene headScene(std::shared_ptr<const Volume> volume, ShadingModel model);

} // namespace limn
