// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measure/stability/FindingText.h"

#include <array>
#include <cstdio>

namespace limn {

Verdict verdictOf(const MeasuredCase& one) {
  Verdict verdict = Verdict::notApplicable;
  for (const Finding& finding : one.findings) {
    if (finding.verdict == Verdict::fail)
      return Verdict::fail;
    if (finding.verdict == Verdict::pass)
      verdict = Verdict::pass;
  }
  return verdict;
}

std::string shortNumber(double value) {
  std::array<char, 32> text{};
  // Counts in full, everything else with two digits.
  const bool isCount = value == static_cast<double>(static_cast<long long>(value)) && value < 1e6;
  std::snprintf(text.data(), text.size(), isCount ? "%.0f" : "%.2g", value);
  return text.data();
}

std::string figureText(const Finding& finding) {
  if (finding.verdict == Verdict::notApplicable)
    return "n/a";
  return shortNumber(finding.figure) + " of " + shortNumber(finding.bound);
}

} // namespace limn
