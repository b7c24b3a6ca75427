// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/accuracy/AccuracyText.h"

#include "accuracy/DecisionVerdict.h"
#include "accuracy/FigureText.h"

namespace limn {
namespace {

const char* const style = R"(
body { font: 15px/1.5 system-ui, sans-serif; color: #1d2229; background: #fff; margin: 40px auto; max-width: 1080px; padding: 0 24px; }
h1 { font-size: 26px; margin: 0 0 4px; } h2 { font-size: 19px; margin: 36px 0 8px; }
p { max-width: 75ch; } p.facts { color: #59626e; margin-top: 0; }
img { width: 100%; height: auto; margin: 12px 0; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; width: 100%; font-size: 14px; }
th { text-align: right; font-weight: 600; color: #59626e; border-bottom: 2px solid #cfd5dc; padding: 4px 10px; vertical-align: bottom; }
td { text-align: right; border-bottom: 1px solid #e6e9ed; padding: 3px 10px; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; padding-left: 0; white-space: normal; }
tr.best td:first-child::after { content: " \2605"; color: #b26a00; }
tr.group td { font-weight: 600; border-bottom: none; padding-top: 14px; }
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '&'   ? "&amp;"
              : c == '<' ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  return result;
}

std::string rowOf(const std::vector<std::string>& cells, const std::string& kind = {},
                  const char* tag = "td") {
  std::string row = kind.empty() ? "<tr>" : "<tr class=\"" + kind + "\">";
  for (const std::string& cell : cells)
    row += std::string("<") + tag + ">" + escaped(cell) + "</" + tag + ">";
  return row + "</tr>\n";
}

std::string timesOf(const Timing& ms) {
  return threeDigits(ms.least) + " – " + threeDigits(ms.most);
}

std::string pointTable(const AccuracyReport& report) {
  std::string table = "<table>\n" + rowOf({"Operating point", "Step, mm", "Time, ms", "least – most",
                                           "Error, 99.9th percentile", "mean", "largest",
                                           "pixels over 1 level, %", "order", "memory, MB"},
                                          {}, "th");
  std::string family;
  for (const MeasuredPoint& point : report.points) {
    if (familyOf(point.point) != family)
      table += rowOf({family = familyOf(point.point)}, "group");
    const bool isKnown = report.reference.converged;
    table += rowOf(
        {stepOf(point.point),
         point.point.toleranceLevels ? "–" : threeDigits(point.point.stepVoxels * report.smallestSpacingMm),
         threeDigits(point.ms.median), timesOf(point.ms), p99_9Text(point.error, report.reference),
         meanText(point.error, report.reference), isKnown ? threeDigits(point.error.largest) : "–",
         isKnown ? threeDigits(100.0 * point.error.shareOverOne) : "–",
         isKnown && point.order ? threeDigits(*point.order) : "–", threeDigits(point.peakMb)},
        isKnown && point.isPareto ? "best" : "");
  }
  return table + "</table>\n";
}

std::string decisionTable(const AccuracyReport& report) {
  std::string table =
      "<table>\n" + rowOf({"Decision", "Time, ms", "of Limn’s time", "Error, 99.9th percentile", "mean",
                           "at step 1/8: 99.9th percentile", "mean", "memory, MB more", "remark"},
                          {}, "th");
  std::string group;
  for (const DecisionCost& cost : report.decisions) {
    if (cost.group != group)
      table += rowOf({group = cost.group}, "group");
    table += rowOf({cost.name + (cost.isDefault ? " (what Limn does)" : ""), threeDigits(cost.ms.median),
                    threeDigits(cost.timesDefault), p99_9Text(cost.error, report.reference),
                    meanText(cost.error, report.reference), p99_9Text(cost.fineError, report.reference),
                    meanText(cost.fineError, report.reference), threeDigits(cost.extraMb), cost.remark});
  }
  table += "</table>\n";
  for (const std::string& sentence : verdictOn(report.decisions))
    table += "<p>" + escaped(sentence) + "</p>\n";
  return table;
}

} // namespace

std::string accuracyPage(const AccuracyReport& report, const std::string& chart) {
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Accuracy "
                     "and time: " +
                     escaped(report.scene) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n";
  page += "<h1>What accuracy costs in time: " + escaped(report.scene) + "</h1>\n<p class=\"facts\">" +
          std::to_string(report.size.x) + " × " + std::to_string(report.size.y) + " pixels · " +
          escaped(report.renderer) + " · " + escaped(report.machine) + "</p>\n";
  page +=
      "<p>" + escaped(referenceSentence(report.reference)) +
      " They are in 8-bit levels (0 to 255) of the premultiplied channels over the pixels that the volume "
      "covers. "
      "A picture whose 99.9th percentile is at most one level is accurate to the screen. Times are medians "
      "of whole pictures.</p>\n";
  page += "<img src=\"" + escaped(chart) +
          "\" alt=\"Error against time, both logarithmic, one curve per family\">\n";
  if (report.reference.converged)
    page += "<p>" + escaped(wishWithinLevels(report.points, 1.0)) + " " +
            escaped(wishWithinMs(report.points, 33.0)) + "</p>\n";
  page +=
      "<h2>Operating points</h2>\n<p>★ marks those that no other point beats in both time and error.</p>\n" +
      pointTable(report);
  if (!report.decisions.empty())
    page += "<h2>What each decision costs</h2>\n<p>One decision changed at a time, all else as Limn does "
            "it.</p>\n" +
            decisionTable(report);
  for (const std::string& remark : report.remarks)
    page += "<p>" + escaped(remark) + "</p>\n";
  return page + "</body>\n</html>\n";
}

} // namespace limn
