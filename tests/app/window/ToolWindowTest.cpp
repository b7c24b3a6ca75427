// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "scene/view/PlaneSettings.h"
#include "widgets/controls/FoldingSection.h"
#include "widgets/planes/PlaneBar.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/view/gestures/ViewDrag.h"

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>

// The tools of the left button, in the program's window.

namespace limn {
namespace {

class ToolWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:6")));
  }

  QString checkedTool() const {
    QStringList checked;
    for (const QAction* one : window->findChild<QToolBar*>()->actions())
      if (one->isChecked() && one->objectName().startsWith(QStringLiteral("tool-")))
        checked << one->objectName().mid(5);
    return checked.join(QLatin1Char(' '));
  }

  QDialog* listOfKeys() const {
    for (QDialog* one : window->findChildren<QDialog*>())
      if (one->windowTitle() == QStringLiteral("Mouse and keys"))
        return one;
    return nullptr;
  }

  QWidget* button(const char* tool) const {
    auto* bar = window->findChild<QToolBar*>();
    return bar->widgetForAction(window->findChild<QAction*>(QStringLiteral("tool-") + QLatin1String(tool)));
  }

  void dragInThePicture() {
    const QPoint from = view().mapTo(window.get(), QPoint(view().width() / 2, view().height() / 2));
    QWindow* handle = window->windowHandle();
    QTest::mousePress(handle, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 3; ++step)
      QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, from + QPoint(9 * step, 5 * step));
    QTest::mouseRelease(handle, Qt::LeftButton, {}, from + QPoint(27, 15));
    QCoreApplication::processEvents();
  }
};

TEST_F(ToolWindow, theToolBarShowsAndChoosesTheTool) {
  EXPECT_EQ(checkedTool(), QStringLiteral("rotate"));
  ASSERT_TRUE(button("pan")->isVisible());
  QTest::mouseClick(button("pan"), Qt::LeftButton);
  EXPECT_EQ(checkedTool(), QStringLiteral("pan"));
  EXPECT_EQ(view().cursor().shape(), Qt::SizeAllCursor);
  const Camera before = scene().camera;
  dragInThePicture();
  EXPECT_NE(scene().camera.target, before.target);
  EXPECT_NEAR(glm::dot(basisOf(scene().camera).forward, basisOf(before).forward), 1.0, 1e-12);

  QTest::mouseClick(button("zoom"), Qt::LeftButton);
  EXPECT_EQ(checkedTool(), QStringLiteral("zoom"));
  EXPECT_EQ(view().cursor().shape(), Qt::BitmapCursor);
  const Camera panned = scene().camera;
  dragInThePicture();
  EXPECT_EQ(scene().camera.target, panned.target);
  EXPECT_NE(scene().camera.position, panned.position);
}

// The buttons of the models come and go with the layout; nothing else may move for them.
TEST_F(ToolWindow, everyButtonKeepsItsPlaceInEveryLayout) {
  window->resize(1380, 640); // every button fits
  auto* bar = window->findChild<QToolBar*>();
  const auto places = [bar] {
    QCoreApplication::processEvents();
    std::vector<QPoint> corners;
    for (QAction* action : bar->actions())
      if (!action->objectName().isEmpty() && action->objectName() != QStringLiteral("savePicture"))
        corners.push_back(bar->widgetForAction(action)->pos());
    return corners;
  };
  const std::vector<QPoint> single = places();
  ASSERT_GE(single.size(), 14u);
  setLayout(CompareLayout::sideBySide);
  EXPECT_EQ(places(), single);
  EXPECT_TRUE(window->findChild<QToolButton*>(QStringLiteral("rightModelButton"))->isVisible());
}

TEST_F(ToolWindow, keysChooseToolsAndEscReturnsToRotating) {
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_W);
  EXPECT_EQ(checkedTool(), QStringLiteral("window-level"));
  EXPECT_EQ(view().cursor().shape(), Qt::BitmapCursor);
  dragInThePicture();
  EXPECT_EQ(undo().count(), 1) << "the window was dragged";
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_EQ(checkedTool(), QStringLiteral("rotate"));
  EXPECT_EQ(view().cursor().shape(), Qt::ArrowCursor);
  const Camera before = scene().camera;
  dragInThePicture();
  EXPECT_EQ(undo().count(), 1);
  EXPECT_NE(scene().camera, before);
  QTest::keyClick(&view(), Qt::Key_M);
  EXPECT_EQ(checkedTool(), QStringLiteral("pan"));
  QTest::keyClick(&view(), Qt::Key_BracketLeft);
  EXPECT_EQ(checkedTool(), QStringLiteral("rotate"));
}

TEST_F(ToolWindow, escCancelsADragFirst) {
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_Z);
  const Camera before = scene().camera;
  const QPoint from = view().mapTo(window.get(), QPoint(60, 60));
  QTest::mousePress(window->windowHandle(), Qt::LeftButton, {}, from);
  QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, {}, from + QPoint(0, 20));
  QCoreApplication::processEvents();
  ASSERT_NE(scene().camera, before);
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_EQ(scene().camera, before);
  EXPECT_EQ(checkedTool(), QStringLiteral("zoom"));
  QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, from);
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_EQ(checkedTool(), QStringLiteral("rotate"));
}

TEST_F(ToolWindow, escReturnsToRotatingWhereverTheKeyboardIs) {
  view().setTool(ViewTool::windowLevel);
  auto* search = window->findChild<PresetBrowser*>()->findChild<QLineEdit*>();
  search->setFocus();
  QTest::keyClick(search, Qt::Key_M); // a letter there
  EXPECT_EQ(checkedTool(), QStringLiteral("window-level"));
  QTest::keyClick(search, Qt::Key_Escape); // empties the field
  EXPECT_TRUE(search->text().isEmpty());
  EXPECT_EQ(checkedTool(), QStringLiteral("window-level"));
  QTest::keyClick(search, Qt::Key_Escape);
  EXPECT_EQ(checkedTool(), QStringLiteral("rotate"));
}

TEST_F(ToolWindow, aButtonWithAMenuDoesNotLookHoveredOnceTheMenuIsClosed) {
  auto* open = window->findChild<QToolButton*>(QStringLiteral("openButton"));
  const QPoint arrow = open->mapTo(window.get(), QPoint(open->width() - 6, open->height() / 2));
  const QImage idleLook = open->grab().toImage();
  QCursor::setPos(window->mapToGlobal(arrow)); // the pointer of the display
  ASSERT_TRUE(test::waitUntil([&] { return open->underMouse(); }));
  EXPECT_NE(open->grab().toImage(), idleLook);
  bool wasOpen = false;
  QTimer leave;
  QObject::connect(&leave, &QTimer::timeout, &leave, [&] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    const QPoint elsewhere = view().mapToGlobal(view().rect().center());
    if (!menu)
      return;
    wasOpen = true;
    if (QCursor::pos() != elsewhere)
      return QCursor::setPos(elsewhere);
    leave.stop();
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(menu->actions().back()).center());
  });
  leave.start(10);
  QTest::mousePress(window->windowHandle(), Qt::LeftButton, {}, arrow); // until the menu is closed
  ASSERT_TRUE(test::waitUntil([&] { return wasOpen; }));
  EXPECT_TRUE(test::waitUntil([&] { return !open->underMouse(); }));
  EXPECT_FALSE(open->isDown());
  QCoreApplication::processEvents();
  EXPECT_EQ(open->grab().toImage(), idleLook);
}

TEST_F(ToolWindow, aButtonDoesNotLookHoveredOnceItsDialogIsClosed) {
  auto* open = window->findChild<QToolButton*>(QStringLiteral("openButton"));
  const QPoint icon = open->mapTo(window.get(), QPoint(12, open->height() / 2));
  const QImage idleLook = open->grab().toImage();
  QCursor::setPos(window->mapToGlobal(icon)); // the pointer of the display
  ASSERT_TRUE(test::waitUntil([&] { return open->underMouse(); }));
  EXPECT_NE(open->grab().toImage(), idleLook);
  const QPoint elsewhere = view().mapToGlobal(view().rect().center());
  onceAsked<QFileDialog>([elsewhere](QFileDialog& dialog) {
    QCursor::setPos(elsewhere);
    ASSERT_TRUE(test::waitUntil([&] { return QCursor::pos() == elsewhere; }));
    dialog.reject();
  });
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, icon); // until the dialog is closed
  EXPECT_TRUE(test::waitUntil([&] { return !open->underMouse(); }));
  QCoreApplication::processEvents();
  EXPECT_EQ(open->grab().toImage(), idleLook);
}

TEST_F(ToolWindow, theWindowsOfTheSlicesDoNotLookHoveredOnceTheirMenuIsLeft) {
  PlaneSettings settings = session().planes();
  settings.layout = PlaneLayout::pictureAndThree;
  session().setPlanes(settings);
  QCoreApplication::processEvents();
  QToolButton* button = nullptr;
  for (QToolButton* one : window->findChild<PlaneBar*>()->findChildren<QToolButton*>())
    if (one->text() == QStringLiteral("Window"))
      button = one;
  ASSERT_NE(button, nullptr);
  const QImage idleLook = button->grab().toImage();
  const QPoint middle = button->mapTo(window.get(), button->rect().center());
  QCursor::setPos(window->mapToGlobal(QPoint(1, 1))); // one that is there already does not enter
  ASSERT_TRUE(test::waitUntil([&] { return !button->underMouse(); }));
  int nudge = 0; // the X server may tell of its own pointer late, and of one that does not move never
  ASSERT_TRUE(test::waitUntil([&] {
    nudge = 1 - nudge;
    QCursor::setPos(window->mapToGlobal(middle + QPoint(nudge, 0)));
    return button->underMouse();
  }));
  QTimer leave;
  bool wasOpen = false;
  QObject::connect(&leave, &QTimer::timeout, &leave, [&] {
    if (QWidget* menu = QApplication::activePopupWidget()) {
      wasOpen = true;
      // As people leave it: the pointer is elsewhere, which the menu keeps from the button.
      QCursor::setPos(window->mapToGlobal(QPoint(1, 1)));
      QTest::keyClick(menu, Qt::Key_Escape); // again where the menu did not listen yet
    }
  });
  leave.start(10);
  QTest::mousePress(window->windowHandle(), Qt::LeftButton, {}, middle); // until the menu is closed
  leave.stop();
  EXPECT_TRUE(wasOpen);
  QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, middle);
  EXPECT_TRUE(test::waitUntil([&] { return !button->underMouse(); }));
  EXPECT_EQ(button->grab().toImage(), idleLook);
}

TEST_F(ToolWindow, theListOfKeysNamesThem) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")) && rest());
  view().setFocus();
  EXPECT_EQ(listOfKeys(), nullptr);
  QTest::keyClick(window->windowHandle(), Qt::Key_Question, Qt::ShiftModifier);
  QDialog* dialog = listOfKeys();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(QRect(0, 0, 1280, 800).contains(QRect({}, dialog->sizeHint()))) << "on a small screen";
  EXPECT_TRUE(QRect(0, 0, 800, 520).contains(QRect({}, dialog->minimumSizeHint()))) << "on a smaller one";
  EXPECT_TRUE(dialog->screen()->availableGeometry().contains(dialog->geometry()));
  dialog->resize(700, 480);
  const auto* close = dialog->findChild<QPushButton*>();
  ASSERT_TRUE(test::waitUntil([&] { return dialog->rect().contains(close->geometry()); }));
  const auto* scroll = dialog->findChild<QScrollArea*>();
  const QSize small = dialog->size();
  dialog->resize(dialog->sizeHint());
  EXPECT_TRUE(test::waitUntil([&] { return dialog->size() != small; }));
  EXPECT_TRUE(test::waitUntil([&] { return scroll->verticalScrollBar()->maximum() == 0; }))
      << "where it has room nothing folds";
  for (const int width : {1008, 784, 700}) { // of windows on screens of 1024 and 800 pixels
    dialog->resize(width, 480);
    ASSERT_TRUE(test::waitUntil([&] { return dialog->width() == width; }));
    QCoreApplication::processEvents();
    EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0) << width;
    for (const QLabel* label : scroll->findChildren<QLabel*>())
      EXPECT_GE(label->height(), label->hasHeightForWidth() ? label->heightForWidth(label->width())
                                                            : label->sizeHint().height())
          << width << ": " << label->text().toStdString() << " is cut";
  }
  QString text;
  for (const QLabel* label : dialog->findChildren<QLabel*>())
    text += label->text();
  for (const char* key : {"[ · M · Z · W", "Esc", "PgUp PgDn", "Del", "Ctrl+Shift+S", "Ctrl+Shift+P"})
    EXPECT_TRUE(text.contains(QString::fromUtf8(key))) << key;
  dialog->close();
}

TEST_F(ToolWindow, oneButtonOffersAllThatMeasures) {
  auto* measure = qobject_cast<QToolButton*>(button("distance"));
  ASSERT_TRUE(measure && measure->menu());
  QStringList offered;
  for (const QAction* one : measure->menu()->actions())
    offered << one->objectName();
  for (const char* tool : {"tool-distance", "tool-angle", "tool-mark"})
    EXPECT_TRUE(offered.contains(QLatin1String(tool))) << tool;
  measure->menu()->actions()[1]->trigger();
  EXPECT_EQ(view().tool(), ViewTool::angle);
  EXPECT_EQ(measure->defaultAction()->objectName(), QStringLiteral("tool-angle"));
  EXPECT_TRUE(measure->isChecked());
  // By a key, too; and it leads back to the one used last.
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_N);
  EXPECT_EQ(measure->defaultAction()->objectName(), QStringLiteral("tool-mark"));
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_FALSE(measure->isChecked());
  QTest::mouseClick(measure, Qt::LeftButton, {}, QPoint(8, measure->height() / 2));
  EXPECT_EQ(view().tool(), ViewTool::mark);
}

TEST_F(ToolWindow, theListOfKeysComesWhereverTheKeyboardIs) {
  auto* header = window->findChild<PropertiesPanel*>()->findChild<FoldingHeader*>();
  ASSERT_NE(header, nullptr);
  header->setFocus();
  ASSERT_TRUE(header->hasFocus());
  QTest::keyClick(window->windowHandle(), Qt::Key_Question, Qt::ShiftModifier);
  ASSERT_NE(listOfKeys(), nullptr);
  listOfKeys()->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  window->activateWindow();
  ASSERT_TRUE(test::waitUntil([&] { return window->isActiveWindow(); }));
  auto* search = window->findChild<PresetBrowser*>()->findChild<QLineEdit*>();
  search->setFocus();
  QTest::keyClick(window->windowHandle(), Qt::Key_Question, Qt::ShiftModifier);
  EXPECT_EQ(listOfKeys(), nullptr) << "where text is written it is a letter";
}

} // namespace
} // namespace limn
