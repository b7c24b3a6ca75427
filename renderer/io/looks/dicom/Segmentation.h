// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/DicomFolder.h"
#include "io/looks/dicom/References.h"
#include "scene/regions/Region.h"
#include "scene/volume/Grid.h"

#include <string>

// What is kept and what is cut away as a segmentation (PS3.3 A.51), for programs that know neither Limn's
// scenes nor its cuts.

namespace limn::dicom {

/// Whether a region has voxels to tell of: labels, a body, cuts or pieces.
bool hasSegments(const Region& keep, const Grid& grid);

/// Fills in a segmentation with a segment for each label that some voxel has, but for the background of a
/// label map. Frames are the slices of the grid along
/// its third axis in which a segment has a voxel. `image` is one of the series, with the UIDs of study and
/// frame; patient, study and whose object it is are not filled in. Throws Error (other).
void putSegmentation(DcmItem& object, const Region& keep, const Grid& grid, DcmItem& image,
                     const SeriesImages& series, const std::string& organisation, const std::string& version);

/// Gives the segments their names, once patient and study are filled in: in UTF-8, in which the object then
/// is. Labels are called as in their file; what cuts and pieces made as a person called those, or by the
/// ranges of the pieces in `unit` (of the scalars; may be empty).
void putSegmentNames(DcmItem& object, const Region& keep, const Grid& grid, const std::string& unit);

} // namespace limn::dicom
