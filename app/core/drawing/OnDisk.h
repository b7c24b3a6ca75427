// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <string>

namespace limn {

/// Whether the scene's voxels stay on disk: OpenGL would copy all of them, the processor reads what it needs.
bool staysOnDisk(const Scene& scene);

/// Throws Error (usage) where OpenGL was asked for and the scene's voxels stay on disk: with the memory that
/// would do, or instead what `otherwise` says, which ends with ", or ".
void requireOpenGlMayCopy(const Scene& scene,
                          const std::string& otherwise = "draw it with --engine cpu, or ");

} // namespace limn
