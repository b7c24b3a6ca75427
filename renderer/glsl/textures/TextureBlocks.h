// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/BlockRanges.h"

namespace limn {

/// The inner planes of texels of whose blocks the layer z = `layer` consists, with one more before the first
/// and one behind the last: first and end, counted with the apron of a volume of `size` texels.
glm::ivec2 planesOfLayer(const glm::ivec3& size, int layer);

/// Gathers the layers z = `first` … `end`-1 of blocks of a volume of `size` texels with its apron. `texels`
/// are its planes from the first that belongs to them. BlockRanges::finish is left to the caller.
void gatherLayers(const float* texels, const glm::ivec3& size, int first, int end, BlockRanges& ranges);

} // namespace limn
