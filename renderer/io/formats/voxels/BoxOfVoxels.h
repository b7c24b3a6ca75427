// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"

namespace limn {

/// So many bytes of a volume's voxels, from a place among them on. No place lies before the end of the last.
using RunReader = std::function<void(std::uint64_t from, unsigned char* to, std::uint64_t bytes)>;

/// One that reads those bytes of a file that is not compressed and no others. Throws Error, naming it, where
/// it cannot be opened; when it reads, where it became shorter.
RunReader seeking(const ByteLocation& location);

/// One that drops what lies between, of voxels that arrive one after the other. When it reads, throws Error,
/// naming `file`, where they end early.
RunReader passing(const std::filesystem::path& file, const ByteReader& all, const VoxelLayout& layout);

/// Reads the voxels of a box of `parts.grid` alone into `parts.stored`: in memory, or in `parts.room` where
/// the budget does not hold them. Throws Error, naming `file`, where there is no room; what `read` does;
/// Cancelled.
void readBox(const std::filesystem::path& file, const RunReader& read, const VoxelLayout& layout,
             const VoxelBox& box, const MemoryBudget& budget, const Progress& progress, VolumeParts& parts);

std::size_t voxelsIn(const VoxelBox& box);

/// That the voxels of a box take as they are kept: colours are one value then.
double bytesKept(const VoxelLayout& layout, const VoxelBox& box);

} // namespace limn
