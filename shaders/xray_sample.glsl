// SPDX-License-Identifier: GPL-3.0-or-later
// An X-ray gathers extinction and no colour.

// The depth and what its sum has lost to rounding so far.
struct Gathered {
  float depth;
  float lost;
};

Gathered nothingGathered() {
  return Gathered(0.0, 0.0);
}

bool isFinished(Gathered ray) {
  return false;
}

vec4 pixelOf(Gathered ray) {
  return vec4(oneMinusExpNeg(ray.depth));
}

void addMaterial(inout Gathered ray, March march, vec3 position, Material material, float i) {
  float term = material.extinction * march.units - ray.lost;
  float sum = ray.depth + term;
  ray.lost = (sum - ray.depth) - term;
  ray.depth = sum;
}
