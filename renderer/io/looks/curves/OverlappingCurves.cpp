// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/OverlappingCurves.h"

#include <algorithm>

namespace limn {
namespace {

using Curve = std::vector<ControlPoint>;

/// A piece of a curve between two neighbouring values: straight.
struct Piece {
  ControlPoint from;
  ControlPoint to;

  ControlPoint at(double u) const {
    return {from.value + u * (to.value - from.value), glm::mix(from.color, to.color, u),
            from.opacity + u * (to.opacity - from.opacity)};
  }
};

bool lessByValue(const ControlPoint& point, double value) {
  return point.value < value;
}

bool valueLess(double value, const ControlPoint& point) {
  return value < point.value;
}

// A curve between two values, no point of it lies between them. Nothing where it does not reach over them.
bool pieceOf(const Curve& curve, double low, double high, Piece& piece) {
  if (curve.front().value > low || curve.back().value < high)
    return false;
  const auto before = std::upper_bound(curve.begin(), curve.end(), low, valueLess) - 1;
  const auto after = std::lower_bound(curve.begin(), curve.end(), high, lessByValue);
  const Piece whole{*before, *after};
  const double width = after->value - before->value;
  piece = {whole.at((low - before->value) / width), whole.at((high - before->value) / width)};
  piece.from.value = low;
  piece.to.value = high;
  if (before->value == low)
    piece.from = *before;
  if (after->value == high)
    piece.to = *after;
  return true;
}

// Where the second of two pieces, less opaque at `u` or as opaque, passes the first; 1 where it does not.
double passedAt(const Piece& top, const Piece& other, double u) {
  const double ahead = top.from.opacity - other.from.opacity;
  const double behind = top.to.opacity - other.to.opacity;
  if (behind >= 0.0 || ahead <= behind)
    return 1.0;
  return std::clamp(ahead / (ahead - behind), u, 1.0);
}

std::size_t topAt(const std::vector<Piece>& pieces, double u) {
  std::size_t top = 0;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const double opacity = pieces[i].at(u).opacity, best = pieces[top].at(u).opacity;
    // Of two that are as opaque, the one that rises.
    if (opacity > best || (opacity == best && pieces[i].to.opacity > pieces[top].to.opacity))
      top = i;
  }
  return top;
}

void append(std::vector<ControlPoint>& points, const ControlPoint& point) {
  if (points.empty() || points.back() != point)
    points.push_back(point);
}

// The most opaque of the pieces, from the low end to the high end.
void appendMostOpaque(std::vector<ControlPoint>& points, const std::vector<Piece>& pieces) {
  std::size_t top = topAt(pieces, 0.0);
  double u = 0.0;
  append(points, pieces[top].at(0.0));
  for (std::size_t turns = 0; turns < pieces.size(); ++turns) {
    std::size_t next = top;
    double at = 1.0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (const double passed = passedAt(pieces[top], pieces[i], u); i != top && passed < at) {
        at = passed;
        next = i;
      }
    if (next == top)
      break;
    append(points, pieces[top].at(at));
    append(points, pieces[next].at(at));
    top = next;
    u = at;
  }
  append(points, pieces[top].to);
}

void appendClear(std::vector<ControlPoint>& points, double value, const glm::dvec3& color) {
  append(points, {value, color, 0.0});
}

} // namespace

TransferFunction joined(const std::vector<Curve>& curves, bool* overlap) {
  std::vector<double> values;
  for (const Curve& curve : curves)
    for (const ControlPoint& point : curve)
      values.push_back(point.value);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (overlap)
    *overlap = false;

  TransferFunction function;
  std::vector<ControlPoint>& points = function.points;
  const auto clearAt = [&](double value) {
    // In the colour of what ends or begins there.
    for (const Curve& curve : curves)
      if (curve.front().value == value || curve.back().value == value)
        return appendClear(points, value,
                           curve.front().value == value ? curve.front().color : curve.back().color);
  };
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    std::vector<Piece> pieces;
    for (const Curve& curve : curves)
      if (Piece piece; pieceOf(curve, values[i], values[i + 1], piece))
        pieces.push_back(piece);
    if (overlap && pieces.size() > 1)
      *overlap = true;
    if (i == 0)
      clearAt(values.front());
    if (pieces.empty()) {
      clearAt(values[i]);
      clearAt(values[i + 1]);
    } else {
      appendMostOpaque(points, pieces);
    }
  }
  if (!values.empty())
    clearAt(values.back());
  return function;
}

} // namespace limn
