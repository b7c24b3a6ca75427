// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Grid.h"

#include <optional>

namespace limn {

/// Where the picture is taken from, world millimetres (DEFINITION section 8).
struct Camera {
  enum class Projection { perspective, orthographic };
  Projection projection = Projection::perspective;
  glm::dvec3 position{0.0, -500.0, 0.0};
  glm::dvec3 target{0.0};
  glm::dvec3 up{0.0, 0.0, 1.0};
  double fovYDeg = 30.0;   ///< vertical field of view, perspective
  double heightMm = 200.0; ///< height of the picture, orthographic

  bool operator==(const Camera&) const = default;
};

/// The camera's axes, orthonormal: `right = forward × up`.
struct CameraBasis {
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 0.0, 1.0};
  glm::dvec3 forward{0.0, 1.0, 0.0};
};

/// A half line `origin + t · direction`, t ≥ 0 in mm, direction of unit length.
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 1.0, 0.0};
};

/// The axes of a camera; an `up` parallel to the view is replaced by the world axis least aligned with it, a
/// position equal to the target looks along +y.
CameraBasis basisOf(const Camera& camera);

/// The ray through the centre of pixel (x, y), y down, of a picture of `size` pixels (DEFINITION section 8).
Ray rayThroughPixel(const Camera& camera, int x, int y, const glm::ivec2& size);

/// The ray on which a place in the world is seen, towards it; nothing where it lies in the eye.
std::optional<Ray> rayThroughPlace(const Camera& camera, const glm::dvec3& worldMm);

/// Half the picture's height in mm at unit distance (perspective: tan(fov/2)) or at any (orthographic:
/// height/2).
double halfHeight(const Camera& camera);

/// From the front, perspective 30°, with the whole box in view and room around it.
Camera defaultCamera(const Grid& grid);

/// The directions from which radiologists look.
enum class StandardView { anterior, posterior, left, right, superior, inferior };

/// A standard view of the whole box, keeping projection and field of view of `camera`. Anterior looks at
/// the patient's face; superior from above the head.
Camera standardView(const Camera& camera, const Grid& grid, StandardView view);

/// Turns the camera about its target: `yaw` about the camera's up, `pitch` about its right, radians.
Camera orbited(const Camera& camera, double yaw, double pitch);

/// Rolls the camera in the picture plane, radians, clockwise as seen.
Camera rolled(const Camera& camera, double angle);

/// Moves the camera and its target in the picture plane by fractions of the picture's height (x right, y up)
/// so that the scene follows.
Camera panned(const Camera& camera, double x, double y);

/// Brings the target nearer by `factor` > 1 or further by `factor` < 1.
Camera zoomed(const Camera& camera, double factor);

} // namespace limn
