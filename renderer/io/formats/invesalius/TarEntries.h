// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Bytes.h"

#include <string>

namespace limn {

/// Goes through the files of a tar archive (plain or gzipped) to the first of this name, whatever its
/// folder, and calls `use` with its size and its bytes. False where there is none. Throws Error where the
/// archive is damaged.
bool withTarEntry(const std::filesystem::path& archive, const std::string& name,
                  const std::function<void(std::uint64_t size, const ByteReader& bytes)>& use);

} // namespace limn
