// SPDX-License-Identifier: GPL-3.0-or-later
// One visible sample: its opacity, its colour, and how they add to the ray.

uniform vec2 u_opacity; // O at r = 0 and r = 1

// What all samples of a ray share.
struct March {
  vec3 first;    // texture coordinates of the entry
  vec3 advance;  // per sample
  vec3 entry;    // centred index of the entry
  vec3 stride;   // per sample
  float fromEye; // mm, of the entry
  float stepMm;
  float units;   // step in unit distances
#ifdef EFFECT_LIGHTING
  Light light;
#endif
};

// The light gathered by a ray. Its transmittance is transmittance * (1 - loss): losses add up from 0 and are
// taken from the transmittance when they are large enough to change it in float, however small the steps are.
struct Gathered {
  vec3 color; // premultiplied
  float transmittance;
  float loss;
};

const float smallLoss = 1.0 / 64.0;

vec3 positionOf(March march, float i) {
  return clamp(march.first + (i + 0.5) * march.advance, u_textureLower, u_textureUpper);
}

void addSample(inout Gathered ray, March march, vec3 position, float scalar, float i) {
  float segment, start;
  float opacity = opacityOf(scalar, segment, start);
  float r = 0.0;
#ifdef EFFECT_GRADIENT
  vec4 gradient = safeNormal(gradientAt(position));
#endif
#ifdef EFFECT_GRADIENT_RATIO
  r = gradientRatio(gradient.w);
#endif

  // Change the opacity before it becomes an extinction, so that the picture does not depend on the step.
#ifdef EFFECT_OPACITY_MAP
  opacity *= mapped(r, u_opacity.x, u_opacity.y);
#endif
#ifdef EFFECT_OPACITY_FACTOR
  opacity *= u_opacity.x;
#endif
#ifdef EFFECT_GRADIENT_OPACITY
  opacity *= gradientOpacity(gradient.w);
#endif
  float alpha = oneMinusExpNeg(minusLog1mOpacity(opacity) * march.units);

  vec3 color = colorOf(scalar, segment, start);
#ifdef EFFECT_LIGHTING
  vec3 normal = vec3(0.0);
#ifdef EFFECT_GRADIENT
  normal = gradient.w > u_flatModulus ? -gradient.xyz : vec3(0.0);
#endif
#ifdef EFFECT_CUT_FACES
  normal = normalNearCut(march.entry + (i + 0.5) * march.stride, normal);
#endif
  color = lit(color, march.light, normal, r);
#endif
#ifdef EFFECT_FOG
  color = fogged(color, march.fromEye + (i + 0.5) * march.stepMm);
#endif

  // Composite front to back.
  float share = (1.0 - ray.loss) * alpha;
  ray.color += ray.transmittance * share * color;
  ray.loss += share;
  if (ray.loss > smallLoss) {
    ray.transmittance -= ray.transmittance * ray.loss;
    ray.loss = 0.0;
  }
}
