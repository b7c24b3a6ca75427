// SPDX-License-Identifier: GPL-3.0-or-later
// One visible piece of a ray: its extinction, its colour, and how they add to what the ray has gathered.

uniform vec2 u_opacity; // O at r = 0 and r = 1
uniform float u_lastTransmittance;

// The light gathered by a ray. Its transmittance is transmittance * (1 - loss): losses add up from 0 and are
// taken from the transmittance when they are large enough to change it in float, however small the steps are.
struct Gathered {
  vec3 color; // premultiplied
  float transmittance;
  float loss;
};

const float smallLoss = 1.0 / 64.0;

Gathered nothingGathered() {
  return Gathered(vec3(0.0), 1.0, 0.0);
}

float transmittanceOf(Gathered ray) {
  return ray.transmittance * (1.0 - ray.loss);
}

bool isFinished(Gathered ray) {
#ifdef EFFECT_EARLY_TERMINATION
  return transmittanceOf(ray) <= u_lastTransmittance;
#else
  return false;
#endif
}

vec4 pixelOf(Gathered ray) {
  float alpha = (1.0 - ray.transmittance) + ray.transmittance * ray.loss;
#ifndef EFFECT_UNLIMITED
  // No colour exceeds 1, so what exceeds alpha is the rounding of a long sum.
  ray.color = min(ray.color, vec3(alpha));
#endif
  return vec4(ray.color, alpha);
}

// The factor by which the gradient changes the opacity over the unit distance, before that becomes an
// extinction: so the picture does not depend on the step.
float opacityFactor(float modulus, float r) {
  float factor = 1.0;
#ifdef EFFECT_OPACITY_MAP
  factor *= mapped(r, u_opacity.x, u_opacity.y);
#endif
#ifdef EFFECT_OPACITY_FACTOR
  factor *= u_opacity.x;
#endif
#ifdef EFFECT_GRADIENT_OPACITY
  factor *= gradientOpacity(modulus);
#endif
  return factor;
}

#ifdef EFFECT_TRAVELLING_LIGHT
vec2 reachingLight(vec3 centredIndex, vec3 normal); // travelling_light.glsl
#endif

// The colour of a material `i` steps behind sample 0, lit and fogged.
vec3 shaded(vec3 color, March march, vec4 gradient, float r, float i) {
#ifdef EFFECT_LIGHTING
  vec3 normal = vec3(0.0);
#ifdef EFFECT_GRADIENT
  normal = gradient.w > u_flatModulus ? -gradient.xyz : vec3(0.0);
#endif
#ifdef EFFECT_CUT_FACES
  normal = normalNearCut(march.firstIndex + i * march.stride, march.stride, normal);
#endif
  vec2 reaching = vec2(1.0);
#ifdef EFFECT_TRAVELLING_LIGHT
  reaching = reachingLight(march.firstIndex + i * march.stride, normal);
#endif
  color = lit(color, lightOf(march), normal, r, reaching);
#endif
#ifdef EFFECT_FOG
  color = fogged(color, march.depth + i * march.stepLength);
#endif
  return color;
}

// The unit gradient and its modulus, and r, where an effect reads them.
vec4 gradientOf(vec3 position, out float r) {
  vec4 gradient = vec4(0.0);
  r = 0.0;
#ifdef EFFECT_GRADIENT
  gradient = safeNormal(gradientAt(position));
#endif
#ifdef EFFECT_GRADIENT_RATIO
  r = gradientRatio(gradient.w);
#endif
  return gradient;
}

// What a sample says of the piece for which it stands.
struct Shaded {
  vec3 color;
  float extinction; // per unit distance
};

#ifdef EFFECT_LABEL_LOOKS
Shaded shadedSample(March march, vec3 position, Material material, float i) {
  float r;
  vec4 gradient = gradientOf(position, r);
  Mixed mixed = mixedAt(position, material, opacityFactor(gradient.w, r));
  return Shaded(shaded(mixed.color, march, gradient, r, i), mixed.extinction);
}

// All of its voxels have one look.
Shaded shadedAlike(March march, vec3 position, Material material, float i) {
  float r;
  vec4 gradient = gradientOf(position, r);
  Mixed alike = alikeAt(position, material, opacityFactor(gradient.w, r));
  return Shaded(shaded(alike.color, march, gradient, r, i), alike.extinction);
}

#ifdef EFFECT_PREINTEGRATION
// The same of a step within one look.
Shaded shadedAlike(March march, vec3 position, MeanOfLook mean, float i) {
  float r;
  vec4 gradient = gradientOf(position, r);
  Mixed alike = alikeAt(position, mean, opacityFactor(gradient.w, r));
  return Shaded(shaded(alike.color, march, gradient, r, i), alike.extinction);
}
#endif
#else
Shaded shadedSample(March march, vec3 position, Material material, float i) {
  float r;
  vec4 gradient = gradientOf(position, r);
  float extinction = material.extinction;
#ifdef EFFECT_CHANGED_OPACITY
  float factor = opacityFactor(gradient.w, r);
#ifdef EFFECT_REGION
  factor *= weightAt(position);
#endif
  if (factor != 1.0)
    extinction = minusLog1mOpacity(factor * material.opacity);
#endif
  return Shaded(shaded(material.color, march, gradient, r, i), extinction);
}
#endif

// Composite front to back a piece of so many unit distances, which have the opacity `alpha`.
void add(inout Gathered ray, Shaded piece, float units, float alpha) {
  float share = (1.0 - ray.loss) * alpha;
  ray.color += ray.transmittance * share * piece.color;
  ray.loss += share;
  if (ray.loss > smallLoss) {
    ray.transmittance -= ray.transmittance * ray.loss;
    ray.loss = 0.0;
  }
}

void addMaterial(inout Gathered ray, March march, vec3 position, Material material, float i) {
  Shaded piece = shadedSample(march, position, material, i);
  add(ray, piece, march.units, oneMinusExpNeg(piece.extinction * march.units));
}
