// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Grid.h"

#include <filesystem>

namespace limn {

/// Throws Error (input), naming `path`, where its voxels need more bytes than this computer has memory. The
/// system would promise them and end the program when they are filled.
void requireMemory(const std::filesystem::path& path, double bytes);

/// Throws Error (input), naming `path`, where a grid cannot be that of a scan: voxels smaller than an atom
/// (1e-7 mm) or larger than a kilometre (1e6 mm), or a place more than a thousand kilometres away (1e9 mm).
/// Such numbers are damage, and beyond them coordinates lose their digits.
void requirePlausible(const std::filesystem::path& path, const Grid& grid);

} // namespace limn
