// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Preset.h"
#include "scene/volume/Histogram.h"

#include <string>
#include <vector>

namespace limn {

/// How a single image is shown: from black to white, opaque and unlit, because an image has no surface that
/// light could show. In Hounsfield units over the window of soft tissue (-160..240 HU) where the image
/// reaches into it, else between its 0.5 % and 99.5 % quantiles.
Preset imageLook(const Volume& volume, const Histogram& histogram);

/// Whether a volume's scalars are Hounsfield units: said by the file, or evident from a range that starts at
/// air (-3100..-900) and reaches beyond soft tissue (> 150).
bool looksLikeHounsfield(const Volume& volume);

/// The unit distance of opacities that mean a material of no known size: 1 mm, or a voxel where that is
/// smaller.
double unitDistanceMm(const Grid& grid);

/// A function for data without a known scale: transparent up to where the noise of the background ends (0.6
/// to 0.9 of the object threshold), a surface from there on, full at the 99.5 % quantile. Its unit distance
/// is that of the grid.
TransferFunction automaticRamp(const Histogram& histogram, const Grid& grid);

/// A preset that knows the landmarks of the data that it was shaped on, moved onto those of other data;
/// others stay where they are (CT presets where Hounsfield put them). On a grid finer than 0.1 mm, as of
/// micro-CT, opacities that hold for a millimetre of a body hold for a voxel.
Preset fittedTo(const Preset& preset, const Histogram& histogram, const Grid& grid);

/// Whether a preset means Hounsfield units.
bool isForHounsfield(const Preset& preset);

/// The preset with the landmarks of Hounsfield units where it means those, so that it can be fitted to data
/// in another scale.
Preset withLandmarks(Preset preset);

/// A look of a volume on this grid as it goes to others: without the smooth normals that opening sets for the
/// volume's slices.
Preset withoutSmoothingOfSlices(Preset preset, const Grid& grid);

/// A built-in preset as it is used on a volume: one that means Hounsfield units is moved onto the values of
/// data that have others.
Preset fittedToValues(const Preset& preset, const Volume& volume, const Histogram& histogram);

/// The name of the built-in preset that a volume opens with: by modality, body part and contrast where its
/// file hints at them, and by its values. Empty where none suits; then it is the automatic ramp.
std::string firstLook(const Volume& volume, const Histogram& histogram);

/// The preset a volume opens with: its first look from `builtIn`, fitted; the automatic ramp where none
/// suits; of a single image its grey values (imageLook). `builtIn` may be empty.
Preset bestFitting(const std::vector<Preset>& builtIn, const Volume& volume, const Effort& effort = {});

} // namespace limn
