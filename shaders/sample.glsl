// One visible sample: its opacity, its colour, and how they add to the ray.

uniform float u_opacityFactor;
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

struct Sample {
  vec3 position; // texture coordinates
  float scalar;
  float opacity;
  float segment;
  float start;
};

Sample sampleAt(March march, float i) {
  Sample s;
  s.position = clamp(march.first + (i + 0.5) * march.advance, u_textureLower, u_textureUpper);
  s.scalar = scalarAt(s.position);
  s.opacity = opacityOf(s.scalar, s.segment, s.start);
  return s;
}

// Add a sample to the colour (rgb) and take its share from the transmittance (a).
vec4 composited(vec4 ray, March march, Sample s, float i) {
  float r = 0.0;
#ifdef EFFECT_GRADIENT
  vec4 gradient = safeNormal(gradientAt(s.position));
#endif
#ifdef EFFECT_GRADIENT_RATIO
  r = gradientRatio(gradient.w);
#endif

  // Change the opacity before it becomes an extinction, so that the picture does not depend on the step.
#ifdef EFFECT_OPACITY_MAP
  s.opacity *= mapped(r, u_opacity.x, u_opacity.y);
#endif
#ifdef EFFECT_OPACITY_FACTOR
  s.opacity *= u_opacity.x;
#endif
#ifdef EFFECT_GRADIENT_OPACITY
  s.opacity *= gradientOpacity(gradient.w);
#endif
  float alpha = oneMinusExpNeg(minusLog1mOpacity(s.opacity) * march.units);

  vec3 color = colorOf(s.scalar, s.segment, s.start);
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
  float weight = ray.a * alpha;
  return vec4(ray.rgb + weight * color, ray.a - weight);
}
