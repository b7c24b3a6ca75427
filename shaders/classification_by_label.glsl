// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer functions of labels, in place of classification.glsl: classification after interpolation by the look of each
// of the eight voxels (DEFINITION section 10). All functions have the same knots: one segment and one start serve them
// all, and each has rows of its own in the textures of segments and of occupancy.

uniform sampler2D u_functionBins;
uniform sampler2D u_functionSegments;
uniform sampler2D u_functionOccupancy; // row 0: of all together; row 1 + q: of look q
uniform vec3 u_functionDomain; // first x, bins per unit, last bin
const float u_perUnitDistance = 1.0; // each look has its own
uniform sampler3D u_cellLooks; // of each cell its look + 1 (of 255), or 0 where several meet
uniform vec3 u_cellsPerTexture;
uniform sampler3D u_labels; // of each cell the looks (of 255) of its four voxels of smallest z
uniform float u_lastLayer; // of those
uniform float u_lookSegments; // from one look to the next
uniform float u_lookUnits[33]; // how many unit distances of each look are in a length

// All that is known without a place; the look only where a block of fetches finds it.
struct Material {
  float scalar;
  float look;
};

// Where a place lies, in voxels from the first: texels have an apron, and positions end at the outermost centres.
vec3 voxelAt(vec3 position) {
  return max(position * u_cellsPerTexture - 1.5, vec3(0.0));
}

// The look of a sample all of whose eight voxels have one, otherwise -1.
float lookOfCell(vec3 position) {
  return floor(texelFetch(u_cellLooks, ivec3(voxelAt(position)), 0).r * 255.0 + 0.5) - 1.0;
}

// Of a look, or where that is -1 of all together.
vec2 occupancyOf(float scalar, float look) {
  return texelFetch(u_functionOccupancy, ivec2(binOf(u_functionDomain, scalar), int(look) + 1), 0).rg;
}

// Whether a scalar may have an opacity at all under a look, or where that is -1 under any.
bool mayBeSeen(float scalar, float look) {
  return occupancyOf(scalar, look).r > 0.0;
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

// The eight voxels around a place: each a part of a vector, those of smaller z in the first.
struct Around {
  vec4 looksBelow, looksAbove;
  vec4 below, above; // shares
#ifdef EFFECT_REGION
  vec4 weightsBelow, weightsAbove;
#endif
};

#ifdef EFFECT_REGION
// The weights of four voxels; the first texel of the region is an apron.
vec4 weightsFrom(ivec3 cell) {
  ivec3 texel = cell + 1;
  return vec4(texelFetch(u_region, texel, 0).r, texelFetch(u_region, texel + ivec3(1, 0, 0), 0).r,
              texelFetch(u_region, texel + ivec3(0, 1, 0), 0).r, texelFetch(u_region, texel + ivec3(1, 1, 0), 0).r);
}
#endif

Around voxelsAround(vec3 position) {
  vec3 place = voxelAt(position);
  ivec3 cell = ivec3(place);
  ivec3 next = ivec3(cell.xy, int(min(float(cell.z) + 1.0, u_lastLayer)));
  vec3 w = place - vec3(cell);
  Around around;
  around.looksBelow = floor(texelFetch(u_labels, cell, 0) * 255.0 + 0.5);
  around.looksAbove = floor(texelFetch(u_labels, next, 0) * 255.0 + 0.5);
#ifdef EFFECT_REGION
  around.weightsBelow = weightsFrom(cell);
  around.weightsAbove = weightsFrom(next);
#endif
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
#ifdef EFFECT_REGION
  factor *= (dot(below, around.weightsBelow) + dot(above, around.weightsAbove)) / (share > 0.0 ? share : 1.0);
#endif
  vec4 value = valueOf(place, look);
  float extinction = share * minusLog1mOpacity(factor * value.a) * u_lookUnits[int(look)];
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
