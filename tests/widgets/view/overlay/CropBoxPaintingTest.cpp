// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ContrastRatio.h"
#include "widgets/view/overlay/CropBoxOverlay.h"

#include <QImage>
#include <QPainter>

#include <gtest/gtest.h>

namespace limn {
namespace {

// The best contrast to the ground along a row of pixels, of those that were painted.
double bestContrast(const QImage& image, int row, const QColor& ground) {
  double best = 1.0;
  for (int x = 0; x < image.width(); ++x)
    best = std::max(best, contrastRatio(image.pixelColor(x, row), ground));
  return best;
}

// WCAG 2.1 asks graphics for 3:1; any grey has that to white or to black.
TEST(CropBoxPainting, handlesAndEdgesStandOutFromTeethBoneAndAir) {
  for (const QColor& ground : {QColor(Qt::white), QColor(236, 228, 208), QColor(122, 128, 138),
                               QColor(180, 180, 180), QColor(60, 60, 60), QColor(Qt::black)})
    for (const bool isHidden : {false, true})
      for (const bool isLively : {false, true}) {
        QImage image(64, 32, QImage::Format_RGB32);
        image.fill(ground);
        CropBoxShape shape;
        const CropFace face{0, true};
        shape.handles.push_back({face, {16.0, 16.0}, {1.0, 0.0}, isHidden, true});
        shape.edges.push_back({QLineF(40.0, 0.0, 40.0, 32.0), isHidden});
        QPainter painter(&image);
        paintCropBox(painter, shape, isLively ? std::optional(face) : std::nullopt);
        painter.end();
        EXPECT_GE(bestContrast(image.copy(0, 0, 32, 32), 16, ground), 3.0) << ground.red() << isHidden;
        EXPECT_GE(bestContrast(image.copy(32, 0, 32, 32), 2, ground), 3.0) << ground.red() << isHidden;
      }
}

// The state of a handle is told by its middle, whatever is behind it.
TEST(CropBoxPainting, aHandleBehindTheBoxLooksOtherThanOneInFront) {
  const auto middle = [](bool isHidden, bool isLively) {
    QImage image(32, 32, QImage::Format_RGB32);
    image.fill(Qt::white);
    CropBoxShape shape;
    const CropFace face{0, true};
    shape.handles.push_back({face, {16.0, 16.0}, {1.0, 0.0}, isHidden, true});
    QPainter painter(&image);
    paintCropBox(painter, shape, isLively ? std::optional(face) : std::nullopt);
    painter.end();
    return image.pixelColor(16, 16);
  };
  EXPECT_GE(contrastRatio(middle(false, false), middle(true, false)), 3.0);
  EXPECT_NE(middle(false, true), middle(false, false));
}

} // namespace
} // namespace limn
