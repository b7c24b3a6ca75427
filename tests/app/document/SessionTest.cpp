// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Session.h"

#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

#include <vector>

namespace limn {
namespace {

TransferFunction rampTo(double value) {
  return {1.0, {{0.0, glm::dvec3(1), 0.0}, {value, glm::dvec3(1), 1.0}}};
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
  // Where it lies otherwise its places mean nothing; undo brings both back.
  Scene turned = session.scene();
  Grid grid = turned.volume->grid();
  grid.originMm.x += 10.0;
  turned.volume = std::make_shared<const Volume>(turned.volume->placed(grid, turned.volume->info()));
  session.edit(turned, {nextGestureId(), "orient"});
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
