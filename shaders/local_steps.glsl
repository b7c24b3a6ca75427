// SPDX-License-Identifier: GPL-3.0-or-later
// Error-controlled steps (renderer/scene/steps/LocalSteps.h): a ray goes from block to block of the map of steps, leaps
// over those of which nothing shows, and takes pieces of its own length in each. Places are in mm behind the
// begin of its span.

uniform sampler3D u_blockSteps; // distance to the nearest visible block; plain rung + 128; resolving rung
uniform vec3 u_stepBlockOffset;
uniform vec3 u_lastStepBlock;
uniform float u_fineness;    // in whole rungs: what is left shortens the ladder
uniform float u_mostChange;
uniform float u_rung0Length;  // the step of rung 0
uniform float u_finestLength;

#ifdef EFFECT_LABEL_LOOKS
const int mostLocalSamples = 7200; // looks take four turns of a loop more
#else
const int mostLocalSamples = 12000;
#endif
const float muchMore = 8.0;
const float muchLess = 0.25;
const float beyondAll = 1e30;

// A ray among the blocks, in units of blocks. It crosses the plane p of an axis at p * perBlock + origin.
struct BlockPath {
  vec3 first;    // at the begin of the span
  vec3 advance;  // per mm
  vec3 perBlock; // mm, 0 where the ray does not follow the axis
  vec3 origin;   // beyond all places where it does not
  vec3 away;     // 1 where the ray goes up, -1 where it goes down
  vec3 outermost; // planes p, times `away`, beyond which there is no block
};

// Where a ray is: in which block, and how much of its chord there is done.
struct Walk {
  vec3 next; // the block behind this one
  float entry; // of the chord
  float exit;
  float within; // done of it
  float step;
  float blockStep; // the longest in this block
  float end; // of the span
  int spent; // samples
};

// A piece of a chord, with a sample at either end.
struct Piece {
  float mm;
  float end; // where the sample behind it lies
  bool isLast; // of its chord
};

BlockPath blockPath(vec3 firstIndex, vec3 direction) {
  BlockPath path;
  path.first = 0.25 * firstIndex + u_stepBlockOffset;
  path.advance = 0.25 * direction;
  vec3 isStill = vec3(lessThan(abs(direction), vec3(1e-20)));
  vec3 isForward = vec3(greaterThan(direction, vec3(0.0)));
  path.perBlock = (1.0 - isStill) / (path.advance + isStill);
  path.origin = isStill * beyondAll - path.first * path.perBlock;
  path.away = 2.0 * isForward - 1.0;
  path.outermost = mix(vec3(-0.5), u_lastStepBlock + 0.5, isForward);
  return path;
}

Walk walkThrough(BlockPath path, float end) {
  vec3 block = clamp(floor(path.first), vec3(0.0), u_lastStepBlock);
  return Walk(block, 0.0, 0.0, 0.0, beyondAll, beyondAll, end, 0);
}

bool isAtExit(Walk walk) {
  return !(walk.within < walk.exit - walk.entry);
}

bool isAtEnd(Walk walk) {
  return isAtExit(walk) && walk.exit >= walk.end;
}

// Behind what leaves this transmittance a block may be sampled more coarsely.
float coarserBehind(float transmittance) {
  return floor(-2.0 / 3.0 * log2(max(transmittance, 1e-6)));
}

// Enters the next block, or leaps over the empty ones from there: then nothing is left of the chord. Whether they
// are empty.
bool enterNext(BlockPath path, float transmittance, inout Walk walk) {
  vec3 facts = floor(texelFetch(u_blockSteps, ivec3(walk.next), 0).rgb * 255.0 + 0.5);
  bool isEmpty = facts.r > 0.0;
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
  float beyond = max(facts.r - 1.0, 0.0);
#else
  float beyond = 0.0;
#endif

  // Leave the cube of empty blocks, or the block, through the nearest of the planes ahead.
  vec3 border = walk.next + beyond * path.away;
  vec3 planes = border + max(path.away, 0.0);
  vec3 exits = planes * path.perBlock + path.origin;
  exits = mix(exits, vec3(beyondAll), vec3(greaterThan(planes * path.away, path.outermost)));
  float exit = min(min(exits.x, exits.y), exits.z);

  // Along the other axes go on as many blocks as planes were passed; where rounding makes it one too few, the next
  // block has no chord, and one too many it cannot make.
  vec3 inside = floor(path.first + exit * path.advance - 1e-4 * path.away);
  inside = clamp(inside, min(walk.next, border), max(walk.next, border));
  vec3 behind = mix(inside, border + path.away, vec3(lessThanEqual(exits, vec3(exit))));
  walk.next = clamp(behind, vec3(0.0), u_lastStepBlock);

  walk.entry = walk.exit;
  walk.exit = max(min(exit, walk.end), walk.entry);
  walk.within = isEmpty ? walk.exit - walk.entry : 0.0;
  float rung = max(facts.g - 128.0 + u_fineness - coarserBehind(transmittance), facts.b);
  walk.blockStep = max(u_rung0Length * exp2(-0.5 * max(rung, 0.0)), u_finestLength);
  walk.step = isEmpty ? beyondAll : min(walk.step, walk.blockStep);
  return isEmpty;
}

// The next piece: a step, or what is left of the chord in one or two equal pieces.
Piece nextPiece(Walk walk) {
  float rest = max(walk.exit - walk.entry - walk.within, 0.0);
  float step = walk.spent < mostLocalSamples ? walk.step : rest;
  Piece piece;
  piece.isLast = rest <= step;
  piece.mm = piece.isLast ? rest : rest < 1.5 * step ? 0.5 * rest : step;
  piece.end = piece.isLast ? walk.exit : walk.entry + (walk.within + piece.mm);
  return piece;
}

// Goes on behind a piece. Where little changed over it, the next is twice as long.
void accept(Piece piece, float change, inout Walk walk) {
  walk.within = piece.isLast ? walk.exit - walk.entry : walk.within + piece.mm;
  if (change < muchLess * u_mostChange)
    walk.step = min(2.0 * walk.step, walk.blockStep);
  walk.spent += 1;
}

// Whether a piece over which so much changed is to be taken again with a smaller step.
bool isToBeRefined(Walk walk, float change) {
  return change > u_mostChange && walk.step > u_finestLength && walk.spent < mostLocalSamples;
}

void refine(float change, inout Walk walk) {
  walk.step = max((change > muchMore * u_mostChange ? 0.25 : 0.5) * walk.step, u_finestLength);
  walk.spent += 1;
}

// Ends a ray behind which nothing shows.
void finish(inout Walk walk) {
  walk.end = walk.exit;
  walk.within = walk.exit - walk.entry;
}
