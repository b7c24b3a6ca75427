// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/nrrd/NrrdHeader.h"
#include "scene/regions/LabelMap.h"

#include <vector>

namespace limn {

/// The segments that 3D Slicer writes as keys into a NRRD header (Segment0_Name, Segment0_LabelValue,
/// Segment0_Color). A segment without a sound label value is left out.
std::vector<Label> slicerSegments(const NrrdHeader& header);

} // namespace limn
