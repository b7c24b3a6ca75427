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

// What a sample says of the piece for which it stands.
struct Shaded {
  vec3 color;       // none
  float extinction; // per unit distance
};

#ifdef EFFECT_LABEL_LOOKS
Shaded shadedSample(March march, vec3 position, Material material, float i) {
  return Shaded(vec3(0.0), mixedAt(position, material, 1.0).extinction);
}

// All of its voxels have one look.
Shaded shadedAlike(March march, vec3 position, Material material, float i) {
  return Shaded(vec3(0.0), alikeAt(position, material, 1.0).extinction);
}

#ifdef EFFECT_PREINTEGRATION
// The same of a step within one look.
Shaded shadedAlike(March march, vec3 position, MeanOfLook mean, float i) {
  return Shaded(vec3(0.0), alikeAt(position, mean, 1.0).extinction);
}
#endif
#else
Shaded shadedSample(March march, vec3 position, Material material, float i) {
  float extinction = material.extinction;
#ifdef EFFECT_REGION
  float weight = weightAt(position);
  if (weight != 1.0)
    extinction = minusLog1mOpacity(weight * material.opacity);
#endif
  return Shaded(vec3(0.0), extinction);
}
#endif

float transmittanceOf(Gathered ray) {
  return exp2(-log2OfE * ray.depth);
}

// Add a piece of so many unit distances; its opacity says less than they do.
void add(inout Gathered ray, Shaded piece, float units, float alpha) {
  float term = piece.extinction * units - ray.lost;
  float sum = ray.depth + term;
  ray.lost = (sum - ray.depth) - term;
  ray.depth = sum;
}

void addMaterial(inout Gathered ray, March march, vec3 position, Material material, float i) {
  add(ray, shadedSample(march, position, material, i), march.units, 0.0);
}
