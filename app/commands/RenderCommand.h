// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace limn {

/// Adds `limn render`: a picture of a scene, or of two shading models side by side.
void addRenderCommand(CLI::App& root);

} // namespace limn
