// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

class CommandSyntax;

/// Adds `limn effects`: what a picture simulates, why, and what each effect costs.
void addEffectsCommand(CommandSyntax& root);

} // namespace limn
