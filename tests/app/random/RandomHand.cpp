// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/random/RandomHand.h"

#include "app/random/LastActions.h"

#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>

#include <algorithm>
#include <vector>

namespace limn::test {
namespace {

// Letters and digits of the view, keys of lists and fields, shortcuts. None that quits: F4, Ctrl+Q, Ctrl+W.
const std::vector<QKeyCombination> keys = {Qt::Key_A,
                                           Qt::Key_P,
                                           Qt::Key_L,
                                           Qt::Key_S,
                                           Qt::Key_I,
                                           Qt::Key_R,
                                           Qt::Key_W,
                                           Qt::Key_M,
                                           Qt::Key_Z,
                                           Qt::Key_B,
                                           Qt::Key_X,
                                           Qt::Key_K,
                                           Qt::Key_D,
                                           Qt::Key_O,
                                           Qt::Key_Space,
                                           Qt::Key_0,
                                           Qt::Key_1,
                                           Qt::Key_2,
                                           Qt::Key_5,
                                           Qt::Key_9,
                                           Qt::Key_Plus,
                                           Qt::Key_Minus,
                                           Qt::Key_Left,
                                           Qt::Key_Right,
                                           Qt::Key_Up,
                                           Qt::Key_Down,
                                           Qt::Key_Home,
                                           Qt::Key_End,
                                           Qt::Key_PageUp,
                                           Qt::Key_Tab,
                                           Qt::Key_Return,
                                           Qt::Key_Delete,
                                           Qt::Key_PageDown,
                                           Qt::Key_Backspace,
                                           Qt::Key_Backtab,
                                           Qt::Key_F1,
                                           Qt::Key_F11,
                                           Qt::Key_Question,
                                           Qt::Key_Comma,
                                           Qt::Key_Period,
                                           Qt::Key_Escape,
                                           Qt::Key_Menu,
                                           Qt::CTRL | Qt::Key_Z,
                                           Qt::CTRL | Qt::SHIFT | Qt::Key_Z,
                                           Qt::CTRL | Qt::Key_Y,
                                           Qt::CTRL | Qt::Key_A,
                                           Qt::CTRL | Qt::Key_C,
                                           Qt::CTRL | Qt::Key_V,
                                           Qt::CTRL | Qt::Key_F,
                                           Qt::CTRL | Qt::Key_S};

QString named(const QWidget& widget) {
  const QString name = widget.accessibleName().isEmpty() ? widget.objectName() : widget.accessibleName();
  return QStringLiteral("%1 %2").arg(QLatin1String(widget.metaObject()->className()), name);
}

} // namespace

RandomHand::RandomHand(unsigned seed, QWidget& window) : m_random(seed), m_window(window) {
  QObject::connect(&m_leaver, &QTimer::timeout, &m_leaver, [this] {
    leaveDialogs();
    // A menu of a tool button holds the event loop, and so the action that opened it.
    if (++m_turnsOfAction > 5)
      leavePopups();
  });
  m_leaver.start(20);
}

void RandomHand::act() {
  m_turnsOfAction = 0;
  const Place here = place();
  const int kind = below(20);
  if (kind < 7)
    click(here);
  else if (kind < 12)
    drag(here);
  else if (kind < 14)
    turnWheel(here);
  else
    press(here);
  QCoreApplication::processEvents();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

void RandomHand::leaveOthers() {
  leavePopups();
  leaveDialogs();
}

void RandomHand::leavePopups() {
  while (QWidget* popup = QApplication::activePopupWidget())
    popup->close();
}

// A dialog that was just opened may not be on the screen yet: it is asked again later.
void RandomHand::leaveDialogs() {
  for (QWidget* window : QApplication::topLevelWidgets())
    if (window->isVisible() && qobject_cast<QDialog*>(window)) {
      noteAction(QStringLiteral("Esc in %1").arg(named(*window)));
      QTest::keyClick(window, Qt::Key_Escape);
      return; // others may be gone with it
    }
}

QPoint RandomHand::within(const QRect& area) {
  return area.topLeft() + QPoint(below(area.width()), below(area.height()));
}

RandomHand::Place RandomHand::place() {
  QWidget* window = QApplication::activePopupWidget();
  if (!window) {
    window = &m_window;
    for (QWidget* other : QApplication::topLevelWidgets())
      if (other->isVisible() && qobject_cast<QDockWidget*>(other) && oneIn(4))
        window = other;
  }
  // Large widgets by their area, small ones by their number.
  if (oneIn(3))
    return {window, within(window->rect())};
  std::vector<QWidget*> seen;
  for (QWidget* widget : window->findChildren<QWidget*>())
    if (widget->window() == window && !widget->visibleRegion().isEmpty())
      seen.push_back(widget);
  if (seen.empty())
    return {window, within(window->rect())};
  QWidget* chosen = seen[static_cast<std::size_t>(below(static_cast<int>(seen.size())))];
  return {window, chosen->mapTo(window, within(chosen->visibleRegion().boundingRect()))};
}

Qt::KeyboardModifiers RandomHand::modifiers() {
  const Qt::KeyboardModifiers offered[] = {Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier};
  return oneIn(5) ? offered[below(3)] : Qt::KeyboardModifiers();
}

Qt::MouseButton RandomHand::button() {
  return oneIn(8) ? Qt::RightButton : oneIn(12) ? Qt::MiddleButton : Qt::LeftButton;
}

void RandomHand::click(const Place& place) {
  const QWidget* under = place.window->childAt(place.at);
  const bool twice = oneIn(6);
  noteAction(QStringLiteral("%1 at %2,%3 on %4")
                 .arg(twice ? QStringLiteral("double click") : QStringLiteral("click"))
                 .arg(place.at.x())
                 .arg(place.at.y())
                 .arg(named(under ? *under : *place.window)));
  QWindow* window = place.window->windowHandle();
  if (twice)
    QTest::mouseDClick(window, Qt::LeftButton, modifiers(), place.at);
  else
    QTest::mouseClick(window, button(), modifiers(), place.at);
}

void RandomHand::drag(const Place& place) {
  const QWidget* under = place.window->childAt(place.at);
  // Selected text that is dragged goes to the window system, which waits for a button that nobody holds.
  if (const auto* label = qobject_cast<const QLabel*>(under);
      label && (label->textInteractionFlags() & Qt::TextSelectableByMouse))
    return click(place);
  const Qt::MouseButton held = button();
  const Qt::KeyboardModifiers with = modifiers();
  noteAction(QStringLiteral("drag from %1,%2 on %3")
                 .arg(place.at.x())
                 .arg(place.at.y())
                 .arg(named(under ? *under : *place.window)));
  // A press may close or delete the window that it meets.
  QPointer<QWindow> window = place.window->windowHandle();
  QPoint at = place.at;
  QTest::mousePress(window, held, with, at);
  for (int step = 1 + below(8); step > 0 && window; --step) {
    const QSize size = window->size(); // beyond it QTest objects
    at = {std::clamp(at.x() + below(61) - 30, 0, size.width() - 1),
          std::clamp(at.y() + below(61) - 30, 0, size.height() - 1)};
    QTest::mouseEvent(QTest::MouseMove, window, Qt::NoButton, with, at);
  }
  if (window && oneIn(8))
    QTest::keyClick(window, Qt::Key_Escape);
  if (window)
    QTest::mouseRelease(window, held, with, at);
}

void RandomHand::turnWheel(const Place& place) {
  QWidget* under = place.window->childAt(place.at);
  if (!under)
    return;
  noteAction(QStringLiteral("wheel at %1,%2 on %3").arg(place.at.x()).arg(place.at.y()).arg(named(*under)));
  const QPoint global = place.window->mapToGlobal(place.at);
  QWheelEvent event(under->mapFromGlobal(global), global, QPoint(), QPoint(0, oneIn(2) ? 120 : -120),
                    Qt::NoButton, modifiers(), Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(under, &event);
}

void RandomHand::press(const Place& place) {
  const QKeyCombination key = keys[static_cast<std::size_t>(below(static_cast<int>(keys.size())))];
  noteAction(QStringLiteral("key %1").arg(QKeySequence(key).toString()));
  QWindow* window = place.window->windowHandle();
  // Keys of the picture go to what lies under the pointer.
  QTest::mouseMove(window, place.at);
  QTest::keyClick(window, key.key(), key.keyboardModifiers());
}

} // namespace limn::test
