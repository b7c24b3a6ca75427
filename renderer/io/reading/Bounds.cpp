// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/Bounds.h"

#include "io/reading/ReadError.h"

#include <unistd.h>

#include <cstdio>

namespace limn {

void requireMemory(const std::filesystem::path& path, double bytes) {
  const double present =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (bytes <= present)
    return;
  char text[160];
  std::snprintf(text, sizeof text, "its voxels need %.1f GiB of memory and this computer has %.1f",
                bytes / (1 << 30), present / (1 << 30));
  failReading(path, text, "save a smaller volume");
}

void requirePlausible(const std::filesystem::path& path, const Grid& grid) {
  char text[160];
  for (int axis = 0; axis < 3; ++axis)
    if (!(grid.spacingMm[axis] >= 1e-7) || !(grid.spacingMm[axis] <= 1e6)) {
      std::snprintf(text, sizeof text, "its voxel spacing of %g mm is damaged", grid.spacingMm[axis]);
      failReading(path, text, "give the true one with --spacing X,Y,Z");
    }
  const double away = glm::length(grid.originMm);
  if (!(away <= 1e9)) {
    std::snprintf(text, sizeof text, "its header places it %g mm away, which is damage", away);
    failReading(path, text, "export it again");
  }
}

} // namespace limn
