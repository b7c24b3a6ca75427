// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FuzzInput.h"

#include "io/formats/voxels/Voxels.h"

namespace limn::test {

/// Reads a volume file; a volume that comes of it has as many voxels as its grid.
template <class Reader>
void readWhole(std::string_view bytes, Reader&& read) {
  const auto file = fileOf(bytes);
  harmless([&] {
    const VolumeParts parts = read(file, MemoryBudget(), Progress{});
    const std::size_t voxels = std::visit([](const auto& stored) { return stored.size(); }, parts.stored);
    if (voxels != voxelCount(file, parts.grid.dims))
      fault("a volume does not fill its grid");
  });
}

} // namespace limn::test
