// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recovery/KeepingWindow.h"

#include <QPushButton>

// That work which was kept aside is found again with its volume.

namespace limn {
namespace {

class KeptWork : public test::KeepingWindow {
protected:
  void SetUp() override {
    KeepingWindow::SetUp();
    window->keepSessions();
  }

  MessageBar& bar(const char* name = "keptBar") const {
    return *window->findChild<MessageBar*>(QLatin1String(name));
  }
  const QPushButton& ofTheEmptyPage() const {
    return *window->findChild<QPushButton*>(QStringLiteral("continue"));
  }

  QStringList offered() const {
    QStringList texts;
    for (const QToolButton* button : bar().findChildren<QToolButton*>())
      if (button->isVisible())
        texts << button->text();
    return texts;
  }

  static void choose(const MessageBar& in, const QString& text) {
    for (QToolButton* button : in.findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == text)
        return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << "no button " << text.toStdString();
  }
  void choose(const QString& text) { choose(bar(), text); }

  void openWindowAgain() {
    window = newWindow();
    window->keepSessions();
  }

  // Opens a volume and changes its curve.
  TransferFunction workOn(const QString& source) {
    EXPECT_TRUE(open(source));
    dragAPoint();
    return scene().transferFunction;
  }

  bool opens(const TransferFunction& expected) {
    return test::waitUntil([&] { return scene().transferFunction == expected; });
  }
};

TEST_F(KeptWork, isOfferedWhenItsVolumeOpensAgain) {
  const TransferFunction earlier = workOn(QStringLiteral("phantom:4"));
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  EXPECT_NE(scene().transferFunction, earlier) << "it opens as its file has it";
  ASSERT_TRUE(bar().isVisible());
  EXPECT_TRUE(bar().isNote()) << "it goes by itself";
  EXPECT_TRUE(bar().sentence().startsWith(QStringLiteral("Your earlier work on this volume (")) &&
              bar().sentence().endsWith(QStringLiteral(") is kept.")))
      << bar().sentence().toStdString();
  EXPECT_EQ(offered(), QStringList({QStringLiteral("Continue"), QStringLiteral("Dismiss")}));
  choose(QStringLiteral("Continue"));
  EXPECT_TRUE(opens(earlier));
  EXPECT_TRUE(window->isWindowModified());
  EXPECT_FALSE(bar().isWanted()) << "it is open";
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  EXPECT_FALSE(bar().sentence().contains(QStringLiteral("this volume")));
}

TEST_F(KeptWork, isOfferedBesideThatOnTheVolumeThatWasLeft) {
  const TransferFunction earlier = workOn(QStringLiteral("phantom:4"));
  const TransferFunction other = workOn(QStringLiteral("phantom:6"));
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(bar().isVisible());
  EXPECT_TRUE(bar().sentence().startsWith(QStringLiteral("Your earlier work on this volume (")) &&
              bar().sentence().contains(QStringLiteral(" is kept, and so is your work on ")))
      << bar().sentence().toStdString();
  choose(QStringLiteral("Bring back the other"));
  ASSERT_TRUE(opens(other));
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  choose(QStringLiteral("Continue"));
  EXPECT_TRUE(opens(earlier));
}

TEST_F(KeptWork, isToldOnceWhereTheSameVolumeOpensOverIt) {
  const TransferFunction left = workOn(QStringLiteral("phantom:4"));
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(bar().isVisible());
  EXPECT_EQ(offered(), QStringList({QStringLiteral("Bring back"), QStringLiteral("Dismiss")}));
  choose(QStringLiteral("Bring back"));
  EXPECT_TRUE(opens(left));
}

TEST_F(KeptWork, isFoundByAnotherWindow) {
  const TransferFunction earlier = workOn(QStringLiteral("phantom:4"));
  window->close();
  openWindowAgain();
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  EXPECT_FALSE(bar().isWanted()) << "it is of another volume";
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(bar().isVisible());
  choose(QStringLiteral("Continue"));
  EXPECT_TRUE(opens(earlier));
}

TEST_F(KeptWork, waitsWhileWhatACrashLeftIsOffered) {
  workOn(QStringLiteral("phantom:6"));
  window->close();
  openWindowAgain();
  ASSERT_TRUE(ofTheEmptyPage().isVisible());
  workOn(QStringLiteral("phantom:4"));
  ASSERT_TRUE(waitForAutosave());
  die();
  openWindowAgain();
  ASSERT_TRUE(bar("recoveryBar").isVisible());
  EXPECT_FALSE(ofTheEmptyPage().isVisible()) << "one at a time";
  choose(bar("recoveryBar"), QStringLiteral("Discard"));
  EXPECT_TRUE(ofTheEmptyPage().isVisible());
}

} // namespace
} // namespace limn
