// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/Threads.h"
#include "engine/PixelRect.h"

#include <algorithm>

namespace limn::cpu {

/// Some neighbouring pixels of a row of a picture.
struct Strip {
  int y = 0;
  int fromX = 0, toX = 0;
  std::size_t inTile = 0; ///< the place of the first in a tile that is stored row by row
};

/// Shares the pixels of `covered`, a part of `tile`, out among threads in strips. Throws as forEach does.
template <class Work>
void forEachStrip(const PixelRect& tile, const PixelRect& covered, int threads, const Work& work,
                  const std::function<bool()>& isCancelled) {
  constexpr int width = 64;
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
      isCancelled);
}

} // namespace limn::cpu
