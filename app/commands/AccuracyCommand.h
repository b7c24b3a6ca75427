// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

class CommandSyntax;

/// `limn accuracy SOURCE -o DIR`: error against time of a scene.
void addAccuracyCommand(CommandSyntax& root);

} // namespace limn
