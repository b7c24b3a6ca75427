// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/SavedOverlay.h"

#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

// Marks over pictures in files of another shape than the view.

namespace limn {
namespace {

OverlaySource sourceOf(CompareLayout layout) {
  OverlaySource source;
  source.comparison.layout = layout;
  source.comparison.scene.volume = phantomVolume({12.0, 0.0, 1});
  source.comparison.scene.camera = defaultCamera(source.comparison.scene.volume->grid());
  source.geometry = {layout, 0.5, {700, 400}, 1.0};
  source.state.sides.resize(static_cast<std::size_t>(pictureCount(layout)));
  return source;
}

TEST(SavedOverlay, isAsLargeAsInAViewOfTheShapeOfTheFile) {
  const OverlaySource view = sourceOf(CompareLayout::single);
  EXPECT_EQ(inFile(view, {1400, 800}).geometry.size, QSize(700, 400)) << "the shape of the view";
  EXPECT_EQ(inFile(view, {512, 512}).geometry.size, QSize(400, 400)) << "as high as the view";
  EXPECT_EQ(inFile(view, {1400, 100}).geometry.size, QSize(700, 50)) << "flatter, and as wide";
}

TEST(SavedOverlay, ofTwoPicturesHasHalfOfTheFileForEach) {
  const ViewGeometry file = inFile(sourceOf(CompareLayout::sideBySide), {600, 400}).geometry;
  EXPECT_EQ(pictureRect(file, 0), QRectF(0, 0, 300, 400));
  EXPECT_EQ(pictureRect(file, 1), QRectF(300, 0, 300, 400)) << "they touch";
}

TEST(SavedOverlay, standsWhereThePictureOfTheFileHasWhatItMarks) {
  for (const CompareLayout layout : {CompareLayout::single, CompareLayout::sideBySide}) {
    const QSize file(512, 512);
    const OverlaySource shown = inFile(sourceOf(layout), file);
    const double factor = static_cast<double>(file.height()) / shown.geometry.size.height();
    const Camera& camera = shown.comparison.scene.camera;
    const int count = standingCount(shown.geometry);
    for (int position = 0; position < count; ++position) {
      const QRectF part(512.0 / count * position, 0.0, 512.0 / count, 512.0); // of the file
      for (const glm::dvec3& world : {camera.target, camera.target + glm::dvec3(30.0, 5.0, -40.0)}) {
        const auto mark = pixelOf(viewProjection(camera, pictureRect(shown.geometry, position)), world);
        const auto drawn = pixelOf(viewProjection(camera, part), world);
        ASSERT_TRUE(mark && drawn);
        EXPECT_NEAR(factor * mark->x(), drawn->x(), 1e-9);
        EXPECT_NEAR(factor * mark->y(), drawn->y(), 1e-9);
      }
    }
    const std::optional<ScaleMark> scale = scaleMarkOf(shown);
    ASSERT_TRUE(scale);
    EXPECT_NEAR(scale->bar.lengthMm / (factor * scale->bar.pixels), mmPerPixel(camera, 512.0), 1e-9);
  }
}

} // namespace
} // namespace limn
