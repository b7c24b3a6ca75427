// SPDX-License-Identifier: GPL-3.0-or-later
// What gather.glsl fetches at a sample: the scalar, to be classified behind its interpolation.

#define Fetched float

Fetched fetchedAt(vec3 position) {
  return scalarAt(position);
}
