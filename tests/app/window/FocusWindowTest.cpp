// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/theme/LookStyle.h"
#include "widgets/view/panels/FocusRing.h"

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QMouseEvent>
#include <QScrollArea>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

// Where the focus is can be seen, and Tab goes everywhere.

namespace limn {
namespace {

class FocusWindowTest : public test::OpenGlWindow, public testing::WithParamInterface<ThemeChoice> {};

// The widget as it is on screen, with what its parents paint around it.
QImage around(const QWidget& widget) {
  QWidget* window = widget.window();
  const QRect place(widget.mapTo(window, QPoint()), widget.size());
  return window->grab(place.adjusted(-3, -3, 3, 3)).toImage();
}

int differingPixels(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < std::min(a.height(), b.height()); ++y)
    for (int x = 0; x < std::min(a.width(), b.width()); ++x)
      count += a.pixel(x, y) != b.pixel(x, y);
  return count;
}

std::string described(const QWidget& widget) {
  return (QString::fromLatin1(widget.metaObject()->className()) + QLatin1Char(' ') + widget.accessibleName() +
          QLatin1Char(' ') + widget.objectName())
      .toStdString();
}

// As where a dialog goes that led to a field, and the pointer rests where it was.
TEST_P(FocusWindowTest, aPointerTakesTheFocusOnceItMovesAndNotBecauseItIsThere) {
  applyTheme(*qApp, GetParam());
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(rest());
  auto* choice = window->findChild<PropertiesPanel*>()->findChild<QComboBox*>();
  ASSERT_NE(choice, nullptr);
  choice->setFocus();
  ASSERT_EQ(window->focusWidget(), choice);
  const QPointF middle = view().rect().center();
  const QPointF global = view().mapToGlobal(middle);
  QEnterEvent enters(middle, middle, global);
  QCoreApplication::sendEvent(&view(), &enters);
  EXPECT_EQ(window->focusWidget(), choice);
  QMouseEvent moves(QEvent::MouseMove, middle, global, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&view(), &moves);
  EXPECT_EQ(window->focusWidget(), &view());
}

TEST_P(FocusWindowTest, tabReachesEveryPanelAndTheFocusShowsOnEachControl) {
  applyTheme(*qApp, GetParam());
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(rest());
  view().setFocus();
  std::set<QWidget*> reached;
  for (int presses = 0; presses < 400; ++presses) {
    QWidget* before = QApplication::focusWidget();
    ASSERT_NE(before, nullptr);
    QTest::keyClick(before, Qt::Key_Tab);
    QWidget* now = QApplication::focusWidget();
    ASSERT_NE(now, nullptr);
    if (now == before)
      continue; // the next point or handle
    if (!reached.insert(now).second && now == &view())
      break;
    QCoreApplication::processEvents();
    EXPECT_FALSE(now->visibleRegion().isEmpty())
        << described(*now); // not behind another panel or scrolled away
    if (now == &view()) {   // a picture that changes by itself
      EXPECT_TRUE(view().findChild<FocusRing*>()->isVisible());
      continue;
    }
    EXPECT_FALSE(view().findChild<FocusRing*>()->isVisible());
    const QImage with = around(*now);
    now->clearFocus();
    const QImage without = around(*now);
    now->setFocus(Qt::TabFocusReason);
    // Half the outline of a small button.
    EXPECT_GE(differingPixels(with, without), 16) << described(*now);
  }
  EXPECT_TRUE(reached.contains(&view()))
      << "after " << reached.size() << ", at " << described(*QApplication::focusWidget());
  EXPECT_TRUE(reached.contains(curves().valueEditor()->canvas()));
  EXPECT_GE(reached.size(), 30u);
}

// A frame around a whole panel looks like a selection, and nobody selected it.
TEST_P(FocusWindowTest, aClickBetweenThePanelsControlsDrawsNoFrameAroundItAndTabDoes) {
  applyTheme(*qApp, GetParam());
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(rest());
  QScrollArea* panel = window->findChild<PropertiesPanel*>();
  ASSERT_NE(panel, nullptr);
  view().setFocus();
  const QImage without = around(*panel);
  QTest::mouseClick(panel, Qt::LeftButton, {}, {1, 1});
  ASSERT_TRUE(panel->hasFocus());
  QCoreApplication::processEvents();
  EXPECT_EQ(differingPixels(around(*panel), without), 0);
  panel->clearFocus();
  panel->setFocus(Qt::TabFocusReason);
  EXPECT_GE(differingPixels(around(*panel), without), 16);
}

// What is typed into nowhere is nobody's: keys of one letter belong to the part that has the keyboard.
TEST_P(FocusWindowTest, lettersTypedWhileNothingHasTheKeyboardDoNothing) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(rest());
  QApplication::focusWidget()->clearFocus();
  ASSERT_EQ(QApplication::focusWidget(), nullptr);
  QTest::mouseMove(window->windowHandle(), QPoint(1, 1)); // over no picture
  const Scene before = scene();
  const ViewTool tool = view().tool();
  const CompareLayout layout = view().compareLayout();
  const QAction& cropBox = *window->findChild<QAction*>(QStringLiteral("cropBox"));
  for (char key = '0'; key <= 'z'; ++key)
    if (std::isalnum(static_cast<unsigned char>(key)))
      QTest::keyClick(window->windowHandle(), key);
  for (const char key : {' ', '[', '+', '-', '?'})
    QTest::keyClick(window->windowHandle(), key);
  EXPECT_EQ(scene(), before);
  EXPECT_EQ(view().tool(), tool);
  EXPECT_EQ(view().compareLayout(), layout);
  EXPECT_FALSE(cropBox.isChecked());
  EXPECT_EQ(undo().count(), 0);
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Theme, FocusWindowTest,
                         testing::Values(ThemeChoice::light, ThemeChoice::dark, ThemeChoice::contrast));

} // namespace
} // namespace limn
