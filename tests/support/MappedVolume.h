// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <cstdint>
#include <filesystem>

namespace limn::test {

/// The same volume with its voxels in a file that is mapped, and what is made of them in a room of its own.
std::shared_ptr<const Volume> mapped(const Volume& volume, const std::filesystem::path& file);

/// A volume of zeros in an unlinked file without a single block on disk, in which some bytes may be written
/// first.
std::shared_ptr<const Volume> sparseVolume(const glm::ivec3& dims,
                                           const std::function<void(std::int16_t*)>& write);

/// Gives back all pages of the volume's voxels that this process has mapped; the file keeps them.
void forgetPages(const Volume& volume);

/// How many bytes of the volume's voxels this process has mapped since.
std::uint64_t touchedBytes(const Volume& volume);

/// Bytes of this process's memory that no file backs.
std::uint64_t ownMemory();

} // namespace limn::test
