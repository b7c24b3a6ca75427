// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QRect>
#include <QTimer>

#include <random>

class QWidget;
class QWindow;

namespace limn::test {

/// Uses the windows of this process at random, by real events: clicks, drags, wheel and keys on any widget
/// that is visible, pop-ups and floating docks included. Every dialog is left by Esc, also one that runs an
/// event loop of its own. What was done last is kept (LastActions).
class RandomHand {
public:
  /// `window` is the program's; equal seeds choose alike as long as the window shows the same.
  RandomHand(unsigned seed, QWidget& window);

  /// One action, and what it brings about at once.
  void act();

  /// Leaves pop-ups and dialogs.
  void leaveOthers();

private:
  /// Where something is done: a place in a window of the display.
  struct Place {
    QWidget* window = nullptr;
    QPoint at;
  };

  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(m_random); }
  bool oneIn(int count) { return below(count) == 0; }
  QPoint within(const QRect& area);
  Place place();
  Qt::KeyboardModifiers modifiers();
  Qt::MouseButton button();
  void click(const Place& place);
  void drag(const Place& place);
  void turnWheel(const Place& place);
  void press(const Place& place);
  void leavePopups();
  void leaveDialogs();

  std::mt19937 m_random;
  QWidget& m_window;
  QTimer m_leaver;         ///< also runs where a dialog holds the event loop
  int m_turnsOfAction = 0; ///< of `m_leaver`
};

} // namespace limn::test
