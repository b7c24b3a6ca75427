// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/paths/PathPicture.h"
#include "engine/PathFigures.h"
#include "scene/basics/Effort.h"
#include "scene/basics/Image.h"

#include <glm/glm.hpp>

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
};

/// Filters the noise that is left in a picture of paths: each radiance becomes a mean over pixels around it,
/// weighted by how likely both show the same: by what lies there, and by patches around both, measured
/// against their standard errors (Rousselle, Manzi, Zwicker: Robust denoising using feature and color
/// information, 2013). Alpha stays. Pixels whose paths tell no error stay as they are.
///
/// What it errs by is found from the paths: each half is filtered by itself and judged by the other, of which
/// it knows nothing. Of colours filtered from half of the paths that is no estimate too low on average, up to
/// the bend of the display curve. Throws Cancelled.
FilteredPaths filtered(const PathPicture& picture, const PathGuides& guides, const Shading& shading,
                       const Effort& effort = {});

} // namespace limn::cpu
