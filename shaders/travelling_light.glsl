// SPDX-License-Identifier: GPL-3.0-or-later
// What share of its light comes to a sample (DEFINITION section 11), as the CPU engine finds it (cpu/simd/NearLight):
// nodes of a grid tell what comes from afar, and looks from the sample what stands near, towards the light and along
// the normal. What moves looks at nodes alone; as a software driver goes both ways of a branch, it has a program that
// can do no more.

uniform sampler3D u_directLight; // codes of scene/light/LightGrid.h
uniform sampler3D u_ambientLight;
uniform vec3 u_directScale; // texture coordinates of nodes per voxel
uniform vec3 u_directOffset; // of the box's centre
uniform vec3 u_ambientScale;
uniform vec3 u_ambientOffset;
uniform float u_lightFrom; // from here on light is stopped, lengths
#ifndef NODES_ALONE
uniform float u_looksNear; // 1: what stands near is looked at; 0: nodes alone tell
uniform float u_layersReach; // so far along the normal, lengths
#endif
uniform float u_shadow; // strengths
uniform float u_occlusion;
uniform float u_directAway; // what stands farther towards the light is told by nodes, lengths
uniform float u_directAsked; // so far towards the light they are asked
uniform float u_ambientAway; // and along the normal

#ifndef NODES_ALONE
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
  // It is there or not, and met once by a ray: a path may begin behind it, or meet it in any quarter of a length.
  int steps = int(ceil(4.0 * (u_directAway - u_lightFrom)));
  for (int i = 0; i <= steps; ++i)
    if (extinctionAt(centredIndex + (u_lightFrom + max(0.0, 0.25 * (float(i) - 0.5))) * perLength) > 0.0)
      return 0.0;
  return 1.0;
#else
  float part = (u_directAway - u_lightFrom) / 6.0;
  float sum = 0.0;
  for (int i = 0; i < 6; ++i)
    sum += extinctionAt(centredIndex + (u_lightFrom + (float(i) + 0.5) * part) * perLength);
  return exp(-part * sum);
#endif
}
#endif

#ifdef EFFECT_OCCLUSION
// Of ambient light past layers at an angle to the normal (scene/light/LightGrid.h: LayerLengths).
float pastLayers(vec4 extinctions, float cosine) {
  float height = 0.25 * u_layersReach;
  vec4 lower = max(height * vec4(0.0, 1.0, 2.0, 3.0), u_lightFrom * cosine);
  vec4 upper = min(height * vec4(1.0, 2.0, 3.0, 4.0), u_layersReach * cosine);
  return exp(-dot(extinctions, max(upper - lower, 0.0)) / cosine);
}

float throughLayers(vec3 centredIndex, vec3 normal) {
  vec3 layer = 0.25 * u_layersReach * normal / u_spacing;
  vec4 extinctions = vec4(extinctionAt(centredIndex + 0.5 * layer), extinctionAt(centredIndex + 1.5 * layer),
                          extinctionAt(centredIndex + 2.5 * layer), extinctionAt(centredIndex + 3.5 * layer));
  // The roots of 1/12, 3/12, 5/12 and so on.
  float sum = pastLayers(extinctions, 0.28867513) + pastLayers(extinctions, 0.5);
  sum += pastLayers(extinctions, 0.64549722) + pastLayers(extinctions, 0.76376262);
  sum += pastLayers(extinctions, 0.86602540) + pastLayers(extinctions, 0.95742711);
  return dot(normal, normal) > 0.25 ? sum / 6.0 : 1.0;
}
#endif
#endif

#ifdef EFFECT_SHADOW
float directLight(vec3 centredIndex) {
  vec3 perLength = u_lightDirection / u_spacing;
  vec3 place = (centredIndex + u_directAsked * perLength) * u_directScale + u_directOffset;
  float far = (255.0 * textureLod(u_directLight, place, 0.0).r - 1.0) / 254.0;
#ifdef NODES_ALONE
  return far;
#else
  return u_looksNear > 0.5 ? far * nearTransmittance(centredIndex, perLength) : far;
#endif
}
#endif

#ifdef EFFECT_OCCLUSION
float ambientLight(vec3 centredIndex, vec3 normal) {
  vec3 place = (centredIndex + u_ambientAway * normal / u_spacing) * u_ambientScale + u_ambientOffset;
  vec4 codes = 255.0 * textureLod(u_ambientLight, place, 0.0);
  float far = clamp((codes.x - 1.0 + dot(codes.yzw - 127.0, normal)) / 254.0, 0.0, 1.0);
#ifdef NODES_ALONE
  return far;
#else
  return u_looksNear > 0.5 ? far * throughLayers(centredIndex, normal) : far;
#endif
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
