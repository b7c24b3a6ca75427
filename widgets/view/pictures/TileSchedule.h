// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/PixelRect.h"

#include <vector>

namespace limn {

/// Cuts a picture into strips, top to bottom, whose height follows the measured time, so that no strip holds
/// the event loop for long. They span the full width unless even the lowest ones take too long: those are cut
/// from left to right. Knows neither OpenGL nor clock.
class TileSchedule {
public:
  /// The time a strip should take where it is drawn in a turn of the window's event loop, ms, and the limits
  /// of its height then, pixels; longer strips may be as much higher. Where nothing is known of the rows to
  /// come, heights at most double from strip to strip: empty space tells nothing about what follows.
  static constexpr double usualMs = 12.0;
  static constexpr int firstRows = 8;
  static constexpr int leastRows = 4; ///< and their multiple: a software renderer shades 4 × 4 pixels at once
  static constexpr int mostRows = 64;
  static constexpr int leastColumns = 16; ///< of a strip that is cut

  TileSchedule() = default; ///< an empty picture, complete

  /// `targetMs`: the time that a strip should take, > 0. `expectedMs`: what each row is expected to take, ms,
  /// from the top; empty where nothing is known.
  explicit TileSchedule(const glm::ivec2& size, double targetMs = usualMs,
                        std::vector<double> expectedMs = {});

  bool complete() const { return m_rowsDone >= m_size.y; }
  int rowsDone() const { return m_rowsDone; } ///< over the whole width
  double fraction() const;                    ///< 0..1
  double spentMs() const { return m_spentMs; }

  /// What each row took, ms: the expectation for the next picture of the same rays.
  const std::vector<double>& rowMs() const { return m_rowMs; }

  /// The strip to draw next; call only while not complete.
  PixelRect next() const;

  /// What the next strip will take, ms: as expected, at most; or what its pixels take if they cost what the
  /// last ones did.
  double predictedMs() const;

  /// Notes that the strip `next()` named was drawn in `ms`.
  void finished(double ms);

  /// Notes that the whole picture was drawn at once in `ms`.
  void finishedWhole(double ms);

private:
  double expectedMs(int firstRow, int rows) const;
  int mostRowsNow() const;
  int alignedRows(double rows) const;
  void learn(const PixelRect& rows);
  void chooseFromLast();
  void chooseFromExpected();

  glm::ivec2 m_size{0};
  double m_targetMs = usualMs;
  std::vector<double> m_expectedMs;
  std::vector<double> m_rowMs;
  int m_rowsDone = 0;
  int m_columnsDone = 0; ///< of the strip that is being cut
  int m_rows = firstRows;
  int m_columns = 0;
  double m_pixelMs = 0.0;              ///< in the last strip
  double m_recentMs = usualMs;         ///< what the last strips took,
  double m_recentExpectedMs = usualMs; ///< and what they were expected to
  double m_spentMs = 0.0;
};

} // namespace limn
