// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/light/Shading.h"
#include "scene/volume/Histogram.h"

namespace limn {

/// Counts the gradient moduli of the eligible voxels (scene/light/Gradient.h) in `bins` > 0 equal bins from 0
/// to the largest, value/mm; one bin where no voxel has a gradient. Costs two passes over the volume.
Histogram gradientHistogram(const Volume& volume, int bins = 1024, const Effort& effort = {});

/// A gradient opacity to begin with: it keeps the strongest boundaries (from the 97th percentile of the
/// moduli) and fades what changes slowly (0 up to the 60th percentile); where both are one, it rises
/// to half the largest modulus. Neutral for a volume without gradients.
GradientOpacity boundaryRamp(const Histogram& gradients);

} // namespace limn
