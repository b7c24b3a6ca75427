// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace limn {

/// Opens the window on `path` (empty: the empty state) and runs until it closes. Returns the exit status; 4
/// where there is no display.
int runWindow(int argc, char** argv, const std::string& path);

} // namespace limn
