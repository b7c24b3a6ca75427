// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a picture on the screen: one triangle covers the viewport, its corners follow from the vertex number.

out vec2 v_place; // 0..1 over the picture, y up

void main() {
  v_place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(2.0 * v_place - 1.0, 0.0, 1.0);
}
