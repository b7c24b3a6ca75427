// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/LookCurves.h"

#include "io/reading/ReadError.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

/// Walks a curve from value to value.
class CurveWalk {
public:
  explicit CurveWalk(const std::vector<ControlPoint>& points) : m_points(points) {}

  bool ends() const { return m_next == m_points.size(); }
  double nextValue() const { return m_points[m_next].value; }

  /// Stops at a value, which is the next of either curve. How many points lie there.
  std::size_t stopAt(double value) {
    m_value = value;
    m_first = m_next;
    while (!ends() && nextValue() == value)
      ++m_next;
    return m_next - m_first;
  }

  /// Point `index` of those at the value; the last one, or the curve itself, where there are fewer.
  ControlPoint at(std::size_t index) const {
    if (m_next > m_first)
      return m_points[std::min(m_first + index, m_next - 1)];
    if (m_next == 0)
      return m_points.front();
    if (ends())
      return m_points.back();
    return between(m_points[m_next - 1], m_points[m_next], m_value);
  }

private:
  static ControlPoint between(const ControlPoint& a, const ControlPoint& b, double value) {
    // Halved before the difference is taken, so that the largest numbers do not overflow.
    const double width = b.value / 2.0 - a.value / 2.0;
    const double u = (value / 2.0 - a.value / 2.0) / width;
    return {value, glm::mix(a.color, b.color, u), a.opacity + u * (b.opacity - a.opacity)};
  }

  const std::vector<ControlPoint>& m_points;
  std::size_t m_first = 0; // of those at the value
  std::size_t m_next = 0;  // behind them
  double m_value = 0.0;
};

bool differ(double a, double b, double width) {
  return std::abs(a - b) > 1e-9 * width;
}

} // namespace

void requirePointCount(std::size_t count, const std::string& name) {
  if (count == 0)
    failReading(name, Message::tr("one of its curves has no points"), saveLookAgain);
  if (count > mostLookPoints)
    failReading(name, Message::tr("one of its curves has more than %1 points").arg(mostLookPoints),
                Message::tr("save it with fewer points"));
}

ControlPoint checkedPoint(const ControlPoint& point, const std::string& name, std::vector<Message>& changes) {
  const ControlPoint limited = naming(name, [&] { return normalised({1.0, {point}}).points.front(); });
  if (limited != point)
    tell(changes, Message::tr("Opacities or colours outside 0 to 1 were limited to it."));
  return limited;
}

std::vector<ControlPoint> checkedCurve(std::vector<ControlPoint> points, const std::string& name,
                                       std::vector<Message>& changes) {
  requirePointCount(points.size(), name);
  for (ControlPoint& point : points)
    point = checkedPoint(point, name, changes);
  std::stable_sort(points.begin(), points.end(),
                   [](const ControlPoint& a, const ControlPoint& b) { return a.value < b.value; });
  return points;
}

TransferFunction merged(const std::vector<ControlPoint>& opacity, const std::vector<ControlPoint>& color) {
  TransferFunction function;
  CurveWalk opacities(opacity);
  CurveWalk colors(color);
  while (!opacities.ends() || !colors.ends()) {
    double value = opacities.ends() ? colors.nextValue() : opacities.nextValue();
    if (!colors.ends())
      value = std::min(value, colors.nextValue());
    const std::size_t ofOpacity = opacities.stopAt(value);
    const std::size_t count = std::max(ofOpacity, colors.stopAt(value));
    for (std::size_t i = 0; i < count; ++i)
      function.points.push_back({value, colors.at(i).color, opacities.at(i).opacity});
  }
  return function;
}

TransferFunction merged(const std::vector<ControlPoint>& opacity, const std::vector<ControlPoint>& color,
                        std::vector<Message>& changes) {
  TransferFunction function = merged(opacity, color);
  const double width = function.points.back().value - function.points.front().value;
  if (differ(opacity.front().value, color.front().value, width) ||
      differ(opacity.back().value, color.back().value, width))
    tell(changes,
         Message::tr("Opacity and colour end at different values; the shorter curve goes on with its "
                     "last ones."));
  return function;
}

} // namespace limn
