// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Session.h"

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

TEST(Session, aMeasuredDistanceIsAnUndoStepThatLeavesTheRestOfTheSlices) {
  Session session;
  const auto measure = [&](const std::optional<MeasuredDistance>& distance) {
    PlaneSettings settings = session.planes();
    const auto before = std::exchange(settings.distance, distance);
    session.setPlanes(settings);
    session.noteDistance(before);
  };
  const MeasuredDistance first{PatientPlane::axial, {0, 0, 0}, {3, 4, 0}};
  measure(first);
  measure(first);
  EXPECT_EQ(session.undoStack().count(), 1) << "an equal one is no step";
  measure(std::nullopt);
  EXPECT_EQ(session.undoStack().undoText(), QStringLiteral("remove distance"));
  session.setTransferFunction(rampTo(10), {nextGestureId(), "a"});
  PlaneSettings elsewhere = session.planes();
  elsewhere.crosshairMm = glm::dvec3(1, 2, 3);
  session.setPlanes(elsewhere);
  session.undoStack().undo();
  session.undoStack().undo();
  EXPECT_EQ(session.planes().distance, first);
  EXPECT_EQ(session.planes().crosshairMm, elsewhere.crosshairMm);
  session.undoStack().undo();
  EXPECT_FALSE(session.planes().distance);
  session.undoStack().redo();
  EXPECT_EQ(session.planes().distance, first);
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
