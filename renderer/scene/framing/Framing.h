// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/framing/VisibleVoxels.h"

#include <vector>

namespace limn {

/// The share of its limiting side that what a picture is framed on fills (DEFINITION section 8).
inline constexpr double framedShare = 0.88;

/// The same direction of view, moved sideways and back until the rectangle around the projections of the
/// visible voxels' centres, specks left out, is centred and fills `framedShare` of the limiting side of a
/// picture of `aspect` (width / height > 0); where the camera is orthographic its height does it. What is
/// thinner than three voxels is framed as if it were as wide. The target is halfway between the nearest and
/// the farthest that count. Exact, but for rounding.
Camera framed(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspect);

/// One distance from eye to target for several directions of view, where they are orthographic one height,
/// mm: the largest with which one of them is framed. Throws Cancelled.
double framedDistance(const std::vector<Camera>& cameras, const Grid& grid, const VisibleVoxels& visible,
                      double aspect, const Effort& effort = {});

/// The same direction of view, centred as framed does, from a distance (of an orthographic camera: with a
/// height) of framedDistance for it and maybe others.
Camera framedFrom(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspect,
                  double distance);

/// The scene's camera, framed on what is visible. Throws Cancelled.
Camera framedCamera(const Scene& scene, double aspect, const Effort& effort = {});

/// A standard view of what is visible in the scene. Throws Cancelled.
Camera framedView(const Scene& scene, StandardView view, double aspect, const Effort& effort = {});

/// The camera that shows at another aspect as much as the camera did before: what was framed stays framed,
/// and who came nearer stays as near.
Camera refitted(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspectBefore,
                double aspect);

/// Whether the camera is the one that `framed` gives for its own direction, but for rounding.
bool isFramed(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspect);

/// Whether a picture of `aspect` shows any of the voxels, specks left out: it does unless all lie behind the
/// eye or beyond one of its edges.
bool seesAny(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspect);

} // namespace limn
