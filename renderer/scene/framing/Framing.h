// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/framing/VisibleBox.h"

namespace limn {

/// The share of both sides of a picture within which what it is framed on stays (DEFINITION section 8).
inline constexpr double framedShare = 0.85;

/// The same direction of view on a box (centred index): its centre is the target, and the distance (or, where
/// the camera is orthographic, the height) the smallest with which its corners stay within `framedShare` of a
/// picture of `aspect` (width / height > 0).
Camera framed(const Camera& camera, const Grid& grid, const IndexBox& box, double aspect);

/// The scene's camera, framed on what is visible. Throws Cancelled.
Camera framedCamera(const Scene& scene, double aspect, const Effort& effort = {});

/// A standard view of what is visible in the scene. Throws Cancelled.
Camera framedView(const Scene& scene, StandardView view, double aspect, const Effort& effort = {});

/// The camera that shows at another aspect as much of the box beside the view as it did before: what was
/// framed stays framed, and who came nearer stays as near.
Camera refitted(const Camera& camera, const Grid& grid, const IndexBox& box, double aspectBefore,
                double aspect);

/// Whether the camera is the one that `framed` gives for its own direction, but for rounding.
bool isFramed(const Camera& camera, const Grid& grid, const IndexBox& box, double aspect);

} // namespace limn
