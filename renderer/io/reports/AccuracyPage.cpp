// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reports/AccuracyPage.h"

#include "accuracy/sweep/AccuracySweep.h"
#include "accuracy/sweep/FigureText.h"
#include "io/reports/HtmlPage.h"

namespace limn {
namespace {

std::string rangeOf(const Timing& ms) {
  return threeDigits(ms.least) + " – " + threeDigits(ms.most);
}

std::string pointTable(const AccuracyReport& report) {
  std::string table = "<table>\n" + htmlRow({"Operating point", "Step, mm", "Time, ms", "least – most",
                                             "Error, 99.9th percentile", "mean", "largest",
                                             "pixels over 1 level, %", "order", "memory, MB"},
                                            {}, "th");
  std::string family;
  for (const MeasuredPoint& point : report.points) {
    if (familyOf(point.point) != family)
      table += htmlRow({family = familyOf(point.point)}, "group");
    const bool isKnown = report.reference.converged;
    table +=
        htmlRow({stepOf(point.point),
                 point.point.toleranceLevels || point.point.paths
                     ? "–"
                     : threeDigits(point.point.stepVoxels * report.smallestSpacingMm),
                 threeDigits(point.ms.median), rangeOf(point.ms), p99_9Text(point.error, report.reference),
                 meanText(point.error, report.reference), isKnown ? threeDigits(point.error.largest) : "–",
                 isKnown ? threeDigits(100.0 * point.error.shareOverOne) : "–",
                 isKnown && point.order ? threeDigits(*point.order) : "–", threeDigits(point.peakMb)},
                isKnown && point.isPareto ? "best" : "");
  }
  return table + "</table>\n";
}

std::string decisionTable(const AccuracyReport& report) {
  std::string table =
      "<table>\n" + htmlRow({"Decision", "Time, ms", "of Limn’s time", "Error, 99.9th percentile", "mean",
                             "at step 1/8: 99.9th percentile", "mean", "memory, MB more", "remark"},
                            {}, "th");
  std::string group;
  for (const DecisionCost& cost : report.decisions) {
    if (cost.group != group)
      table += htmlRow({group = cost.group}, "group");
    table += htmlRow({cost.name + (cost.isDefault ? " (what Limn does)" : ""), threeDigits(cost.ms.median),
                      threeDigits(cost.timesDefault), p99_9Text(cost.error, report.reference),
                      meanText(cost.error, report.reference), p99_9Text(cost.fineError, report.reference),
                      meanText(cost.fineError, report.reference), threeDigits(cost.extraMb), cost.remark});
  }
  table += "</table>\n";
  for (const std::string& sentence : verdictOn(report.decisions))
    table += "<p>" + escapedHtml(sentence) + "</p>\n";
  return table;
}

} // namespace

std::string accuracyPage(const AccuracyReport& report, const std::string& chart) {
  std::string page;
  page += "<h1>What accuracy costs in time: " + escapedHtml(report.scene) + "</h1>\n<p class=\"facts\">" +
          std::to_string(report.size.x) + " × " + std::to_string(report.size.y) + " pixels · " +
          escapedHtml(report.renderer) + " · " + escapedHtml(report.machine) + "</p>\n";
  page += "<p>" + escapedHtml(referenceSentence(report.reference)) +
          " They are in 8-bit levels (0 to 255) of the premultiplied channels over the pixels that the "
          "volume covers. A picture whose 99.9th percentile is at most one level is accurate to the screen. "
          "Times are medians of whole pictures.</p>\n";
  page += "<img src=\"" + escapedHtml(chart) +
          "\" alt=\"Error against time, both logarithmic, one curve per family\">\n";
  if (report.reference.converged)
    page += "<p>" + escapedHtml(wishWithinLevels(report.points, 1.0)) + " " +
            escapedHtml(wishWithinMs(report.points, 33.0)) + "</p>\n";
  page +=
      "<h2>Operating points</h2>\n<p>★ marks those that no other point beats in both time and error.</p>\n" +
      pointTable(report);
  if (!report.decisions.empty())
    page += "<h2>What each decision costs</h2>\n<p>One decision changed at a time, all else as Limn does "
            "it.</p>\n" +
            decisionTable(report);
  for (const std::string& remark : report.remarks)
    page += "<p>" + escapedHtml(remark) + "</p>\n";
  return htmlPage("Accuracy and time: " + report.scene, page);
}

} // namespace limn
