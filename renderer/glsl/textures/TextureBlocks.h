// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glsl/textures/TextureVoxels.h"
#include "scene/steps/EmptySpace.h"

namespace limn {

/// The blocks of a volume as the shaders read it.
BlockRanges blockRanges(const TextureVoxels& voxels);

} // namespace limn
