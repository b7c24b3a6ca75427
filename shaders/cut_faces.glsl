// SPDX-License-Identifier: GPL-3.0-or-later
// Near a face that the crop box cuts, that face's outward normal takes the gradient's place.

uniform vec3 u_cutLower; // centred index; far outside where the crop does not cut
uniform vec3 u_cutUpper;
uniform float u_cutDepth;

// Which of an axis's two faces is nearer, -1 or 1. Where rounding would decide, as in the middle of a slab that
// takes a single sample, it is the face through which a ray along `direction` enters.
float nearerFace(float fromLower, float fromUpper, float direction) {
  if (abs(fromUpper - fromLower) <= 1e-3 * u_cutDepth)
    return direction > 0.0 ? -1.0 : 1.0;
  return fromLower < fromUpper ? -1.0 : 1.0;
}

vec3 normalNearCut(vec3 centredIndex, vec3 direction, vec3 normal) {
  vec3 fromLower = (centredIndex - u_cutLower) * u_spacing;
  vec3 fromUpper = (u_cutUpper - centredIndex) * u_spacing;
  vec3 nearer = min(fromLower, fromUpper);
  float nearest = min(min(nearer.x, nearer.y), nearer.z);
  if (nearest > u_cutDepth)
    return normal;
  if (nearer.x == nearest)
    return vec3(nearerFace(fromLower.x, fromUpper.x, direction.x), 0.0, 0.0);
  if (nearer.y == nearest)
    return vec3(0.0, nearerFace(fromLower.y, fromUpper.y, direction.y), 0.0);
  return vec3(0.0, 0.0, nearerFace(fromLower.z, fromUpper.z, direction.z));
}
