// SPDX-License-Identifier: GPL-3.0-or-later
// Near a face that the crop box cuts, that face's outward normal takes the gradient's place.

uniform vec3 u_cutLower; // centred index; far outside where the crop does not cut
uniform vec3 u_cutUpper;
uniform float u_cutDepth; // mm

vec3 normalNearCut(vec3 centredIndex, vec3 normal) {
  vec3 fromLower = (centredIndex - u_cutLower) * u_spacing;
  vec3 fromUpper = (u_cutUpper - centredIndex) * u_spacing;
  vec3 nearer = min(fromLower, fromUpper);
  float nearest = min(min(nearer.x, nearer.y), nearer.z);
  if (nearest > u_cutDepth)
    return normal;
  vec3 side = vec3(fromLower.x <= fromUpper.x ? -1.0 : 1.0, fromLower.y <= fromUpper.y ? -1.0 : 1.0,
                   fromLower.z <= fromUpper.z ? -1.0 : 1.0);
  if (nearer.x == nearest)
    return vec3(side.x, 0.0, 0.0);
  if (nearer.y == nearest)
    return vec3(0.0, side.y, 0.0);
  return vec3(0.0, 0.0, side.z);
}
