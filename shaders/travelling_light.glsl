// SPDX-License-Identifier: GPL-3.0-or-later
// What share of its light comes to a sample (DEFINITION section 11), as the CPU engine finds it (cpu/simd/NearLight):
// nodes of a grid tell what comes from afar, and looks from the sample itself what stands near.

uniform sampler3D u_directLight; // codes of scene/light/LightGrid.h
uniform sampler3D u_ambientLight;
uniform vec3 u_nodesScale; // texture coordinates per voxel
uniform vec3 u_nodesOffset; // of the box's centre
uniform float u_lightFrom; // from here on light is stopped, lengths
uniform float u_looksNear; // 1; 0: nodes alone tell
uniform float u_shadow; // strengths
uniform float u_occlusion;

const float nearLength = 4.5; // lengths, along the light
const float thickness = 1.5; // of the two layers along the normal that are taken to be alike

vec4 nodesAt(sampler3D nodes, vec3 centredIndex) {
  return textureLod(nodes, centredIndex * u_nodesScale + u_nodesOffset, 0.0) * 255.0;
}

// The extinction per length at a place; of a surface, and behind it, more than anything shines through.
float extinctionAt(vec3 centredIndex) {
  if (any(lessThan(centredIndex, u_boxLower)) || any(greaterThanEqual(centredIndex, u_boxUpper)))
    return 0.0;
  vec3 position = clamp(toTexture(centredIndex), u_textureLower, u_textureUpper);
#if defined(EFFECT_ISOSURFACE) || defined(EFFECT_HYBRID)
  if (isHitAt(position))
    return 1e3;
#endif
#ifdef EFFECT_ISOSURFACE
  return 0.0;
#else
  float scalar = scalarAt(position);
  float factor = 1.0;
#ifdef EFFECT_CHANGED_OPACITY
  float r;
  vec4 gradient = gradientOf(position, r);
  factor = opacityFactor(gradient.w, r);
#endif
#ifdef EFFECT_LABEL_LOOKS
  return mixedLooks(placeOf(scalar), position, factor).extinction;
#else
#ifdef EFFECT_REGION
  factor *= weightAt(position);
#endif
  return minusLog1mOpacity(factor * materialOf(scalar).opacity) * u_perUnitDistance;
#endif
#endif
}

#ifdef EFFECT_SHADOW
float nearTransmittance(vec3 centredIndex, vec3 perLength) {
#ifdef EFFECT_ISOSURFACE
  // It is there or not, and met once by a ray.
  for (float at = u_lightFrom + 0.125; at < nearLength; at += 0.25)
    if (extinctionAt(centredIndex + at * perLength) > 0.0)
      return 0.0;
  return 1.0;
#else
  float part = 0.5 * (nearLength - u_lightFrom);
  float before = extinctionAt(centredIndex + (u_lightFrom + 0.5 * part) * perLength);
  float behind = extinctionAt(centredIndex + (u_lightFrom + 1.5 * part) * perLength);
  return exp(-part * (before + behind));
#endif
}

float directLight(vec3 centredIndex) {
  vec3 perLength = u_lightDirection / u_spacing;
  float far = (nodesAt(u_directLight, centredIndex + nearLength * perLength).r - 1.0) / 254.0;
  return u_looksNear > 0.5 ? far * nearTransmittance(centredIndex, perLength) : far;
}
#endif

#ifdef EFFECT_OCCLUSION
// exp(-depth) of both layers towards a direction of this cosine, of which what lies nearer than u_lightFrom counts not.
float throughLayers(vec2 extinctions, float cosine) {
  vec2 ends = vec2(thickness, 2.0 * thickness);
  vec2 lengths = clamp(ends - u_lightFrom * cosine, 0.0, thickness) / cosine;
  return exp(-dot(extinctions, lengths));
}

float ambientLight(vec3 centredIndex, vec3 normal) {
  vec3 perLength = normal / u_spacing;
  vec4 codes = nodesAt(u_ambientLight, centredIndex + 2.0 * thickness * perLength);
  float far = clamp((codes.x - 1.0 + dot(codes.yzw - 127.0, normal)) / 254.0, 0.0, 1.0);
  if (u_looksNear < 0.5)
    return far;
  vec2 extinctions = vec2(extinctionAt(centredIndex + 0.5 * thickness * perLength),
                          extinctionAt(centredIndex + 1.5 * thickness * perLength));
  // Gauss's three points over the square of the cosine.
  float near = (5.0 * throughLayers(extinctions, sqrt(0.1127017)) + 8.0 * throughLayers(extinctions, sqrt(0.5)) +
                5.0 * throughLayers(extinctions, sqrt(0.8872983))) / 18.0;
  // Without a normal all is taken to be as it is here; the grid counts from the place on.
  float alike = exp(min(extinctions.x, 10.0) * u_lightFrom);
  return min(1.0, far * (dot(normal, normal) > 0.25 ? near : alike));
}
#endif

vec2 reachingLight(vec3 centredIndex, vec3 normal) {
  vec2 reaching = vec2(1.0);
#ifdef EFFECT_SHADOW
  reaching.x = 1.0 - u_shadow * (1.0 - directLight(centredIndex));
#endif
#ifdef EFFECT_OCCLUSION
  reaching.y = 1.0 - u_occlusion * (1.0 - ambientLight(centredIndex, normal));
#endif
  return reaching;
}
