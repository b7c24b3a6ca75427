// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "raycaster/RayCaster.h"
#include "scene/CompareLayout.h"

#include <vector>

namespace limn {

/// How many times the `difference` layout shows the difference.
inline constexpr double differenceGain = 4.0;

/// How many pictures a layout draws: 1 or 2.
int pictureCount(CompareLayout layout);

/// Where the pictures lie in a view of `size` pixels, y down; in `wipe` and `difference` both fill it. Side
/// by side they are equal in size, with `gap` pixels between them (one more where the width is odd). Empty
/// where the view is too small to show them.
std::vector<PixelRect> pictureRects(CompareLayout layout, const glm::ivec2& size, int gap);

/// The column of the wipe border in a view `width` pixels wide; `fraction` is limited to 0..1.
int wipeColumn(int width, double fraction);

/// The picture under column `x`: 0 or 1.
int pictureAt(CompareLayout layout, const glm::ivec2& size, double wipeFraction, double x);

} // namespace limn
