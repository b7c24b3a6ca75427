// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

class CommandSyntax;

/// `limn stability`: the hard cases and random scenes on this machine's driver. Its exit status is 1 where
/// one fails.
void addStabilityCommand(CommandSyntax& root);

} // namespace limn
