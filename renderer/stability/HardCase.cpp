// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/HardCase.h"

#include "scene/basics/Error.h"

#include <utility>

namespace limn {

std::string verdictText(Verdict verdict) {
  const char* texts[] = {"pass", "fail", "n/a"};
  return texts[static_cast<int>(verdict)];
}

Finding atMost(std::string engine, std::string what, double figure, double bound, std::string reason) {
  return {std::move(engine), std::move(what), figure, bound, figure <= bound ? Verdict::pass : Verdict::fail,
          std::move(reason)};
}

Finding notApplicable(std::string engine, std::string what, std::string reason) {
  return {std::move(engine), std::move(what), 0.0, 0.0, Verdict::notApplicable, std::move(reason)};
}

std::vector<MeasuredCase> measure(const std::vector<HardCase>& cases, Workbench& bench,
                                  const ReportStability& report) {
  std::vector<MeasuredCase> measured;
  for (const HardCase& one : cases) {
    if (report)
      report(static_cast<double>(measured.size()) / static_cast<double>(cases.size()),
             one.id + ": " + one.title);
    measured.push_back({one.id, one.title, {}});
    try {
      measured.back().findings = one.measure(bench);
    } catch (const Error& error) {
      Finding failed = atMost("program", "", 1.0, 0.0, error.what());
      measured.back().findings = {std::move(failed)};
    }
  }
  return measured;
}

bool allHold(const std::vector<MeasuredCase>& cases) {
  for (const MeasuredCase& one : cases)
    for (const Finding& finding : one.findings)
      if (finding.verdict == Verdict::fail)
        return false;
  return true;
}

} // namespace limn
