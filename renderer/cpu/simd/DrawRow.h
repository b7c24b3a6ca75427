// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"

#include <cstddef>

namespace limn::cpu {

// All of these compute the pixels `fromX` … `toX - 1` of row `y` into `out`, with the best instructions that
// the processor has and InstructionSet.h allows.

/// Premultiplied RGBA without background.
void drawRow(const PictureTerms& terms, int y, int fromX, int toX, glm::vec4* out);

/// Where rays meet the surface, for each pixel: in the brick that is drawn, and the nearest of all bricks. In
/// steps behind sample 0, +∞ where nowhere; null where the picture has no surface.
struct RowHits {
  const float* own = nullptr;
  const float* nearest = nullptr;
};

/// What the brick that is drawn adds to the pixels: premultiplied RGBA, to be put over what lies behind it.
/// Returns how many samples of the rays lie in it.
std::int64_t drawShares(const PictureTerms& terms, int y, int fromX, int toX, const RowHits& hits,
                        glm::vec4* out);

/// The hits of the brick that is drawn.
void findHits(const PictureTerms& terms, int y, int fromX, int toX, float* out);

/// The scalars of the brick that is drawn, of pictures that classify one for each ray: {the largest, {minus
/// the smallest, or {the sum; then whether any was kept, or how many. Leaves pixels alone whose rays pass by.
/// Returns how many samples of the rays lie in it.
std::int64_t findScalars(const PictureTerms& terms, int y, int fromX, int toX, glm::dvec2* out);

/// The pixels of such scalars, found of whole rays.
void classifyScalars(const PictureTerms& terms, const glm::dvec2* scalars, std::size_t pixels,
                     glm::vec4* out);

} // namespace limn::cpu
