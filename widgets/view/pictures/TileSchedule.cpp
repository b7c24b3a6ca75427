// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/TileSchedule.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace limn {
namespace {

// How much an older strip counts beside the next one when it is asked how right the expectation is.
constexpr double memory = 0.8;

// The middle of a row may cost this many times what the whole costs on average.
constexpr double unevenness = 2.0;

} // namespace

TileSchedule::TileSchedule(const glm::ivec2& size, double targetMs, std::vector<double> expectedMs)
    : m_size(size), m_targetMs(targetMs), m_expectedMs(std::move(expectedMs)),
      m_rowMs(static_cast<std::size_t>(std::max(0, size.y)), 0.0),
      m_rows(static_cast<int>(firstRows * targetMs / usualMs)), m_columns(size.x), m_recentMs(targetMs),
      m_recentExpectedMs(targetMs) {
  assert(m_expectedMs.empty() || m_expectedMs.size() == m_rowMs.size());
  if (!m_expectedMs.empty())
    chooseFromExpected();
}

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

double TileSchedule::expectedMs(int firstRow, int rows) const {
  const auto first = m_expectedMs.begin() + firstRow;
  return m_recentMs / m_recentExpectedMs * std::accumulate(first, first + rows, 0.0);
}

double TileSchedule::predictedMs() const {
  const glm::ivec2 size = next().size;
  const double fromLast = m_pixelMs * size.x * size.y;
  if (m_expectedMs.empty())
    return fromLast;
  const double share = static_cast<double>(size.x) / m_size.x;
  return expectedMs(m_rowsDone, size.y) * std::min(1.0, unevenness * share);
}

// Compare what whole rows took with what they should have.
void TileSchedule::learn(const PixelRect& rows) {
  const auto first = m_expectedMs.begin() + rows.topLeft.y;
  const auto taken = m_rowMs.begin() + rows.topLeft.y;
  m_recentExpectedMs = memory * m_recentExpectedMs + std::accumulate(first, first + rows.size.y, 0.0);
  m_recentMs = memory * m_recentMs + std::accumulate(taken, taken + rows.size.y, 0.0);
}

void TileSchedule::finished(double ms) {
  const PixelRect done = next();
  m_spentMs += ms;
  m_pixelMs = std::max(ms, 1e-3) / (static_cast<double>(done.size.x) * done.size.y);
  for (int row = 0; row < done.size.y; ++row)
    m_rowMs[static_cast<std::size_t>(m_rowsDone) + static_cast<std::size_t>(row)] += ms / done.size.y;
  m_columnsDone += done.size.x;
  if (m_columnsDone >= m_size.x) {
    if (!m_expectedMs.empty())
      learn(done);
    m_rowsDone += done.size.y;
    m_columnsDone = 0;
  }
  if (complete())
    return;
  m_expectedMs.empty() ? chooseFromLast() : chooseFromExpected();
}

int TileSchedule::mostRowsNow() const {
  return static_cast<int>(mostRows * m_targetMs / usualMs);
}

// Strips end where a multiple of the least height is left below them: OpenGL's rows count from there.
int TileSchedule::alignedRows(double rows) const {
  const int wanted = static_cast<int>(std::clamp<double>(rows, leastRows, mostRowsNow()));
  const int below = m_size.y - m_rowsDone - wanted;
  return wanted - (below > 0 ? (leastRows - below % leastRows) % leastRows : 0);
}

// The height of a strip stays until it is done.
void TileSchedule::chooseFromLast() {
  const double pixels = std::min(m_targetMs / m_pixelMs, 2.0 * m_rows * m_columns);
  if (m_columnsDone == 0)
    m_rows = alignedRows(pixels / m_size.x);
  m_columns =
      static_cast<int>(std::clamp<double>(pixels / m_rows, std::min(leastColumns, m_size.x), m_size.x));
}

// As many rows as fit into the target; where the lowest strip does not, a part of its width.
void TileSchedule::chooseFromExpected() {
  const int left = m_size.y - m_rowsDone;
  if (m_columnsDone == 0) {
    int rows = std::min(leastRows, left);
    while (rows < std::min(mostRowsNow(), left) && expectedMs(m_rowsDone, rows + 1) <= m_targetMs)
      ++rows;
    m_rows = alignedRows(rows);
  }
  const double whole = expectedMs(m_rowsDone, std::min(m_rows, left));
  const double columns = whole > m_targetMs ? m_size.x * m_targetMs / (unevenness * whole) : m_size.x;
  m_columns = static_cast<int>(std::clamp<double>(columns, std::min(leastColumns, m_size.x), m_size.x));
}

void TileSchedule::finishedWhole(double ms) {
  m_rowMs.assign(m_rowMs.size(), ms / std::max<double>(1.0, m_size.y));
  m_rowsDone = m_size.y;
  m_spentMs = ms;
}

} // namespace limn
