// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measure/accuracy/MeasureAccuracy.h"

#include "app/measure/accuracy/MeasureDecisions.h"

namespace limn {

AccuracyReport measureAccuracy(const std::string& name, const Scene& scene, const glm::ivec2& size,
                               const std::vector<OperatingPoint>& points, Decide withDecisions,
                               RealRenderers& renderers, const ReportProgress& progress) {
  const auto part = [&](double from, double to) -> ReportProgress {
    if (!progress)
      return {};
    return [=, &progress](double fraction, const std::string& doing) {
      progress(from + fraction * (to - from), doing);
    };
  };
  const ConvergedPicture converged = convergedPicture(scene, size, renderers.precisely(), part(0.0, 0.3));
  const double end = withDecisions == Decide::each ? 0.7 : 1.0;
  AccuracyReport report = measureAccuracy(name, scene, size, points, converged, renderers, part(0.3, end));
  if (withDecisions == Decide::each)
    report.decisions = measureDecisions(scene, size, converged.pixels, part(end, 1.0));
  return report;
}

} // namespace limn
