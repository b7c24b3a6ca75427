// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/function/PiecewiseTable.h"

#include "scene/function/MeanMaterial.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int binCount = 1024;
constexpr int segmentsPerRow = 256;
constexpr int texelsPerSegment = 4;
constexpr float beyondAllValues = 3e38f;

// A sample's bin is computed in float; a knot this near to an edge, in bins, belongs to both sides.
constexpr double edgeMargin = 1e-3;

// Knots as the shader sees them.
struct FloatKnot {
  float x;
  glm::vec4 value;
};

struct Segment {
  float start, end;
  glm::vec4 value, slope; // at the start, per unit of x
  glm::vec4 before{0.0f}; // integrals up to the start
};

Segment segmentBetween(const FloatKnot& left, const FloatKnot& right) {
  const double width = static_cast<double>(right.x) - left.x;
  const glm::dvec4 rise = glm::dvec4(right.value) - glm::dvec4(left.value);
  // Nearer than this, the slope would exceed what a float holds: a step.
  const bool isSloped = width > 1e-30;
  return {left.x, right.x, left.value, isSloped ? glm::vec4(rise / width) : glm::vec4(0.0f)};
}

Segment constantSegment(const FloatKnot& knot, float end) {
  return {knot.x, end, knot.value, glm::vec4(0.0f)};
}

std::vector<Segment> segmentsOf(const std::vector<FloatKnot>& knots) {
  std::vector<Segment> segments;
  segments.push_back(constantSegment(knots.front(), knots.front().x));
  for (std::size_t k = 1; k < knots.size(); ++k)
    segments.push_back(segmentBetween(knots[k - 1], knots[k]));
  segments.push_back(constantSegment(knots.back(), beyondAllValues));
  // Sum in double from knot to knot.
  glm::dvec4 integral(0.0);
  for (std::size_t k = 1; k < knots.size(); ++k) {
    const glm::dvec4 from(knots[k - 1].value);
    const glm::dvec4 to(knots[k].value);
    integral += (static_cast<double>(knots[k].x) - knots[k - 1].x) *
                meanOfPiece({glm::dvec3(from), from.a}, {glm::dvec3(to), to.a});
    segments[k + 1].before = glm::vec4(integral);
  }
  return segments;
}

void storeSegments(const std::vector<Segment>& segments, PiecewiseTable& table) {
  const int rows = static_cast<int>((segments.size() + segmentsPerRow - 1) / segmentsPerRow);
  table.segmentCount = static_cast<int>(segments.size());
  table.segmentsSize = {segmentsPerRow * texelsPerSegment, rows};
  table.segments.assign(static_cast<std::size_t>(table.segmentsSize.x) * rows, glm::vec4(0.0f));
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    glm::vec4* texels = &table.segments[texelsPerSegment * i];
    texels[0] = segment.value;
    texels[1] = segment.slope;
    texels[2] = {segment.start, segment.end, 0.0f, 0.0f};
    texels[3] = segment.before;
  }
}

// Places of the knots in units of bins. Where the domain has no width one bin serves all arguments.
std::vector<double> placesOf(const std::vector<FloatKnot>& knots, const ValueRange& limits,
                             PiecewiseTable& table) {
  const double first = std::max<double>(knots.front().x, limits.lowest);
  const double last = std::min<double>(knots.back().x, limits.highest);
  // A bin must not be narrower than a few steps of float.
  const double magnitude = std::max({std::abs(first), std::abs(last), 1e-30});
  const int count = static_cast<int>(std::clamp((last - first) / magnitude * 0x1p22, 1.0, double(binCount)));
  const bool hasWidth = count >= 8;
  // The outermost bins serve all arguments beyond the knots and hold none themselves.
  const double perUnit = hasWidth ? (count - 3) / (last - first) : 0.0;
  const float low = hasWidth ? static_cast<float>(first - 1.5 / perUnit) : 0.0f;
  table.bins.resize(hasWidth ? static_cast<std::size_t>(count) : 1);
  table.domain = {low, static_cast<float>(perUnit), static_cast<float>(table.bins.size() - 1)};
  std::vector<double> places;
  for (const FloatKnot& knot : knots) {
    if (hasWidth)
      places.push_back((static_cast<double>(knot.x) - low) * table.domain.y);
    else
      places.push_back(knot.x < limits.lowest ? -1.0 : knot.x > limits.highest ? 2.0 : 0.5);
  }
  return places;
}

// The function is linear between knots: its largest value in a bin lies at the bin's ends or at its knots.
float largestOpacityIn(const std::vector<Segment>& segments, const std::vector<FloatKnot>& knots,
                       std::size_t before, std::size_t after, double low, double high) {
  const auto valueAt = [&segments](std::size_t segment, double x) {
    const Segment& line = segments[segment];
    return static_cast<float>(line.value.a + (x - line.start) * line.slope.a);
  };
  float largest = std::max(valueAt(before, low), valueAt(after, high));
  for (std::size_t k = before; k < after; ++k)
    largest = std::max(largest, knots[k].value.a);
  return largest;
}

void storeBins(const std::vector<Segment>& segments, const std::vector<FloatKnot>& knots,
               const std::vector<double>& places, PiecewiseTable& table) {
  table.occupancy.resize(table.bins.size());
  int visible = 0;
  for (std::size_t bin = 0; bin < table.bins.size(); ++bin) {
    const auto low = static_cast<double>(bin);
    const auto before = std::lower_bound(places.begin(), places.end(), low - edgeMargin) - places.begin();
    const auto after =
        std::upper_bound(places.begin(), places.end(), low + 1.0 + edgeMargin) - places.begin();
    const auto knotAt = [&](std::ptrdiff_t k) {
      return k < after ? knots[static_cast<std::size_t>(k)].x : beyondAllValues;
    };
    table.bins[bin] = {segments[static_cast<std::size_t>(before)].start, knotAt(before), knotAt(before + 1),
                       static_cast<float>(before)};
    const double perUnit = table.domain.y > 0.0f ? table.domain.y : 1.0;
    const float largest = largestOpacityIn(
        segments, knots, static_cast<std::size_t>(before), static_cast<std::size_t>(after),
        table.domain.x + (low - edgeMargin) / perUnit, table.domain.x + (low + 1.0 + edgeMargin) / perUnit);
    table.occupancy[bin] = {largest, static_cast<float>(visible)};
    visible += largest > 0.0f ? 1 : 0;
    // The shader steps over two knots before it loops.
    table.loopSteps = std::max(table.loopSteps, static_cast<int>(after - before) - 2);
  }
}

} // namespace

PiecewiseTable piecewiseTable(const std::vector<Knot>& knots, const ValueRange& limits) {
  std::vector<FloatKnot> rounded;
  rounded.reserve(knots.size());
  for (const Knot& knot : knots)
    rounded.push_back({static_cast<float>(std::clamp(knot.x, -1e30, 1e30)), glm::vec4(knot.value)});
  if (rounded.empty())
    rounded.push_back({0.0f, glm::vec4(0.0f)});
  PiecewiseTable table;
  const std::vector<Segment> segments = segmentsOf(rounded);
  storeSegments(segments, table);
  storeBins(segments, rounded, placesOf(rounded, limits, table), table);
  return table;
}

PiecewiseTable tableOf(const TransferFunction& function, const ValueRange& range) {
  std::vector<Knot> knots;
  for (const ControlPoint& point : function.points)
    knots.push_back({normalisedValue(range, point.value), glm::dvec4(point.color, point.opacity)});
  return piecewiseTable(knots, {0.0, range.highest > range.lowest ? 1.0 : 0.0});
}

PiecewiseTable tableOf(const GradientOpacity& curve, double unit) {
  std::vector<Knot> knots;
  // A scene without a curve has the neutral one.
  if (curve.points.empty())
    knots.push_back({0.0, glm::dvec4(0.0, 0.0, 0.0, 1.0)});
  for (const GradientOpacityPoint& point : curve.points)
    knots.push_back({point.gradient / (unit > 0.0 ? unit : 1.0), glm::dvec4(0.0, 0.0, 0.0, point.opacity)});
  // No difference of normalised voxels is longer than √3 in these units.
  return piecewiseTable(knots, {0.0, 1.75});
}

} // namespace limn
