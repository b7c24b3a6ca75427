// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace limn {

/// Adds `limn bench`: milliseconds per frame by renderer, scene and step.
void addBenchCommand(CLI::App& root);

} // namespace limn
