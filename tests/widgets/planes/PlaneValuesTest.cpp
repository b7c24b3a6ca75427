// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlaneHost.h"

#include "support/CoveringPlane.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneDrag.h"
#include "widgets/planes/PlaneOverlay.h"
#include "widgets/planes/PlanePictures.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(PlaneFrame, showsAllOfTheVolumeAndLeadsThereAndBack) {
  const auto volume = test::countingVolume({60, 50, 20}, {1.0, 1.0, 2.0});
  for (const PatientPlane plane : patientPlanes)
    for (const double ratio : {1.0, 1.5, 2.0}) {
      const PlaneFrame frame =
          planeFrame(volume->grid(), plane, {29, 24, 18}, {321, 199}, ratio, std::nullopt);
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
        const QPointF point =
            pointOf(frame, indexToWorld(volume->grid(), side * glm::dvec3(60, 50, 20) - 0.5));
        EXPECT_TRUE(QRectF(0, 0, 321, 199).contains(point));
      }
      const QPointF back = pointOf(frame, worldAt(frame, {12.5, 101.25}));
      EXPECT_NEAR(back.x(), 12.5, 1e-9);
      EXPECT_NEAR(back.y(), 101.25, 1e-9);
      EXPECT_NEAR(glm::dot(worldAt(frame, {5, 5}) - glm::dvec3(29, 24, 18), axesOf(plane).forward), 0.0, 1e-9)
          << "what is seen lies in the slice";
    }
}

TEST(PlaneFrame, inAnotherShapeShowsItsHeightAboutItsMiddle) {
  const auto volume = test::countingVolume({60, 50, 20}, {1.0, 1.0, 2.0});
  const PlaneFrame seen =
      planeFrame(volume->grid(), PatientPlane::coronal, {29, 24, 18}, {320, 200}, 1.5, std::nullopt);
  const auto middle = [](const PlaneFrame& frame) {
    return pixelToWorld(frame.grid, (glm::dvec2(frame.grid.size) - 1.0) / 2.0);
  };
  for (const glm::ivec2& size : {glm::ivec2(512, 512), glm::ivec2(900, 100)}) {
    const PlaneFrame shaped = shapedAs(seen, size);
    EXPECT_EQ(shaped.grid.size, size);
    EXPECT_NEAR(glm::distance(middle(shaped), middle(seen)), 0.0, 1e-9);
    EXPECT_NEAR(shaped.grid.spacingMm * size.y, seen.grid.spacingMm * seen.grid.size.y, 1e-9);
  }
  EXPECT_DOUBLE_EQ(shapedAs(seen, {512, 512}).pixelRatio, 1.5 * 512.0 / 300.0) << "as high as it was";
  EXPECT_DOUBLE_EQ(shapedAs(seen, {900, 100}).pixelRatio, 1.5 * 900.0 / 480.0) << "as wide as it was";
}

TEST(PlanePictures, outlineTheKeptRegionAndTintOnlyIt) {
  const auto volume = test::countingVolume({20, 20, 3}, {1.0, 1.0, 1.0});
  PlaneContent content = test::contentOf(volume);
  std::vector<std::uint8_t> places(20 * 20 * 3, 0);
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = i % 20 >= 10; // kept is the half at the patient's left
  content.keep = bodyRegion({20, 20, 3}, places);
  content.function.points = {{0.0, {1, 0, 0}, 1.0}};
  content.settings.window = GreyWindow{1e6, 1.0}; // black
  content.settings.interpolation = PlaneInterpolation::nearest;
  const PlaneGrid plane = test::coveringPlane(volume->grid(), PatientPlane::axial, {0, 0, 1});
  PlanePictures pictures;
  const auto colorAt = [&](int x) { return pictures.picture(content, plane).pixelColor(x, 5); };
  EXPECT_EQ(colorAt(10), QColor(0xff, 0xc8, 0x3c)) << "the outline";
  EXPECT_EQ(colorAt(9), QColor(Qt::black));
  EXPECT_EQ(colorAt(11), QColor(Qt::black));
  content.settings.isTinted = true;
  EXPECT_EQ(colorAt(9), QColor(Qt::black)) << "not kept";
  EXPECT_EQ(colorAt(11), QColor(179, 0, 0)) << "0.7 of red";
  content.settings.outlinesRegion = false;
  EXPECT_EQ(colorAt(10), QColor(179, 0, 0));
  EXPECT_EQ(pictures.readings(), 1) << "the volume was read once";
  content.keep = {};
  EXPECT_EQ(colorAt(9), QColor(179, 0, 0));
  content.function.points.front().color = {0, 1, 0};
  EXPECT_EQ(colorAt(9), QColor(0, 179, 0)) << "another curve";
  EXPECT_EQ(pictures.readings(), 1);
}

TEST(PlanePictures, outlineLabelsInTheColourOfTheirOwnCurves) {
  const auto volume = test::countingVolume({20, 20, 3}, {1.0, 1.0, 1.0});
  PlaneContent content = test::contentOf(volume);
  std::vector<std::uint8_t> places(20 * 20 * 3, 0);
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = i % 20 >= 10 ? 1 : 0;
  const std::vector<Label> names{{0, "rest", glm::dvec3(1.0)}, {1, "tumour", {0, 0, 1}}};
  content.keep = {Region::Kind::labels,
                  "seg",
                  std::make_shared<const LabelMap>(glm::ivec3(20, 20, 3), places, names),
                  {1.0, 1.0}};
  const PlaneGrid plane = test::coveringPlane(volume->grid(), PatientPlane::axial, {0, 0, 1});
  PlanePictures pictures;
  const auto atEdge = [&] { return pictures.picture(content, plane).pixelColor(10, 5); };
  EXPECT_EQ(atEdge(), QColor(Qt::blue)) << "that of the file";
  content.keep = withLookOf(content.keep, 1, TransferFunction{1.0, {{0.0, {1, 0, 0}, 0.5}}});
  EXPECT_EQ(atEdge(), QColor(Qt::red)) << "as the picture and legends have it";
  content.keep = withLookOf(content.keep, 1, std::nullopt);
  EXPECT_EQ(atEdge(), QColor(Qt::blue));
}

TEST(PlanePictures, showALabelsColourWhereItsLineAndThatOfWhatIsKeptCoincide) {
  const auto volume = test::countingVolume({20, 20, 3}, {1.0, 1.0, 1.0});
  PlaneContent content = test::contentOf(volume);
  std::vector<std::uint8_t> places(20 * 20 * 3, 0);
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = i % 20 >= 15 ? 2 : i % 20 >= 10 ? 1 : 0;
  const std::vector<Label> names{
      {0, "rest", glm::dvec3(1.0)}, {1, "liver", {0, 0, 1}}, {2, "spleen", {1, 0, 0}}};
  content.keep = {Region::Kind::labels,
                  "seg",
                  std::make_shared<const LabelMap>(glm::ivec3(20, 20, 3), places, names),
                  {0.0, 1.0, 0.0}};
  content.settings.interpolation = PlaneInterpolation::nearest;
  const PlaneGrid plane = test::coveringPlane(volume->grid(), PatientPlane::axial, {0, 0, 1});
  const QColor orange(0xff, 0xc8, 0x3c);
  PlanePictures pictures;
  EXPECT_EQ(pictures.picture(content, plane).pixelColor(10, 5), QColor(Qt::blue));
  EXPECT_EQ(pictures.picture(content, plane).pixelColor(14, 5), QColor(Qt::blue));
  EXPECT_TRUE(pictures.hasKeptLineNear({10, 5}, 0)) << "below it";
  EXPECT_TRUE(pictures.hasKeptLineNear({8, 5}, 2));
  EXPECT_FALSE(pictures.hasKeptLineNear({7, 5}, 2));
  EXPECT_FALSE(pictures.hasKeptLineNear({-9, 40}, 2)) << "outside the picture";
  content.keep.weights = {1.0, 0.0, 0.0}; // the background has no line of its own
  EXPECT_EQ(pictures.picture(content, plane).pixelColor(9, 5), orange);
  content.settings.outlinesRegion = false;
  pictures.picture(content, plane);
  EXPECT_FALSE(pictures.hasKeptLineNear({9, 5}, 2)) << "none is painted";
}

TEST(PlanePictures, areCoarseOnlyWhereTheyWouldTakeTooLong) {
  PlaneContent content = test::contentOf(test::countingVolume({40, 40, 20}, glm::dvec3(1.0)));
  const PlaneGrid plane = test::coveringPlane(content.volume->grid(), PatientPlane::axial, {0, 0, 5});
  PlaneGrid next = plane;
  next.originMm.z += 1.0;
  PlanePictures pictures;
  EXPECT_EQ(pictures.coarseness(content, plane, 1e-9), 1) << "nothing tells yet";
  pictures.picture(content, plane);
  EXPECT_EQ(pictures.coarseness(content, plane, 1e-9), 1) << "it is there";
  EXPECT_GT(pictures.coarseness(content, next, 1e-9), 1);
  EXPECT_EQ(pictures.coarseness(content, next, 1e9), 1);
  const double ms = 1e-6;
  const int once = pictures.coarseness(content, next, ms);
  EXPECT_NEAR(pictures.coarseness(content, next, ms / 100.0), 10 * once, 10) << "as the root of the pixels";
  content.settings.slab.thicknessMm = 5.0;
  EXPECT_EQ(pictures.coarseness(content, next, 1e-9), 1) << "another sampling takes another time";
}

TEST(PlaneText, tellsPlaceValueAndWindow) {
  PlaneContent content = test::contentOf(test::countingVolume({60, 50, 20}, {1.0, 1.0, 2.0}));
  EXPECT_EQ(slicePlaceText(content, PatientPlane::axial).replace(QChar(0xa0), ' '), "S 18 mm · 10/20");
  EXPECT_EQ(slicePlaceText(content, PatientPlane::coronal).replace(QChar(0xa0), ' '), "P 24 mm · 25/50");
  content.settings.crosshairMm = glm::dvec3(-0.25, 0.0, 0.0);
  EXPECT_EQ(slicePlaceText(content, PatientPlane::sagittal).replace(QChar(0xa0), ' '), "R 0.3 mm · 1/60");
  content.settings.window = GreyWindow{-600.0, 1500.0};
  EXPECT_EQ(windowText(content), QStringLiteral("W 1500 · L −600"));
  content.settings.slab = {Slab::Mode::maximum, 20.0};
  EXPECT_EQ(windowText(content).replace(QChar(0xa0), ' '), QStringLiteral("max 20 mm · W 1500 · L −600"));
}

TEST(PlaneFrame, showsTheBodyWhereThatAloneIsKept) {
  PlaneContent content = test::contentOf(test::countingVolume({40, 30, 20}, {1.0, 2.0, 3.0}));
  const Grid& all = content.volume->grid();
  EXPECT_EQ(seenGrid(content), all);
  content.keep.kind = Region::Kind::body;
  EXPECT_EQ(seenGrid(content), all) << "it is not found yet";
  std::vector<std::uint8_t> places(40 * 30 * 20, 0);
  content.keep = bodyRegion(all.dims, places);
  EXPECT_EQ(seenGrid(content), all) << "there is none";
  for (int k = 5; k < 15; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 10; i < 20; ++i)
        places[static_cast<std::size_t>(i + 40 * (j + 30 * k))] = 1;
  content.keep = bodyRegion(all.dims, places);
  const Grid seen = seenGrid(content);
  EXPECT_EQ(seen.dims, glm::ivec3(12, 13, 12)) << "one voxel more where there is one";
  EXPECT_EQ(indexToWorld(seen, {0, 0, 0}), indexToWorld(all, {9, 0, 4}));
  EXPECT_EQ(indexToWorld(seen, {11, 12, 11}), indexToWorld(all, {20, 12, 15}));
  content.keep.kind = Region::Kind::labels;
  EXPECT_EQ(seenGrid(content), all) << "labels are shown and hidden in turn, and slices stay where they are";
}

TEST(PlaneText, claimsNoSidesThatTheFileDoesNotTell) {
  const auto known = test::countingVolume({6, 5, 4}, glm::dvec3(1.0));
  VolumeInfo info = known->info();
  info.orientationKnown = false;
  info.spacingKnown = false;
  const PlaneContent content =
      test::contentOf(std::make_shared<const Volume>(known->placed(known->grid(), info)));
  EXPECT_EQ(planeTitle(*content.volume, PatientPlane::axial), QStringLiteral("Columns × rows"));
  EXPECT_FALSE(slicePlaceText(content, PatientPlane::axial).contains('S'));
  const PlaneFrame frame =
      planeFrame(content.volume->grid(), PatientPlane::axial, {}, {300, 200}, 1.0, std::nullopt);
  const PlaneOverlay overlay = planeOverlay(content, PatientPlane::axial, frame, {300, 200}, {});
  EXPECT_FALSE(overlay.letters);
  EXPECT_FALSE(overlay.scale) << "nor a length";
  EXPECT_EQ(overlay.notes.back().text, QStringLiteral("Orientation unknown"));
}

TEST(PlaneOverlay, hasItsSidesAndTextsInsideAndClearOfEachOther) {
  PlaneContent content = test::contentOf(test::countingVolume({60, 50, 20}, {1.0, 1.0, 2.0}));
  const std::array<std::array<const char*, 4>, 3> sides{
      {{"R", "L", "A", "P"}, {"R", "L", "S", "I"}, {"A", "P", "S", "I"}}};
  for (const PatientPlane plane : patientPlanes)
    for (const QSize& size : {QSize(160, 110), QSize(380, 200), QSize(1200, 900)}) {
      const PlaneFrame frame =
          planeFrame(content.volume->grid(), plane, crosshairOf(content), size, 1.0, std::nullopt);
      const PlaneOverlay overlay = planeOverlay(content, plane, frame, size, {});
      const auto& wanted = sides[static_cast<std::size_t>(plane)];
      ASSERT_TRUE(overlay.letters);
      EXPECT_EQ(overlay.letters->letters, (OrientationLetters{wanted[0], wanted[1], wanted[2], wanted[3]}));
      for (const Note& note : overlay.notes)
        EXPECT_TRUE(overlay.view.contains(note.plate)) << note.text.toStdString() << ' ' << size.width();
      EXPECT_EQ(overlay.notes.size(), size.height() < 130 ? 1u : 3u);
      EXPECT_EQ(overlay.scale.has_value(), size.height() >= 130);
      if (overlay.scale) {
        EXPECT_FALSE(overlay.scale->plate.intersects(overlay.notes.back().plate));
      }
    }
}

TEST(PlaneOverlay, outlinesTheCropBoxUnlessItIsNotAsked) {
  PlaneContent content = test::contentOf(test::countingVolume({40, 40, 20}, glm::dvec3(1.0)));
  const PlaneFrame frame =
      planeFrame(content.volume->grid(), PatientPlane::axial, crosshairOf(content), {300, 300}, 1.0, {});
  const auto outline = [&] {
    return planeOverlay(content, PatientPlane::axial, frame, {300, 300}, QFont()).crop;
  };
  EXPECT_TRUE(outline().empty()) << "nothing is cut";
  content.crop = {{0.25, 0.0, 0.0}, {0.75, 0.5, 1.0}};
  ASSERT_EQ(outline().size(), 4);
  // 20 × 20 mm of it, from 9.5 to 29.5 and from -0.5 to 19.5.
  const QRectF box = outline().boundingRect();
  EXPECT_NEAR(box.width(), 20.0 / mmPerLogicalPixel(frame), 1e-9);
  EXPECT_NEAR(box.left(), pointOf(frame, {9.5, 0.0, 0.0}).x(), 1e-9);
  EXPECT_NEAR(box.bottom(), pointOf(frame, {0.0, 19.5, 0.0}).y(), 1e-9);
  const auto title = [&] {
    return planeOverlay(content, PatientPlane::axial, frame, {300, 300}, QFont()).notes.front().text;
  };
  EXPECT_FALSE(title().endsWith(QStringLiteral("outside the crop")));
  const CropBox crop = content.crop;
  content.crop = {{0.0, 0.0, 0.0}, {1.0, 1.0, 0.25}}; // and the slice lies in the middle
  EXPECT_TRUE(outline().empty());
  EXPECT_TRUE(title().endsWith(QStringLiteral("outside the crop"))) << title().toStdString();
  content.crop = crop;
  content.settings.outlinesRegion = false;
  EXPECT_TRUE(outline().empty());
}

TEST(PlaneDeck, placesFillTheRoomAndDoNotOverlap) {
  for (const PlaneLayout layout : planeLayouts)
    for (const PatientPlane large : patientPlanes)
      for (const QSize& size : {QSize(760, 400), QSize(301, 203)}) {
        PlaneSettings settings;
        settings.layout = layout;
        settings.large = large;
        const QRect room(QPoint(0, 30), size);
        const std::array<QRect, 4> places = placesOf(settings, room);
        int area = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
          EXPECT_TRUE(places[i].isEmpty() || room.contains(places[i]));
          area += places[i].isEmpty() ? 0 : places[i].width() * places[i].height();
          for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(places[i].intersects(places[j]));
        }
        const int most = room.width() * room.height();
        EXPECT_GE(area, most - 2 * 2 * (room.width() + room.height())) << "but for lines of 2 pixels between";
        EXPECT_FALSE(places[0].isEmpty()) << "the picture is always there";
        const int widest = std::ranges::max(places, {}, &QRect::width).width();
        if (layout == PlaneLayout::oneLarge) {
          EXPECT_EQ(places[static_cast<std::size_t>(large) + 1].width(), widest);
        }
      }
}

} // namespace
} // namespace limn
