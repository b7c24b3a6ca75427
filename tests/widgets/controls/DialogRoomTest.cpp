// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/DialogRoom.h"

#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QScreen>
#include <QVBoxLayout>

#include <gtest/gtest.h>

namespace limn {
namespace {

const QRect small(0, 0, 800, 560);

TEST(FitInto, makesLargeWindowsSmallerAndLeavesOthersAsTheyAre) {
  QDialog dialog;
  dialog.resize(1100, 660);
  fitInto(dialog, small);
  EXPECT_TRUE(small.contains(QRect({}, dialog.size())));
  EXPECT_GT(dialog.width(), 700);
  dialog.resize(500, 400);
  fitInto(dialog, small);
  EXPECT_EQ(dialog.size(), QSize(500, 400));
}

TEST(FitInto, movesWindowsThatHaveAPlaceIntoTheRoom) {
  QDialog dialog;
  dialog.setGeometry(700, 500, 400, 300);
  fitInto(dialog, small);
  EXPECT_TRUE(small.contains(dialog.geometry()));
  EXPECT_EQ(dialog.size(), QSize(400, 300));
  dialog.setGeometry(-50, -20, 1400, 900);
  fitInto(dialog, small);
  EXPECT_TRUE(small.contains(dialog.geometry()));
}

TEST(DialogRoom, everyDialogThatIsShownFitsItsScreen) {
  DialogRoom room;
  qApp->installEventFilter(&room);
  QDialog dialog;
  dialog.resize(5000, 4000);
  dialog.show();
  EXPECT_TRUE(dialog.screen()->availableGeometry().contains(dialog.geometry()))
      << dialog.width() << 'x' << dialog.height();
}

TEST(WholeScroll, asksForRoomForAllAndTakesLess) {
  auto* content = new QWidget;
  content->setMinimumSize(1500, 700);
  QDialog dialog;
  auto* column = new QVBoxLayout(&dialog);
  auto* scroll = new WholeScroll(content);
  column->addWidget(scroll);
  EXPECT_GE(dialog.sizeHint().width(), 1500);
  EXPECT_GE(dialog.sizeHint().height(), 700);
  dialog.resize(600, 400);
  dialog.show();
  EXPECT_EQ(dialog.size(), QSize(600, 400));
}

} // namespace
} // namespace limn
