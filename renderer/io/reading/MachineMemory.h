// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace limn {

/// Throws Error (input), naming `path`, where its voxels need more bytes than this computer has memory. The
/// system would promise them and end the program when they are filled.
void requireMemory(const std::filesystem::path& path, double bytes);

} // namespace limn
