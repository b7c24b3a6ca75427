// SPDX-License-Identifier: GPL-3.0-or-later
// Rays, affine in the pixel, in centred index coordinates (renderer/scene/steps/RayFrame.h). Lengths, t
// among them, are in units of the smallest spacing: a picture's bits do not depend on the unit of its world.

uniform vec2 u_pictureCentre;
uniform vec3 u_anchor;
uniform vec3 u_anchorX;
uniform vec3 u_anchorY;
uniform vec3 u_direction;
uniform vec3 u_directionX;
uniform vec3 u_directionY;
uniform float u_tangentPerPixel;
uniform float u_anchorDistance;
uniform vec3 u_boxLower;
uniform vec3 u_boxUpper;
uniform vec3 u_spacing; // 1 or larger
uniform float u_stepsPerLength;
uniform float u_mostSamples;

struct Ray {
  vec3 anchor;
  vec3 direction; // voxels per length
  float eye;      // t of the eye
  float aside;    // how much farther from the eye t = 0 lies than the anchor plane
};

Ray rayThrough(vec2 fragment) {
  vec2 c = fragment - u_pictureCentre;
  vec2 tangent = c * u_tangentPerPixel;
  float length = sqrt(1.0 + dot(tangent, tangent));
  Ray ray;
  ray.anchor = u_anchor + c.x * u_anchorX + c.y * u_anchorY;
  ray.direction = (u_direction + c.x * u_directionX + c.y * u_directionY) / length;
  ray.eye = -u_anchorDistance * length;
  // length - 1 without cancellation; from c, because a compiler that finds the length's own terms used twice may
  // round the length otherwise than in a program without fog.
  ray.aside = u_anchorDistance * (dot(c, c) * u_tangentPerPixel * u_tangentPerPixel / (1.0 + length));
  return ray;
}

// Clip the ray to the half-open box and to what lies before the eye; empty unless y > x.
vec2 spanInBox(Ray ray) {
  // An axis that the ray does not move along bounds nothing, or leaves nothing.
  bvec3 isParallel = lessThan(abs(ray.direction), vec3(1e-20));
  vec3 direction = mix(ray.direction, vec3(1.0), isParallel);
  vec3 a = (u_boxLower - ray.anchor) / direction;
  vec3 b = (u_boxUpper - ray.anchor) / direction;
  vec3 entry = mix(min(a, b), vec3(-1e30), isParallel);
  vec3 exit = mix(max(a, b), vec3(1e30), isParallel);
  bvec3 isBelow = lessThan(ray.anchor, u_boxLower);
  bvec3 isAbove = greaterThanEqual(ray.anchor, u_boxUpper);
  for (int axis = 0; axis < 3; ++axis)
    if (isParallel[axis] && (isBelow[axis] || isAbove[axis]))
      return vec2(0.0);
  return vec2(max(max(entry.x, entry.y), max(entry.z, ray.eye)), min(min(exit.x, exit.y), exit.z));
}

// A chord of a whole number of steps must not get one more by rounding: stepCountGuard of RayFrame.h.
int sampleCount(float chord) {
  return int(clamp(ceil(chord * u_stepsPerLength * (1.0 - 1e-6)), 1.0, u_mostSamples));
}
