// SPDX-License-Identifier: GPL-3.0-or-later
// Blinn-Phong and Phong (paper eq. 1-4) in the frame of the grid's axes.

uniform float u_ambient;
uniform float u_diffuse;
uniform float u_specular;
uniform vec2 u_exponent; // at r = 0 and r = 1
uniform float u_energyWeight; // 1; 0 makes the energy factor 1
uniform vec2 u_significance;
uniform float u_knee;
uniform vec3 u_lightDirection; // towards the light

// What lighting needs of a ray, the same for all its samples.
struct Light {
  vec3 toViewer;
  vec3 toLight;
  vec3 halfway;
};

Light lightAlong(vec3 direction) {
  Light light;
  light.toViewer = -direction;
#ifdef EFFECT_FIXED_LIGHT
  light.toLight = u_lightDirection;
  vec4 halfway = safeNormal(light.toLight + light.toViewer);
  light.halfway = halfway.w > shortestHalfVector ? halfway.xyz : vec3(0.0);
#else
  light.toLight = light.toViewer;
  light.halfway = light.toViewer;
#endif
  return light;
}

#ifdef EFFECT_SPECULAR
float highlight(Light light, vec3 normal, float r) {
#ifdef EFFECT_EXPONENT_MAP
  float exponent = mapped(r, u_exponent.x, u_exponent.y);
#else
  float exponent = u_exponent.x;
#endif
#ifdef EFFECT_PHONG
  // Mirror the light's direction at the normal and compare it with the viewer's.
  float towardsLight = dot(normal, light.toLight);
#ifdef EFFECT_TWO_SIDED
  normal = towardsLight < 0.0 ? -normal : normal;
  towardsLight = abs(towardsLight);
#endif
  vec3 mirrored = 2.0 * towardsLight * normal - light.toLight;
  float term = towardsLight > 0.0 ? blinnTerm(dot(mirrored, light.toViewer), exponent) : 0.0;
#else
  float alignment = dot(normal, light.halfway);
#ifdef EFFECT_TWO_SIDED
  alignment = abs(alignment);
#endif
  float term = blinnTerm(alignment, exponent);
#endif
#ifdef EFFECT_ENERGY_FACTOR
  term *= energyFactor(u_energyWeight * exponent, u_energyWeight * u_exponent.y);
#endif
#ifdef EFFECT_SIGNIFICANCE
  term *= significanceWeight(u_significance.x, u_significance.y, r);
#endif
  return term;
}
#endif

// `reaching`: the shares S and A of DEFINITION section 11, of what is reflected and of ambient light.
vec3 lit(vec3 material, Light light, vec3 normal, float r, vec2 reaching) {
#ifdef EFFECT_OCCLUSION
  vec3 sum = material * (u_ambient * reaching.y);
#else
  vec3 sum = material * u_ambient;
#endif
#ifdef EFFECT_DIFFUSE
  float facing = dot(normal, light.toLight);
#ifdef EFFECT_TWO_SIDED
  facing = abs(facing);
#endif
  facing = max(0.0, facing);
#ifdef EFFECT_SHADOW
  facing *= reaching.x;
#endif
  sum += material * (u_diffuse * facing);
#endif
#ifdef EFFECT_SPECULAR
  float strength = u_specular * highlight(light, normal, r);
#ifdef EFFECT_SHADOW
  strength *= reaching.x;
#endif
#ifdef EFFECT_SPECULAR_OF_LIGHT
  sum += vec3(strength);
#else
  sum += material * strength;
#endif
#endif
#ifdef EFFECT_UNLIMITED
  return sum;
#else
#ifdef EFFECT_KNEE
  sum = knee(sum, u_knee);
#endif
  return clamp(sum, 0.0, 1.0);
#endif
}
