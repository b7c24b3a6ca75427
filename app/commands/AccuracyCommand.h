// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace limn {

/// `limn accuracy SOURCE -o DIR`: error against time of a scene.
void addAccuracyCommand(CLI::App& root);

} // namespace limn
