// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/ViewInput.h"

#include <QKeyEvent>

#include <gtest/gtest.h>

namespace limn {
namespace {

using namespace viewcommand;

ViewCommand press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  return commandOf(QKeyEvent(QEvent::KeyPress, key, modifiers));
}

TEST(ViewKeys, slicersKeysChooseTheStandardViews) {
  EXPECT_EQ(press(Qt::Key_End), ViewCommand(LookFrom{StandardView::anterior}));
  EXPECT_EQ(press(Qt::Key_End, Qt::ShiftModifier), ViewCommand(LookFrom{StandardView::posterior}));
  EXPECT_EQ(press(Qt::Key_PageDown), ViewCommand(LookFrom{StandardView::left}));
  EXPECT_EQ(press(Qt::Key_PageDown, Qt::ShiftModifier), ViewCommand(LookFrom{StandardView::right}));
  EXPECT_EQ(press(Qt::Key_Home), ViewCommand(LookFrom{StandardView::superior}));
  EXPECT_EQ(press(Qt::Key_Home, Qt::ShiftModifier), ViewCommand(LookFrom{StandardView::inferior}));
  EXPECT_EQ(press(Qt::Key_Insert), ViewCommand(LookFromNearest{}));
}

TEST(ViewKeys, theKeypadWorksWithAndWithoutTheNumberLock) {
  EXPECT_EQ(press(Qt::Key_1, Qt::KeypadModifier), ViewCommand(LookFrom{StandardView::anterior}));
  EXPECT_EQ(press(Qt::Key_End, Qt::KeypadModifier | Qt::ShiftModifier),
            ViewCommand(LookFrom{StandardView::posterior}));
  EXPECT_EQ(press(Qt::Key_3, Qt::KeypadModifier), ViewCommand(LookFrom{StandardView::left}));
  EXPECT_EQ(press(Qt::Key_7, Qt::KeypadModifier), ViewCommand(LookFrom{StandardView::superior}));
  EXPECT_EQ(press(Qt::Key_0, Qt::KeypadModifier), ViewCommand(LookFromNearest{}));
}

TEST(ViewKeys, lettersChooseTheViewsButRResets) {
  EXPECT_EQ(press(Qt::Key_A), ViewCommand(LookFrom{StandardView::anterior}));
  EXPECT_EQ(press(Qt::Key_P), ViewCommand(LookFrom{StandardView::posterior}));
  EXPECT_EQ(press(Qt::Key_L), ViewCommand(LookFrom{StandardView::left}));
  EXPECT_EQ(press(Qt::Key_S), ViewCommand(LookFrom{StandardView::superior}));
  EXPECT_EQ(press(Qt::Key_I), ViewCommand(LookFrom{StandardView::inferior}));
  EXPECT_EQ(press(Qt::Key_R), ViewCommand(Reset{}));
}

TEST(ViewKeys, theRestOfTheTable) {
  EXPECT_EQ(press(Qt::Key_0), ViewCommand(WindowPreset{0}));
  EXPECT_EQ(press(Qt::Key_9), ViewCommand(WindowPreset{9}));
  EXPECT_EQ(press(Qt::Key_W), ViewCommand(UseTool{ViewTool::windowLevel}));
  EXPECT_EQ(press(Qt::Key_M), ViewCommand(UseTool{ViewTool::pan}));
  EXPECT_EQ(press(Qt::Key_Z), ViewCommand(UseTool{ViewTool::zoom}));
  EXPECT_EQ(press(Qt::Key_BracketLeft), ViewCommand(UseTool{ViewTool::rotate}));
  EXPECT_EQ(press(Qt::Key_Left), ViewCommand(Rotate{-1, 0}));
  EXPECT_EQ(press(Qt::Key_Down), ViewCommand(Rotate{0, 1}));
  EXPECT_EQ(press(Qt::Key_Plus, Qt::ShiftModifier), ViewCommand(Zoom{1}));
  EXPECT_EQ(press(Qt::Key_Minus), ViewCommand(Zoom{-1}));
  EXPECT_EQ(press(Qt::Key_Space), ViewCommand(Swap{}));
  EXPECT_EQ(press(Qt::Key_Escape), ViewCommand(Cancel{}));
}

TEST(ViewKeys, leaveTheProgramsShortcutsAlone) {
  EXPECT_EQ(press(Qt::Key_S, Qt::ControlModifier), ViewCommand());
  EXPECT_EQ(press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier), ViewCommand());
  EXPECT_EQ(press(Qt::Key_P, Qt::AltModifier), ViewCommand());
  EXPECT_EQ(press(Qt::Key_F11), ViewCommand());
}

} // namespace
} // namespace limn
