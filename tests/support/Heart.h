// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>
#include <ctime>

namespace limn::test {

/// How long the event loop was held from one beat to the next by the program's own work: the time on the
/// clock or, where other programs had the processor, the program's own processor time.
class Heart {
public:
  Heart() {
    QObject::connect(&m_timer, &QTimer::timeout, [this] { beat(); });
    m_timer.start(2);
  }
  double longestMs() const { return m_longestMs; }
  int beats() const { return m_beats; }

private:
  void beat() {
    const std::clock_t processor = std::clock();
    if (m_beats++ > 0) {
      const double processorMs = 1000.0 * static_cast<double>(processor - m_processor) / CLOCKS_PER_SEC;
      m_longestMs = std::max(m_longestMs, std::min<double>(processorMs, m_clock.elapsed()));
    }
    m_clock.start();
    m_processor = processor;
  }

  QTimer m_timer;
  QElapsedTimer m_clock;
  std::clock_t m_processor = 0;
  double m_longestMs = 0.0;
  int m_beats = 0;
};

} // namespace limn::test
