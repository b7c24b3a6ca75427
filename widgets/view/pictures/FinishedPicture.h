// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Image.h"

#include <QImage>

#include <memory>

namespace limn {

/// A picture over a background as 8 bits (Format_RGBA8888, opaque), rounded as picture files are.
QImage overBackground(const Image& picture, const glm::dvec3& background);

/// The same into a part of an image of four bytes a pixel, red first.
void putOverBackground(const Image& picture, const glm::dvec3& background, QImage& bytes,
                       const glm::ivec2& topLeft);

/// A complete picture of a side as everybody wants it: as drawn, and as shown and saved.
struct FinishedPicture {
  std::shared_ptr<const Image> image;
  QImage bytes; ///< over the background, rounded as a file is
  double contrast = 0.0;
};

/// Makes everything of a picture that was read back. Takes time with every pixel; needs no OpenGL, so that it
/// may run beside the event loop.
FinishedPicture finished(std::shared_ptr<const Image> image, const glm::dvec3& background);

} // namespace limn
