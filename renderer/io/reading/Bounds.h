// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/MemoryBudget.h"
#include "scene/basics/Message.h"
#include "scene/basics/Room.h"
#include "scene/volume/Grid.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace limn {

/// Throws Error (input), naming `path`, where its voxels need more bytes than this computer has memory. The
/// system would promise them and end the program when they are filled.
void requireMemory(const std::filesystem::path& path, double bytes);

/// Where voxels of so many bytes are kept: in memory (null) where the budget holds them and there is so much,
/// otherwise in a room, which says in `warnings` how much of the disk it takes.
/// Throws Error, naming `path`, where neither is large enough.
std::shared_ptr<Room> roomFor(const std::filesystem::path& path, double bytes, const MemoryBudget& budget,
                              std::vector<Message>& warnings);

/// Throws Error (input), naming `path`, where a grid cannot be that of a scan: voxels smaller than an atom
/// (1e-7 mm) or larger than a kilometre (1e6 mm), or a place more than a thousand kilometres away (1e9 mm).
/// Such numbers are damage, and beyond them coordinates lose their digits.
void requirePlausible(const std::filesystem::path& path, const Grid& grid);

} // namespace limn
