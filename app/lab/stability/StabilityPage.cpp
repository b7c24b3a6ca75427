// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/stability/StabilityText.h"
#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "io/reports/HtmlPage.h"
#include "io/scenefile/SceneFile.h"

#include <algorithm>
#include <array>
#include <utility>

namespace limn {
namespace {

const char* const style = R"(
td { vertical-align: top; } td.text { text-align: left; white-space: normal; }
.pass { color: #1a7f37; } .fail { color: #c4261d; font-weight: 600; } .none { color: #737b85; }
tr.reason td { color: #59626e; font-size: 13px; text-align: left; white-space: normal; padding: 2px 0 6px 0; }
tr.reason.fail td { color: #c4261d; }
tr.case td { border-bottom: none; padding-top: 22px; font-weight: 600; font-size: 15px; white-space: normal; text-align: left; }
tr.shown td { text-align: left; padding: 6px 0 10px; white-space: normal; }
figure { display: inline-block; vertical-align: top; width: 112px; margin: 0 10px 6px 0; font-size: 12px; line-height: 1.3; color: #59626e; }
figure img { width: 112px; height: auto; margin: 0; display: block; image-rendering: pixelated; border-radius: 4px; }
p.sum { font-size: 17px; font-weight: 600; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 2px 16px; margin: 12px 0; font-size: 14px; }
dt { color: #59626e; } dd { margin: 0; } ul { padding-left: 20px; } a { color: inherit; }
@media print {
  @page { size: A4 landscape; margin: 12mm; }
  body { margin: 0; max-width: none; padding: 0; font-size: 11px; }
  table { font-size: 10px; } tr.reason td { font-size: 9px; } tr.case td { font-size: 12px; padding-top: 12px; break-after: avoid; }
  td, th { padding: 2px 5px; } tr { break-inside: avoid; }
}
)";

// Over the dark grey of the program's view, rounded to 8 bits; what is no number becomes magenta.
BytePicture shownImage(const Image& image) {
  constexpr float background = 0.08f;
  BytePicture shown;
  shown.size = image.size;
  for (const glm::vec4& pixel : image.pixels) {
    const glm::vec3 color = glm::vec3(pixel) + (1.0f - pixel.a) * background;
    const bool isNumber = color.r == color.r && color.g == color.g && color.b == color.b;
    const glm::ivec3 bytes =
        isNumber ? glm::ivec3(glm::clamp(color, 0.0f, 1.0f) * 255.0f + 0.5f) : glm::ivec3(255, 0, 255);
    for (int channel = 0; channel < 3; ++channel)
      shown.bytes.push_back(static_cast<std::uint8_t>(bytes[channel]));
  }
  return shown;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::string_view group = bytes.substr(at, 3);
    unsigned bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8 | (i < group.size() ? static_cast<unsigned char>(group[i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i)
      text += i <= group.size() ? letters[bits >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

std::string dataOf(const Image& image) {
  const ScratchFolder folder;
  writeBytes(folder.path() / "picture.png", shownImage(image), "");
  return "data:image/png;base64," + base64(readTextFile(folder.path() / "picture.png"));
}

constexpr std::array<const char*, 6> engines = {"reference", "gl", "slices", "cpu", "cpp", "glsl"};
constexpr std::array<const char*, 6> engineTitles = {"double precision", "ray caster", "slices",
                                                     "CPU engine",       "in C++",     "in GLSL"};

// An error that ended the case stands in no column.
bool isOfAnEngine(const Finding& finding) {
  return std::ranges::find(engines, finding.engine) != engines.end();
}

std::string titleOf(const std::string& engine) {
  const auto found = std::ranges::find(engines, engine);
  return found == engines.end() ? engine : engineTitles[static_cast<std::size_t>(found - engines.begin())];
}

std::string picturesOf(const MeasuredCase& one) {
  constexpr std::size_t most = 9;
  std::string figures;
  std::size_t shown = 0;
  for (const Finding& finding : one.findings)
    for (const Image& picture : finding.pictures)
      if (shown < most) {
        const std::string what = titleOf(finding.engine) + (finding.what.empty() ? "" : ", " + finding.what);
        figures += "<figure><img alt=\"" + escapedHtml(what) + "\" src=\"" + dataOf(picture) + "\">" +
                   escapedHtml(what) + "</figure>";
        ++shown;
      }
  return figures.empty() ? "" : "<tr class=\"shown\"><td colspan=\"6\">" + figures + "</td></tr>\n";
}

std::string classOf(Verdict verdict) {
  return verdict == Verdict::pass ? "pass" : verdict == Verdict::fail ? "fail" : "none";
}

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

// `isOfOne`: it is not the reason of every figure in its row.
std::string reasonRow(const Finding& finding, bool isOfOne) {
  const std::string text = isOfOne ? titleOf(finding.engine) + ": " + finding.reason : finding.reason;
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
    const bool differ = std::ranges::any_of(
        sameSetting, [&](const Finding* row) { return row->reason != sameSetting.front()->reason; });
    for (const Finding* row : sameSetting)
      if (std::ranges::find(told, row->reason) == told.end()) {
        reasons += reasonRow(*row, differ || !isOfAnEngine(*row));
        told.push_back(row->reason);
      }
    sameSetting.clear();
    if (!next || std::ranges::find(told, next->reason) == told.end()) {
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

// Links to what fails and to what cannot apply, each reason once.
std::string outline(const std::vector<MeasuredCase>& cases, Verdict verdict, const char* title) {
  std::string items;
  std::vector<std::string> told;
  for (const MeasuredCase& one : cases)
    for (const Finding& finding : one.findings) {
      const std::string text = titleOf(finding.engine) + ": " + finding.reason;
      if (finding.verdict != verdict || std::ranges::find(told, one.id + text) != told.end())
        continue;
      told.push_back(one.id + text);
      items += "<li><a href=\"#" + one.id + "\">" + one.id + "</a> " + escapedHtml(text) + "</li>\n";
    }
  if (items.empty())
    return {};
  return "<details" + std::string(verdict == Verdict::fail ? " open" : "") + "><summary class=\"" +
         classOf(verdict) + "\">" + title + "</summary>\n<ul>\n" + items + "</ul></details>\n";
}

std::string factsOf(const StabilityReport& report) {
  std::string facts = "<dl>\n";
  for (const auto& [name, text] : {std::pair<const char*, std::string>{"Program", "Limn " + report.version},
                                   {"Driver", report.renderer + ", " + report.driver},
                                   {"Machine", report.machine},
                                   {"Measured", report.date},
                                   {"Command", report.command}})
    facts += "<dt>" + std::string(name) + "</dt><dd>" + escapedHtml(text) + "</dd>\n";
  return facts + "</dl>\n";
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
                     " drawn as slices too, " + std::to_string(fuzz.brickCompared) +
                     " in bricks (largest difference " + shortNumber(fuzz.worstInBricks) + ").</p>\n";
  for (const FuzzFailure& failure : fuzz.failures)
    text += "<p class=\"fail\">" + escapedHtml(lineOf(failure)) + "</p>\n";
  return text;
}

} // namespace

std::string stabilityPage(const StabilityReport& report) {
  std::string body = "<h1>Numerical stability</h1>\n" + factsOf(report) + "<p class=\"sum " +
                     (holds(report) ? "pass" : "fail") + "\">" + escapedHtml(stabilitySummary(report)) +
                     "</p>\n" + outline(report.cases, Verdict::fail, "What fails") +
                     outline(report.cases, Verdict::notApplicable, "What cannot apply, and why");
  body += "<p>Situations in which volume renderers are known to fail, each drawn by the double-precision "
          "reference, by the ray caster, the CPU engine and by slices, with a figure that must not exceed "
          "its bound (\"figure of "
          "bound\"). Grey lines say what the figures above them are and where the bounds come from.</p>\n";
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
