// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/Tolerance.h"
#include "accuracy/sweep/OperatingPoint.h"
#include "engine/DrawingEngine.h"
#include "scene/basics/Message.h"

#include <cstdint>
#include <functional>

namespace limn {

/// Told how far long work is, 0..1, and what it does; throws Cancelled to end it.
using ReportProgress = std::function<void(double fraction, const Message& doing)>;

/// A picture that finer steps no longer change, and how far it is certain.
struct ConvergedPicture {
  PrecisePixels pixels;
  ReferenceFacts facts;
};

/// The picture against which errors are measured (DEFINITION section 9): no early termination, all steps
/// halved for the pixels that still change until the last halving changes the 99.9th percentile by at most
/// 0.15 level and the mean by at most 0.005. Error-controlled steps, which get there with a hundredth of the
/// samples, begin at fineness 6 and end at a tenth of that mean. What does not integrate is exact cell by
/// cell, or gets equal steps where `draw` does not go that way: they begin at 1/4 voxel or at the scene's
/// step, whichever is smaller. `facts.converged` is false where that was not reached at the finest ladder, at
/// a step of 1/1024 voxel or, from a finer one, by four halvings.
ConvergedPicture convergedPicture(const Scene& scene, const glm::ivec2& size, const DrawPrecisely& draw,
                                  const ReportProgress& report = {},
                                  StepControl control = StepControl::cells);

/// By how much floats move a converged picture at most where the projection adds samples up, levels. On the
/// CT head and the phantom, whole and in bricks, the percentile came to 0.0091
/// (tests/cpu/ConvergedInFloatsTest).
constexpr double floatP99_9 = 0.01;
constexpr double floatMean = 0.0005;

/// The smallest errors that can be told from none against a picture: three times its own last change, and
/// what floats move it by where it was drawn in those. Smaller ones are to be printed as "< x".
double leastP99_9(const ReferenceFacts& facts);
double leastMean(const ReferenceFacts& facts);

} // namespace limn
