// SPDX-License-Identifier: GPL-3.0-or-later
// A polygon parallel to the picture that covers the volume between two planes.

in vec4 a_corner; // place in the viewport, depths of the near and the far plane

flat out vec2 v_planes;

void main() {
  gl_Position = vec4(a_corner.xy, 0.0, 1.0);
  v_planes = a_corner.zw;
}
