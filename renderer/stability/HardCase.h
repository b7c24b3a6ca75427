// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Image.h"

#include <functional>
#include <string>
#include <vector>

namespace limn {

/// How a row of the report ends.
enum class Verdict { pass, fail, notApplicable };

/// "pass", "fail" or "n/a".
std::string verdictText(Verdict verdict);

/// One row of the report on a hard case.
struct Finding {
  std::string engine;  ///< "reference", "gl", "slices"; "cpp", "glsl" for functions that draw nothing
  std::string what;    ///< which of the case's settings; may be empty
  double figure = 0.0; ///< measured
  double bound = 0.0;  ///< which the figure must not exceed
  Verdict verdict = Verdict::notApplicable;
  std::string reason; ///< what the figure is and where the bound comes from, or why the case cannot apply
  std::vector<Image> pictures{}; ///< what was drawn, at most two, where there is something to see
};

/// Passes where `figure` ≤ `bound`; a figure that is not a number fails.
Finding atMost(std::string engine, std::string what, double figure, double bound, std::string reason);

/// A row for an engine, or a setting, that a case cannot be asked of; `reason` says why.
Finding notApplicable(std::string engine, std::string what, std::string reason);

class Workbench;

/// A situation in which volume renderers are known to fail, as a scene or an input with a bound: a row of
/// the report for each renderer that can draw it, and for each of the settings that it names.
struct HardCase {
  std::string id;    ///< "H1", stable from version to version
  std::string title; ///< the situation and what must hold, for people
  std::vector<Finding> (*measure)(Workbench& bench);
};

/// What was measured of a case.
struct MeasuredCase {
  std::string id;
  std::string title;
  std::vector<Finding> findings;
};

/// Told how far long work is, 0..1, and what it does; throws Cancelled to end it.
using ReportStability = std::function<void(double fraction, const std::string& doing)>;

/// Measures cases one after the other. A case that ends with an error has failed, with the error's sentence;
/// Cancelled passes through.
std::vector<MeasuredCase> measure(const std::vector<HardCase>& cases, Workbench& bench,
                                  const ReportStability& report = {});

/// Whether no finding of any case failed.
bool allHold(const std::vector<MeasuredCase>& cases);

} // namespace limn
