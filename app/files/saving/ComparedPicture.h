// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ImageFile.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Image.h"
#include "widgets/view/overlay/ViewGeometry.h"

#include <string>

class QImage;

namespace limn {

struct Comparison;

/// Marks over a picture of their size, both premultiplied.
Image withMarks(Image image, const QImage& marks);

/// The pixels of what is saved of a view as large as it stands there: pictures beside each other touch.
glm::ivec2 savedSize(const ViewGeometry& geometry);

/// Whether the file of this path takes bytes (by its ending): these have a ground that can be seen through,
/// and a resolution; floats (EXR) always have the former.
bool takesBytes(const std::string& path);

/// A picture as files of bytes have it: colours that are not multiplied by their alpha.
BytePicture bytesWithAlpha(const Image& image);

/// What a saved picture tells of its sides, so that it is drawn and opened as it was. A look is called by the
/// name of the program's preset that it is, and otherwise by none: pictures travel, and names that somebody
/// gave stay here.
ShownSides savedSides(const Comparison& shown);

} // namespace limn
