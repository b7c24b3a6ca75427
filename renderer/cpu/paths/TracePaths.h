// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/paths/NoiseFilter.h"
#include "cpu/paths/PathPicture.h"
#include "cpu/paths/PathTerms.h"

#include <functional>

namespace limn::cpu {

/// Follows paths of the pixels of `covered`, a part of the picture, until each has `paths`. Between some of
/// them `isCancelled`, which may be empty, is asked; true ends it with Cancelled, and what was found stays.
void tracePaths(const PathTerms& paths, const PictureTerms& terms, std::uint32_t seed,
                const PixelRect& covered, int count, int threads, const std::function<bool()>& isCancelled,
                PathPicture& picture);

/// What lies where paths of the pixels of `covered` first meet something, a few of each: to guide a filter
/// (NoiseFilter). A seed gives the same ones, whatever threads there are. Throws Cancelled.
PathGuides tracedGuides(const PathTerms& paths, const PictureTerms& terms, std::uint32_t seed,
                        const PixelRect& covered, const Effort& effort, const PathPicture& picture);

} // namespace limn::cpu
