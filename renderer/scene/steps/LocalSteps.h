// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

namespace limn {

// Error-controlled steps: samples are spent where the picture needs them. Three rules choose the local step,
// all of them from one ladder of lengths: facts of each block say on which rung to begin (BlockSteps); behind
// what already hides it a block may be sampled more coarsely; and a step over which the light that it adds
// changes by more than a limit is taken again with a smaller one. One number, the fineness, makes all of them
// finer. renderer/accuracy/README.md says what these words mean and what that gains.

/// The step of a rung of the ladder, in units of the smallest spacing: 2 at rung 0, shorter by √2 from each
/// to the next.
double stepOfRung(double rung);
inline constexpr int rungsPerHalving = 2;

/// 1/2048 of the smallest spacing.
inline constexpr int finestRung = 24;

/// The most samples of one ray under error-controlled steps: drivers end all loops of a fragment together
/// after some 65 000 iterations, and a sample takes up to five of them. A ray that has spent them goes on
/// with one sample in each block.
inline constexpr int mostLocalSamples = 12000;

/// The same where labels have looks of their own, which take up to four iterations more.
inline constexpr int mostLocalSamplesOfLooks = 7200;

/// How many rungs finer than the facts of a block alone ask for; 2 rungs halve every step. A part of a rung
/// shortens the whole ladder by its share.
struct Fineness {
  static constexpr double least = 0.0;
  static constexpr double most = 24.0;
};

/// Where light travels (DEFINITION section 11) a tolerance asks for no more: a pixel has 16,384 paths.
inline constexpr double mostLitFineness = 8.0;

/// The whole rungs of a fineness, and by what the part that is left multiplies every step, 1/√2 … 1.
int wholeRungs(double fineness);
double ladderScale(double fineness);

/// The fineness with which a scene is drawn; absent: equal steps. A tolerance whose fineness has not been
/// found for this picture (accuracy/Tolerance) takes the one that heads commonly need.
std::optional<double> finenessOf(const Quality& quality);

/// A quality with another step; error-controlled ones change by the same ratio, as far as they can.
Quality withSteps(Quality quality, double stepVoxels);

/// The fineness that a tolerance commonly needs.
double usualFineness(double toleranceLevels);

/// The largest difference, from one sample to the next, of the light that a step adds to a channel of the
/// pixel (0..1) if it is all like the one or like the other; beyond it the step is taken again with a smaller
/// one.
double mostChange(double fineness);

/// By how many rungs a block may be sampled more coarsely behind what leaves this transmittance: its error
/// weighs less, and steps as the cube root of that share the samples out best.
int coarserBehind(double transmittance);

/// Whether a piece over which the light changed by so much is to be taken again; `limit` is mostChange.
inline bool isToBeRefined(double change, double limit, int rung) {
  return change > limit && rung < finestRung;
}

/// The rung with which it is taken again: half or, where the change is far too large, a quarter of the step.
int refinedRung(int rung, double change, double limit);

/// The rung behind a piece that was kept: twice the step where little changed, as far as the block allows.
int relaxedRung(int rung, int blockRung, double change, double limit);

/// The length of the next piece of a chord: a step, or what is left of it in one or two equal pieces.
double pieceOf(double rest, double step);

} // namespace limn
