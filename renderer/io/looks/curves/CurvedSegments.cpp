// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/CurvedSegments.h"

#include "io/looks/curves/LookCurves.h"
#include "io/looks/curves/Simplified.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// A curved segment is looked at so often; between two samples it strays less than the margin kept below.
constexpr int samples = 512;
constexpr double margin = 0.0005;

double clampedMidpoint(double midpoint) {
  return std::clamp(midpoint, 1e-5, 1.0 - 1e-5);
}

bool isStraight(double sharpness) {
  return sharpness < 0.01;
}

bool isStep(double sharpness) {
  return sharpness > 0.99;
}

// Half of the change is done at the midpoint.
double unwarped(double v, double midpoint) {
  return v < 0.5 ? 2.0 * v * midpoint : midpoint + 2.0 * (v - 0.5) * (1.0 - midpoint);
}

// How much of the change is done: VTK's rule (vtkPiecewiseFunction).
double bent(double v, double sharpness) {
  if (isStraight(sharpness))
    return v;
  const double exponent = 1.0 + 10.0 * sharpness;
  const double w =
      v < 0.5 ? 0.5 * std::pow(2.0 * v, exponent) : 1.0 - 0.5 * std::pow(2.0 * (1.0 - v), exponent);
  // A cubic from 0 to 1 with the tangent 1 - sharpness at both ends.
  const double cubic = w * w * (3.0 - 2.0 * w);
  const double tangents = w * (1.0 - w) * (1.0 - 2.0 * w);
  return std::clamp(cubic + (1.0 - sharpness) * tangents, 0.0, 1.0);
}

/// One segment.
class Segment {
public:
  Segment(const BentPoint& from, const BentPoint& to, const SegmentRule& rule)
      : m_from(from.point), m_to(to.point), m_rule(rule), m_midpoint(clampedMidpoint(from.midpoint)),
        m_sharpness(from.sharpness) {}

  bool isEmpty() const { return !(m_to.value > m_from.value); }

  /// Appends what lies between the ends. False where that is exact.
  bool appendTo(std::vector<ControlPoint>& points) const {
    if (isEmpty())
      return false;
    if (m_rule.space == ColorSpace::step || isStep(m_sharpness)) {
      appendStep(points);
      return false;
    }
    const bool changes = m_from.color != m_to.color || m_from.opacity != m_to.opacity;
    const bool isRgb = m_rule.space == ColorSpace::rgb || m_from.color == m_to.color;
    if (!changes || (isRgb && isStraight(m_sharpness) && !m_rule.isLogarithmic)) {
      if (changes && m_midpoint != 0.5)
        points.push_back(at(0.5));
      return false;
    }
    appendCurve(points);
    return true;
  }

private:
  double valueAt(double u) const {
    if (m_rule.isLogarithmic)
      return std::clamp(m_from.value * std::pow(m_to.value / m_from.value, u), m_from.value, m_to.value);
    return m_from.value * (1.0 - u) + m_to.value * u;
  }

  // Where `v` counts the way so that 0.5 is the midpoint.
  ControlPoint at(double v) const {
    const double done = bent(v, m_sharpness);
    return {valueAt(unwarped(v, m_midpoint)), mixed(m_rule.space, m_from.color, m_to.color, done),
            m_from.opacity + done * (m_to.opacity - m_from.opacity)};
  }

  void appendStep(std::vector<ControlPoint>& points) const {
    const bool isAtStart = m_rule.space == ColorSpace::step;
    if (!isAtStart)
      points.push_back({valueAt(m_midpoint), m_from.color, m_from.opacity});
    points.push_back({isAtStart ? m_from.value : valueAt(m_midpoint), m_to.color, m_to.opacity});
  }

  void appendCurve(std::vector<ControlPoint>& points) const {
    std::vector<ControlPoint> seen{m_from};
    for (int i = 1; i < samples; ++i)
      if (const ControlPoint point = at(i / double(samples)); point.value > seen.back().value)
        seen.push_back(point);
    if (seen.back().value < m_to.value)
      seen.push_back(m_to);
    else
      seen.back() = m_to;
    const std::vector<ControlPoint> kept = simplified(seen, segmentTolerance - margin);
    points.insert(points.end(), kept.begin() + 1, kept.end() - 1);
  }

  ControlPoint m_from;
  ControlPoint m_to;
  SegmentRule m_rule;
  double m_midpoint;
  double m_sharpness;
};

void requireSoundRule(const std::vector<BentPoint>& points, const SegmentRule& rule,
                      const std::string& name) {
  if (rule.isLogarithmic && !points.empty() && !(points.front().point.value > 0.0))
    failReading(name, Message::tr("its scale is logarithmic, but not all of its values are above 0"),
                Message::tr("save it with a linear scale"));
}

} // namespace

std::vector<BentPoint> checkedCurve(std::vector<BentPoint> points, const std::string& name,
                                    std::vector<Message>& changes) {
  requirePointCount(points.size(), name);
  for (BentPoint& bent : points) {
    if (!std::isfinite(bent.midpoint) || !std::isfinite(bent.sharpness))
      failReading(name, Message::tr("a midpoint or sharpness in it is no number"), saveLookAgain);
    bent.point = checkedPoint(bent.point, name, changes);
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const BentPoint& a, const BentPoint& b) { return a.point.value < b.point.value; });
  return points;
}

static bool isOpacityStep(const BentPoint& from, const BentPoint& to) {
  return isStep(from.sharpness) && from.point.opacity != to.point.opacity &&
         from.point.value < to.point.value;
}

std::vector<ControlPoint> straightened(const std::vector<BentPoint>& points, const SegmentRule& rule,
                                       const std::string& name, std::vector<Message>& changes) {
  requireSoundRule(points, rule, name);
  std::vector<ControlPoint> straight;
  for (std::size_t i = 0; i < points.size(); ++i) {
    straight.push_back(points[i].point);
    if (i + 1 < points.size() && isOpacityStep(points[i], points[i + 1]))
      tell(changes,
           Message::tr("Where the opacity is fully sharp it steps, as it was meant; programs on VTK since "
                       "2023 draw a ramp there by mistake."));
    if (i + 1 < points.size() && Segment(points[i], points[i + 1], rule).appendTo(straight))
      tell(changes, Message::tr("Curved segments became straight ones that differ from them by at most %1.")
                        .arg(Message::rounded(segmentTolerance, 2)));
    if (straight.size() > mostLookPoints)
      failReading(
          name, Message::tr("straight segments for its curves need more than %1 points").arg(mostLookPoints),
          Message::tr("save it with fewer points"));
  }
  return straight;
}

} // namespace limn
