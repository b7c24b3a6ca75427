// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"

namespace limn {

/// A report and what it is called where many stand together: the name under which it was read.
struct NamedReport {
  std::string name;
  AccuracyReport report;
};

/// What one operating point brought over all scenes of a cohort that were measured at it.
struct CohortPoint {
  OperatingPoint point;
  int scenes = 0;          ///< measured at this point
  int converged = 0;       ///< of those, with an exact picture; errors are theirs alone
  double usualP99_9 = 0.0; ///< levels: median over scenes of the 99.9th percentile
  double worstP99_9 = 0.0; ///< levels: the largest of them
  double usualMean = 0.0;  ///< levels: median of the mean errors
  std::string worst;       ///< the report in which it is so large
  Timing ms;               ///< over scenes, of their median times
  bool operator==(const CohortPoint&) const = default;
};

/// The part of a cohort that one machine measured with one renderer: times of others are not comparable.
struct CohortGroup {
  std::string machine;
  std::string renderer;
  int reports = 0;
  std::vector<CohortPoint> points; ///< in the order in which reports name them first
};

/// Groups and points in the order in which they come first. Each point of a report counts once.
std::vector<CohortGroup> cohortOf(const std::vector<NamedReport>& reports);

} // namespace limn
