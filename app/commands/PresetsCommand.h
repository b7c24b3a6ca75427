// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace limn {

/// Adds `limn presets list` and `limn presets show NAME`.
void addPresetsCommand(CLI::App& root);

} // namespace limn
