// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace limn {

/// Adds `limn effects`: what a picture simulates, why, and what each effect costs.
void addEffectsCommand(CLI::App& root);

} // namespace limn
