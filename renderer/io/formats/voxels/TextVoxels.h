// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"

namespace limn {

/// Reads voxels written as decimal numbers between white space, scalar only, as the bytes arrive. `warnings`
/// takes note of numbers behind the last voxel; with `mayBeCut` also of a text that ends right behind a
/// digit, of which it may have lost others. Throws Error, naming `file`, where the text is too short or a
/// word is no number of the layout's type; Cancelled.
void readTextVoxels(const std::filesystem::path& file, const ByteReader& text, const VoxelLayout& layout,
                    const MemoryBudget& budget, const Progress& progress, bool mayBeCut, VolumeParts& parts);

/// The same from a place in a file, which must not be compressed.
void readTextVoxels(const ByteLocation& location, const VoxelLayout& layout, const MemoryBudget& budget,
                    const Progress& progress, VolumeParts& parts);

} // namespace limn
