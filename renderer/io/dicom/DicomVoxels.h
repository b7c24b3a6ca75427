// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/series/DicomSeries.h"
#include "io/reading/Progress.h"

namespace limn {

/// The voxels of a series as stored, and what they mean.
struct DicomVoxels {
  VoxelArray stored; ///< slice after slice, no resampling yet
  Rescale rescale;
  std::optional<PaddingRange> padding;
};

/// Reads and decodes every slice of a series whose files are supported and whole. Keeps the stored type where
/// all slices share rescale, padding and format; otherwise, and through a modality look-up table, the values
/// become float with padding as NaN. Colour becomes luminance. What was changed is stated in `warnings`.
/// Reports fractions 0..1. Throws Error (input); Cancelled.
DicomVoxels readVoxels(const DicomSeries& series, const Progress& progress,
                       std::vector<std::string>& warnings);

} // namespace limn
