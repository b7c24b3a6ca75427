// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/series/DicomGeometry.h"
#include "io/dicom/series/DicomSeries.h"
#include "io/reading/Progress.h"
#include "scene/basics/MemoryBudget.h"
#include "scene/basics/Room.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace limn {

/// The voxels of a series as stored, and what they mean.
struct DicomVoxels {
  VoxelVectors stored; ///< slice after slice, no resampling yet
  Rescale rescale;
  std::optional<PaddingRange> padding;
  std::shared_ptr<Room> room; ///< where they lie; null: in memory
  bool bitsIgnored = false;   ///< some had bits set beyond those of a value
};

/// Where the voxels of a series go.
struct DicomKeeping {
  std::filesystem::path path; ///< that was opened, for errors
  MemoryBudget budget;
  bool isPassing = false; ///< until they are resampled: what lies on disk meanwhile is not told
  /// The voxels to keep, columns, rows and slices as they are sorted; absent: all. Files of other slices are
  /// not opened.
  std::optional<VoxelBox> box = {};
};

/// Reads and decodes every slice of a series whose files are supported and whole. Keeps the stored type where
/// all slices share rescale, padding and format; otherwise, and through a modality look-up table, the values
/// become float with padding as NaN. Colour becomes luminance. What was changed is stated in `warnings`,
/// but for ignored bits.
/// Reports fractions 0..1. Throws Error (input); Cancelled.
/// They lie on disk where the budget does not hold them.
DicomVoxels readVoxels(const DicomSeries& series, const DicomKeeping& keeping, const Progress& progress,
                       std::vector<Message>& warnings);

/// Resamples slices onto the grid of `geometry`: each shifted in its plane (bilinear), planes between two of
/// them mixed linearly. Where one of the voxels to mix is padding, the nearest is taken instead; what no
/// slice covers becomes padding, for which a value that no voxel has is declared where none was (the type is
/// widened if all are in use). Integers are rounded. Where the budget does not hold them, the new voxels lie
/// on disk. Throws Error where there is no room; Cancelled.
DicomVoxels resampled(DicomVoxels voxels, const glm::ivec3& sourceDims, const DicomGeometry& geometry,
                      const DicomKeeping& keeping, const Progress& progress, std::vector<Message>& warnings);

} // namespace limn
