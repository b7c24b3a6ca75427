// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

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
/// Case does not matter. Links are words; those that leave the guide name their file.
QString guideText(const std::vector<GuideChapter>& chapters, const QString& words = {});

} // namespace limn
