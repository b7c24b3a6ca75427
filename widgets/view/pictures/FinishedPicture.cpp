// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/FinishedPicture.h"

#include "scene/PictureFigures.h"
#include "widgets/view/pictures/PictureBytes.h"

namespace limn {

FinishedPicture finished(std::shared_ptr<const Image> image, const glm::dvec3& background) {
  FinishedPicture picture;
  picture.contrast = contrastOf(*image);
  picture.bytes = overBackground(*image, background);
  picture.upwards = picture.bytes.mirrored();
  picture.image = std::move(image);
  return picture;
}

} // namespace limn
