// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace limn {

/// Adds `limn info`: what a volume is, or with --system what a bug report needs.
void addInfoCommand(CLI::App& root);

} // namespace limn
