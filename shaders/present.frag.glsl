// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a premultiplied picture over the background; with a gain, the amplified signed difference of two.

in vec2 v_place;
out vec4 fragColor;

uniform sampler2D u_left;
uniform sampler2D u_right;
uniform vec3 u_background;
uniform float u_gain; // 0: show the left picture alone
uniform vec3 u_leftBrighter;
uniform vec3 u_rightBrighter;

vec3 overBackground(vec4 picture) {
  return picture.rgb + (1.0 - picture.a) * u_background;
}

void main() {
  vec3 color = overBackground(texture(u_left, v_place));
  if (u_gain > 0.0) {
    vec3 apart = overBackground(texture(u_right, v_place)) - color;
    float most = abs(apart.g) > abs(apart.r) ? apart.g : apart.r;
    most = abs(apart.b) > abs(most) ? apart.b : most;
    color = min(u_gain * abs(most), 1.0) * (most < 0.0 ? u_leftBrighter : u_rightBrighter);
  }
  fragColor = vec4(color, 1.0);
}
