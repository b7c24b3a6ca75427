// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/PictureScreen.h"

#include "scene/PictureFigures.h"

#include <algorithm>

namespace limn {
namespace {

// The nearest; std::lround takes ten times as long.
uchar byteOf(double value) {
  // NOLINTNEXTLINE(bugprone-incorrect-roundings)
  return static_cast<uchar>(std::clamp(value, 0.0, 1.0) * 255.0 + 0.5);
}

} // namespace

QImage overBackground(const Image& picture, const glm::dvec3& background) {
  QImage bytes(picture.size.x, picture.size.y, QImage::Format_RGBA8888);
  putOverBackground(picture, background, bytes, {0, 0});
  return bytes;
}

void putOverBackground(const Image& picture, const glm::dvec3& background, QImage& bytes,
                       const glm::ivec2& topLeft) {
  for (int y = 0; y < picture.size.y; ++y) {
    uchar* row = bytes.scanLine(topLeft.y + y) + std::ptrdiff_t{4} * topLeft.x;
    for (int x = 0; x < picture.size.x; ++x) {
      const glm::vec4& pixel = picture.at(x, y);
      for (int channel = 0; channel < 3; ++channel)
        row[4 * x + channel] = byteOf(pixel[channel] + (1.0 - pixel.a) * background[channel]);
      row[4 * x + 3] = 255;
    }
  }
}

FinishedPicture finished(std::shared_ptr<const Image> image, const glm::dvec3& background) {
  FinishedPicture picture;
  picture.contrast = contrastOf(*image);
  picture.bytes = overBackground(*image, background);
  picture.image = std::move(image);
  return picture;
}

} // namespace limn
