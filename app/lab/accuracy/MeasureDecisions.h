// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"

namespace limn {

/// What each decision about accuracy costs in a scene, one at a time, drawn by the GLSL ray caster on the
/// current OpenGL context: every way of every decision that can show in it (glsl/decisions/Decisions).
/// Steps are sampled, not pre-integrated, and not jittered. `fineError` is at 1/8 voxel without early
/// termination (but for the decisions about that), so that neither hides what the decision itself does. Each
/// way is timed in turn with the program's own until glFinish, three times at least: on the clock, and for
/// its share of the program's own time by the processor's clock where a software driver draws. Changes the
/// framebuffer bound. Throws Error, and Cancelled through `progress`.
std::vector<DecisionCost> measureDecisions(const Scene& scene, const glm::ivec2& size,
                                           const PrecisePixels& converged,
                                           const ReportProgress& progress = {});

} // namespace limn
