// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace limn::test {

/// What can be opened below a folder, by name: files that hold a volume, and folders of slices (all of whose
/// files have one ending, or none). Label maps are left out.
std::vector<std::filesystem::path> volumesBelow(const std::filesystem::path& folder);

} // namespace limn::test
