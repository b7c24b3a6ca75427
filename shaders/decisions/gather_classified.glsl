// SPDX-License-Identifier: GPL-3.0-or-later
// Gather a ray through voxels classified before interpolation, in place of gather.glsl: their colours,
// premultiplied by opacity, are what is interpolated.

uniform sampler3D u_classifiedVolume;

vec4 classifiedAt(vec3 position) {
  return textureLod(u_classifiedVolume, position, 0.0);
}

Material materialFrom(vec4 classified) {
  Material material;
  material.opacity = classified.a;
  material.extinction = minusLog1mOpacity(classified.a);
  material.color = clamp(classified.rgb / classified.a, 0.0, 1.0);
  return material;
}

#ifdef EFFECT_LONG_RAYS
// One loop: drivers limit the iterations of all loops of a fragment together.
Gathered gather(March march, int count) {
  Gathered gathered = nothingGathered();
  for (int i = 0; i < count && !isFinished(gathered); ++i) {
    vec3 position = positionOf(march, float(i));
    vec4 classified = classifiedAt(position);
    if (classified.a > 0.0)
      addMaterial(gathered, march, position, materialFrom(classified), float(i));
  }
  return gathered;
}
#else
// Moves i to the next sample that has an opacity, `count` or beyond where there is none; as in gather.glsl.
void findVisible(March march, int count, inout int i, inout vec3 position, inout vec4 classified) {
  bool isSearching = i < count;
  while (isSearching) {
    int end = count;
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
    // Leap over blocks without a voxel that shows.
    int alike = 0;
    bool isLeaping = true;
    while (isLeaping) {
      int leap = emptySamples(march.blocks, float(i), alike);
      i += leap;
      isLeaping = leap > 0 && i < count;
    }
    end = min(i + alike, count);
#endif
    // Look at the samples of this block.
    bool isLooking = true;
    while (isLooking) {
      position = i < count ? positionOf(march, float(i)) : u_textureLower;
      classified = classifiedAt(position);
      isSearching = i < count && !(classified.a > 0.0);
      i += isSearching ? 1 : 0;
      isLooking = isSearching && i < end;
    }
    isSearching = isSearching && i < count;
  }
}

// Find the next visible sample, then shade until none is visible.
Gathered gather(March march, int count) {
  Gathered gathered = nothingGathered();
  int i = 0;
  vec3 position = u_textureLower;
  vec4 classified = vec4(0.0);
  findVisible(march, count, i, position, classified);
  while (i < count) {
    bool isVisible = true;
    while (isVisible) {
      addMaterial(gathered, march, position, materialFrom(classified), float(i));
      i = isFinished(gathered) ? count : i + 1;
      position = i < count ? positionOf(march, float(i)) : u_textureLower;
      classified = classifiedAt(position);
      isVisible = i < count && classified.a > 0.0;
    }
    ++i; // that one is known
    findVisible(march, count, i, position, classified);
  }
  return gathered;
}
#endif
