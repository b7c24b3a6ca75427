// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Image.h"

#include <string>
#include <vector>

namespace limn {

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

Finding notApplicable(std::string engine, std::string what, std::string reason);

} // namespace limn
