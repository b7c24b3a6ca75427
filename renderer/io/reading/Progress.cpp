// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/Progress.h"

#include "scene/basics/Error.h"

namespace limn {

void reportOrStop(const Progress& progress, double fraction, const Message& what) {
  if (progress.isCancelled && progress.isCancelled())
    throw Cancelled();
  if (progress.report)
    progress.report(fraction, what);
}

Progress part(const Progress& whole, double from, double to) {
  Progress result;
  result.isCancelled = whole.isCancelled;
  if (whole.report)
    result.report = [report = whole.report, from, to](double fraction, const Message& what) {
      report(from + (to - from) * fraction, what);
    };
  return result;
}

Effort effortOf(const Progress& progress, const Message& what) {
  Effort effort;
  effort.isCancelled = progress.isCancelled;
  if (progress.report)
    effort.report = [report = progress.report, what](double fraction) { report(fraction, what); };
  return effort;
}

} // namespace limn
