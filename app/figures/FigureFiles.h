// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/figures/FigureMaker.h"

#include <QImage>

#include <filesystem>
#include <string>

namespace limn {

/// The kinds of files that a figure can be written as.
enum class FigureFormat { png, tiff, exr, pdf };

/// By the ending. Throws Error (usage) that names the endings there are.
FigureFormat figureFormatOf(const std::filesystem::path& path);

/// What of a figure's pictures a format needs.
inline FigurePixels pixelsFor(FigureFormat format) {
  return format == FigureFormat::exr ? FigurePixels::floats : FigurePixels::bytes;
}

/// The figure as a picture, marks and all.
QImage imageOf(const MadeFigure& made);

/// Writes a figure: PNG and TIFF in 8 bits, EXR as premultiplied floats whose pictures have no background,
/// PDF with its text as text and its pictures without loss. `description` (figureToJson) goes along, so that
/// the figure can be opened again. Complete or untouched. Throws Error.
void writeFigure(const std::filesystem::path& path, const MadeFigure& made, const std::string& description);

} // namespace limn
