// SPDX-License-Identifier: GPL-3.0-or-later
// What the kept region leaves of the opacity (DEFINITION section 10): weights in texels beside those of the volume.

uniform sampler3D u_region;

float weightAt(vec3 position) {
  return filtered(u_region, position).r;
}
