// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>

#include <cstddef>
#include <optional>

namespace limn {

/// A time that is not known exactly: "about 40 s", "about 4 min", "about 2.5 h".
QString aboutText(double seconds);

/// From so much of some work (0..1) on its pace tells something.
inline constexpr double aHundredth = 0.01;

/// How long work will still take that goes on as it did, s: from how far it came (0..1) in which time. Absent
/// in the first two seconds and in its first part of `telling`, of which nothing follows.
std::optional<double> secondsLeft(double fraction, double seconds, double telling = aHundredth);

/// Tells it of work under way, by its pace since it was first seen to come on: what is prepared before says
/// nothing. Of several pictures in one file each has an equal share of the work and takes a time of its own,
/// so that nothing is known before the last.
class TimeLeft {
public:
  /// Less than a hundredth may be `telling`, such as one of many frames alike.
  void begin(std::size_t pictures = 1, double telling = aHundredth);

  /// " (about 4 min left)" behind what is said of the work at this fraction; empty where nothing is known and
  /// where it is as good as done.
  QString text(double fraction);

  /// How long work still takes that came to this fraction so many seconds after it began, s: from the pace of
  /// the last picture.
  std::optional<double> left(double fraction, double seconds);

private:
  /// How far the last picture came, and when.
  struct Place {
    double fraction = 0.0;
    double seconds = 0.0;
  };

  QElapsedTimer m_clock;
  double m_pictures = 1.0;
  double m_telling = aHundredth;
  std::optional<Place> m_last; ///< where that was first seen to come on; absent before
};

} // namespace limn
