// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "gl/PictureTarget.h"

namespace limn {

/// Lets an engine draw a tile of a picture as large as the target into it, whether it draws there or in
/// memory.
inline void drawTile(DrawingEngine& engine, const Scene& scene, const PixelRect& tile,
                     PictureTarget& target) {
  target.bind();
  if (const std::optional<Image> pixels = engine.draw(scene, target.size(), tile, {}))
    target.write(tile.topLeft, *pixels);
}

} // namespace limn
