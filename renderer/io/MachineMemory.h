// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Error.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>

#include <unistd.h>

namespace limn {

/// Throws Error (input), naming `path`, where its voxels need more bytes than this computer has memory. The
/// system would promise them and end the program when they are filled.
inline void requireMemory(const std::filesystem::path& path, double bytes) {
  const double present =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (bytes <= present)
    return;
  char text[160];
  std::snprintf(text, sizeof text,
                "its voxels need %.1f GiB of memory and this computer has %.1f; save a smaller volume.",
                bytes / (1 << 30), present / (1 << 30));
  throw Error(Error::Kind::input, "Cannot read " + path.string() + ": " + text);
}

} // namespace limn
