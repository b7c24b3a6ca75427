// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/TileSchedule.h"

#include <algorithm>
#include <cassert>

namespace limn {

double TileSchedule::fraction() const {
  if (complete())
    return 1.0;
  const double cut = static_cast<double>(m_columnsDone) * next().size.y / m_size.x;
  return (m_rowsDone + cut) / m_size.y;
}

PixelRect TileSchedule::next() const {
  assert(!complete());
  return {{m_columnsDone, m_rowsDone},
          {std::min(m_columns, m_size.x - m_columnsDone), std::min(m_rows, m_size.y - m_rowsDone)}};
}

double TileSchedule::predictedMs() const {
  return m_pixelMs * next().size.x * next().size.y;
}

void TileSchedule::finished(double ms) {
  const glm::ivec2 done = next().size;
  m_spentMs += ms;
  m_pixelMs = std::max(ms, 1e-3) / (static_cast<double>(done.x) * done.y);
  m_columnsDone += done.x;
  const bool isWhole = m_columnsDone >= m_size.x;
  if (isWhole) {
    m_rowsDone += done.y;
    m_columnsDone = 0;
  }
  const double pixels = std::min(targetMs / m_pixelMs, 2.0 * m_rows * m_columns);
  // The height of a strip stays until it is done.
  if (isWhole)
    m_rows = static_cast<int>(std::clamp<double>(pixels / m_size.x, leastRows, mostRows));
  m_columns =
      static_cast<int>(std::clamp<double>(pixels / m_rows, std::min(leastColumns, m_size.x), m_size.x));
}

void TileSchedule::finishedWhole(double ms) {
  m_rowsDone = m_size.y;
  m_spentMs = ms;
}

} // namespace limn
