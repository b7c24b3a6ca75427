// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/PixelRect.h"
#include "scene/Scene.h"
#include "scene/basics/Image.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace limn {

/// A picture in double precision, and what the tests need to know about each ray.
struct ReferencePicture {
  glm::ivec2 size{0};
  std::vector<glm::dvec4> pixels; ///< premultiplied RGBA without background, row by row from the top
  std::vector<int>
      samples; ///< the N of each pixel's ray, or the error-controlled ones it took; 0 where it misses
};

/// Whether the sum of the light terms is limited (DEFINITION section 4) or left as it is, which shows by how
/// much it overflows.
enum class Limiting { clampOrKnee, none };

/// How rays keep a tolerance: cell by cell, as the CPU engine's do (scene/steps/CellRule), or in the steps
/// that shaders take (scene/steps/LocalSteps), whose twin this is.
enum class ToTolerance { byCells, byLocalSteps };

/// Draws the definition itself (DEFINITION section 7) in double precision, on every
/// core, without lookup tables. `isCancelled` may be empty; true ends the work with Cancelled. Pixels outside
/// `tile` stay zero.
ReferencePicture renderReference(const Scene& scene, const glm::ivec2& size, int threads = 0,
                                 const std::function<bool()>& isCancelled = {},
                                 Limiting limiting = Limiting::clampOrKnee,
                                 const std::optional<PixelRect>& tile = {},
                                 ToTolerance way = ToTolerance::byCells);

/// Draws again, with the scene as it is now, those pixels of a picture of the same size whose entry in
/// `wanted` is not 0, their rays as long as the step asks for: the limit on samples is for pictures that
/// people wait for. Throws as above; cancelled, the picture holds both old and new rows.
void redrawReference(ReferencePicture& picture, const Scene& scene, const std::vector<std::uint8_t>& wanted,
                     int threads = 0, const std::function<bool()>& isCancelled = {});

/// The picture rounded to floats.
Image toImage(const ReferencePicture& picture);

} // namespace limn
