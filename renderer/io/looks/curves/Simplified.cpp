// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/Simplified.h"

#include <algorithm>
#include <limits>

namespace limn {
namespace {

// How far a piece may reach: keeps the walk linear in the number of points, whatever they are.
constexpr std::size_t longestPiece = 4096;

glm::dvec4 channels(const ControlPoint& point) {
  return {point.color, point.opacity};
}

// The slopes of all straight lines from a point that pass within the tolerance of those after it.
class Fan {
public:
  Fan(const ControlPoint& from, double tolerance) : m_from(from), m_tolerance(tolerance) {}

  bool holds(const ControlPoint& end) const {
    const glm::dvec4 slope = (channels(end) - channels(m_from)) / (end.value - m_from.value);
    return glm::all(glm::greaterThanEqual(slope, m_lowest)) && glm::all(glm::lessThanEqual(slope, m_highest));
  }

  /// False where no line is left.
  bool narrow(const ControlPoint& passed) {
    const double width = passed.value - m_from.value;
    const glm::dvec4 rise = channels(passed) - channels(m_from);
    m_lowest = glm::max(m_lowest, (rise - m_tolerance) / width);
    m_highest = glm::min(m_highest, (rise + m_tolerance) / width);
    return glm::all(glm::lessThanEqual(m_lowest, m_highest));
  }

private:
  ControlPoint m_from;
  double m_tolerance;
  glm::dvec4 m_lowest{-std::numeric_limits<double>::infinity()};
  glm::dvec4 m_highest{std::numeric_limits<double>::infinity()};
};

// Where the longest piece from a point ends.
std::size_t pieceEnd(const std::vector<ControlPoint>& points, std::size_t from, double tolerance) {
  std::size_t end = from + 1;
  Fan fan(points[from], tolerance);
  const std::size_t last = std::min(points.size() - 1, from + longestPiece);
  for (std::size_t i = from + 1; i <= last && points[i].value > points[i - 1].value; ++i) {
    if (fan.holds(points[i]))
      end = i;
    if (!fan.narrow(points[i]))
      break;
  }
  return end;
}

} // namespace

std::vector<ControlPoint> simplified(const std::vector<ControlPoint>& points, double tolerance) {
  std::vector<ControlPoint> kept;
  for (std::size_t at = 0; at < points.size(); at = pieceEnd(points, at, tolerance))
    kept.push_back(points[at]);
  return kept;
}

} // namespace limn
