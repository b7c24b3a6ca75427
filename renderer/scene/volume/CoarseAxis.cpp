// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/CoarseAxis.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace limn {

CoarseAxis::CoarseAxis(int fine, int coarse) : m_fine(fine), m_coarse(coarse) {
  std::vector<double> centres;
  centres.reserve(static_cast<std::size_t>(fine) + static_cast<std::size_t>(coarse));
  for (int i = 0; i < fine; ++i)
    centres.push_back(i);
  const double each = static_cast<double>(fine) / coarse;
  for (int i = 0; i < coarse; ++i)
    centres.push_back((i + 0.5) * each - 0.5);
  std::ranges::sort(centres);
  centres.erase(std::unique(centres.begin(), centres.end()), centres.end());
  m_places.reserve(centres.size());
  for (const double centre : centres)
    m_places.push_back(placeAt(centre));
}

int CoarseAxis::cellBegin(int cell) const {
  return static_cast<int>(std::int64_t{cell} * m_fine / m_coarse);
}

// Beyond the outermost centres a field is constant.
CoarseAxis::Place CoarseAxis::placeAt(double index) const {
  const double each = static_cast<double>(m_fine) / m_coarse;
  const double coarse = std::clamp((index + 0.5) / each - 0.5, 0.0, m_coarse - 1.0);
  const auto partOf = [](double at) { return static_cast<float>(at - std::floor(at)); };
  return {static_cast<int>(index), partOf(index), static_cast<int>(coarse), partOf(coarse)};
}

} // namespace limn
