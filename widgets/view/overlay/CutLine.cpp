// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/CutLine.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double leastStep = 2.0;     // logical pixels between corners of a line drawn in one go
constexpr double tremble = 5.0;       // what moved less is a click
constexpr double closingReach = 10.0; // a click this near to the first corner closes the line

const QColor lineColor(255, 196, 64);
const QColor veilColor(255, 64, 48, 70);

double apart(const QPointF& a, const QPointF& b) {
  return QLineF(a, b).length();
}

QPointF within(const QRectF& picture, const QPointF& point) {
  return {std::clamp(point.x(), picture.left(), picture.right()),
          std::clamp(point.y(), picture.top(), picture.bottom())};
}

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
  const QPointF along = b - a;
  const double length2 = QPointF::dotProduct(along, along);
  const double share =
      length2 > 0.0 ? std::clamp(QPointF::dotProduct(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return apart(p, a + share * along);
}

// Marks the corners that a line keeps which stays within `slack` of all others (Douglas and Peucker).
void keepCorners(const std::vector<QPointF>& line, std::size_t first, std::size_t last, double slack,
                 std::vector<bool>& isKept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double farthest = slack;
    std::size_t at = from;
    for (std::size_t n = from + 1; n < to; ++n)
      if (const double distance = distanceToSegment(line[n], line[from], line[to]); distance > farthest) {
        farthest = distance;
        at = n;
      }
    if (at == from)
      continue;
    isKept[at] = true;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
}

} // namespace

CutLine lineFrom(const QPointF& point, const QRectF& picture) {
  CutLine line;
  line.picture = picture;
  line.corners = {within(picture, point)};
  line.pointer = line.corners.front();
  line.isHeld = true;
  return line;
}

bool pressLine(CutLine& line, const QPointF& point) {
  line.pointer = within(line.picture, point);
  if (line.corners.size() >= 3 && apart(line.pointer, line.corners.front()) <= closingReach)
    return true;
  line.isHeld = true;
  if (apart(line.pointer, line.corners.back()) >= leastStep)
    line.corners.push_back(line.pointer);
  return false;
}

void moveLine(CutLine& line, const QPointF& point, bool isStraight) {
  line.pointer = within(line.picture, point);
  if (line.isHeld && line.isStraight && !isStraight)
    line.corners.push_back(line.pointer); // the end of the straight piece
  line.isStraight = line.isHeld && isStraight;
  if (line.isHeld && !isStraight && apart(line.pointer, line.corners.back()) >= leastStep)
    line.corners.push_back(line.pointer);
}

bool releaseLine(CutLine& line, const QPointF& point) {
  line.pointer = within(line.picture, point);
  if (line.isStraight || apart(line.pointer, line.corners.back()) >= leastStep)
    line.corners.push_back(line.pointer);
  line.isHeld = line.isStraight = false;
  const bool isClick = std::all_of(line.corners.begin(), line.corners.end(), [&line](const QPointF& corner) {
    return apart(corner, line.corners.front()) < tremble;
  });
  if (isClick)
    line.corners.resize(1);
  line.isByClicks = line.isByClicks || isClick;
  return !line.isByClicks;
}

bool shortenLine(CutLine& line) {
  if (line.corners.size() < 2)
    return false;
  line.corners.pop_back();
  return true;
}

bool isArea(const CutLine& line) {
  const std::vector<QPointF>& corners = line.corners;
  if (corners.size() < 3)
    return false;
  const auto farthest =
      std::max_element(corners.begin(), corners.end(), [&](const QPointF& a, const QPointF& b) {
        return apart(a, corners.front()) < apart(b, corners.front());
      });
  return std::any_of(corners.begin(), corners.end(), [&](const QPointF& corner) {
    return distanceToSegment(corner, corners.front(), *farthest) >= 1.0;
  });
}

std::vector<QPointF> closedLine(const CutLine& line) {
  std::vector<QPointF> closed = line.corners;
  if (line.isByClicks || line.isStraight)
    closed.push_back(line.pointer);
  return closed;
}

std::vector<glm::dvec2> polygonOf(const CutLine& line) {
  const std::vector<QPointF>& corners = line.corners;
  std::vector<bool> isKept(corners.size());
  if (!corners.empty()) {
    isKept.front() = isKept.back() = true;
    keepCorners(corners, 0, corners.size() - 1, 0.25, isKept);
  }
  const QPointF middle = line.picture.center();
  const double half = line.picture.height() / 2.0;
  std::vector<glm::dvec2> polygon;
  for (std::size_t n = 0; n < corners.size(); ++n)
    if (isKept[n])
      polygon.emplace_back((corners[n].x() - middle.x()) / half, (middle.y() - corners[n].y()) / half);
  return polygon;
}

void paintCutLine(QPainter& painter, const CutLine& line) {
  const QPolygonF corners(QList<QPointF>(line.corners.begin(), line.corners.end()));
  const std::vector<QPointF> closed = closedLine(line);
  const QPolygonF area(QList<QPointF>(closed.begin(), closed.end()));
  QPainterPath veil; // even-odd, as the voxels are cut
  veil.setFillRule(Qt::OddEvenFill);
  veil.addPolygon(area);
  veil.closeSubpath();
  if (!line.removesInside)
    veil.addRect(line.picture);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(line.picture);
  if (area.size() > 2)
    painter.fillPath(veil, veilColor);
  // Dark below light: seen on any tissue.
  for (const auto& [color, width] : {std::pair(QColor(0, 0, 0, 160), 4.0), std::pair(lineColor, 2.0)}) {
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(corners);
  }
  painter.setPen(QPen(lineColor, 1.5, Qt::DashLine));
  QPolygonF closing{corners.back()};
  if (line.isByClicks || line.isStraight)
    closing << line.pointer;
  if (area.size() > 2)
    closing << corners.front();
  painter.drawPolyline(closing);
  if (line.isByClicks) {
    painter.setPen(QPen(QColor(0, 0, 0, 160), 1.0));
    painter.setBrush(lineColor);
    for (const QPointF& corner : corners)
      painter.drawEllipse(corner, 3.0, 3.0);
  }
  painter.restore();
}

} // namespace limn
