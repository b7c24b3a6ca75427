// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/ByteNodes.h"

#include "io/looks/curves/LookCurves.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double levels = 255.0;

ByteNodes::Node nodeOf(const ControlPoint& point, const ByteNodes& map) {
  const double fraction = (point.value - map.low) / (map.high - map.low);
  return {std::round(levels * fraction),
          {std::round(levels * point.color.r), std::round(levels * point.color.g),
           std::round(levels * point.color.b), std::round(levels * point.opacity)}};
}

double valueOf(const ByteNodes::Node& node, const ByteNodes& map) {
  return map.low + node.intensity / levels * (map.high - map.low);
}

// A range that the points span, or where they all lie at one value, some that begins there.
void setRange(ByteNodes& map, const std::vector<ControlPoint>& points) {
  map.low = points.front().value;
  map.high = points.back().value;
  if (map.low == map.high)
    map.high += std::max(1.0, std::abs(map.low) * 1e-6);
}

void tellRounding(const TransferFunction& function, const ByteNodes& map, std::vector<Message>& changes) {
  double moved = 0.0, shade = 0.0;
  for (const ControlPoint& point : function.points) {
    const ByteNodes::Node node = nodeOf(point, map);
    moved = std::max(moved, std::abs(valueOf(node, map) - point.value));
    const std::array<double, 4> exact{point.color.r, point.color.g, point.color.b, point.opacity};
    for (std::size_t channel = 0; channel < 4; ++channel)
      shade = std::max(shade, std::abs(node.rgba[channel] / levels - exact[channel]));
  }
  if (moved > 1e-9 * (map.high - map.low))
    changes.push_back(
        Message::tr("The format has 256 places for points: the values of some moved, by up to %1.")
            .arg(Message::rounded(moved, 3)));
  if (shade > 1e-9)
    changes.push_back(
        Message::tr("The format has colours and opacities in 256 levels: some were rounded, by up to %1.")
            .arg(Message::rounded(shade, 3)));
}

} // namespace

PointLook pointLook(const ByteNodes& map, const std::string& file) {
  if (map.low > map.high)
    failReading(file, Message::tr("its range of values ends before it begins"), saveLookAgain);
  PointLook look;
  look.isRelative = map.low == map.high;
  for (const ByteNodes::Node& node : map.nodes) {
    if (node.intensity < 0.0 || node.intensity > levels)
      failReading(file, Message::tr("the intensity of one of its points is not in 0..255"), saveLookAgain);
    const double value = look.isRelative ? node.intensity / levels : valueOf(node, map);
    look.points.push_back(
        {value, glm::dvec3(node.rgba[0], node.rgba[1], node.rgba[2]) / levels, node.rgba[3] / levels});
  }
  return look;
}

ByteNodes byteNodes(const TransferFunction& function, std::vector<Message>& changes) {
  const std::vector<ControlPoint>& points = function.points;
  ByteNodes map;
  setRange(map, points);
  std::size_t dropped = 0;
  for (const ControlPoint& point : points) {
    const ByteNodes::Node node = nodeOf(point, map);
    const std::size_t count = map.nodes.size();
    // Of several at one place only the first and the last are seen.
    if (count >= 2 && map.nodes[count - 2].intensity == node.intensity) {
      map.nodes.pop_back();
      ++dropped;
    }
    map.nodes.push_back(node);
  }
  if (map.nodes.back().intensity < levels)
    map.nodes.push_back({levels, map.nodes.back().rgba});
  tellRounding(function, map, changes);
  if (dropped > 0)
    changes.push_back(Message::tr("%1 points lie closer together than the format can tell and were left out.")
                          .arg(dropped));
  return map;
}

} // namespace limn
