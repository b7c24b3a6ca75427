// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that lies in voxels, between them, in place of driver_weights.glsl: eight voxels, weighed in floats.
// At the outermost texels' centres and beyond, what lies there counts, as for the driver (CLAMP_TO_EDGE).

vec4 alongX(sampler3D voxels, ivec3 low, int highX, float weight) {
  return mix(texelFetch(voxels, low, 0), texelFetch(voxels, ivec3(highX, low.yz), 0), weight);
}

vec4 filtered(sampler3D voxels, vec3 position) {
  vec3 size = vec3(textureSize(voxels, 0));
  vec3 place = clamp(position * size - 0.5, vec3(0.0), size - 1.0);
  vec3 below = floor(place);
  vec3 weight = place - below;
  ivec3 low = ivec3(below);
  ivec3 high = ivec3(min(below + 1.0, size - 1.0));
  return mix(mix(alongX(voxels, low, high.x, weight.x),
                 alongX(voxels, ivec3(low.x, high.y, low.z), high.x, weight.x), weight.y),
             mix(alongX(voxels, ivec3(low.xy, high.z), high.x, weight.x),
                 alongX(voxels, ivec3(low.x, high.yz), high.x, weight.x), weight.y), weight.z);
}
