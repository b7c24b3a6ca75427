// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

class CommandSyntax;

/// Adds `limn bench`: milliseconds per frame by renderer, scene and step.
void addBenchCommand(CommandSyntax& root);

} // namespace limn
