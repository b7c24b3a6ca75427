// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/Workbench.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// What a seed broke.
struct FuzzFailure {
  std::uint64_t seed = 0;
  std::string sentence;
};

/// What random scenes showed.
struct FuzzReport {
  int seeds = 0;             ///< scenes drawn
  int refused = 0;           ///< of them: volumes without a valid voxel, refused in a sentence
  int referenceCompared = 0; ///< scenes compared with the double-precision reference
  int slices = 0;            ///< scenes also drawn by the slice renderer
  int freshlyDrawn = 0;      ///< scenes also drawn by a ray caster that had drawn nothing before
  int programs = 0;          ///< shader programs that the ray caster compiled for them all
  std::size_t pixelsCompared = 0;
  std::size_t pixelsUnequal = 0; ///< left out: rounding gave their rays another number of samples
  int brickCompared = 0;         ///< scenes in equal steps compared with the same picture drawn in bricks
  double worstInBricks = 0.0;    ///< from the whole picture, of a channel 0..1
  double worstDifference = 0.0;  ///< from the reference, of a channel 0..1, where no ray may end early
  std::uint64_t worstSeed = 0;
  double slowestSeconds = 0.0;
  std::uint64_t slowestSeed = 0;
  std::vector<FuzzFailure> failures;
};

/// Who draws random scenes.
enum class FuzzedBy { everyRenderer, processorAlone };

/// Draws the scenes of `seeds` seeds from `firstSeed` on with the ray caster on the current OpenGL context
/// and with the CPU engine, each twice, and checks what must hold for any picture (PictureInvariants), the
/// reference where a seed is comparable, the slice renderer and a fresh ray caster for a part of them. One
/// ray caster draws all: a seed alone gives the same result. The processor alone needs no context.
/// `progress`, if given, hears how many are done; false ends the work. Throws Error (openGl) where nothing
/// can be drawn at all.
FuzzReport runFuzz(int seeds, std::uint64_t firstSeed, const std::function<bool(int)>& progress = {},
                   FuzzedBy fuzzedBy = FuzzedBy::everyRenderer);

/// One line that says what failed and how to repeat it: `limn stability --fuzz 1 --seed S`.
std::string lineOf(const FuzzFailure& failure);

/// What `limn stability` found, and on what: enough for somebody else to judge it, and nothing personal.
struct StabilityReport {
  std::string version;
  std::string renderer; ///< e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string driver;   ///< its versions and limits
  std::string machine;  ///< processor and system
  std::string date;     ///< of measuring, ISO 8601
  std::string command;  ///< that measures the same again
  std::vector<MeasuredCase> cases;
  std::optional<FuzzReport> fuzz;
};

} // namespace limn
