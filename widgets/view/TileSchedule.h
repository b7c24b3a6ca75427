// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "raycaster/RayCaster.h"

namespace limn {

/// Cuts a picture into strips of full width, top to bottom, whose height follows the measured time, so that
/// no strip holds the event loop for long. Knows neither OpenGL nor clock.
class TileSchedule {
public:
  /// The time a strip should take, ms, and the limits of its height, pixels. Heights at most double from
  /// strip to strip: rows of empty space tell nothing about the rows that follow.
  static constexpr double targetMs = 12.0;
  static constexpr int firstRows = 8;
  static constexpr int leastRows = 2;
  static constexpr int mostRows = 64;

  TileSchedule() = default; ///< an empty picture, complete
  explicit TileSchedule(const glm::ivec2& size) : m_size(size) {}

  bool complete() const { return m_rowsDone >= m_size.y; }
  int rowsDone() const { return m_rowsDone; }
  double fraction() const; ///< 0..1
  double spentMs() const { return m_spentMs; }

  /// The strip to draw next; call only while not complete.
  PixelRect next() const;

  /// What the next strip will take if its rows cost what the last ones did, ms.
  double predictedMs() const;

  /// Notes that the strip `next()` named was drawn in `ms`.
  void finished(double ms);

  /// Notes that the whole picture was drawn at once in `ms`.
  void finishedWhole(double ms);

private:
  glm::ivec2 m_size{0};
  int m_rowsDone = 0;
  int m_rows = firstRows;
  double m_rowMs = targetMs / firstRows;
  double m_spentMs = 0.0;
};

} // namespace limn
