// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <vector>

namespace limn {

/// A chapter of the guide: a document of `app/guide`, which the program carries.
struct GuideChapter {
  QString id;       ///< "gestures": what places in it begin with
  QString path;     ///< below `app/guide`: "presets/README.md"
  QString markdown; ///< as it is read on the forge, too
};

/// The chapters in the order in which they are read.
std::vector<GuideChapter> guideChapters();

/// Where a file of the guide lies within the program: ":/guide/window.png".
QString guideResource(const QString& path);

/// Where a link of a chapter leads, as seen from the guide's folder: "presets/README.md", "../../README.md".
QString guidePathOf(const GuideChapter& chapter, const QString& link);

/// Where such a path lies in the sources, which a reader of the program may not have: "README.md".
QString sourcePathOf(const QString& guidePath);

/// What stands for a link to it: "the README (README.md in Limn's source)".
QString withSource(const QString& words, const QString& sourcePath);

/// The guide for a terminal: every paragraph, line of a table or code that holds all of these words, or
/// stands right under a heading that does, below the headings that it stands under. Without words everything.
/// Case does not matter, nor do words that questions are made of. Where no place holds all others, other
/// names of things count, too (guideWordsOf), and headings may hold some. Links are words; those that leave
/// the guide name their file.
QString guideText(const std::vector<GuideChapter>& chapters, const QString& words = {});

/// A place in the guide that can be gone to.
struct GuideHeading {
  int level; ///< 1: a chapter
  QString text;
  QString anchor; ///< "presets" for a chapter, "presets.files" for a part of it
};

/// The guide as one page.
struct GuidePage {
  QString body; ///< HTML without styles; places have their anchors, links between chapters lead to them
  std::vector<GuideHeading> headings; ///< in the order of the page
};

/// Turns the chapters into one page. `picture` gives the address at which a picture of the guide is found,
/// such as "window.png". Links that lead out of the guide become the name of the file. Needs an application
/// with fonts, because Qt reads the Markdown.
GuidePage guidePage(const std::vector<GuideChapter>& chapters,
                    const std::function<QString(const QString& path)>& picture);

/// The guide as one HTML file with its pictures inside, a list of contents and a field to search.
QString guideFile(const std::vector<GuideChapter>& chapters);

} // namespace limn
