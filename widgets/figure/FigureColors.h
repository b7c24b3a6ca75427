// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/FigureSettings.h"

#include <QColor>

namespace limn {

/// What a figure is printed with on its page; each stands out from it by 4.5:1, lines by 3:1.
struct FigureColors {
  QColor page, text, quiet, line, grid;
};

/// A transparent page is taken to be laid on a light one.
inline FigureColors colorsOn(FigureSettings::Page page) {
  if (page == FigureSettings::Page::black)
    return {QColor(0, 0, 0), QColor(255, 255, 255), QColor(178, 182, 188), QColor(150, 154, 160),
            QColor(60, 62, 66)};
  return {page == FigureSettings::Page::white ? QColor(255, 255, 255) : QColor(Qt::transparent),
          QColor(0, 0, 0), QColor(84, 88, 94), QColor(110, 114, 120), QColor(222, 224, 228)};
}

} // namespace limn
