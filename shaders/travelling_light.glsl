// SPDX-License-Identifier: GPL-3.0-or-later
// What share of its light comes to a sample (DEFINITION section 11), as the CPU engine finds it (cpu/simd/NearLight):
// nodes of a grid tell what comes from afar, and looks from the sample what stands near towards the light. What moves
// looks at nodes alone; as a software driver goes both ways of a branch, it has a program that can do no more.

uniform sampler3D u_directLight; // codes of scene/light/LightGrid.h
uniform sampler3D u_ambientLight;
uniform vec3 u_nodesScale; // texture coordinates per voxel
uniform vec3 u_nodesOffset; // of the box's centre
uniform float u_lightFrom; // from here on light is stopped, lengths
#ifndef NODES_ALONE
uniform float u_looksNear; // 1: what stands nearer towards the light is looked at; 0: nodes alone tell
#endif
uniform float u_shadow; // strengths
uniform float u_occlusion;
uniform float u_directAway; // so far towards the light nodes are asked, lengths
uniform float u_ambientAway; // and along the normal

vec4 nodesAt(sampler3D nodes, vec3 centredIndex) {
  return textureLod(nodes, centredIndex * u_nodesScale + u_nodesOffset, 0.0) * 255.0;
}

#ifdef EFFECT_SHADOW
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

float nearTransmittance(vec3 centredIndex, vec3 perLength) {
#ifdef EFFECT_ISOSURFACE
  // It is there or not, and met once by a ray: a path may begin behind it, or meet it in any quarter of a length.
  int steps = int(ceil(4.0 * (u_directAway - u_lightFrom)));
  for (int i = 0; i <= steps; ++i)
    if (extinctionAt(centredIndex + (u_lightFrom + max(0.0, 0.25 * (float(i) - 0.5))) * perLength) > 0.0)
      return 0.0;
  return 1.0;
#else
  float part = 0.5 * (u_directAway - u_lightFrom);
  float before = extinctionAt(centredIndex + (u_lightFrom + 0.5 * part) * perLength);
  float behind = extinctionAt(centredIndex + (u_lightFrom + 1.5 * part) * perLength);
  return exp(-part * (before + behind));
#endif
}
#endif

float directLight(vec3 centredIndex) {
  vec3 perLength = u_lightDirection / u_spacing;
  float far = (nodesAt(u_directLight, centredIndex + u_directAway * perLength).r - 1.0) / 254.0;
#ifdef NODES_ALONE
  return far;
#else
  return u_looksNear > 0.5 ? far * nearTransmittance(centredIndex, perLength) : far;
#endif
}
#endif

#ifdef EFFECT_OCCLUSION
float ambientLight(vec3 centredIndex, vec3 normal) {
  vec4 codes = nodesAt(u_ambientLight, centredIndex + u_ambientAway * normal / u_spacing);
  return clamp((codes.x - 1.0 + dot(codes.yzw - 127.0, normal)) / 254.0, 0.0, 1.0);
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
