// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/LookCurves.h"

#include "io/looks/curves/CurvedSegments.h"
#include "io/reading/ReadError.h"
#include "scene/ProjectionFacts.h"

#include <algorithm>
#include <cmath>
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

constexpr double highestByte = 255.0; // where such programs end a curve that does nothing

// Gradients are not negative: the curve from 0 on.
std::vector<GradientOpacityPoint> fromZero(const std::vector<ControlPoint>& curve) {
  std::vector<GradientOpacityPoint> points;
  const bool startsBelow = curve.front().value < 0.0;
  if (startsBelow)
    points.push_back({0.0, classify({1.0, curve}, 0.0).opacity});
  for (const ControlPoint& point : curve)
    if (point.value > 0.0 || (point.value == 0.0 && !startsBelow))
      points.push_back({point.value, point.opacity});
  return points;
}

bool isConstant(const std::vector<GradientOpacityPoint>& points) {
  return std::all_of(points.begin(), points.end(), [&](const GradientOpacityPoint& point) {
    return point.opacity == points.front().opacity;
  });
}

double spacingFor(const std::optional<LookTarget>& target, std::vector<Message>& changes) {
  if (target)
    tell(changes, Message::tr("Gradient opacity was converted between value per voxel and value per mm for "
                              "voxels of %1 mm.")
                      .arg(Message::rounded(target->meanSpacingMm, 4)));
  else
    tell(changes,
         Message::tr("Gradient opacity was converted between value per voxel and value per mm for voxels "
                     "of 1 mm; name the volume for which the look is meant (--for) to have its own."));
  return target ? target->meanSpacingMm : 1.0;
}

Message rangeText(double low, double high) {
  return Message::tr("%1 to %2").arg(Message::rounded(low, 6), Message::rounded(high, 6));
}

} // namespace

std::vector<ReadLook> finished(PointLook look, const std::string& file,
                               const std::optional<LookTarget>& target) {
  ReadLook read{{}, std::move(look.changes)};
  read.preset.name = lookNameOf(file);
  TransferFunction function{1.0, checkedCurve(std::move(look.points), file, read.changes)};
  if (look.isRelative) {
    function = stretchedOver(function, target, read.changes);
    function.points = checkedCurve(std::move(function.points), file, read.changes); // huge ones no longer are
  }
  read.preset.transferFunction = std::move(function);
  return {std::move(read)};
}

TransferFunction pointsAlone(const Preset& preset, std::vector<Message>& changes) {
  tellLostModel(preset.shading, changes);
  tellLostParts(preset, changes);
  if (preset.shading)
    tell(changes, Message::tr("Light and material were left out: the format has no place for them."));
  if (preset.gradientOpacity)
    tell(changes, Message::tr("The opacity by gradient was left out: the format has no place for it."));
  TransferFunction function = overOneMillimetre(preset.transferFunction, changes);
  if (function.points.empty())
    function.points.push_back({}); // transparent
  return function;
}

std::vector<ControlPoint> maskedTo(const std::vector<ControlPoint>& points, double low, double high) {
  const auto end = [&](double value, bool isClear) {
    const Classified seen = classify({1.0, points}, value);
    return ControlPoint{value, seen.color, isClear ? 0.0 : seen.opacity};
  };
  std::vector<ControlPoint> masked;
  if (std::isfinite(low))
    masked = {end(low, true), end(low, false)};
  for (const ControlPoint& point : points)
    if (point.value > low && point.value < high)
      masked.push_back(point);
  if (!std::isfinite(high))
    return masked;
  const auto atEnd = std::ranges::lower_bound(points, high, {}, &ControlPoint::value);
  const bool hasPoint = atEnd != points.end() && atEnd->value == high; // the first one, before any step there
  masked.push_back(hasPoint ? *atEnd : end(high, false));
  masked.push_back(masked.back());
  masked.back().opacity = 0.0;
  return masked;
}

std::vector<ControlPoint> simplified(const std::vector<ControlPoint>& points, double tolerance) {
  std::vector<ControlPoint> kept;
  for (std::size_t at = 0; at < points.size(); at = pieceEnd(points, at, tolerance))
    kept.push_back(points[at]);
  return kept;
}

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

std::optional<GradientOpacity> gradientOpacityFromVtk(const std::vector<ControlPoint>& curve,
                                                      const std::optional<LookTarget>& target,
                                                      std::vector<Message>& changes) {
  GradientOpacity opacity{fromZero(curve)};
  if (isConstant(opacity.points)) {
    if (opacity.points.front().opacity == 1.0)
      return std::nullopt;
    return opacity;
  }
  const double spacing = spacingFor(target, changes);
  for (GradientOpacityPoint& point : opacity.points)
    point.gradient /= spacing;
  return opacity;
}

std::vector<GradientOpacityPoint> gradientOpacityForVtk(const std::optional<GradientOpacity>& opacity,
                                                        const std::optional<LookTarget>& target,
                                                        std::vector<Message>& changes) {
  if (!opacity || opacity->points.empty())
    return {{0.0, 1.0}, {highestByte, 1.0}};
  std::vector<GradientOpacityPoint> points = opacity->points;
  if (isConstant(points))
    return points;
  const double spacing = spacingFor(target, changes);
  for (GradientOpacityPoint& point : points)
    point.gradient *= spacing;
  return points;
}

TransferFunction stretchedOver(const TransferFunction& function, const std::optional<LookTarget>& target,
                               std::vector<Message>& changes) {
  if (!target) {
    tell(changes,
         Message::tr("Its values are relative, from 0 to 1, and stay so; name the volume for which the "
                     "look is meant (--for) to stretch them over its range."));
    return function;
  }
  TransferFunction stretched = function;
  for (ControlPoint& point : stretched.points)
    point.value = target->low + point.value * (target->high - target->low);
  tell(changes, Message::tr("Its values from 0 to 1 were stretched over %1.")
                    .arg(rangeText(target->low, target->high)));
  return stretched;
}

TransferFunction overOneMillimetre(const TransferFunction& function, std::vector<Message>& changes) {
  if (function.unitDistanceMm == 1.0 || function.points.empty())
    return function;
  const auto rescaled = [&](double opacity) {
    return opacity < 1.0 ? -std::expm1(std::log1p(-opacity) / function.unitDistanceMm) : 1.0;
  };
  constexpr int looks = 64;
  std::vector<ControlPoint> seen;
  for (std::size_t i = 0; i < function.points.size(); ++i) {
    const ControlPoint& from = function.points[i];
    seen.push_back({from.value, from.color, rescaled(from.opacity)});
    if (i + 1 == function.points.size() || function.points[i + 1].opacity == from.opacity)
      continue;
    const ControlPoint& to = function.points[i + 1];
    for (int k = 1; k < looks; ++k) {
      const double u = k / double(looks);
      const ControlPoint between{std::lerp(from.value, to.value, u), glm::mix(from.color, to.color, u),
                                 rescaled(std::lerp(from.opacity, to.opacity, u))};
      if (between.value > seen.back().value && between.value < to.value)
        seen.push_back(between);
    }
  }
  tell(changes,
       Message::tr("Opacities over %1 mm became those over 1 mm, within %2.")
           .arg(Message::rounded(function.unitDistanceMm, 4), Message::rounded(segmentTolerance, 2)));
  return {1.0, simplified(seen, 0.8 * segmentTolerance)};
}

void tellLostModel(const std::optional<Shading>& shading, std::vector<Message>& changes) {
  if (!shading)
    return;
  if (shading->model == ShadingModel::enhanced || shading->model == ShadingModel::robust)
    tell(changes, Message::tr("The shading model %1 was left out, with its exponent range, opacity range and "
                              "gradient reference: other programs light by the classic model or not at all.")
                      .arg(nameOf(shading->model)));
  if (shading->model == ShadingModel::physical)
    tell(changes, Message::tr("Physical light was left out: other programs light by the classic model or not "
                              "at all."));
}

void tellLostParts(const Preset& preset, std::vector<Message>& changes) {
  if (preset.projection && *preset.projection != Projection::composite)
    tell(changes, Message::tr("The projection \"%1\" was left out.").arg(nameOf(*preset.projection)));
  if (preset.landmarks)
    tell(changes, Message::tr("How the look moves to data of another scale was left out."));
}

} // namespace limn
