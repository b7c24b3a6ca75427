// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Session.h"

#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

namespace limn {
namespace {

TransferFunction rampTo(double value) {
  return {1.0, {{0.0, glm::dvec3(1), 0.0}, {value, glm::dvec3(1), 1.0}}};
}

// A thread holds a map until it is packed; a minute stands for never.
bool isLetGo(const std::weak_ptr<const LabelMap>& map) {
  const auto never = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!map.expired() && std::chrono::steady_clock::now() < never)
    std::this_thread::yield();
  return map.expired();
}

TEST(Session, aDragIsOneUndoStepWithItsLastName) {
  Session session;
  const Gesture drag{nextGestureId(), "move point to 10 HU"};
  session.setTransferFunction(rampTo(10), drag);
  session.setTransferFunction(rampTo(20), {drag.id, "move point to 20 HU"});
  session.setTransferFunction(rampTo(30), {drag.id, "move point to 30 HU"});
  EXPECT_EQ(session.undoStack().count(), 1);
  EXPECT_EQ(session.undoStack().undoText(), "move point to 30 HU");
  session.undoStack().undo();
  EXPECT_TRUE(session.scene().transferFunction.points.empty());
  session.undoStack().redo();
  EXPECT_EQ(session.scene().transferFunction, rampTo(30));
}

TEST(Session, twoGesturesAreTwoSteps) {
  Session session;
  session.setTransferFunction(rampTo(10), {nextGestureId(), "a"});
  session.setTransferFunction(rampTo(20), {nextGestureId(), "b"});
  EXPECT_EQ(session.undoStack().count(), 2);
  session.undoStack().undo();
  EXPECT_EQ(session.scene().transferFunction, rampTo(10));
}

TEST(Session, slicesAreAWayOfLookingWithoutUndo) {
  Session session;
  std::vector<PlaneSettings> told;
  QObject::connect(&session, &Session::planesChanged, [&](const PlaneSettings& now) { told.push_back(now); });
  PlaneSettings settings;
  settings.crosshairMm = glm::dvec3(1, 2, 3);
  session.setPlanes(settings);
  session.setPlanes(settings);
  EXPECT_EQ(session.planes(), settings);
  EXPECT_EQ(told, std::vector{settings}) << "an equal one changes nothing";
  EXPECT_EQ(session.undoStack().count(), 0);
}

TEST(Session, namedViewsAreAnUndoStepThatLeavesTheScene) {
  Session session;
  int told = 0;
  QObject::connect(&session, &Session::viewsChanged, [&] { ++told; });
  const std::vector<NamedView> one{{"front", Camera{}}};
  session.setViews(one, "keep view \"front\"");
  session.setViews(one, "again");
  EXPECT_EQ(told, 1) << "equal ones change nothing";
  EXPECT_EQ(session.undoStack().count(), 1);
  EXPECT_EQ(session.undoStack().undoText(), "keep view \"front\"");
  EXPECT_TRUE(session.isEdited());
  session.setTransferFunction(rampTo(10), {nextGestureId(), "a"});
  session.setViews({}, "delete view \"front\"");
  session.undoStack().undo();
  EXPECT_EQ(session.views(), one);
  EXPECT_EQ(session.scene().transferFunction, rampTo(10));
  session.undoStack().undo();
  EXPECT_EQ(session.views(), one) << "the curve is another step";
  session.undoStack().undo();
  EXPECT_TRUE(session.views().empty());
  session.undoStack().redo();
  LoadedScene other;
  other.views = {{"side", Camera{}}};
  session.open(other);
  EXPECT_EQ(session.views(), other.views);
  session.open({});
  EXPECT_TRUE(session.views().empty());
}

TEST(Session, theHistoryHoldsNoMapOfLabelsButThatOfTheMoment) {
  Session session;
  std::vector<std::weak_ptr<const LabelMap>> maps;
  for (int n = 0; n < 5; ++n) {
    std::vector<std::uint8_t> places(8, 0);
    places[static_cast<std::size_t>(n)] = 1;
    const auto map =
        std::make_shared<const LabelMap>(glm::ivec3(2), std::move(places), std::vector<Label>(2));
    maps.push_back(map);
    session.setKeep({Region::Kind::labels, "s", map, {1.0, 0.5}}, {nextGestureId(), "keep"});
    session.setTransferFunction(rampTo(n), {nextGestureId(), "curve"});
    EXPECT_EQ(session.scene().keep.labels, map);
  }
  for (std::size_t n = 0; n < 4; ++n)
    EXPECT_TRUE(isLetGo(maps[n])) << n << ": a thread packs them";
  EXPECT_EQ(session.undoStack().count(), 10);
  for (std::size_t n = 5; n-- > 0;) {
    const Region keep = session.scene().keep;
    ASSERT_TRUE(keep.labels);
    EXPECT_EQ(keep.labels->placeAt(n), 1u);
    session.undoStack().undo();
    EXPECT_EQ(session.scene().keep, keep) << "the curve was undone alone";
    session.undoStack().undo();
  }
  EXPECT_EQ(session.scene(), Scene{});
  session.undoStack().redo();
  EXPECT_EQ(session.scene().keep.labels->placeAt(0), 1u);
}

// Each cut of a volume has a map of its own, and a day's work has hundreds of cuts.
TEST(Session, theHistoryTakesBoundedMemoryForLabelsAndUndoesAllOfThem) {
  constexpr glm::ivec3 dims(64, 64, 32);
  constexpr std::size_t voxels = 64 * 64 * 32; // a map without runs takes as many bytes
  constexpr std::size_t most = 3 * voxels;
  constexpr int cuts = 20;
  Session session(nullptr, most);
  const auto placeAt = [](int cut, std::size_t voxel) {
    return static_cast<std::uint8_t>((voxel + static_cast<std::size_t>(cut)) % 2);
  };
  for (int cut = 0; cut < cuts; ++cut) {
    std::vector<std::uint8_t> places(voxels);
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
      places[voxel] = placeAt(cut, voxel);
    std::weak_ptr<const LabelMap> before = session.scene().keep.labels;
    session.setKeep({Region::Kind::labels,
                     "s",
                     std::make_shared<const LabelMap>(dims, std::move(places), std::vector<Label>(2)),
                     {1.0, 0.5}},
                    {nextGestureId(), "cut"});
    EXPECT_TRUE(isLetGo(before)); // which is packed by then
  }
  // Those of the last two cuts may still be packed as the last one comes, and are counted with the next.
  EXPECT_GE(session.labelBytes(), voxels);
  EXPECT_LE(session.labelBytes(), most + 2 * voxels);
  for (int cut = cuts; cut-- > 0;) {
    ASSERT_TRUE(session.scene().keep.labels);
    for (const std::size_t voxel : {std::size_t{0}, voxels / 2, voxels - 1})
      EXPECT_EQ(session.scene().keep.labels->placeAt(voxel), placeAt(cut, voxel)) << cut;
    session.undoStack().undo();
  }
  EXPECT_EQ(session.scene(), Scene{});
}

TEST(Session, theOldestOfManyStepsIsForgotten) {
  Session session;
  for (int n = 0; n <= Session::mostSteps; ++n)
    session.setTransferFunction(rampTo(n + 1), {nextGestureId(), "curve"});
  EXPECT_EQ(session.undoStack().count(), Session::mostSteps);
  session.undoStack().setIndex(0);
  EXPECT_EQ(session.scene().transferFunction, rampTo(1)) << "as the first step left it";
  EXPECT_TRUE(session.isEdited()) << "what was opened cannot be come back to";
}

Measurement distanceTo(double mm) {
  return {Measurement::Kind::distance, PatientPlane::axial, {{0, 0, 0}, {mm, 0, 0}}};
}

TEST(Session, whatIsMeasuredIsOneUndoStepAGestureAndLeavesAllElse) {
  Session session;
  std::vector<std::size_t> told;
  QObject::connect(
      &session, &Session::measurementsChanged,
      [&](const std::vector<Measurement>& measurements) { told.push_back(measurements.size()); });
  const Gesture drag{nextGestureId(), "Distance 5 mm"};
  session.setMeasurements({distanceTo(3)}, {drag.id, "Distance 3 mm"});
  session.setMeasurements({distanceTo(5)}, drag);
  session.setMeasurements({distanceTo(5)}, drag);
  EXPECT_EQ(session.undoStack().count(), 1);
  EXPECT_EQ(session.undoStack().undoText(), QStringLiteral("Distance 5 mm"));
  EXPECT_EQ(told, (std::vector<std::size_t>{1, 1})) << "an equal list changes nothing";
  session.setMeasurements({distanceTo(5), distanceTo(7)}, {nextGestureId(), "Distance 7 mm"});
  session.setTransferFunction(rampTo(10), {nextGestureId(), "a"});
  PlaneSettings elsewhere = session.planes();
  elsewhere.crosshairMm = glm::dvec3(1, 2, 3);
  session.setPlanes(elsewhere);
  session.undoStack().undo();
  EXPECT_EQ(session.measurements().size(), 2u) << "the curve's step is the curve's";
  session.undoStack().undo();
  EXPECT_EQ(session.measurements(), std::vector{distanceTo(5)});
  EXPECT_EQ(session.planes(), elsewhere);
  session.undoStack().undo();
  EXPECT_TRUE(session.measurements().empty());
  session.undoStack().redo();
  session.undoStack().redo();
  EXPECT_EQ(session.measurements(), (std::vector{distanceTo(5), distanceTo(7)}));
}

TEST(Session, aMeasuringDragThatIsCancelledLeavesNoStep) {
  Session session;
  const Gesture drag{nextGestureId(), "Distance 3 mm"};
  session.setMeasurements({distanceTo(3)}, drag);
  session.setMeasurements({}, drag);
  EXPECT_EQ(session.undoStack().count(), 0);
  EXPECT_TRUE(session.measurements().empty());
}

TEST(Session, whatWasMeasuredGoesWithTheVolumeAndComesWithItsSession) {
  Session session;
  LoadedScene loaded;
  loaded.scene.volume = phantomVolume({.spacingMm = 16.0});
  loaded.measurements = {distanceTo(4)};
  session.open(loaded);
  EXPECT_EQ(session.measurements(), loaded.measurements);
  EXPECT_EQ(session.undoStack().count(), 0);
  // Where it lies otherwise they lie there, too; undo brings both back.
  Scene turned = session.scene();
  Grid grid = turned.volume->grid();
  grid.originMm.x += 10.0;
  turned.volume = std::make_shared<const Volume>(turned.volume->placed(grid, turned.volume->info()));
  session.edit(turned, {nextGestureId(), "orient"});
  ASSERT_EQ(session.measurements().size(), 1u);
  for (std::size_t end = 0; end < 2; ++end) {
    const glm::dvec3 moved =
        session.measurements().front().placesMm[end] - loaded.measurements.front().placesMm[end];
    // Rounding: through voxels of 16 mm and back, places of tens of millimetres.
    EXPECT_LT(glm::length(moved - glm::dvec3(10.0, 0.0, 0.0)), 1e-12) << end;
  }
  session.undoStack().undo();
  EXPECT_EQ(session.measurements(), loaded.measurements);
  // Other voxels have nothing of them.
  Scene other = session.scene();
  other.volume = phantomVolume({.spacingMm = 16.0});
  session.edit(other, {nextGestureId(), "other voxels"});
  EXPECT_TRUE(session.measurements().empty());
  session.undoStack().undo();
  EXPECT_EQ(session.measurements(), loaded.measurements);
  loaded.measurements.clear();
  session.open(loaded);
  EXPECT_TRUE(session.measurements().empty());
}

TEST(Session, undoKeepsTheCameraOfTheMoment) {
  Session session;
  session.setTransferFunction(rampTo(10), {nextGestureId(), "a"});
  Camera camera = session.scene().camera;
  camera.position = {1, 2, 3};
  session.setCamera(camera);
  EXPECT_EQ(session.undoStack().count(), 1);
  session.undoStack().undo();
  EXPECT_EQ(session.scene().camera, camera);
  EXPECT_TRUE(session.scene().transferFunction.points.empty());
}

TEST(Session, aDragThatEndsWhereItBeganLeavesNoStep) {
  Session session;
  session.setTransferFunction(rampTo(10), {nextGestureId(), "a"});
  const Gesture drag{nextGestureId(), "b"};
  session.setTransferFunction(rampTo(20), drag);
  session.setTransferFunction(rampTo(10), drag);
  EXPECT_EQ(session.undoStack().count(), 1);
  session.undoStack().undo();
  EXPECT_TRUE(session.scene().transferFunction.points.empty());
}

TEST(Session, tellsEachChangeOnceAndAnEqualSceneNever) {
  Session session;
  std::vector<Scene> told;
  QObject::connect(&session, &Session::sceneChanged, [&](const Scene& scene) { told.push_back(scene); });
  session.setTransferFunction(rampTo(10), {nextGestureId(), "a"});
  session.setTransferFunction(rampTo(10), {nextGestureId(), "b"});
  session.setCamera(session.scene().camera);
  EXPECT_EQ(told.size(), 1u);
}

TEST(Session, openingEndsTheHistory) {
  Session session;
  session.setTransferFunction(rampTo(10), {nextGestureId(), "a"});
  session.open({});
  EXPECT_EQ(session.undoStack().count(), 0);
}

} // namespace
} // namespace limn
