// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/frame/Frame.h"
#include "scene/view/PlaneSettings.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/view/gestures/ViewDrag.h"
#include "widgets/view/panels/FocusRing.h"

#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

// From panel to panel by F6, and the picture alone by F11.

namespace limn {
namespace {

class PanelCycleTest : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    ASSERT_TRUE(open(QStringLiteral("phantom:8")));
    ASSERT_TRUE(rest());
    view().setFocus();
  }

  QWidget* press(int key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window->windowHandle(), static_cast<Qt::Key>(key), modifiers);
    QCoreApplication::processEvents();
    return QApplication::focusWidget();
  }

  QWidget* presetList() const { return window->findChild<QTreeView*>(QStringLiteral("presetList")); }
  QWidget& plot() const { return *curves().valueEditor()->canvas(); }
  PropertiesPanel& properties() const { return *window->findChild<PropertiesPanel*>(); }
};

TEST_F(PanelCycleTest, f6GoesRoundThePanelsThatAreSeenAndShiftF6Back) {
  EXPECT_EQ(press(Qt::Key_F6), &plot());
  EXPECT_TRUE(properties().isAncestorOf(press(Qt::Key_F6)));
  EXPECT_EQ(press(Qt::Key_F6), presetList()) << "not the panels behind it, nor slices that are not shown";
  EXPECT_EQ(press(Qt::Key_F6), &view());
  EXPECT_EQ(press(Qt::Key_F6, Qt::ShiftModifier), presetList());
  EXPECT_TRUE(properties().isAncestorOf(press(Qt::Key_F6, Qt::ShiftModifier)));
  EXPECT_EQ(press(Qt::Key_F6, Qt::ShiftModifier), &plot());
}

TEST_F(PanelCycleTest, thePictureIsReachedWhoeverDrawsIt) {
  view().setEngine(Engine::cpu, {});
  ASSERT_TRUE(rest());
  EXPECT_EQ(press(Qt::Key_F6, Qt::ShiftModifier), presetList());
  EXPECT_EQ(press(Qt::Key_F6), &view());
}

TEST_F(PanelCycleTest, slicesComeAfterThePictureWhereTheyAreShown) {
  PlaneSettings settings = session().planes();
  settings.layout = PlaneLayout::pictureAndThree;
  session().setPlanes(settings);
  QCoreApplication::processEvents();
  const QWidget* inSlices = press(Qt::Key_F6);
  EXPECT_TRUE(window->findChild<PlaneDeck*>()->isAncestorOf(inSlices));
  EXPECT_NE(inSlices, &view());
  EXPECT_EQ(press(Qt::Key_F6), &plot());
}

TEST_F(PanelCycleTest, aPanelGoesOnWhereItWasLeft) {
  const QWidget* first = nullptr;
  press(Qt::Key_F6);
  first = press(Qt::Key_F6);
  const QWidget* second = press(Qt::Key_Tab);
  ASSERT_NE(first, second);
  press(Qt::Key_F6);
  EXPECT_EQ(press(Qt::Key_F6, Qt::ShiftModifier), second);
}

TEST_F(PanelCycleTest, theOtherCurveIsEnteredWhereItIsShown) {
  curves().showGradient(true);
  QCoreApplication::processEvents();
  EXPECT_EQ(QApplication::focusWidget(), &view()) << "it takes no keyboard by itself";
  EXPECT_TRUE(curves().gradientEditor()->isAncestorOf(press(Qt::Key_F6)));
}

TEST_F(PanelCycleTest, enterInThePresetListLeadsNowhereAndInTheSearchToThePicture) {
  presetList()->setFocus();
  QTest::keyClick(presetList(), Qt::Key_Down);
  QTest::keyClick(presetList(), Qt::Key_Return);
  EXPECT_EQ(QApplication::focusWidget(), presetList()) << "one goes on through the list";
  EXPECT_EQ(press(Qt::Key_F6), &view());
  auto* search = window->findChild<PresetBrowser*>()->findChild<QLineEdit*>();
  EXPECT_EQ(press(Qt::Key_F, Qt::ControlModifier), search);
  QTest::keyClicks(search, QStringLiteral("bone"));
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(QApplication::focusWidget(), &view());
  EXPECT_TRUE(view().findChild<FocusRing*>()->isVisible()) << "where the keyboard is";
}

// What belongs to no panel is left by F6, and holds nobody.
TEST_F(PanelCycleTest, fromToolBarAndMessagesItLeadsIntoThePanels) {
  const auto expectWayOut = [this](QWidget& from) {
    from.setFocus(Qt::TabFocusReason);
    ASSERT_EQ(QApplication::focusWidget(), &from);
    EXPECT_EQ(press(Qt::Key_F6), presetList());
    EXPECT_EQ(press(Qt::Key_F6), &view());
    from.setFocus(Qt::TabFocusReason);
    EXPECT_TRUE(properties().isAncestorOf(press(Qt::Key_F6, Qt::ShiftModifier)));
  };
  auto* bar = window->findChild<QToolBar*>(QStringLiteral("toolBar"));
  QToolButton* tool = nullptr;
  for (QToolButton* button : bar->findChildren<QToolButton*>())
    if (!tool && button->isVisible() && button->isEnabled() && button->focusPolicy() & Qt::TabFocus)
      tool = button;
  ASSERT_TRUE(tool);
  expectWayOut(*tool);
  messages().show(MessageBar::Kind::question, QStringLiteral("Shall I?"));
  for (QToolButton* button : messages().findChildren<QToolButton*>())
    if (button->isVisible())
      return expectWayOut(*button);
  ADD_FAILURE() << "the message has no button";
}

class PictureAlone : public PanelCycleTest {
protected:
  FadingNote* note() const { return window->findChild<FadingNote*>(); }
};

TEST_F(PictureAlone, aNoteSaysHowToComeBackAndFades) {
  press(Qt::Key_F11);
  ASSERT_TRUE(note());
  EXPECT_TRUE(note()->isVisible());
  EXPECT_TRUE(note()->text().contains(QStringLiteral("F11 or Esc")));
  const QWidget& centre = *window->centralWidget();
  EXPECT_TRUE(test::waitUntil([&] { return centre.width() == window->width(); }));
  const QRect picture = centre.rect();
  EXPECT_NEAR(note()->geometry().center().x(), picture.center().x(), 1) << "where the picture is now";
  EXPECT_TRUE(picture.contains(note()->geometry()));
  EXPECT_TRUE(test::waitUntil([&] { return !note()->isVisible(); }));
  press(Qt::Key_F11);
  EXPECT_FALSE(note()->isVisible());
}

TEST_F(PictureAlone, escBringsThePanelsBackOnceATurnIsADragAgain) {
  press(Qt::Key_F11);
  ASSERT_FALSE(presetList()->isVisible());
  EXPECT_FALSE(curves().isVisible());
  press(Qt::Key_W);
  press(Qt::Key_Escape);
  EXPECT_EQ(view().tool(), ViewTool::rotate);
  EXPECT_FALSE(presetList()->isVisible()) << "the first Esc leaves the tool";
  press(Qt::Key_Escape);
  EXPECT_TRUE(presetList()->isVisible());
  EXPECT_TRUE(curves().isVisible());
  EXPECT_TRUE(window->statusBar()->isVisible());
  EXPECT_FALSE(note()->isVisible());
}

} // namespace
} // namespace limn
