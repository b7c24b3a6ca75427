// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/LabelFigures.h"
#include "scene/regions/Region.h"
#include "scene/volume/Volume.h"

#include <vector>

namespace limn {

/// What the voxels of each label say, in the order of the map's labels; the map lies on the volume's grid.
/// Invalid voxels count for the size of their label, not for its values. Throws Cancelled.
std::vector<LabelFigures> figuresOfLabels(const LabelMap& labels, const Volume& volume,
                                          const Effort& effort = {});

} // namespace limn
