// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HtmlPage.h"
#include "app/stability/FindingText.h"
#include "app/stability/StabilityReport.h"

#include <QBuffer>
#include <QImage>

#include <algorithm>

namespace limn {
namespace {

const char* const style = R"(
td { vertical-align: top; } td.text, th.text { text-align: left; white-space: normal; }
td.verdict { font-weight: 600; } .pass { color: #1a7f37; } .fail { color: #c4261d; } .none { color: #737b85; }
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
  return figures.empty() ? "" : "<tr class=\"shown\"><td colspan=\"5\">" + figures + "</td></tr>\n";
}

std::string classOf(Verdict verdict) {
  return verdict == Verdict::pass ? "pass" : verdict == Verdict::fail ? "fail" : "none";
}

std::string rowOf(const Finding& finding) {
  const bool isMeasured = finding.verdict != Verdict::notApplicable;
  return "<tr><td>" + escapedHtml(finding.engine) + "</td><td class=\"text\">" + escapedHtml(finding.what) +
         "</td><td>" + (isMeasured ? shortNumber(finding.figure) : "") + "</td><td>" +
         (isMeasured ? shortNumber(finding.bound) : "") + "</td><td class=\"verdict " +
         classOf(finding.verdict) + "\">" + verdictText(finding.verdict) + "</td></tr>\n";
}

// A reason that several rows share is told once, behind the last of them.
std::string rowsOf(const MeasuredCase& one) {
  std::string rows;
  for (std::size_t i = 0; i < one.findings.size(); ++i) {
    rows += rowOf(one.findings[i]);
    if (i + 1 == one.findings.size() || one.findings[i + 1].reason != one.findings[i].reason)
      rows += "<tr><td></td><td class=\"text none\" colspan=\"4\">" + escapedHtml(one.findings[i].reason) +
              "</td></tr>\n";
  }
  return rows;
}

std::string caseRows(const MeasuredCase& one) {
  return "<tr class=\"case\" id=\"" + one.id + "\"><td colspan=\"5\"><span class=\"" +
         classOf(verdictOf(one)) + "\">" + one.id + "</span> " + escapedHtml(one.title) + "</td></tr>\n" +
         rowsOf(one) + picturesOf(one);
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
  body += "<p>Situations in which volume renderers are known to fail, each drawn by the double-precision "
          "reference, "
          "by the ray caster and by slices, with a figure that must not exceed its bound. Grey lines say "
          "what the "
          "figure is and where the bound comes from.</p>\n";
  if (!report.cases.empty()) {
    body += "<table>\n<tr><th>Engine</th><th "
            "class=\"text\">Setting</th><th>Figure</th><th>Bound</th><th>Verdict</th></tr>\n";
    for (const MeasuredCase& one : report.cases)
      body += caseRows(one);
    body += "</table>\n";
  }
  if (report.fuzz)
    body += fuzzText(*report.fuzz);
  return htmlPage("Limn: numerical stability", body, style);
}

} // namespace limn
