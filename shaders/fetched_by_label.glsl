// SPDX-License-Identifier: GPL-3.0-or-later
// What gather.glsl fetches at a sample, in place of fetched.glsl: the scalar, and the look of its eight voxels.

#define Fetched vec2

Fetched fetchedAt(vec3 position) {
  return vec2(scalarAt(position), lookOfCell(position));
}

bool mayBeSeen(Fetched fetched) {
  return mayBeSeen(fetched.x, fetched.y);
}

Material materialOf(Fetched fetched) {
  return Material(fetched.x, fetched.y);
}
