// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

class CommandSyntax;

/// Adds `limn info`: what a volume is, or with --system what a bug report needs.
void addInfoCommand(CommandSyntax& root);

} // namespace limn
