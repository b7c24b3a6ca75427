// SPDX-License-Identifier: GPL-3.0-or-later
// A fixed offset of the samples for each pixel, from an ordered pattern of 8 by 8: trades rings for noise.

uniform float u_jitter; // 1; 0 puts the samples back into the middle

float jitteredOffset(vec2 fragment) {
  ivec2 p = ivec2(fragment) & 7;
  int q = p.x ^ p.y;
  // Interleave the bits of q and p.y, the lowest first: neighbours differ as much as possible.
  int rank = (q & 1) << 5 | (p.y & 1) << 4 | (q & 2) << 2 | (p.y & 2) << 1 | (q & 4) >> 1 | (p.y & 4) >> 2;
  return 0.5 + u_jitter * ((float(rank) + 0.5) / 64.0 - 0.5);
}
