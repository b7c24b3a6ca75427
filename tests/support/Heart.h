// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/JudgedTime.h"
#include "support/Sanitizers.h"

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>

namespace limn::test {

/// How long the event loop was held from one beat to the next.
class Heart {
public:
  Heart() {
    QObject::connect(&m_timer, &QTimer::timeout, [this] { beat(); });
    m_timer.start(2);
  }
  double longestMs() const { return m_longestMs; }       ///< on the clock
  double longestOwnMs() const { return m_longestOwnMs; } ///< of the loop's thread on a processor
  int beats() const { return m_beats; }

private:
  void beat() {
    const double ownMs = threadMs();
    if (m_beats++ > 0) {
      m_longestMs = std::max(m_longestMs, 1e-6 * static_cast<double>(m_clock.nsecsElapsed()));
      m_longestOwnMs = std::max(m_longestOwnMs, ownMs - m_ownMs);
    }
    m_clock.start();
    m_ownMs = ownMs;
  }

  QTimer m_timer;
  QElapsedTimer m_clock;
  double m_ownMs = 0.0;
  double m_longestMs = 0.0;
  double m_longestOwnMs = 0.0;
  int m_beats = 0;
};

/// The loop turned, and no turn took more of a processor than `mostMs`, nor of the clock where that is
/// judged.
inline void expectShortTurns(const Heart& heart, const std::string& what, double mostMs) {
  EXPECT_GT(heart.beats(), 10) << what;
  LIMN_NEEDS_ITS_OWN_TIME;
  EXPECT_LE(heart.longestOwnMs(), mostMs) << what;
  judgeMs("longest turn of the event loop, " + what, heart.longestMs(), mostMs);
}

} // namespace limn::test
