// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/OrientationCube.h"

#include "scene/volume/Phantom.h"
#include "widgets/ContrastRatio.h"
#include "widgets/view/overlay/Overlay.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

// The cube that shows how a picture lies: which face is where, and that it says nothing wrong.

namespace limn {
namespace {

constexpr std::array views{StandardView::anterior, StandardView::posterior, StandardView::left,
                           StandardView::right,    StandardView::superior,  StandardView::inferior};

std::shared_ptr<const Volume> volumeLying(const glm::dmat3& direction, bool isKnown) {
  Grid grid;
  grid.dims = {3, 4, 5};
  grid.spacingMm = {1.0, 1.5, 2.5};
  grid.originMm = {10.0, -20.0, 30.0};
  grid.direction = direction;
  VolumeInfo info;
  info.orientationKnown = isKnown;
  return std::make_shared<const Volume>(grid, std::vector<float>(60, 1.0f), Rescale{}, std::nullopt, info);
}

// Turned by 20° about z, then by 30° about x.
glm::dmat3 oblique() {
  const double a = 20.0 * std::numbers::pi / 180.0, b = 30.0 * std::numbers::pi / 180.0;
  const glm::dmat3 z(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1);
  const glm::dmat3 x(1, 0, 0, 0, std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b));
  return x * z;
}

glm::dmat3 mirrored() {
  return {glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
}

// From all around, upright and not.
std::vector<Camera> manyCameras(const Volume& volume) {
  std::vector<Camera> cameras;
  const Camera first = defaultCamera(volume.grid());
  for (double yaw = 0.0; yaw < 6.3; yaw += 0.37)
    for (double pitch = -1.5; pitch < 1.6; pitch += 0.41)
      cameras.push_back(rolled(orbited(first, yaw, pitch), 0.3 * yaw));
  return cameras;
}

const CubeSide& inFront(const std::vector<CubeSide>& sides) {
  return *std::ranges::max_element(sides, {}, &CubeSide::facing);
}

class OrientationCubeTest : public testing::Test {
protected:
  OrientationCubeTest() {
    comparison.scene.volume = phantomVolume({12.0, 0.0, 1});
    comparison.scene.camera = defaultCamera(comparison.scene.volume->grid());
    state.resting = true;
    state.sides.resize(2);
  }
  OverlaySource source(const QSize& size = {700, 400}) const {
    OverlaySource source;
    source.comparison = comparison;
    source.geometry = {comparison.layout, comparison.wipe, size, 1.0};
    source.state = state;
    source.hasCube = true;
    return source;
  }
  Comparison comparison;
  PictureState state;
};

TEST_F(OrientationCubeTest, fromEveryStandardViewTheFaceInFrontBearsThePatientsLetter) {
  constexpr std::array letters{"A", "P", "L", "R", "S", "I"};
  for (const glm::dmat3& direction : {glm::dmat3(1.0), mirrored(), oblique(), mirrored() * oblique()}) {
    const auto volume = volumeLying(direction, true);
    const auto faces = cubeFaces(*volume);
    for (std::size_t i = 0; i < views.size(); ++i) {
      const Camera camera = standardView({}, volume->grid(), views[i]);
      const std::vector<CubeSide> sides = cubeSides(faces, camera, {0.0, 0.0}, 72.0);
      ASSERT_EQ(sides.size(), 1u) << "straight on";
      EXPECT_EQ(sides[0].letter, QLatin1String(letters[i]));
      EXPECT_EQ(faces[sides[0].face].view, views[i]);
      // Upright and not mirrored: its right is at the right, its top at the top (y down).
      EXPECT_GT(sides[0].onto.map(QPointF(1.0, 0.0)).x(), 10.0) << letters[i];
      EXPECT_LT(sides[0].onto.map(QPointF(0.0, -1.0)).y(), -10.0) << letters[i];
    }
  }
}

TEST_F(OrientationCubeTest, itsLettersAreThoseAtTheEdgesOfThePicture) {
  const auto faces = cubeFaces(*comparison.scene.volume);
  for (const StandardView view : views) {
    const Camera camera = standardView({}, comparison.scene.volume->grid(), view);
    const OrientationLetters letters = orientationLetters(camera);
    // Turned a little, the next face shows at the edge from which it comes.
    const auto next = [&](double yaw, double pitch) {
      const std::vector<CubeSide> sides = cubeSides(faces, orbited(camera, yaw, pitch), {0.0, 0.0}, 72.0);
      EXPECT_EQ(sides.size(), 2u);
      return std::ranges::min_element(sides, {}, &CubeSide::facing)->letter.toStdString();
    };
    EXPECT_EQ(next(0.4, 0.0), letters.right);
    EXPECT_EQ(next(-0.4, 0.0), letters.left);
    EXPECT_EQ(next(0.0, -0.4), letters.top);
    EXPECT_EQ(next(0.0, 0.4), letters.bottom);
  }
}

TEST_F(OrientationCubeTest, whereSidesAreUnknownItNamesTheAxesOfTheGrid) {
  for (const glm::dmat3& direction : {glm::dmat3(1.0), mirrored(), oblique(), mirrored() * oblique()}) {
    const auto volume = volumeLying(direction, false);
    const Grid& grid = volume->grid();
    for (const CubeFace& face : cubeFaces(*volume)) {
      EXPECT_FALSE(face.view);
      // From there the last index of its axis is nearer than the first, or the other way round.
      const int axis = face.letter[1].unicode() - 'x';
      const bool isLast = face.letter[0] == QLatin1Char('+');
      Camera camera;
      camera.target = boxCentreMm(grid);
      camera.position = camera.target + 500.0 * face.outward;
      camera.up = face.up;
      EXPECT_EQ(inFront(cubeSides(cubeFaces(*volume), camera, {}, 72.0)).letter, face.letter);
      glm::dvec3 first(0.0), last(0.0);
      last[axis] = grid.dims[axis] - 1;
      const double nearer = glm::dot(indexToWorld(grid, last) - indexToWorld(grid, first), face.outward);
      EXPECT_NEAR(nearer, (isLast ? 1.0 : -1.0) * grid.spacingMm[axis] * last[axis], 1e-12); // rounding
      EXPECT_TRUE(face.meaning.contains(isLast ? QStringLiteral("last") : QStringLiteral("first")));
      EXPECT_TRUE(face.meaning.endsWith(axis == 0   ? QStringLiteral("column")
                                        : axis == 1 ? QStringLiteral("row")
                                                    : QStringLiteral("slice")));
    }
  }
}

TEST_F(OrientationCubeTest, ofEachFaceThatIsSeenTheMiddleIsFoundAndNoPointLiesOnTwo) {
  int found = 0;
  for (const Camera& camera : manyCameras(*comparison.scene.volume)) {
    comparison.scene.camera = camera;
    const OverlaySource of = source();
    const OrientationCube cube = *orientationCubeOf(of);
    ASSERT_GE(cube.sides.size(), 1u);
    ASSERT_LE(cube.sides.size(), 3u);
    for (const CubeSide& side : cube.sides) {
      EXPECT_EQ(cubeFaceAt(of, side.onto.map(QPointF(0.0, 0.0))), side.face);
      EXPECT_TRUE(cube.plate.contains(side.outline.boundingRect()));
      EXPECT_GT(side.onto.determinant(), 0.0) << "no letter is mirrored";
      ++found;
    }
    for (double x = cube.plate.left(); x < cube.plate.right(); x += 5.3)
      for (double y = cube.plate.top(); y < cube.plate.bottom(); y += 5.3)
        EXPECT_LE(std::ranges::count_if(cube.sides,
                                        [&](const CubeSide& side) {
                                          return side.outline.containsPoint({x, y}, Qt::OddEvenFill);
                                        }),
                  1);
    EXPECT_FALSE(cubeFaceAt(of, cube.plate.topLeft() - QPointF(2.0, 2.0)));
  }
  EXPECT_GT(found, 250);
}

TEST_F(OrientationCubeTest, aFaceThatIsLookedAtStraightOnLeadsToTheOppositeOne) {
  EXPECT_EQ(cubeFaceLedTo(source(), 0), 1u) << "the phantom is seen from the front";
  EXPECT_EQ(cubeFaceLedTo(source(), 2), 2u);
  const QPointF middle = orientationCubeOf(source())->plate.center();
  EXPECT_EQ(toolTipAt(source(), middle), QStringLiteral("Look from the back"));
  comparison.scene.camera = orbited(comparison.scene.camera, 0.1, 0.0);
  EXPECT_EQ(cubeFaceLedTo(source(), 0), 0u);
  EXPECT_EQ(toolTipAt(source(), middle), QStringLiteral("Look from the front"));
  comparison.scene.camera = rolled(defaultCamera(comparison.scene.volume->grid()), 0.5);
  EXPECT_EQ(cubeFaceLedTo(source(), 0), 0u) << "which stands it upright";
  EXPECT_TRUE(toolTipAt(source(), {350.0, 200.0}).isEmpty());
}

TEST_F(OrientationCubeTest, standsClearOfAllElseOrNotAtAll) {
  comparison.scene.crop.upper.z = 0.5; // so that there is a note, too
  for (const CompareLayout layout : compareLayouts)
    for (const QSize& size : {QSize(300, 300), QSize(602, 300), QSize(700, 400), QSize(1400, 800)})
      for (const double covered : {0.0, 60.0}) {
        comparison.layout = layout;
        OverlaySource of = source(size);
        of.coveredBelow = covered;
        const Overlay overlay = overlayOf(of);
        const QRectF first = of.written(0);
        EXPECT_EQ(overlay.cube.has_value(), first.width() >= 300.0 && first.height() >= 300.0);
        if (!overlay.cube)
          continue;
        const QRectF& plate = overlay.cube->plate;
        EXPECT_TRUE(first.contains(plate));
        for (const Note& note : overlay.notes)
          EXPECT_FALSE(note.plate.intersects(plate)) << note.text.toStdString();
        for (const PlacedLabel& label : overlay.labels)
          EXPECT_FALSE(label.steadyPlate.intersects(plate));
        for (const LetterMarks& letters : overlay.letters)
          for (const auto& place : letters.places)
            EXPECT_FALSE(place && place->intersects(plate));
        EXPECT_FALSE(overlay.scale && overlay.scale->plate.intersects(plate));
        EXPECT_FALSE(overlay.differenceBar && overlay.differenceBar->plate.intersects(plate));
      }
}

TEST_F(OrientationCubeTest, isAbsentWhereItIsSwitchedOffOrNothingStandsAboveThePicture) {
  OverlaySource off = source();
  off.hasCube = false;
  EXPECT_FALSE(overlayOf(off).cube);
  EXPECT_FALSE(cubeFaceAt(off, orientationCubeOf(source())->plate.center()));
  OverlaySource bare = source();
  bare.hasOverlay = false;
  EXPECT_FALSE(cubeFaceAt(bare, orientationCubeOf(source())->plate.center()));
}

TEST_F(OrientationCubeTest, itsLettersAreLegible) {
  for (const bool isLit : {false, true})
    for (double facing = 0.0; facing <= 1.0; facing += 0.125)
      EXPECT_GE(contrastRatio(cubeLetterColor, cubeFaceColor(facing, isLit)), 4.5) << facing; // WCAG 2.1, AA
}

} // namespace
} // namespace limn
