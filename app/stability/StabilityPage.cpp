// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HtmlPage.h"
#include "app/stability/FindingText.h"
#include "app/stability/StabilityReport.h"

#include <QBuffer>
#include <QImage>

#include <algorithm>
#include <array>

namespace limn {
namespace {

const char* const style = R"(
td { vertical-align: top; } td.text { text-align: left; white-space: normal; }
.pass { color: #1a7f37; } .fail { color: #c4261d; font-weight: 600; } .none { color: #737b85; }
tr.reason td { color: #59626e; font-size: 13px; text-align: left; white-space: normal; padding: 2px 0 6px 0; }
tr.reason.fail td { color: #c4261d; }
tr.case td { border-bottom: none; padding-top: 22px; font-weight: 600; font-size: 15px; white-space: normal; text-align: left; }
tr.shown td { text-align: left; padding: 6px 0 10px; white-space: normal; }
figure { display: inline-block; margin: 0 10px 0 0; font-size: 12px; color: #59626e; text-align: center; }
figure img { width: 96px; height: auto; margin: 0; display: block; image-rendering: pixelated; border-radius: 4px; }
p.sum { font-size: 17px; font-weight: 600; }
)";

// Over the dark grey of the program's view, rounded to 8 bits; what is no number becomes magenta.
QImage shownImage(const Image& image) {
  constexpr float background = 0.08f;
  QImage shown(image.size.x, image.size.y, QImage::Format_RGB888);
  for (int y = 0; y < image.size.y; ++y)
    for (int x = 0; x < image.size.x; ++x) {
      const glm::vec4& pixel = image.at(x, y);
      const glm::vec3 color = glm::vec3(pixel) + (1.0f - pixel.a) * background;
      const bool isNumber = color.r == color.r && color.g == color.g && color.b == color.b;
      const glm::ivec3 bytes(glm::clamp(color, 0.0f, 1.0f) * 255.0f + 0.5f);
      shown.setPixelColor(x, y, isNumber ? QColor(bytes.r, bytes.g, bytes.b) : QColor(Qt::magenta));
    }
  return shown;
}

std::string dataOf(const Image& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  shownImage(image).save(&buffer, "PNG");
  return "data:image/png;base64," + bytes.toBase64().toStdString();
}

std::string picturesOf(const MeasuredCase& one) {
  constexpr std::size_t most = 9;
  std::string figures;
  std::size_t shown = 0;
  for (const Finding& finding : one.findings)
    for (const Image& picture : finding.pictures)
      if (shown < most) {
        figures += "<figure><img alt=\"" + escapedHtml(finding.engine + ", " + finding.what) + "\" src=\"" +
                   dataOf(picture) + "\">" + escapedHtml(finding.engine) + "</figure>";
        ++shown;
      }
  return figures.empty() ? "" : "<tr class=\"shown\"><td colspan=\"6\">" + figures + "</td></tr>\n";
}

std::string classOf(Verdict verdict) {
  return verdict == Verdict::pass ? "pass" : verdict == Verdict::fail ? "fail" : "none";
}

constexpr std::array<const char*, 5> engines = {"reference", "gl", "slices", "cpp", "glsl"};
constexpr std::array<const char*, 5> engineTitles = {"double precision", "ray caster", "slices", "in C++",
                                                     "in GLSL"};
const char* const acrossAll = "<td colspan=\"6\">";

// A row for each setting, a column for each engine.
std::string rowOf(const std::vector<const Finding*>& sameSetting) {
  std::string row = "<tr><td class=\"text\">" + escapedHtml(sameSetting.front()->what) + "</td>";
  for (const char* engine : engines) {
    std::string cell = "<td></td>";
    for (const Finding* finding : sameSetting)
      if (finding->engine == engine)
        cell = "<td class=\"" + classOf(finding->verdict) + "\">" + figureText(*finding) + "</td>";
    row += cell;
  }
  return row + "</tr>\n";
}

// An error that ended the case stands in no column.
bool isOfAnEngine(const Finding& finding) {
  return std::find(engines.begin(), engines.end(), finding.engine) != engines.end();
}

std::string reasonRow(const Finding& finding) {
  const bool isOfOne = finding.verdict == Verdict::notApplicable || !isOfAnEngine(finding);
  const std::string text = isOfOne ? finding.engine + ": " + finding.reason : finding.reason;
  const char* kind = isOfAnEngine(finding) ? "reason" : "reason fail";
  return std::string("<tr class=\"") + kind + "\">" + acrossAll + escapedHtml(text) + "</td></tr>\n";
}

// Reasons that several settings share are told once, below the last of them.
std::string rowsOf(const MeasuredCase& one) {
  std::string rows;
  std::vector<const Finding*> sameSetting;
  std::vector<std::string> told;
  std::string reasons;
  for (std::size_t i = 0; i < one.findings.size(); ++i) {
    const Finding& finding = one.findings[i];
    sameSetting.push_back(&finding);
    const Finding* next = i + 1 < one.findings.size() ? &one.findings[i + 1] : nullptr;
    if (next && next->what == finding.what)
      continue;
    rows += rowOf(sameSetting);
    for (const Finding* row : sameSetting)
      if (std::find(told.begin(), told.end(), row->reason) == told.end()) {
        reasons += reasonRow(*row);
        told.push_back(row->reason);
      }
    sameSetting.clear();
    if (!next || std::find(told.begin(), told.end(), next->reason) == told.end()) {
      rows += reasons;
      reasons.clear();
    }
  }
  return rows;
}

std::string caseRows(const MeasuredCase& one) {
  return "<tr class=\"case\" id=\"" + one.id + "\">" + acrossAll + "<span class=\"" +
         classOf(verdictOf(one)) + "\">" + one.id + "</span> " + escapedHtml(one.title) + "</td></tr>\n" +
         rowsOf(one) + picturesOf(one);
}

std::string headRow() {
  std::string row = "<tr><th>Setting</th>";
  for (const char* title : engineTitles)
    row += std::string("<th>") + title + "</th>";
  return row + "</tr>\n";
}

std::string fuzzText(const FuzzReport& fuzz) {
  std::string text = "<h2>Random scenes</h2>\n<p>" + std::to_string(fuzz.seeds) + " drawn, " +
                     std::to_string(fuzz.referenceCompared) +
                     " compared with the reference (largest difference " + shortNumber(fuzz.worstDifference) +
                     ", seed " + std::to_string(fuzz.worstSeed) + "), " + std::to_string(fuzz.slices) +
                     " drawn as slices too.</p>\n";
  for (const FuzzFailure& failure : fuzz.failures)
    text += "<p class=\"fail\">" + escapedHtml(lineOf(failure)) + "</p>\n";
  return text;
}

} // namespace

std::string stabilityPage(const StabilityReport& report) {
  std::string body = "<h1>Numerical stability</h1>\n<p class=\"facts\">Limn " + escapedHtml(report.version) +
                     " · " + escapedHtml(report.renderer) + " · " + escapedHtml(report.machine) +
                     "</p>\n<p class=\"sum " + (holds(report) ? "pass" : "fail") + "\">" +
                     escapedHtml(stabilitySummary(report)) + "</p>\n";
  body +=
      "<p>Situations in which volume renderers are known to fail, each drawn by the double-precision "
      "reference, "
      "by the ray caster and by slices, with a figure that must not exceed its bound (\"figure of bound\"). "
      "Grey lines say what the figures above them are and where the bounds come from.</p>\n";
  if (!report.cases.empty()) {
    body += "<table>\n" + headRow();
    for (const MeasuredCase& one : report.cases)
      body += caseRows(one);
    body += "</table>\n";
  }
  if (report.fuzz)
    body += fuzzText(*report.fuzz);
  return htmlPage("Limn: numerical stability", body, style);
}

} // namespace limn
