// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/ColourTable.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int fewestEntries = 4096;
constexpr int mostEntries = 65535;

std::uint16_t level(double share) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * 65535.0));
}

/// The slopes of the lines from one entry that stay near those after it.
struct Corridor {
  double lowest = -1e300;
  double highest = 1e300;

  bool isOpen() const { return lowest <= highest; }
  void narrow(double from, double to, double allowed, double distance) {
    lowest = std::max(lowest, (to - allowed - from) / distance);
    highest = std::min(highest, (to + allowed - from) / distance);
  }
  bool contains(double slope) const { return slope >= lowest && slope <= highest; }
};

// How far a line may miss an entry: what cannot be seen.
double allowedError(const ColourTable& table, std::size_t entry, std::size_t channel) {
  constexpr std::size_t alpha = 3;
  const double unseen =
      channel == alpha ? 0.002 * table.entries[entry][channel] : table.largest / (16.0 * 255.0);
  return std::max(0.5, unseen);
}

// The last entry that a straight line from `start` reaches without leaving the corridor of any channel.
std::size_t lineFrom(const ColourTable& table, std::size_t start) {
  std::array<Corridor, 4> corridors;
  std::size_t reached = start + 1;
  for (std::size_t next = start + 1; next < table.entries.size(); ++next) {
    const auto distance = static_cast<double>(next - start);
    bool isOpen = true, isStraight = true;
    for (std::size_t c = 0; c < 4; ++c) {
      const double from = table.entries[start][c], to = table.entries[next][c];
      isStraight = isStraight && corridors[c].contains((to - from) / distance);
      corridors[c].narrow(from, to, allowedError(table, next, c), distance);
      isOpen = isOpen && corridors[c].isOpen();
    }
    if (isStraight)
      reached = next;
    if (!isOpen)
      break;
  }
  return reached;
}

ControlPoint pointAt(const ColourTable& table, std::size_t entry) {
  const auto& [red, green, blue, alpha] = table.entries[entry];
  const double largest = table.largest;
  return {table.valueOf(entry), glm::dvec3(red, green, blue) / largest, alpha / largest};
}

} // namespace

int entriesFor(const ValueRange& range) {
  const double width = range.highest - range.lowest;
  if (width != std::floor(width) || width < 1.0)
    return fewestEntries;
  if (width >= mostEntries)
    return mostEntries;
  const int steps = static_cast<int>(width);
  return steps * ((fewestEntries - 2) / steps + 1) + 1;
}

ColourTable tableOf(const TransferFunction& function, const ValueRange& range, double stepMm) {
  ColourTable table{range.lowest, range.highest, 65535, {}};
  table.entries.resize(static_cast<std::size_t>(entriesFor(range)));
  for (std::size_t i = 0; i < table.entries.size(); ++i) {
    const Classified here = classify(function, table.valueOf(i));
    const double alpha = -std::expm1(-extinctionPerMm(here.opacity, function.unitDistanceMm) * stepMm);
    table.entries[i] = {level(here.color.r), level(here.color.g), level(here.color.b), level(alpha)};
  }
  return table;
}

TransferFunction functionOf(const ColourTable& table, double stepMm) {
  TransferFunction function;
  function.unitDistanceMm = stepMm;
  function.points.push_back(pointAt(table, 0));
  for (std::size_t at = 0; at + 1 < table.entries.size();) {
    at = lineFrom(table, at);
    function.points.push_back(pointAt(table, at));
  }
  return function;
}

} // namespace limn
