// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/UndoStep.h"

#include <QObject>
#include <QUndoCommand>
#include <QUndoStack>

#include <gtest/gtest.h>

#include <optional>

namespace limn {
namespace {

/// A stack that holds three steps, and one of its steps that is followed.
class FollowedStep : public testing::Test {
protected:
  FollowedStep() {
    stack.setUndoLimit(3);
    QObject::connect(&stack, &QUndoStack::indexChanged, &stack, [this] {
      if (step)
        step->follow();
    });
  }

  void push(int count = 1) {
    for (int n = 0; n < count; ++n)
      stack.push(new QUndoCommand);
  }

  QUndoStack stack;
  std::optional<UndoStep> step;
};

TEST_F(FollowedStep, isUndoneAndDoneAgain) {
  push(2);
  step.emplace(stack);
  EXPECT_TRUE(step->isDone());
  push();
  stack.undo();
  EXPECT_TRUE(step->isDone()) << "another was undone";
  stack.undo();
  EXPECT_FALSE(step->isDone());
  stack.redo();
  EXPECT_TRUE(step->isDone());
}

TEST_F(FollowedStep, isTheSameWhereTheOldestStepsAreForgotten) {
  push(3);
  step.emplace(stack);
  push();
  stack.undo();
  EXPECT_TRUE(step->isDone()) << "its number is that of the one before now";
  stack.undo();
  EXPECT_FALSE(step->isDone());
}

TEST_F(FollowedStep, holdsForGoodOnceItIsForgottenItself) {
  push();
  step.emplace(stack);
  push(5);
  EXPECT_TRUE(step->isDone());
  for (int n = 0; n < 3; ++n)
    stack.undo();
  EXPECT_TRUE(step->isDone()) << "nothing takes it back any more";
}

TEST_F(FollowedStep, isGoneOnceAnotherIsDoneInItsPlace) {
  push(2);
  step.emplace(stack);
  stack.undo();
  push(2);
  EXPECT_FALSE(step->isDone());
  stack.undo();
  push();
  EXPECT_FALSE(step->isDone());
}

TEST_F(FollowedStep, goesWithTheWholeStack) {
  push();
  step.emplace(stack);
  stack.clear();
  EXPECT_FALSE(step->isDone());
  push();
  EXPECT_FALSE(step->isDone());
}

TEST_F(FollowedStep, isNoneOfAStackWithoutAny) {
  step.emplace(stack);
  EXPECT_FALSE(step->isDone());
  push();
  EXPECT_FALSE(step->isDone());
}

} // namespace
} // namespace limn
