// SPDX-License-Identifier: GPL-3.0-or-later
// Gather a ray by error-controlled steps: a sample at either end of each piece stands for half of it, and a piece
// over which the light that it adds changes too much is taken again with a smaller step, so that edges lie between
// two samples as close as that.

// Enters the next block where a chord is done. Behind empty blocks there is nothing to compare with.
void enterAtExit(BlockPath path, float transmittance, inout Walk walk, inout Shaded before) {
  if (isAtExit(walk) && !isAtEnd(walk)) {
    bool isEmpty = enterNext(path, transmittance, walk);
    before.extinction = isEmpty ? 0.0 : before.extinction;
  }
}

// Moves to the next piece at one of whose ends something may be seen. A software driver runs the body of a loop
// once for rays that have ended: those fetch one texel that stays in its cache.
void findPiece(BlockPath path, March march, float transmittance, inout Walk walk, inout Shaded before,
               out Piece piece, out vec3 position, out float scalar) {
  bool isSearching = true;
  while (isSearching) {
    enterAtExit(path, transmittance, walk, before);
    piece = nextPiece(walk);
    bool isInside = !isAtExit(walk);
    position = isInside ? positionOf(march, piece.end) : u_textureLower;
    scalar = scalarAt(position);
    isSearching = isInside ? !(before.extinction > 0.0) && !mayBeSeen(scalar) : !isAtEnd(walk);
    if (isSearching && isInside)
      accept(piece, 0.0, walk);
  }
}

// How much the light that the two halves of a piece add to a channel of the pixel differs, as if either were the
// whole; the halves have the opacities given.
float changeBetween(Shaded before, Shaded here, float was, float is, float transmittance) {
  vec3 color = abs(is * here.color - was * before.color);
  return 2.0 * transmittance * max(max(color.r, color.g), max(color.b, abs(is - was)));
}

// The sample at a place.
Shaded sampleAt(March march, vec3 position, float scalar, float place) {
  Shaded here = shadedSample(march, position, materialOf(scalar), place);
  here.extinction = mayBeSeen(scalar) ? here.extinction : 0.0;
  return here;
}

// Find the next piece that may be seen, then take pieces until one cannot.
Gathered gatherAlong(Ray ray, vec2 span, out int spent) {
  March march = marchFrom(ray, span.x);
  BlockPath path = blockPath(march.firstIndex, ray.direction);
  Walk walk = walkThrough(path, span.y - span.x);
  Gathered gathered = nothingGathered();
  vec3 position = positionOf(march, 0.0);
  float scalar = scalarAt(position);
  Shaded before = sampleAt(march, position, scalar, 0.0);
  walk.spent = before.extinction > 0.0 ? 1 : 0;
  Piece piece;
  findPiece(path, march, 1.0, walk, before, piece, position, scalar);
  while (!isAtEnd(walk)) {
    bool isShading = true;
    while (isShading) {
      // Composite the piece, or take it again with a smaller step.
      Shaded here = sampleAt(march, position, scalar, piece.end);
      float units = 0.5 * piece.mm * u_perUnitDistance;
      float was = oneMinusExpNeg(before.extinction * units);
      float is = oneMinusExpNeg(here.extinction * units);
      float change = changeBetween(before, here, was, is, transmittanceOf(gathered));
      if (isToBeRefined(walk, change)) {
        refine(change, walk);
      } else {
        add(gathered, before, units, was);
        add(gathered, here, units, is);
        accept(piece, change, walk);
        before = here;
      }
      if (isFinished(gathered))
        finish(walk);

      // Go on to the next piece.
      enterAtExit(path, transmittanceOf(gathered), walk, before);
      piece = nextPiece(walk);
      isShading = !isAtExit(walk);
      position = isShading ? positionOf(march, piece.end) : u_textureLower;
      scalar = scalarAt(position);
      isShading = isShading && (before.extinction > 0.0 || mayBeSeen(scalar));
    }
    findPiece(path, march, transmittanceOf(gathered), walk, before, piece, position, scalar);
  }
  spent = walk.spent;
  return gathered;
}
