// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/FigureHeading.h"

#include "widgets/figure/FigureText.h"

#include <QFontMetricsF>
#include <QStringList>
#include <QTextLayout>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// In heights of the body's font.
constexpr double firstLine = 1.7; // with the room below the last
constexpr double nextLine = 1.3;
constexpr double afterLetter = 0.6;
constexpr double afterName = 0.8;

double widthOf(const QString& text, const QFont& font) {
  return QFontMetricsF(font).horizontalAdvance(text);
}

// Between words, and within one only where it alone is too long; what a dot joins begins no line with it.
QStringList brokenLines(QString text, const QFont& font, double width) {
  if (widthOf(text, font) <= width)
    return {text};
  text.replace(QStringLiteral(" ·"), QStringLiteral("\u00a0·"));
  QTextLayout broken(text, font);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  broken.setTextOption(option);
  QStringList lines;
  broken.beginLayout();
  for (QTextLine line = broken.createLine(); line.isValid(); line = broken.createLine()) {
    line.setLineWidth(std::max(1.0, width));
    lines << text.mid(line.textStart(), line.textLength()).trimmed();
  }
  broken.endLayout();
  return lines;
}

} // namespace

QFont headingFont(const FigureLayout& layout, HeadingPart::Kind kind) {
  if (kind == HeadingPart::Kind::details)
    return figureFont(layout, noteScale);
  if (kind == HeadingPart::Kind::name)
    return figureFont(layout);
  QFont bold = figureFont(layout, 1.1);
  bold.setBold(true);
  return bold;
}

std::vector<HeadingPart> headingParts(const Figure& figure, std::size_t panel, const FigureLayout& layout,
                                      double width) {
  std::vector<HeadingPart> parts;
  double indent = 0.0;
  if (figure.settings.shows(FigureMark::panelLetters) && figure.panels.size() > 1) {
    const QString letter = panelLetter(panel);
    parts.push_back({HeadingPart::Kind::letter, letter});
    indent =
        widthOf(letter, headingFont(layout, HeadingPart::Kind::letter)) + afterLetter * layout.textPixels;
  }
  if (!figure.settings.shows(FigureMark::names))
    return parts;
  int line = 0;
  const auto add = [&](HeadingPart::Kind kind, const QString& text) {
    for (const QString& words : brokenLines(text, headingFont(layout, kind), width - indent))
      parts.push_back({kind, words, indent, line++});
  };
  const FigurePanel& shown = figure.panels[panel];
  if (!shown.name.isEmpty())
    add(HeadingPart::Kind::name, shown.name);
  const QString details = panelDetails(shown);
  if (details.isEmpty())
    return parts;
  if (line > 0) {
    const double left = indent + afterName * layout.textPixels +
                        widthOf(parts.back().text, headingFont(layout, HeadingPart::Kind::name));
    if (left + widthOf(details, headingFont(layout, HeadingPart::Kind::details)) <= width) {
      parts.push_back({HeadingPart::Kind::details, details, left, line - 1});
      return parts;
    }
  }
  add(HeadingPart::Kind::details, details);
  return parts;
}

double headingHeight(const Figure& figure, const FigureLayout& layout, double width) {
  int last = 0;
  for (std::size_t panel = 0; panel < figure.panels.size(); ++panel)
    for (const HeadingPart& part : headingParts(figure, panel, layout, width))
      last = std::max(last, part.line);
  return std::round((firstLine + nextLine * last) * layout.textPixels);
}

double headingBaseline(const FigureLayout& layout, int line) {
  return QFontMetricsF(figureFont(layout)).ascent() + nextLine * line * layout.textPixels;
}

} // namespace limn
