// SPDX-License-Identifier: GPL-3.0-or-later
// Samples at the front of their steps, in place of jitter.glsl: of order 1, where the middle is of order 2.

float jitteredOffset(vec2 fragment) {
  return 0.0;
}
