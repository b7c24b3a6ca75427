// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/light/LightingTerms.h"

namespace limn {

/// All rays of a picture as functions that are affine in the pixel, in *centred index* coordinates (voxel
/// index minus the index of the box's centre). Built in double and read by the reference in double, by the
/// shaders in float. A ray is measured from an anchor plane through the box's centre and not from the eye, so
/// that a far camera loses no digits; an eye of a perspective camera within the sphere around the box is its
/// own anchor, so that neither a near one loses any.
///
/// With c = (x+½-W/2, H/2-(y+½)), y down: anchor = anchor + c.x·anchorX + c.y·anchorY; direction likewise, to
/// be divided by `sqrt(1 + |c|²·tangentPerPixel²)`.
struct RayFrame {
  glm::dvec3 anchor{0.0}, anchorX{0.0}, anchorY{0.0};          ///< voxels
  glm::dvec3 direction{0.0}, directionX{0.0}, directionY{0.0}; ///< voxels per mm
  double tangentPerPixel = 0.0;                                ///< 0 for orthographic cameras
  double anchorDistanceMm = 0.0; ///< ≥ 0, from the eye (or camera plane) to the anchor plane
};

/// The rays of a picture of `size` pixels of a volume on `grid`.
RayFrame rayFrame(const Camera& camera, const Grid& grid, const glm::ivec2& size);

/// One ray: `anchor + t · direction`, t in mm, t = eye at the eye (≤ 0).
struct FramedRay {
  glm::dvec3 anchor{0.0};
  glm::dvec3 direction{0.0}; ///< voxels per mm
  double eye = 0.0;
};

/// The ray through the middle of pixel (x, y), y down, of a picture of `size`.
FramedRay framedRay(const RayFrame& frame, int x, int y, const glm::ivec2& size);

/// A box in centred index coordinates, half open: a ray in its lower face is inside, in its upper outside.
struct IndexBox {
  glm::dvec3 lower{0.0};
  glm::dvec3 upper{0.0};
};

/// The part of the volume box that the crop leaves.
IndexBox croppedBox(const Grid& grid, const CropBox& crop);

/// The index of the box's centre: centred index = index - this.
glm::dvec3 centreIndex(const Grid& grid);

/// The crop faces that cut the volume, centred index; far outside the box where a face does not cut.
struct CutPlanes {
  glm::dvec3 lower{0.0};
  glm::dvec3 upper{0.0};
};

/// The planes of those faces of the crop that lie within the box.
CutPlanes cutPlanes(const Grid& grid, const CropBox& crop);

/// The unit vector towards a light that shines along `directionWorld`, along the grid's axes.
glm::dvec3 towardsLightAlongAxes(const glm::dvec3& directionWorld, const Grid& grid);

/// The same of a picture's light; absent: headlight.
std::optional<glm::dvec3> towardsLight(const LightingTerms& terms, const Camera& camera, const Grid& grid);

/// The part of a ray inside a box and not behind the eye, mm; empty unless `end > begin`.
struct RaySpan {
  double begin = 0.0;
  double end = 0.0;
  bool isEmpty() const { return !(end > begin); }
};

/// Where a ray enters the box and leaves it; rays along a face count as IndexBox says.
RaySpan spanInBox(const FramedRay& ray, const IndexBox& box);

/// The most samples of one ray (DEFINITION section 7).
inline constexpr int mostSamples = 60000;

/// The share by which a span may exceed a whole number of steps before it gets one step more. Rounding would
/// otherwise give a chord of exactly k steps k or k+1 samples by chance, and float and double would differ.
inline constexpr double stepCountGuard = 1e-6;

/// N = max(1, ceil(length/step · (1 - stepCountGuard))), limited to `most`.
int sampleCount(double lengthMm, double stepMm, int most = mostSamples);

/// Where in its step a jittered pixel takes its samples, 0..1: an ordered pattern of 8 by 8 whose mean is
/// the middle. Counted from the picture's lower left corner, as OpenGL does.
double jitteredOffset(int x, int yDown, int height);

/// The transmittance at which a ray ends. A hair above 1 - e, so that a ray of exactly that opacity ends in
/// float as in double; early termination costs far more than this 1e-4 of the light that is left.
inline double lastTransmittance(double earlyTermination) {
  return (1.0 - earlyTermination) * (1.0 + 1e-4);
}

/// The step of a scene in mm.
double stepMm(const Scene& scene);

/// The samples that the longest possible ray (the box's diagonal) would need, before the limit.
double longestRaySamples(const Scene& scene);

} // namespace limn
