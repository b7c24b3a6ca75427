// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/Region.h"
#include "scene/volume/Volume.h"

#include <memory>

namespace limn {

/// A volume whose values are labels as a label map on `grid`, which may be another: each voxel takes the
/// label that is nearest to its centre, and the background (0) outside. `described` are names and colours
/// by value, of which those matter that occur; others are called "Label 3" and get a colour of their own.
/// Labels are listed by their value, the background first. Throws Error (input) where a value is no whole
/// number or where there are more than 65535 labels; Cancelled.
std::shared_ptr<const LabelMap> labelsOnGrid(const Volume& labels, const std::vector<Label>& described,
                                             const Grid& grid, const Effort& effort = {});

/// The colour of the n-th label: neighbours in the list differ much.
glm::dvec3 labelColor(std::size_t n);

} // namespace limn
