// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QTimer>
#include <QWindow>

#include <chrono>

namespace limn::test {

/// When waiting ends: shortly before CTest's time limit (LIMN_TEST_SECONDS, from the start of the first wait
/// of the process), so that what did not come is named; without a limit never.
inline const QDeadlineTimer& endOfWaiting() {
  using namespace std::chrono_literals;
  static const int seconds = qEnvironmentVariableIntValue("LIMN_TEST_SECONDS");
  static const QDeadlineTimer end =
      seconds > 0 ? QDeadlineTimer(seconds * 1s - 20s) : QDeadlineTimer(QDeadlineTimer::Forever);
  return end;
}

/// Runs the event loop until something holds, however busy the machine is; false where the time limit of the
/// test itself came first.
template <class Condition>
[[nodiscard]] bool waitUntil(Condition&& holds) {
  QTimer tick; // what other threads and processes do wakes no event loop
  tick.start(5);
  while (!holds()) {
    if (endOfWaiting().hasExpired())
      return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  return true;
}

/// Waits until a shown window is on the screen.
template <class Widget>
[[nodiscard]] bool waitUntilExposed(const Widget& window) {
  return waitUntil([&] { return window.windowHandle() && window.windowHandle()->isExposed(); });
}

} // namespace limn::test
