// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "scene/framing/KeptVoxels.h"
#include "widgets/curve/HistogramButton.h"

#include <QMenu>

// What stands behind the curve, in the program's window.

namespace limn {
namespace {

class HistogramWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  }

  TransferFunctionCanvas& plot() const { return *curves().valueEditor()->canvas(); }
  HistogramButton& button() const { return *window->findChild<HistogramButton*>(); }

  void choose(const char* name) { button().menu()->findChild<QAction*>(QLatin1String(name))->trigger(); }

  // Acts in the menu, which runs a loop of its own, until that closes; after many acts in vain it is closed.
  template <class Act>
  void whileOpen(Act&& act) {
    auto* look = new QTimer(window.get());
    QObject::connect(look, &QTimer::timeout, look, [this, act, left = 200]() mutable {
      if (!button().menu()->isVisible())
        return;
      act(*button().menu());
      if (button().menu()->isVisible() && --left == 0)
        button().menu()->close();
    });
    look->start(20);
  }

  // How the plot looks without a pointer over it.
  QImage shown() { return plot().grab().toImage(); }
};

TEST_F(HistogramWindow, itsButtonOpensAMenuThatChangesThePlotAndIsRemembered) {
  const QImage before = shown();
  QAction* linear = button().menu()->findChild<QAction*>(QStringLiteral("histogram-linear"));
  whileOpen([linear](QMenu& menu) {
    QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(linear).center());
  });
  // A menu may close as its window appears below the pointer.
  for (int tries = 0; tries < 5 && !linear->isChecked(); ++tries)
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {},
                      button().mapTo(window.get(), QRectF(button().rect()).center()).toPoint());
  ASSERT_TRUE(linear->isChecked());
  EXPECT_NE(shown(), before);
  const Settings settings(UserFolders::below(folder.path()).settings);
  EXPECT_EQ(settings.histogramView(), (HistogramView{HistogramScale::linear, HistogramPart::whole}));
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(HistogramWindow, theKeyboardReachesIt) {
  button().setFocus();
  ASSERT_TRUE(button().hasFocus());
  QAction* linear = button().menu()->findChild<QAction*>(QStringLiteral("histogram-linear"));
  whileOpen([linear](QMenu& menu) {
    QTest::keyClick(&menu, menu.activeAction() == linear ? Qt::Key_Return : Qt::Key_Down);
  });
  for (int tries = 0; tries < 5 && !linear->isChecked(); ++tries)
    QTest::keyClick(&button(), Qt::Key_Space);
  ASSERT_TRUE(linear->isChecked());
}

TEST_F(HistogramWindow, ofWhatIsKeptFollowsTheCropAndOfWhatIsVisibleTheCurve) {
  const QImage whole = shown();
  session().setCrop({{0.0, 0.0, 0.0}, {1.0, 0.3, 1.0}}, {nextGestureId(), "crop"});
  EXPECT_EQ(shown(), whole) << "of the whole volume all count";
  choose("histogram-kept");
  ASSERT_TRUE(test::waitUntil([&] { return shown() != whole; }));
  const QImage kept = shown();
  session().setCrop({}, {nextGestureId(), "uncut"});
  EXPECT_TRUE(test::waitUntil([&] { return shown() == whole; }));
  undo().undo();
  EXPECT_TRUE(test::waitUntil([&] { return shown() == kept; }));
  choose("histogram-visible");
  const QImage visible = shown();
  EXPECT_NE(visible, kept) << "without the air around the head";
  choose("histogram-whole");
  EXPECT_EQ(shown(), whole);
}

} // namespace
} // namespace limn
