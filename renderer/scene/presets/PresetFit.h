// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Preset.h"
#include "scene/volume/Histogram.h"

#include <string>
#include <vector>

namespace limn {

/// Whether a volume's scalars are Hounsfield units: said by the file, or evident from a range that starts at
/// air (-3100..-900) and reaches beyond soft tissue (> 150).
bool looksLikeHounsfield(const Volume& volume);

/// The threshold that best separates background from object (N. Otsu, IEEE Trans. SMC 9 (1979) 62), scalar
/// units.
double objectThreshold(const Histogram& histogram);

/// A function for data without a known scale: transparent up to 0.6 of the object threshold, then a ramp
/// up to the 99.5 % quantile.
TransferFunction automaticRamp(const Histogram& histogram);

/// A preset moved onto data without an absolute scale (MR): its first and last point go to the 0.5 % and
/// 99.8 % quantiles of the volume's values. CT presets stay where Hounsfield put them.
Preset fittedTo(const Preset& preset, const Histogram& histogram);

/// The preset a volume opens with: by modality and value range from `builtIn`, fitted; the automatic ramp
/// where none suits. `builtIn` may be empty.
Preset bestFitting(const std::vector<Preset>& builtIn, const Volume& volume, const Effort& effort = {});

} // namespace limn
