// SPDX-License-Identifier: GPL-3.0-or-later
// The number of samples of each ray in place of a picture.

out vec4 fragColor;

void main() {
  vec2 span = spanInBox(rayThrough(gl_FragCoord.xy));
  fragColor = vec4(span.y > span.x ? float(sampleCount(span.y - span.x)) : 0.0);
}
