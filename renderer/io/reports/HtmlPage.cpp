// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reports/HtmlPage.h"

namespace limn {
namespace {

const char* const commonStyle = R"(
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

} // namespace

std::string escapedHtml(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '&'   ? "&amp;"
              : c == '<' ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  return result;
}

std::string htmlRow(const std::vector<std::string>& cells, const std::string& kind, const char* tag) {
  std::string row = kind.empty() ? "<tr>" : "<tr class=\"" + kind + "\">";
  for (const std::string& cell : cells)
    row += std::string("<") + tag + ">" + escapedHtml(cell) + "</" + tag + ">";
  return row + "</tr>\n";
}

std::string htmlPage(const std::string& title, const std::string& body, const std::string& style) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" +
         escapedHtml(title) + "</title>\n<style>" + commonStyle + style + "</style>\n</head>\n<body>\n" +
         body + "</body>\n</html>\n";
}

} // namespace limn
