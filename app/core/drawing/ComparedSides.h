// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SceneFile.h"
#include "scene/basics/Image.h"
#include "scene/view/CompareLayout.h"

#include <vector>

namespace limn {

/// The scenes that a picture shows which has these sides, from left to right; of one the scene as it is.
std::vector<Scene> scenesShown(const Scene& scene, const ShownSides& sides);

/// Two pictures of one size as a layout of two shows them: side by side, parted at `wipe` (0..1 of the
/// width), or as their amplified difference over `background`, which is opaque.
Image comparedPicture(const Image& left, const Image& right, CompareLayout layout, double wipe,
                      const glm::dvec3& background);

} // namespace limn
