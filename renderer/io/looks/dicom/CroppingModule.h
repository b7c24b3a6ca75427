// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/Items.h"
#include "scene/Scene.h"

#include <array>

// The Volume Cropping module (PS3.3 C.11.24): boxes along the volume's axes.

namespace limn::dicom {

/// Two opposite corners of a box, patient millimetres; its edges lie along the volume's axes.
using BoxCorners = std::array<glm::dvec3, 2>;

/// Writes a crop and the flags that refer to it; `input` is the item of the input sequence.
void putCrop(DcmItem& object, DcmItem& input, const CropBox& crop, const Grid& grid);

/// The boxes that apply to the one input. Throws Error (input) for what is cut out by a segmentation or a box
/// that is missing or damaged; planes are left out with a sentence.
std::vector<BoxCorners> cropsIn(DcmItem& object, DcmItem& input, const std::string& name,
                                std::vector<Message>& changes);

/// What all boxes leave of a volume, as fractions along its axes; nothing where they leave none.
std::optional<CropBox> cropWithin(const std::vector<BoxCorners>& boxes, const Grid& grid);

} // namespace limn::dicom
