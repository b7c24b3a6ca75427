// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/paths/PathPicture.h"
#include "engine/PathFigures.h"
#include "scene/basics/Effort.h"
#include "scene/basics/Image.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace limn::cpu {

/// What lies where paths of each pixel first meet something, on average; rows from the top.
struct PathGuides {
  std::vector<glm::vec3> albedo;
  std::vector<glm::vec3> normal; ///< of length 1 where all agree; 0 where the field is flat
  std::vector<float> depth;      ///< behind the entry into the box, lengths
};

/// A picture of paths whose noise was filtered, premultiplied display colours, and what that came to.
struct FilteredPaths {
  Image image;
  NoiseFigures figures;
  std::optional<double> rmsLevels; ///< the error that is left; absent where paths do not tell it
};

/// What filtering takes for a while, bytes a pixel: guides, a picture, two of radiances with variances, and
/// what is made of one of them.
inline constexpr std::size_t filterBytes = sizeof(glm::vec4) + 11 * sizeof(glm::vec3) + sizeof(float);

/// Filters the noise that is left in a picture of paths: each radiance becomes a mean over pixels around it,
/// weighted by how likely both show the same: by what lies there, and by patches around both, measured
/// against their standard errors (Rousselle, Manzi, Zwicker: Robust denoising using feature and color
/// information, 2013). Alpha stays. Pixels of which fewer than four paths met something stay as they are.
///
/// What it errs by is found from the paths: each half is filtered by itself and judged by the other, of which
/// it knows nothing but the spread of both together. Of colours filtered from half of the paths that is no
/// estimate too low on average, up to the bend of the display curve; pixels that stay count as off by all
/// that they can show, as they do without the filter. Tells `effort` how far it is. Throws Cancelled.
FilteredPaths filtered(const PathPicture& picture, const PathGuides& guides, const Shading& shading,
                       const Effort& effort = {});

} // namespace limn::cpu
