// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

class CommandSyntax;

/// Adds `limn render`: a picture of a scene, or of two shading models side by side.
void addRenderCommand(CommandSyntax& root);

} // namespace limn
