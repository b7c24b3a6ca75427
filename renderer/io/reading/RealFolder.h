// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace limn {

/// Whether a folder shows the state of the kernel (/proc, /sys and the like) rather than files on a disk: its
/// files announce lengths that they do not have, and reading some of them has effects.
bool isPseudoFolder(const std::filesystem::path& folder);

} // namespace limn
