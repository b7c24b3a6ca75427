// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/MeasureMarks.h"

#include "scene/volume/Phantom.h"
#include "widgets/ContrastRatio.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/overlay/SavedOverlay.h"

#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include <gtest/gtest.h>

// What was measured, as it stands above slices and pictures.

namespace limn {
namespace {

using Kind = Measurement::Kind;

constexpr QRectF shownIn(0.0, 0.0, 640.0, 480.0);

MeasureShape distanceShape(const QPointF& from, const QPointF& to, std::size_t number = 0) {
  return {number, Kind::distance, {from, to}, QStringLiteral("23.2 mm"), false};
}

MeasureShape ellipseShape(const QPointF& centre, double a, double b) {
  return {0,
          Kind::ellipse,
          {centre - QPointF(a, 0), centre + QPointF(a, 0), centre - QPointF(0, b), centre + QPointF(0, b),
           centre},
          QStringLiteral("38 ± 12 HU · 123 mm²"),
          false};
}

TEST(MeasureMarks, aTextStandsBesideWhatWasMeasuredAndInTheView) {
  std::vector<MeasureShape> shapes;
  for (const QPointF& to : {QPointF(360, 240), QPointF(280, 240), QPointF(320, 300), QPointF(350, 180),
                            QPointF(321, 241), QPointF(320, 240), QPointF(600, 60)})
    shapes.push_back(distanceShape({320, 240}, to));
  for (const auto& [a, b] : {std::pair(40.0, 20.0), std::pair(5.0, 60.0), std::pair(0.0, 0.0)})
    shapes.push_back(ellipseShape({320, 240}, a, b));
  shapes.push_back({0, Kind::angle, {{300, 200}, {320, 260}, {380, 240}}, QStringLiteral("45.0°"), false});
  shapes.push_back({0, Kind::angle, {{320, 260}, {320, 260}, {320, 260}}, QStringLiteral("none"), false});
  // In the corners, too.
  for (const QPointF& at : {QPointF(2, 2), QPointF(638, 2), QPointF(2, 478), QPointF(638, 478)})
    shapes.push_back({0, Kind::mark, {at}, QStringLiteral("1"), false});
  for (std::size_t n = 0; n < shapes.size(); ++n) {
    const std::vector<MeasureMark> marks = placedMeasures({shapes[n]}, {}, shownIn, {});
    ASSERT_TRUE(marks.front().note) << n;
    const QRectF& plate = marks.front().note->plate;
    EXPECT_FALSE(measuredArea(shapes[n]).intersects(plate)) << n;
    EXPECT_TRUE(shownIn.contains(plate)) << n;
    const QPointF& anchor = marks.front().anchor;
    EXPECT_NE(std::ranges::find(shapes[n].places, anchor), shapes[n].places.end()) << n;
  }
}

TEST(MeasureMarks, textsKeepClearOfEachOtherAndOfWhatIsWritten) {
  std::vector<MeasureShape> shapes;
  for (std::size_t n = 0; n < 12; ++n)
    shapes.push_back(distanceShape({300.0, 200.0 + 6.0 * static_cast<double>(n)},
                                   {340.0, 200.0 + 6.0 * static_cast<double>(n)}, n));
  const std::vector<QRectF> written{{0, 0, 640, 40}, {0, 440, 200, 40}, {350, 150, 60, 30}};
  const std::vector<MeasureMark> marks = placedMeasures(shapes, {}, shownIn, written);
  for (std::size_t a = 0; a < marks.size(); ++a) {
    for (std::size_t b = a + 1; b < marks.size(); ++b)
      EXPECT_FALSE(marks[a].note->plate.intersects(marks[b].note->plate)) << a << ' ' << b;
    for (const QRectF& plate : written)
      EXPECT_FALSE(marks[a].note->plate.intersects(plate)) << a;
  }
}

// Two lines across a head, in one of two narrow pictures beside each other.
TEST(MeasureMarks, aTextStandsAtItsOwnLineNotAtTheEndOfAnother) {
  const QRectF narrow(0, 0, 400, 500);
  const std::vector<MeasureShape> shapes{distanceShape({90, 197}, {310, 197}, 0),
                                         distanceShape({40, 245}, {360, 245}, 1)};
  const std::vector<QRectF> letters{{368, 236, 18, 18}, {14, 236, 18, 18}};
  const std::vector<MeasureMark> marks = placedMeasures(shapes, {}, narrow, letters);
  const auto away = [](const QRectF& plate, const QPointF& point) {
    const QPointF nearest(std::clamp(point.x(), plate.left(), plate.right()),
                          std::clamp(point.y(), plate.top(), plate.bottom()));
    return QLineF(nearest, point).length();
  };
  for (std::size_t n = 0; n < 2; ++n) {
    const QRectF& plate = marks[n].note->plate;
    for (const QPointF& end : shapes[1 - n].places)
      EXPECT_GT(away(plate, end), away(plate, marks[n].anchor)) << n;
    for (const QRectF& letter : letters)
      EXPECT_FALSE(plate.intersects(letter)) << n;
  }
  EXPECT_FALSE(marks[0].note->plate.intersects(marks[1].note->plate));
}

TEST(MeasureMarks, hundredsHaveAPlaceEach) {
  std::vector<MeasureShape> shapes;
  for (std::size_t n = 0; n < 400; ++n)
    shapes.push_back({n,
                      Kind::mark,
                      {{static_cast<double>(n % 20) * 32.0, static_cast<double>(n / 20) * 24.0}},
                      QString::number(n),
                      false});
  for (const MeasureMark& mark : placedMeasures(shapes, {}, shownIn, {}))
    EXPECT_TRUE(shownIn.contains(mark.note->plate)) << mark.shape.number;
  // Nor does a shownIn without room for one make trouble.
  EXPECT_EQ(placedMeasures(shapes, {}, {0, 0, 10, 5}, {}).size(), 400u);
}

TEST(MeasureMarks, aLongNameIsCut) {
  MeasureShape shape = distanceShape({300, 200}, {340, 200});
  shape.text = QString(500, QLatin1Char('W'));
  const std::vector<MeasureMark> marks = placedMeasures({shape}, {}, shownIn, {});
  EXPECT_LE(marks.front().note->plate.width(), 240.0);
  EXPECT_TRUE(marks.front().note->text.endsWith(QChar(0x2026)));
}

TEST(MeasureMarks, theNearestHandleIsTaken) {
  const std::vector<MeasureShape> shapes{distanceShape({100, 100}, {110, 100}, 3),
                                         distanceShape({104, 100}, {200, 200}, 7)};
  EXPECT_EQ(measureHandleAt(shapes, {101, 100}), (MeasureHandle{3, 0}));
  EXPECT_EQ(measureHandleAt(shapes, {105, 101}), (MeasureHandle{7, 0}));
  EXPECT_EQ(measureHandleAt(shapes, {203, 204}), (MeasureHandle{7, 1}));
  EXPECT_FALSE(measureHandleAt(shapes, {210, 210}));
  EXPECT_FALSE(measureHandleAt({}, {0, 0}));
  MeasureShape open = shapes.front();
  open.isOpen = true;
  EXPECT_FALSE(measureHandleAt({open}, {101, 100})) << "what is being measured has none yet";
}

// On any ground, black, white or between: what is written has at least the contrast of small text, 4.5 : 1,
// also of what lies behind what is seen.
TEST(MeasureMarks, textsAreReadOnAnyGround) {
  QFont font;
  font.setPointSize(28); // strokes that cover pixels wholly
  for (const auto& [grey, isHidden] :
       {std::pair(0, false), {90, false}, {128, false}, {200, false}, {255, false}, {0, true}, {255, true}}) {
    QImage image(shownIn.size().toSize(), QImage::Format_RGB32);
    image.fill(QColor(grey, grey, grey));
    QPainter painter(&image);
    painter.setFont(font);
    MeasureShape shape = distanceShape({300, 200}, {340, 200});
    shape.isHidden = isHidden;
    const std::vector<MeasureMark> marks = placedMeasures({shape}, font, shownIn, {});
    paintMeasures(painter, marks);
    painter.end();
    const QRect plate = marks.front().note->plate.toAlignedRect();
    const QColor ground = image.pixelColor(plate.center().x(), plate.top() + 3);
    double best = 0.0;
    for (int x = plate.left(); x <= plate.right(); ++x)
      for (int y = plate.top() + 4; y < plate.bottom() - 3; ++y)
        best = std::max(best, contrastRatio(image.pixelColor(x, y), ground));
    EXPECT_GE(best, 4.5) << grey << (isHidden ? " behind" : " before");
  }
}

// White or amber on a dark border: a line is seen where either would vanish.
TEST(MeasureMarks, linesShowOnWhiteAndOnBlack) {
  for (const QColor& ground : {QColor(Qt::white), QColor(Qt::black)}) {
    QImage image(shownIn.size().toSize(), QImage::Format_RGB32);
    image.fill(ground);
    QPainter painter(&image);
    MeasureShape shape = distanceShape({300, 200}, {400, 200});
    shape.text.clear();
    paintMeasures(painter, placedMeasures({shape}, {}, shownIn, {}));
    painter.end();
    double best = 1.0;
    for (int y = 194; y < 207; ++y)
      best = std::max(best, contrastRatio(image.pixelColor(350, y), ground));
    EXPECT_GE(best, 3.0);
  }
}

TEST(MeasureMarks, picturesHaveThemWhereTheCameraSeesTheirPlaces) {
  OverlaySource source;
  source.comparison.scene.volume = phantomVolume({12.0, 0.0, 1});
  source.comparison.scene.camera = defaultCamera(source.comparison.scene.volume->grid());
  source.comparison.layout = CompareLayout::sideBySide;
  source.geometry = {CompareLayout::sideBySide, 0.5, {700, 400}, 1.0};
  source.state.resting = true;
  source.state.sides.resize(2);
  const Camera& camera = source.comparison.scene.camera;
  const glm::dvec3 behind = camera.position - basisOf(camera).forward * 50.0;
  source.comparison.measures = {
      {4, Kind::distance, {{0, 0, 0}, {20, 0, 10}}, QStringLiteral("22.4 mm"), true},
      {5, Kind::distance, {{0, 0, 0}, behind}, QStringLiteral("far"), false}};
  const Overlay overlay = overlayOf(source);
  ASSERT_EQ(overlay.measures.size(), 2u) << "each of two pictures";
  for (int position = 0; position < 2; ++position) {
    const Overlay::Measures& measures = overlay.measures[static_cast<std::size_t>(position)];
    ASSERT_EQ(measures.marks.size(), 1u) << "what lies behind the eye is not seen";
    const MeasureShape& shape = measures.marks.front().shape;
    EXPECT_EQ(shape.number, 4u);
    EXPECT_TRUE(shape.isInHand);
    EXPECT_EQ(shape.places[1],
              *pixelOf(viewProjection(camera, pictureRect(source.geometry, position)), {20, 0, 10}));
    EXPECT_TRUE(measures.picture.contains(shape.places[0]));
  }
}

TEST(MeasureMarks, eachPictureOfTwoHasThemFaintByWhatItShowsItself) {
  OverlaySource source;
  source.comparison.scene.volume = phantomVolume({12.0, 0.0, 1});
  source.comparison.scene.camera = defaultCamera(source.comparison.scene.volume->grid());
  source.comparison.measures = {{0, Kind::distance, {{0, 0, 0}, {20, 0, 10}}, QStringLiteral("22.4 mm")}};
  const auto isFaintAt = [&source](CompareLayout layout, int position) {
    source.comparison.layout = layout;
    source.geometry = {layout, 0.5, {700, 400}, 1.0};
    return measureShapesOf(source, position).at(0).isHidden;
  };
  source.comparison.measures[0].isHidden = {true, false};
  EXPECT_TRUE(isFaintAt(CompareLayout::single, 0));
  EXPECT_TRUE(isFaintAt(CompareLayout::sideBySide, 0));
  EXPECT_FALSE(isFaintAt(CompareLayout::sideBySide, 1));
  EXPECT_FALSE(isFaintAt(CompareLayout::wipe, 0)) << "the other picture shows it";
  source.comparison.isSwapped = true;
  EXPECT_FALSE(isFaintAt(CompareLayout::sideBySide, 0));
  EXPECT_TRUE(isFaintAt(CompareLayout::sideBySide, 1));
  source.comparison.measures[0].isHidden = {true, true};
  EXPECT_TRUE(isFaintAt(CompareLayout::wipe, 0));
}

// Nobody has a hand on what is in a file.
TEST(SavedMarks, showNoMeasurementAsInHand) {
  OverlaySource source;
  source.comparison.layout = CompareLayout::single;
  source.comparison.scene.volume = phantomVolume({12.0, 0.0, 1});
  const Camera camera = source.comparison.scene.camera =
      defaultCamera(source.comparison.scene.volume->grid());
  source.geometry = {CompareLayout::single, 0.5, {700, 400}, 1.0};
  source.state.sides.resize(1);
  source.comparison.measures = {{0,
                                 Kind::distance,
                                 {camera.target, camera.target + 30.0 * basisOf(camera).right},
                                 QStringLiteral("30 mm"),
                                 true}};
  const auto first = [](const Overlay& overlay) { return overlay.measures.at(0).marks.at(0).shape; };
  ASSERT_TRUE(first(overlayOf(source)).isInHand);
  const MeasureShape saved = first(savedOverlay(source, {}));
  EXPECT_FALSE(saved.isInHand);
  EXPECT_EQ(saved.places.size(), 2u) << "but it is there";
}

// Handles of the usual size would cover all of an ellipse of a few pixels.
TEST(MeasureMarks, theHandlesOfSomethingSmallLeaveItSeen) {
  for (const double radius : {8.0, 60.0}) {
    QImage image(shownIn.size().toSize(), QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    MeasureShape shape = ellipseShape({320, 240}, radius, radius);
    shape.isInHand = true;
    paintMeasures(painter, placedMeasures({shape}, {}, shownIn, {}));
    painter.end();
    int free = 0, inside = 0;
    for (int y = 240 - static_cast<int>(radius) + 2; y < 240 + radius - 2; ++y)
      for (int x = 320 - static_cast<int>(radius) + 2; x < 320 + radius - 2; ++x)
        if (QLineF(QPointF(x, y), QPointF(320, 240)).length() < radius - 2.0) {
          ++inside;
          free += image.pixelColor(x, y) == QColor(Qt::black);
        }
    EXPECT_GT(free, inside / 2) << radius;
  }
}

} // namespace
} // namespace limn
