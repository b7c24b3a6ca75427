// SPDX-License-Identifier: GPL-3.0-or-later
// Error-controlled steps (renderer/scene/LocalSteps.h): a ray goes from block to block of the map of steps, leaps
// over those of which nothing shows, and takes pieces of its own length in each. Places are in mm behind the
// begin of its span.

uniform sampler3D u_blockSteps; // distance to the nearest visible block; plain level + 128; resolving level
uniform vec3 u_stepBlockOffset;
uniform vec3 u_lastStepBlock;
uniform float u_fineness;
uniform float u_mostChange;
uniform float u_level0Mm; // the step of level 0

const float finestLevel = 24.0;
const int mostLocalSamples = 12000;
const float levelsPerHalving = 2.0;
const float muchMore = 8.0;
const float muchLess = 0.25;
const float beyondAll = 1e30;

// A ray among the blocks, in units of blocks.
struct BlockPath {
  vec3 first;     // at the begin of the span
  vec3 advance;   // per mm
  vec3 perBlock;  // mm per block along each axis, 0 where the ray does not follow the axis
  vec3 still;     // 0, and beyond all places where the ray does not follow the axis
  vec3 isForward; // 1 where it goes up
};

// Where a ray is: in which block, and how much of its chord there is done.
struct Walk {
  vec3 next;       // the block behind this one
  float entry;     // of the chord
  float exit;
  float within;    // done of it
  float level;     // of the step
  float blockLevel; // the coarsest in this block
  float end;       // of the span
  int spent;       // samples
};

// A piece of a chord.
struct Piece {
  float length;
  float middle;
  bool isLast; // of its chord
};

BlockPath blockPath(vec3 firstIndex, vec3 direction) {
  BlockPath path;
  path.first = 0.25 * firstIndex + u_stepBlockOffset;
  path.advance = 0.25 * direction;
  vec3 isStill = vec3(lessThan(abs(direction), vec3(1e-20)));
  path.perBlock = (1.0 - isStill) / (path.advance + isStill);
  path.still = isStill * beyondAll;
  path.isForward = vec3(greaterThan(direction, vec3(0.0)));
  return path;
}

Walk walkThrough(BlockPath path, float end) {
  vec3 block = clamp(floor(path.first), vec3(0.0), u_lastStepBlock);
  return Walk(block, 0.0, 0.0, 0.0, 0.0, 0.0, end, 0);
}

bool isAtExit(Walk walk) {
  return !(walk.within < walk.exit - walk.entry);
}

bool isAtEnd(Walk walk) {
  return isAtExit(walk) && walk.exit >= walk.end;
}

// Where the ray leaves the cube of blocks nearer than `reach`, along each axis. The outermost blocks have no end.
vec3 exitsOf(BlockPath path, vec3 block, float reach) {
  vec3 away = 2.0 * path.isForward - 1.0;
  vec3 ahead = mix(block, u_lastStepBlock - block, path.isForward);
  vec3 faces = block + path.isForward + away * (reach - 1.0);
  return (faces - path.first) * path.perBlock + path.still + beyondAll * vec3(lessThan(ahead, vec3(reach - 0.5)));
}

// The block that the ray is in when it has left that cube: through the nearest face by a whole number of blocks,
// along the other axes as many blocks on as it has passed faces.
vec3 blockBehind(BlockPath path, vec3 block, float reach, vec3 exits, float exit) {
  vec3 away = 2.0 * path.isForward - 1.0;
  vec3 through = vec3(lessThanEqual(exits, vec3(exit)));
  vec3 inside = block;
  if (reach > 1.0) {
    vec3 border = block + away * (reach - 1.0);
    inside = clamp(floor(path.first + exit * path.advance), min(block, border), max(block, border));
    vec3 passed = vec3(lessThanEqual(exitsOf(path, inside, 1.0), vec3(exit)));
    inside += away * passed;
    vec3 entered = (inside + 1.0 - path.isForward - path.first) * path.perBlock - path.still;
    inside -= away * vec3(greaterThan(entered, vec3(exit))) * vec3(notEqual(inside, block));
  }
  return clamp(mix(inside, block + away * reach, through), vec3(0.0), u_lastStepBlock);
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
  float reach = max(facts.r, 1.0);
#else
  float reach = 1.0;
#endif
  vec3 exits = exitsOf(path, walk.next, reach);
  float exit = min(min(exits.x, exits.y), exits.z);
  walk.next = blockBehind(path, walk.next, reach, exits, exit);
  walk.entry = walk.exit;
  walk.exit = max(min(exit, walk.end), walk.entry);
  walk.within = isEmpty ? walk.exit - walk.entry : 0.0;
  float wanted = facts.g - 128.0 + u_fineness - coarserBehind(transmittance);
  walk.blockLevel = clamp(max(wanted, facts.b), 0.0, finestLevel);
  walk.level = isEmpty ? 0.0 : max(walk.level, walk.blockLevel);
  return isEmpty;
}

// The next piece: a step, or what is left of the chord in one or two equal pieces.
Piece nextPiece(Walk walk) {
  float rest = max(walk.exit - walk.entry - walk.within, 0.0);
  float step = walk.spent < mostLocalSamples ? u_level0Mm * exp2(-0.5 * walk.level) : rest;
  Piece piece;
  piece.isLast = rest <= step;
  piece.length = piece.isLast ? rest : rest < 1.5 * step ? 0.5 * rest : step;
  piece.middle = walk.entry + (walk.within + 0.5 * piece.length);
  return piece;
}

// Goes on behind a piece. Where little changed over it, the next is longer.
void accept(Piece piece, float change, inout Walk walk) {
  walk.within = piece.isLast ? walk.exit - walk.entry : walk.within + piece.length;
  if (change < muchLess * u_mostChange)
    walk.level = max(walk.level - levelsPerHalving, walk.blockLevel);
  walk.spent += 1;
}

// Whether a piece over which so much changed is to be taken again with a smaller step.
bool isToBeRefined(Walk walk, float change) {
  return change > u_mostChange && walk.level < finestLevel && walk.spent < mostLocalSamples;
}

void refine(float change, inout Walk walk) {
  float halvings = change > muchMore * u_mostChange ? 2.0 : 1.0;
  walk.level = min(walk.level + halvings * levelsPerHalving, finestLevel);
  walk.spent += 1;
}

// Ends a ray behind which nothing shows.
void finish(inout Walk walk) {
  walk.end = walk.exit;
  walk.within = walk.exit - walk.entry;
}
