// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/MachineMemory.h"

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

} // namespace limn
