// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer functions of labels, in place of classification.glsl: classification after interpolation by the look of each
// of the eight voxels (DEFINITION section 10). All functions have the same knots: one segment and one start serve them
// all, and each has rows of its own in the textures of segments and of occupancy.

uniform sampler2D u_functionBins;
uniform sampler2D u_functionSegments;
uniform sampler2D u_functionOccupancy; // row 0: of all together; row 1 + q: of look q
uniform vec3 u_functionDomain; // first x, bins per unit, last bin
uniform float u_perUnitDistance;
uniform sampler3D u_cellLooks; // of each cell its look, or 255 where several meet
uniform vec3 u_cellsPerTexture;
uniform vec3 u_lastCell;
uniform sampler3D u_labels; // of each texel its look (of 65535) and its weight
uniform float u_lookSegments; // from one look to the next
uniform float u_lookUnits[33]; // how many unit distances of each look are in a length

// All that is known without a place; the look only where a block of fetches finds it.
struct Material {
  float scalar;
  float look;
};

// The look of a sample all of whose eight voxels have one, otherwise -1. The first texel is an apron.
float lookOfCell(vec3 position) {
  vec3 cell = clamp(floor(position * u_cellsPerTexture - 1.5), vec3(0.0), u_lastCell);
  float look = floor(texelFetch(u_cellLooks, ivec3(cell), 0).r * 255.0 + 0.5);
  return look < 255.0 ? look : -1.0;
}

// Whether a scalar may have an opacity at all under a look, or where that is -1 under any.
bool mayBeSeen(float scalar, float look) {
  return texelFetch(u_functionOccupancy, ivec2(binOf(u_functionDomain, scalar), int(look) + 1), 0).r > 0.0;
}

bool mayBeSeen(float scalar) {
  return mayBeSeen(scalar, -1.0);
}

Material materialOf(float scalar) {
  return Material(scalar, -1.0);
}

// What the looks around a place absorb together.
struct Mixed {
  vec3 color;
  float extinction; // per length
};

// The eight voxels around a place: each a part of a vector, those below along z in the first.
struct Around {
  vec4 looksBelow, looksAbove;
  vec4 below, above; // shares
  vec4 weightsBelow, weightsAbove;
};

Around voxelsAround(vec3 position) {
  Around around;
  vec3 size = vec3(textureSize(u_labels, 0));
  vec3 place = clamp(position * size - 0.5, vec3(0.0), size - 1.0);
  vec3 w = place - floor(place);
  ivec3 low = ivec3(floor(place));
  ivec3 high = ivec3(min(floor(place) + 1.0, size - 1.0));
  vec2 v0 = texelFetch(u_labels, low, 0).rg;
  vec2 v1 = texelFetch(u_labels, ivec3(high.x, low.yz), 0).rg;
  vec2 v2 = texelFetch(u_labels, ivec3(low.x, high.y, low.z), 0).rg;
  vec2 v3 = texelFetch(u_labels, ivec3(high.xy, low.z), 0).rg;
  vec2 v4 = texelFetch(u_labels, ivec3(low.xy, high.z), 0).rg;
  vec2 v5 = texelFetch(u_labels, ivec3(high.x, low.y, high.z), 0).rg;
  vec2 v6 = texelFetch(u_labels, ivec3(low.x, high.yz), 0).rg;
  vec2 v7 = texelFetch(u_labels, high, 0).rg;
  around.looksBelow = floor(vec4(v0.r, v1.r, v2.r, v3.r) * 65535.0 + 0.5);
  around.looksAbove = floor(vec4(v4.r, v5.r, v6.r, v7.r) * 65535.0 + 0.5);
  around.weightsBelow = vec4(v0.g, v1.g, v2.g, v3.g);
  around.weightsAbove = vec4(v4.g, v5.g, v6.g, v7.g);
  vec4 inPlane = vec4(1.0 - w.x, w.x, 1.0 - w.x, w.x) * vec4(vec2(1.0 - w.y), vec2(w.y));
  around.below = (1.0 - w.z) * inPlane;
  around.above = w.z * inPlane;
  return around;
}

// The look of the first voxel that has a share.
float nextLook(Around around) {
  float last = around.above.z > 0.0 ? around.looksAbove.z : around.looksAbove.w;
  last = around.above.y > 0.0 ? around.looksAbove.y : last;
  last = around.above.x > 0.0 ? around.looksAbove.x : last;
  last = around.below.w > 0.0 ? around.looksBelow.w : last;
  last = around.below.z > 0.0 ? around.looksBelow.z : last;
  last = around.below.y > 0.0 ? around.looksBelow.y : last;
  return around.below.x > 0.0 ? around.looksBelow.x : last;
}

// The segment of all functions that holds a scalar.
struct Place {
  float segment;
  float within; // behind its start
};

vec4 valueOf(Place place, float look) {
  float segment = place.segment + look * u_lookSegments;
  vec4 slope = segmentTexel(u_functionSegments, segment, 1);
  return segmentTexel(u_functionSegments, segment, 0) + place.within * slope;
}

// Adds what the next look takes, if any voxel is left, and leaves the others.
void addLook(Place place, float factor, inout Around around, inout Mixed mixed) {
  float look = nextLook(around);
  vec4 below = vec4(equal(around.looksBelow, vec4(look))) * around.below;
  vec4 above = vec4(equal(around.looksAbove, vec4(look))) * around.above;
  float share = dot(below + above, vec4(1.0));
  float weight = (dot(below, around.weightsBelow) + dot(above, around.weightsAbove)) / (share > 0.0 ? share : 1.0);
  vec4 value = valueOf(place, look);
  float extinction = share * minusLog1mOpacity(factor * weight * value.a) * u_lookUnits[int(look)];
  mixed.extinction += extinction;
  mixed.color += extinction * clamp(value.rgb, 0.0, 1.0);
  around.below -= below;
  around.above -= above;
}

// Where looks meet, around few places more than two.
Mixed mixedLooks(Place place, vec3 position, float factor) {
  Around around = voxelsAround(position);
  Mixed mixed = Mixed(vec3(0.0), 0.0);
  bool isMore = true;
  while (isMore) {
    addLook(place, factor, around, mixed);
    addLook(place, factor, around, mixed);
    isMore = dot(around.below + around.above, vec4(1.0)) > 0.0;
  }
  mixed.color /= mixed.extinction > 0.0 ? mixed.extinction : 1.0;
  return mixed;
}

Place placeOf(float scalar) {
  float start;
  float segment = segmentAt(u_functionBins, u_functionSegments, u_functionDomain, scalar, start);
  return Place(segment, scalar - start);
}

// One look at a place of this scalar, its opacity times a factor.
Mixed alikeAt(vec3 position, Place place, float look, float factor) {
#ifdef EFFECT_REGION
  factor *= weightAt(position);
#endif
  vec4 value = valueOf(place, look);
  return Mixed(clamp(value.rgb, 0.0, 1.0), minusLog1mOpacity(factor * value.a) * u_lookUnits[int(look)]);
}

// The same of a material whose look is known.
Mixed alikeAt(vec3 position, Material material, float factor) {
  return alikeAt(position, placeOf(material.scalar), material.look, factor);
}

// The looks at a place of this material. In equal steps they are several where this is asked (gather.glsl).
Mixed mixedAt(vec3 position, Material material, float factor) {
  Place place = placeOf(material.scalar);
#if !defined(EFFECT_LOCAL_STEPS) && !defined(EFFECT_LONG_RAYS)
  return mixedLooks(place, position, factor);
#else
  float look = lookOfCell(position);
  Mixed alike = alikeAt(position, place, max(look, 0.0), factor);
  Mixed mixed = mixedLooks(place, position, factor);
  return Mixed(look < 0.0 ? mixed.color : alike.color, look < 0.0 ? mixed.extinction : alike.extinction);
#endif
}
