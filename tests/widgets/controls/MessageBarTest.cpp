// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/MessageBar.h"

#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace limn {
namespace {

void dismiss(const MessageBar& bar) {
  for (QToolButton* button : bar.findChildren<QToolButton*>())
    if (button->text() == QStringLiteral("Dismiss"))
      return QTest::mouseClick(button, Qt::LeftButton);
  FAIL() << "no button to dismiss it";
}

// What is done on dismissal may say the next thing in the same bar, and still needs what it holds afterwards.
TEST(MessageBar, whatIsDoneOnDismissalMaySaySomethingElse) {
  MessageBar bar;
  auto held = std::make_shared<int>(1);
  const std::weak_ptr<int> watched = held;
  bool isHeld = false;
  auto sayNext = [&bar, &watched, &isHeld, held = std::move(held)] {
    const std::weak_ptr<int>& seen = watched;
    bool& told = isHeld;
    bar.show(MessageBar::Kind::error, QStringLiteral("second"));
    told = !seen.expired();
  };
  bar.show(MessageBar::Kind::error, QStringLiteral("first"), {}, {}, {{}, std::move(sayNext)});
  dismiss(bar);
  EXPECT_TRUE(bar.isVisible());
  EXPECT_EQ(bar.sentence(), QStringLiteral("second"));
  EXPECT_TRUE(isHeld) << "as long as it runs";
  dismiss(bar);
  EXPECT_FALSE(bar.isVisible());
}

// It runs once, and what it holds goes with it.
TEST(MessageBar, whatIsDoneOnDismissalIsDoneOnce) {
  MessageBar bar;
  int runs = 0;
  bar.show(MessageBar::Kind::error, QStringLiteral("first"), {}, {}, {{}, [&runs] { ++runs; }});
  dismiss(bar);
  bar.show(MessageBar::Kind::error, QStringLiteral("second"));
  dismiss(bar);
  EXPECT_EQ(runs, 1);
}

// Two things can be done, and it can be dismissed all the same.
TEST(MessageBar, whatItOffersSecondIsDoneByAButtonOfItsOwn) {
  MessageBar bar;
  QStringList done;
  const auto offering = [&done](const char* text) {
    return MessageBar::Action{QString::fromUtf8(text), [&done, text] { done << QString::fromUtf8(text); }};
  };
  bar.show(MessageBar::Kind::error, QStringLiteral("lost"), {}, offering("Search"), {}, offering("Go on"));
  for (QToolButton* button : bar.findChildren<QToolButton*>())
    if (button->text() == QStringLiteral("Go on")) {
      EXPECT_EQ(button->accessibleName(), button->text());
      QTest::mouseClick(button, Qt::LeftButton);
    }
  EXPECT_EQ(done, QStringList(QStringLiteral("Go on")));
  dismiss(bar);
  EXPECT_FALSE(bar.isVisible());
  bar.show(MessageBar::Kind::error, QStringLiteral("found"));
  for (const QToolButton* button : bar.findChildren<QToolButton*>())
    EXPECT_EQ(button->isVisible(), button->text() == QStringLiteral("Dismiss"));
}

} // namespace
} // namespace limn
