// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/PixelRect.h"

#include <algorithm>
#include <functional>

namespace limn::cpu {

/// Calls `work(i)` for each i of 0 … count-1, on `threads` of the processor (0: all), the caller's among
/// them. `isCancelled`, which may be empty, is asked between two pieces of work on the caller's thread; once
/// it is true no piece is begun, and Cancelled is thrown. So is what `work` throws. A thread takes up to
/// `together` pieces on end, so that small ones cost no more to hand out.
void forEach(int count, int threads, const std::function<void(int)>& work,
             const std::function<bool()>& isCancelled = {}, int together = 1);

/// Some neighbouring pixels of a row of a picture.
struct Strip {
  int y = 0;
  int fromX = 0, toX = 0;
  std::size_t inTile = 0; ///< the place of the first in a tile that is stored row by row
};

/// Shares the pixels of `covered`, a part of `tile`, out among threads in strips of `width` pixels at most,
/// `together` strips on end. Throws as forEach does.
template <class Work>
void forEachStrip(const PixelRect& tile, const PixelRect& covered, int threads, const Work& work,
                  const std::function<bool()>& isCancelled, int width = 64, int together = 1) {
  const glm::ivec2 inTile = covered.topLeft - tile.topLeft;
  const int strips = (covered.size.x + width - 1) / width;
  forEach(
      strips * covered.size.y, threads,
      [&](int piece) {
        const int y = piece / strips;
        const int from = piece % strips * width;
        const int to = std::min(from + width, covered.size.x);
        work(Strip{covered.topLeft.y + y, covered.topLeft.x + from, covered.topLeft.x + to,
                   static_cast<std::size_t>(inTile.y + y) * tile.size.x + (inTile.x + from)});
      },
      isCancelled, together);
}

} // namespace limn::cpu
