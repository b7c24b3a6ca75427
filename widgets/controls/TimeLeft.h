// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>

#include <optional>

namespace limn {

/// A time that is not known exactly: "about 40 s", "about 4 min", "about 2.5 h".
QString aboutText(double seconds);

/// How long work will still take that goes on as it did, s: from how far it came (0..1) in which time. Absent
/// in the first two seconds and the first hundredth, of which nothing follows.
std::optional<double> secondsLeft(double fraction, double seconds);

/// Tells it of work under way.
class TimeLeft {
public:
  void begin() { m_clock.start(); }

  /// " (about 4 min left)" behind what is said of the work at this fraction; empty where nothing is known and
  /// where it is as good as done.
  QString text(double fraction) const;

private:
  QElapsedTimer m_clock;
};

} // namespace limn
