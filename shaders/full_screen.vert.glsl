// SPDX-License-Identifier: GPL-3.0-or-later
// One triangle that covers the viewport; each fragment is a pixel's ray.

in vec2 a_corner;

void main() {
  gl_Position = vec4(a_corner, 0.0, 1.0);
}
