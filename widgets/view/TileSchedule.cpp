// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/TileSchedule.h"

#include <algorithm>
#include <cassert>

namespace limn {

double TileSchedule::fraction() const {
  return complete() ? 1.0 : static_cast<double>(m_rowsDone) / m_size.y;
}

PixelRect TileSchedule::next() const {
  assert(!complete());
  return {{0, m_rowsDone}, {m_size.x, std::min(m_rows, m_size.y - m_rowsDone)}};
}

double TileSchedule::predictedMs() const {
  return m_rowMs * next().size.y;
}

void TileSchedule::finished(double ms) {
  const int rows = next().size.y;
  m_rowsDone += rows;
  m_spentMs += ms;
  m_rowMs = std::max(ms, 1e-3) / rows;
  const double wanted = std::min<double>(targetMs / m_rowMs, 2.0 * m_rows);
  m_rows = std::clamp(static_cast<int>(wanted), leastRows, mostRows);
}

void TileSchedule::finishedWhole(double ms) {
  m_rowsDone = m_size.y;
  m_spentMs = ms;
}

} // namespace limn
