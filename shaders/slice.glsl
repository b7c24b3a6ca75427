// SPDX-License-Identifier: GPL-3.0-or-later
// One slice of the integral of RENDERING 7: the piece of the ray between two planes, one sample at its middle,
// to be blended with over.

flat in vec2 v_planes; // mm along the view from the anchor plane

out vec4 fragColor;

// The piece of the ray that lies in the box and between the planes, weighed by its own length: a ray at an
// angle to the view has more of every slab, and less of those that the box's faces cut.
vec2 pieceOf(Ray ray) {
  vec2 tangent = (gl_FragCoord.xy - u_pictureCentre) * u_tangentPerPixel;
  float mmPerDepth = sqrt(1.0 + dot(tangent, tangent));
  vec2 span = spanInBox(ray);
  return vec2(max(span.x, v_planes.x * mmPerDepth), min(span.y, v_planes.y * mmPerDepth));
}

March marchOver(Ray ray, vec2 piece) {
  March march;
  march.stepMm = piece.y - piece.x;
  march.entry = ray.anchor + piece.x * ray.direction;
  march.stride = march.stepMm * ray.direction;
  march.first = toTexture(march.entry);
  march.advance = march.stride * u_textureScale;
  march.fromEye = piece.x - ray.eye;
  march.units = march.stepMm * u_perUnitDistance;
#ifdef EFFECT_LIGHTING
  march.light = lightAlong(ray.direction * u_spacing);
#endif
  return march;
}

void main() {
  Ray ray = rayThrough(gl_FragCoord.xy);
  vec2 piece = pieceOf(ray);
  if (!(piece.y > piece.x))
    discard;
  March march = marchOver(ray, piece);
  vec3 position = positionOf(march, 0.0);
  float scalar = scalarAt(position);
  if (!mayBeSeen(scalar))
    discard;
  Gathered gathered = Gathered(vec3(0.0), 1.0, 0.0);
  addSample(gathered, march, position, scalar, 0.0);
  float transmittance = gathered.transmittance;
  fragColor = vec4(gathered.color, (1.0 - transmittance) + transmittance * gathered.loss);
}
