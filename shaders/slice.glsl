// SPDX-License-Identifier: GPL-3.0-or-later
// One slice of the integral of DEFINITION section 7: the piece of the ray between two planes as one step, to be blended
// with over.

flat in vec2 v_planes; // lengths along the view from the anchor plane

out vec4 fragColor;

// The piece of the ray that lies in the box and between the planes, weighed by its own length: a ray at an
// angle to the view has more of every slab, and less of those that the box's faces cut.
vec2 pieceOf(Ray ray) {
  vec2 tangent = (gl_FragCoord.xy - u_pictureCentre) * u_tangentPerPixel;
  float lengthPerDepth = sqrt(1.0 + dot(tangent, tangent));
  vec2 span = spanInBox(ray);
  return vec2(max(span.x, v_planes.x * lengthPerDepth), min(span.y, v_planes.y * lengthPerDepth));
}

// What the piece holds. Where that cannot be seen the fragment ends here: drivers skip what follows.
Material materialIn(March march) {
#ifdef EFFECT_PREINTEGRATION
  float before = scalarAt(positionOf(march, -0.5));
  float behind = scalarAt(positionOf(march, 0.5));
  if (!mayBeSeenBetween(before, behind))
    discard;
  return meanMaterial(before, behind);
#else
  float scalar = scalarAt(positionOf(march, 0.0));
  if (!mayBeSeen(scalar))
    discard;
  return materialOf(scalar);
#endif
}

void main() {
  Ray ray = rayThrough(gl_FragCoord.xy);
  vec2 piece = pieceOf(ray);
  if (!(piece.y > piece.x))
    discard;
  March march = marchThrough(ray, piece, 1);
  Gathered gathered = nothingGathered();
  addMaterial(gathered, march, positionOf(march, 0.0), materialIn(march), 0.0);
  fragColor = pixelOf(gathered);
}
