// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/ConvergedPicture.h"

#include <cstdint>
#include <optional>

namespace limn {

/// What exact pixels drawn at random say of a picture, free of assumptions: if none of n lies farther off
/// than x levels, the share of pixels that do exceeds 1 in 1,000 with a chance of less than 0.999ⁿ, which is
/// 5 %.
struct ErrorByChance {
  double levels = 0.0; ///< farther than which none lies in any channel, its own error counted
  double own = 0.0;    ///< what the last halving of the exact pixels' steps changed, levels
  double p99_9 = 0.0;  ///< 99.9th percentile of the channels of those that are covered (ImageError)
  int pixels = 0;      ///< that were drawn, each perhaps more than once
  bool operator==(const ErrorByChance&) const = default;
};

/// So many pixels say it: log 0.05 / log 0.999.
inline constexpr int chancePixels = 2995;

/// Pixels of a picture of `size` drawn at random among those whose rays meet what is kept of the volume, each
/// as likely as the others in every draw: 1 where one was drawn. The others are empty in every picture.
std::vector<std::uint8_t> pixelsByChance(const Scene& scene, const glm::ivec2& size, std::uint64_t seed);

/// The error of a picture of the scene, which is final: `draw` integrates the pixels that chance picks until
/// halving their steps changes none by more than a tenth of what is said, or by 0.02 level where that is
/// more. Absent where they do not come to that. The draw follows from the picture's bytes: the same picture
/// gets the same answer, and nobody chose it. Throws what `draw` throws.
std::optional<ErrorByChance> errorByChance(const Scene& scene, const Image& picture,
                                           const DrawPrecisely& draw);

/// The same with a draw of one's own.
std::optional<ErrorByChance> errorByChance(const Scene& scene, const Image& picture,
                                           const DrawPrecisely& draw, std::uint64_t seed);

/// "99.9 % of the pixels lie within 0.5 levels of the exact picture (95 % sure: …)."
Message describe(const ErrorByChance& error);

} // namespace limn
