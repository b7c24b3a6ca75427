// SPDX-License-Identifier: GPL-3.0-or-later
// Gather a ray by error-controlled steps: each sample stands for its piece, and a piece over which the light
// that it adds changes too much is taken again with a smaller step.

// Enters the next block where a chord is done. Behind empty blocks there is nothing to compare with.
void enterAtExit(BlockPath path, float transmittance, inout Walk walk, inout Shaded before) {
  if (isAtExit(walk) && !isAtEnd(walk)) {
    bool isEmpty = enterNext(path, transmittance, walk);
    before.extinction = isEmpty ? 0.0 : before.extinction;
  }
}

// Moves to the next piece that may be seen, or whose predecessor was: a boundary may lie between them. A software
// driver runs the body of a loop once for rays that have ended: those fetch one texel that stays in its cache.
void findPiece(BlockPath path, March march, float transmittance, inout Walk walk, inout Shaded before,
               out Piece piece, out vec3 position, out float scalar) {
  bool isSearching = true;
  while (isSearching) {
    enterAtExit(path, transmittance, walk, before);
    piece = nextPiece(walk);
    bool isInside = !isAtExit(walk);
    position = isInside ? positionOf(march, piece.middle) : u_textureLower;
    scalar = scalarAt(position);
    isSearching = isInside ? !(before.extinction > 0.0) && !mayBeSeen(scalar) : !isAtEnd(walk);
    if (isSearching && isInside)
      accept(piece, 0.0, walk);
  }
}

// How much the light that a piece of opacity `alpha` adds to a channel of the pixel differs from what it would
// add if it were like the piece before.
float changeBetween(Shaded before, Shaded here, float alpha, float units, float transmittance) {
  float was = oneMinusExpNeg(before.extinction * units);
  vec3 color = abs(alpha * here.color - was * before.color);
  return transmittance * max(max(color.r, color.g), max(color.b, abs(alpha - was)));
}

// Find the next piece that may be seen, then take pieces until one cannot.
Gathered gather(Ray ray, vec2 span, out int spent) {
  March march = marchFrom(ray, span.x);
  BlockPath path = blockPath(march.firstIndex, ray.direction);
  Walk walk = walkThrough(path, span.y - span.x);
  Gathered gathered = nothingGathered();
  Shaded before = Shaded(vec3(0.0), 0.0);
  Piece piece;
  vec3 position;
  float scalar;
  findPiece(path, march, 1.0, walk, before, piece, position, scalar);
  while (!isAtEnd(walk)) {
    bool isShading = true;
    while (isShading) {
      Shaded here = shadedSample(march, position, materialOf(scalar), piece.middle);
      here.extinction = mayBeSeen(scalar) ? here.extinction : 0.0;

      // Composite the piece, or take it again with a smaller step.
      float units = piece.length * u_perUnitDistance;
      float alpha = oneMinusExpNeg(here.extinction * units);
      float change = changeBetween(before, here, alpha, units, transmittanceOf(gathered));
      if (isToBeRefined(walk, change)) {
        refine(change, walk);
      } else {
        add(gathered, here, units, alpha);
        accept(piece, change, walk);
        before = here;
      }
      if (isFinished(gathered))
        finish(walk);

      // Go on to the next piece.
      enterAtExit(path, transmittanceOf(gathered), walk, before);
      piece = nextPiece(walk);
      isShading = !isAtExit(walk);
      position = isShading ? positionOf(march, piece.middle) : u_textureLower;
      scalar = scalarAt(position);
      isShading = isShading && (before.extinction > 0.0 || mayBeSeen(scalar));
    }
    findPiece(path, march, transmittanceOf(gathered), walk, before, piece, position, scalar);
  }
  spent = walk.spent;
  return gathered;
}
