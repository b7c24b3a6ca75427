// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/accuracy/AccuracyTable.h"

#include "accuracy/sweep/FigureText.h"

#include <algorithm>

namespace limn {
namespace {

using Row = std::vector<std::string>;

// Columns as wide as their widest entry; the first is aligned left, the others right.
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string gap(widths[i] - row[i].size(), ' ');
      text += i == 0 ? row[i] + gap : "  " + gap + row[i];
    }
    text += "\n";
  }
  return text;
}

Row rowOf(const MeasuredPoint& point, const AccuracyReport& report) {
  const bool isKnown = report.reference.converged;
  return {familyOf(point.point) + ", " + stepOf(point.point),
          point.point.toleranceLevels || point.point.paths
              ? "-"
              : threeDigits(point.point.stepVoxels * report.smallestSpacingMm),
          threeDigits(point.ms.median),
          threeDigits(point.ms.least) + " .. " + threeDigits(point.ms.most),
          p99_9Text(point.error, report.reference),
          meanText(point.error, report.reference),
          isKnown ? threeDigits(point.error.rms) : "-",
          isKnown ? threeDigits(point.error.largest) : "-",
          isKnown ? threeDigits(100.0 * point.error.shareOverOne) : "-",
          isKnown && point.order ? threeDigits(*point.order) : "-",
          threeDigits(point.peakMb),
          isKnown && point.isPareto ? "*" : ""};
}

Row rowOf(const CohortPoint& point) {
  const bool isKnown = point.converged > 0;
  return {familyOf(point.point) + ", " + stepOf(point.point),
          std::to_string(point.scenes),
          threeDigits(point.ms.median),
          threeDigits(point.ms.least) + " .. " + threeDigits(point.ms.most),
          isKnown ? threeDigits(point.usualP99_9) : "-",
          isKnown ? threeDigits(point.worstP99_9) : "-",
          isKnown ? threeDigits(point.usualMean) : "-",
          isKnown ? point.worst : "-"};
}

// How many scenes have times and no errors.
std::string unknownSentence(const CohortGroup& group) {
  int unknown = 0;
  for (const CohortPoint& point : group.points)
    unknown = std::max(unknown, point.scenes - point.converged);
  return unknown == 0 ? "" : std::to_string(unknown) + " without a converged picture count in times alone.\n";
}

Row rowOf(const DecisionCost& cost, const ReferenceFacts& reference) {
  return {cost.group + ": " + cost.name + (cost.isDefault ? " (Limn's)" : ""),
          threeDigits(cost.ms.median),
          threeDigits(cost.timesDefault),
          p99_9Text(cost.error, reference),
          meanText(cost.error, reference),
          p99_9Text(cost.fineError, reference),
          meanText(cost.fineError, reference),
          threeDigits(cost.extraMb)};
}

} // namespace

std::string accuracyTable(const AccuracyReport& report) {
  std::string text = report.scene + ", " + std::to_string(report.size.x) + "x" +
                     std::to_string(report.size.y) + " pixels, " + report.machine + ", " + report.renderer +
                     "\n" + referenceSentence(report.reference) + "\n\n";
  std::vector<Row> rows{{"errors in levels of 255", "mm", "ms", "least .. most", "99.9 %", "mean", "rms",
                         "largest", "% over 1", "order", "MB", "best"}};
  for (const MeasuredPoint& point : report.points)
    rows.push_back(rowOf(point, report));
  text += aligned(rows);
  if (!report.decisions.empty()) {
    std::vector<Row> costs{{"what each decision costs", "ms", "of Limn's time", "99.9 %", "mean",
                            "at 1/8: 99.9 %", "mean", "MB more"}};
    for (const DecisionCost& cost : report.decisions)
      costs.push_back(rowOf(cost, report.reference));
    text += "\n";
    text += aligned(costs);
    for (const std::string& sentence : verdictOn(report.decisions))
      text += sentence + "\n";
  }
  for (const std::string& remark : report.remarks)
    text += remark + "\n";
  return text;
}

std::string cohortTable(const std::vector<CohortGroup>& groups) {
  std::string text;
  for (const CohortGroup& group : groups) {
    text += text.empty() ? "" : "\n";
    text += std::to_string(group.reports) + (group.reports == 1 ? " report, " : " reports, ") +
            group.machine + ", " + group.renderer + "\n" + unknownSentence(group);
    std::vector<Row> rows{{"errors in levels of 255; usual = median", "scenes", "usual ms", "least .. most",
                           "usual 99.9 %", "worst", "usual mean", "worst in"}};
    for (const CohortPoint& point : group.points)
      rows.push_back(rowOf(point));
    text += aligned(rows);
  }
  return text;
}

} // namespace limn
