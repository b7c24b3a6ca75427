// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guide/Guide.h"

#include <functional>

namespace limn {

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
