// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/stability/StabilityText.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace limn {
namespace {

// How much of its bound a finding uses: what is the tightest row of an engine.
double shareOfBound(const Finding& finding) {
  if (finding.verdict != Verdict::pass)
    return finding.verdict == Verdict::fail ? 1e300 : -1.0;
  return finding.bound > 0.0 ? finding.figure / finding.bound : 0.0;
}

std::vector<const Finding*> tightestOfEachEngine(const MeasuredCase& one) {
  std::vector<const Finding*> tightest;
  for (const Finding& finding : one.findings) {
    const auto same = std::find_if(tightest.begin(), tightest.end(),
                                   [&](const Finding* other) { return other->engine == finding.engine; });
    if (same == tightest.end())
      tightest.push_back(&finding);
    else if (shareOfBound(finding) > shareOfBound(**same))
      *same = &finding;
  }
  return tightest;
}

std::string lineOf(const MeasuredCase& one) {
  std::string line = one.id + std::string(5 - std::min<std::size_t>(4, one.id.size()), ' ');
  line += verdictText(verdictOf(one)) + (verdictOf(one) == Verdict::notApplicable ? "   " : "  ") +
          one.title + "\n";
  std::string figures;
  for (const Finding* finding : tightestOfEachEngine(one)) {
    if (!figures.empty())
      figures += " · ";
    figures += finding->engine + " " + figureText(*finding);
  }
  line += "           " + figures + "\n";
  for (const Finding& finding : one.findings)
    if (finding.verdict == Verdict::fail)
      line += "     FAILS " + finding.engine + (finding.what.empty() ? "" : ", " + finding.what) + ": " +
              figureText(finding) + " (" + finding.reason + ")\n";
  return line;
}

std::string plural(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

} // namespace

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

bool holds(const StabilityReport& report) {
  return allHold(report.cases) && (!report.fuzz || report.fuzz->failures.empty());
}

std::string stabilitySummary(const StabilityReport& report) {
  std::size_t rows = 0, failed = 0, without = 0;
  for (const MeasuredCase& one : report.cases)
    for (const Finding& finding : one.findings) {
      ++rows;
      failed += finding.verdict == Verdict::fail;
      without += finding.verdict == Verdict::notApplicable;
    }
  std::string text;
  if (!report.cases.empty())
    text = plural(report.cases.size(), "case", "cases") + ", " + plural(rows, "row", "rows") + ": " +
           std::to_string(rows - failed - without) + " hold, " + std::to_string(failed) + " fail, " +
           std::to_string(without) + " cannot apply.";
  if (report.fuzz) {
    if (!text.empty())
      text += " ";
    text += plural(static_cast<std::size_t>(report.fuzz->seeds), "random scene", "random scenes") + ": ";
    text += plural(report.fuzz->failures.size(), "failure", "failures") + ".";
  }
  return text;
}

std::string stabilityTable(const StabilityReport& report) {
  std::string table = report.renderer + ", " + report.machine + "\n";
  if (!report.cases.empty())
    table +=
        "Each line: the tightest figure \"of\" its bound. reference: double precision; gl: ray caster; "
        "slices; cpu: CPU engine;\n"
        "cpp, glsl: one formula in both languages; n/a: cannot apply, for the reason that the page tells.\n";
  for (const MeasuredCase& one : report.cases)
    table += lineOf(one);
  if (report.fuzz)
    for (const FuzzFailure& failure : report.fuzz->failures)
      table += lineOf(failure) + "\n";
  return table + stabilitySummary(report) + "\n";
}

} // namespace limn
