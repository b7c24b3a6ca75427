// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "raycaster/RayCaster.h"

namespace limn {

/// Cuts a picture into strips, top to bottom, whose height follows the measured time, so that no strip holds
/// the event loop for long. They span the full width unless even the lowest ones take too long: those are cut
/// from left to right. Knows neither OpenGL nor clock.
class TileSchedule {
public:
  /// The time a strip should take, ms, and the limits of its height, pixels. Heights at most double from
  /// strip to strip: rows of empty space tell nothing about the rows that follow.
  static constexpr double targetMs = 12.0;
  static constexpr int firstRows = 8;
  static constexpr int leastRows = 2;
  static constexpr int mostRows = 64;
  /// Of a strip that is cut: a software renderer's threads share squares of 64 pixels.
  static constexpr int leastColumns = 128;

  TileSchedule() = default; ///< an empty picture, complete
  explicit TileSchedule(const glm::ivec2& size) : m_size(size), m_columns(size.x) {}

  bool complete() const { return m_rowsDone >= m_size.y; }
  int rowsDone() const { return m_rowsDone; } ///< over the whole width
  double fraction() const;                    ///< 0..1
  double spentMs() const { return m_spentMs; }

  /// The strip to draw next; call only while not complete.
  PixelRect next() const;

  /// What the next strip will take if its pixels cost what the last ones did, ms.
  double predictedMs() const;

  /// Notes that the strip `next()` named was drawn in `ms`.
  void finished(double ms);

  /// Notes that the whole picture was drawn at once in `ms`.
  void finishedWhole(double ms);

private:
  glm::ivec2 m_size{0};
  int m_rowsDone = 0;
  int m_columnsDone = 0; ///< of the strip that is being cut
  int m_rows = firstRows;
  int m_columns = 0;
  double m_pixelMs = 0.0;
  double m_spentMs = 0.0;
};

} // namespace limn
