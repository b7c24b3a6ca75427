// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/JudgedTime.h"

#include <algorithm>
#include <chrono>

namespace limn::test {

/// How long somebody who cancels at the worst moment waits: work that may be cancelled asks for it again and
/// again, and this holds the longest time between two questions, and from the last to the end. Belongs to the
/// thread that does the work.
class LongestWait {
public:
  LongestWait() { begin(); }

  /// To be called with each question, and once more when the work has ended.
  void asked() {
    const double cpu = threadMs() - m_cpu;
    const std::chrono::duration<double, std::milli> clock = Clock::now() - m_clock;
    m_cpuMs = std::max(m_cpuMs, cpu);
    m_clockMs = std::max(m_clockMs, clock.count());
    ++m_count;
    begin();
  }

  double cpuMs() const { return m_cpuMs; } ///< of the thread's own work, whatever else the machine does
  double clockMs() const { return m_clockMs; }
  int count() const { return m_count; }

private:
  using Clock = std::chrono::steady_clock;

  void begin() {
    m_cpu = threadMs();
    m_clock = Clock::now();
  }

  double m_cpu = 0.0, m_cpuMs = 0.0, m_clockMs = 0.0;
  Clock::time_point m_clock;
  int m_count = 0;
};

/// The wait that `work(wait)` leaves, or the least of three where it takes more than `mostMs` of the
/// processor: what a system takes to hand out memory or withholds from a machine counts in a thread's time
/// and comes once; what the work itself takes comes each time.
template <typename Work>
LongestWait waitOf(double mostMs, const Work& work) {
  LongestWait least;
  for (int tries = 0; tries < 3 && (tries == 0 || least.cpuMs() > mostMs); ++tries) {
    LongestWait wait;
    work(wait);
    if (tries == 0 || wait.cpuMs() < least.cpuMs())
      least = wait;
  }
  return least;
}

} // namespace limn::test
