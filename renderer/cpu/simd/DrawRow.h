// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"

namespace limn::cpu {

/// Draws the pixels `fromX` … `toX - 1` of row `y` to `out`, with the best instructions that the processor
/// has and InstructionSet.h allows: premultiplied RGBA without background.
void drawRow(const PictureTerms& terms, int y, int fromX, int toX, glm::vec4* out);

} // namespace limn::cpu
