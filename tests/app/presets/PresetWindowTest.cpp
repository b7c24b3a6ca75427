// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "widgets/PresetNames.h"
#include "widgets/presets/PresetBrowser.h"

// Presets in the program's window, by mouse and keys.

namespace limn {
namespace {

class PresetWindow : public test::WindowHarness {
protected:
  PresetBrowser& browser() const { return *window->findChild<PresetBrowser*>(); }
  QTreeView& list() const { return *browser().findChild<QTreeView*>(); }

  void pointTo(const char* preset) {
    const QPoint place = rowOf(browser(), QLatin1String(preset)).center();
    QTest::mouseMove(window->windowHandle(), list().viewport()->mapTo(window.get(), place));
  }
  void click(const char* preset) {
    const QPoint place = rowOf(browser(), QLatin1String(preset)).center();
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {},
                      list().viewport()->mapTo(window.get(), place));
  }
};

TEST_F(PresetWindow, thePresetUnderThePointerIsSeenAndLeavesNothingBehind) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const Scene before = scene();
  const int steps = undo().count();
  pointTo("CT lung");
  ASSERT_TRUE(test::waitUntil([&] { return view().scene() != before; }));
  const Scene seen = view().scene();
  EXPECT_EQ(curves().valueEditor()->canvas()->transferFunction(), seen.transferFunction) << "the curve";
  EXPECT_EQ(scene(), before) << "what is edited";
  QTest::mouseMove(window->windowHandle(), view().mapTo(window.get(), view().rect().center()));
  ASSERT_TRUE(test::waitUntil([&] { return view().scene() == before; }));
  EXPECT_EQ(curves().valueEditor()->canvas()->transferFunction(), before.transferFunction);
  EXPECT_EQ(undo().count(), steps);
  click("CT lung");
  EXPECT_EQ(scene(), seen) << "what was seen is what a click gives";
  EXPECT_EQ(undo().count(), steps + 1);
}

TEST_F(PresetWindow, theKeyboardSeesPresetsBeforeEnterUsesOne) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  click("CT bone");
  const Scene before = scene();
  const int steps = undo().count();
  QTest::keyClick(window->windowHandle(), Qt::Key_Down);
  ASSERT_TRUE(test::waitUntil([&] { return view().scene() != before; }));
  const Scene seen = view().scene();
  EXPECT_EQ(undo().count(), steps);
  QTest::keyClick(window->windowHandle(), Qt::Key_Escape);
  EXPECT_EQ(view().scene(), before);
  QTest::keyClick(window->windowHandle(), Qt::Key_Return);
  EXPECT_EQ(scene(), seen);
  EXPECT_EQ(undo().count(), steps + 1);
}

TEST_F(PresetWindow, aPreviewEndsWhereAnotherVolumeIsOpened) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const Scene before = scene();
  pointTo("CT lung");
  ASSERT_TRUE(test::waitUntil([&] { return view().scene() != before; }));
  ASSERT_TRUE(open(QStringLiteral("phantom:3")));
  EXPECT_EQ(view().scene(), scene());
  EXPECT_NE(scene().volume, before.volume);
}

} // namespace
} // namespace limn
