// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engines/RealRenderers.h"

namespace limn {

/// Whether a report also says what each decision about accuracy costs.
enum class Decide { none, each };

/// Measures error and time of a scene: the converged picture, then every point, then each decision where
/// wanted.
AccuracyReport measureAccuracy(const std::string& name, const Scene& scene, const glm::ivec2& size,
                               const std::vector<OperatingPoint>& points, Decide withDecisions,
                               RealRenderers& renderers, const ReportProgress& progress);

} // namespace limn
