// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a premultiplied picture over the background; with a gain, the amplified difference of two.

in vec2 v_place;
out vec4 fragColor;

uniform sampler2D u_left;
uniform sampler2D u_right;
uniform vec3 u_background;
uniform float u_gain; // 0: show the left picture alone

vec3 overBackground(vec4 picture) {
  return picture.rgb + (1.0 - picture.a) * u_background;
}

void main() {
  vec3 color = overBackground(texture(u_left, v_place));
  if (u_gain > 0.0)
    color = u_gain * abs(color - overBackground(texture(u_right, v_place)));
  fragColor = vec4(color, 1.0);
}
