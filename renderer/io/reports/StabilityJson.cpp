// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reports/ReportJson.h"

#include "io/json/JsonText.h"
#include "stability/StabilityReport.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

Json rowOf(const MeasuredCase& one, const Finding& finding) {
  const bool isMeasured = finding.verdict != Verdict::notApplicable;
  return {{"id", one.id},
          {"title", one.title},
          {"what", finding.what},
          {"engine", finding.engine},
          {"figure", isMeasured ? Json(finding.figure) : Json()},
          {"bound", isMeasured ? Json(finding.bound) : Json()},
          {"verdict", verdictText(finding.verdict)},
          {"reason", finding.reason}};
}

Json fuzzOf(const std::optional<FuzzReport>& fuzz) {
  if (!fuzz)
    return {{"seeds", 0}, {"failures", Json::array()}};
  Json failures = Json::array();
  for (const FuzzFailure& failure : fuzz->failures)
    failures.push_back({{"seed", failure.seed}, {"sentence", failure.sentence}});
  return {{"seeds", fuzz->seeds},
          {"refused", fuzz->refused},
          {"reference_compared", fuzz->referenceCompared},
          {"slices", fuzz->slices},
          {"programs", fuzz->programs},
          {"pixels_compared", fuzz->pixelsCompared},
          {"pixels_unequal_samples", fuzz->pixelsUnequal},
          {"worst_difference", fuzz->worstDifference},
          {"worst_seed", fuzz->worstSeed},
          {"slowest_s", fuzz->slowestSeconds},
          {"slowest_seed", fuzz->slowestSeed},
          {"failures", failures}};
}

} // namespace

std::string stabilityJson(const StabilityReport& report) {
  Json rows = Json::array();
  for (const MeasuredCase& one : report.cases)
    for (const Finding& finding : one.findings)
      rows.push_back(rowOf(one, finding));
  const Json json{{"version", report.version},
                  {"renderer", report.renderer},
                  {"driver", report.driver},
                  {"machine", report.machine},
                  {"date", report.date},
                  {"command", report.command},
                  {"cases", rows},
                  {"fuzz", fuzzOf(report.fuzz)}};
  return textOf(json);
}

} // namespace limn
