// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace limn {

/// The DICOM looks in the folder of a series (or of its file), and below it, whose images are all of that
/// series; newest file first. What cannot be read is none. Throws Cancelled.
std::vector<std::filesystem::path> looksBeside(const std::filesystem::path& volume, std::optional<int> series,
                                               const Progress& progress);

} // namespace limn
