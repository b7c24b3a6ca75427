// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

class CommandSyntax;

/// Adds `limn presets list` and `limn presets show NAME`.
void addPresetsCommand(CommandSyntax& root);

} // namespace limn
