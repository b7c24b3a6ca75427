// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/MeasureMarks.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace limn {
namespace {

const QColor measureHalo(0, 0, 0, 180);
const QColor measureColor(255, 255, 255);
const QColor measureInHand(255, 196, 64);

constexpr double hiddenOpacity = 0.4; // of what lies behind what is seen: there, and plainly behind
constexpr double handleRadius = 4.0;  // logical pixels
constexpr double leastHandleRadius = 1.5;
constexpr double widestAcross = 60.0; // of what a distance spans, to each side
constexpr double aroundMark = 8.0;
constexpr double gapAround = 3.0;
constexpr double roomForText = 220.0;
constexpr double arcRadius = 16.0;
constexpr std::size_t mostKeptClear = 40;
constexpr std::array leaderLengths{18.0, 34.0, 58.0, 90.0, 130.0};

// An end at which a text can stand, and the way that leads away from what was measured.
struct Anchor {
  QPointF at;
  double degrees; // counted as QLineF counts: 0 right, 90 up
};

double bearingOf(const QPointF& from, const QPointF& to) {
  return from == to ? 45.0 : QLineF(from, to).angle();
}

std::vector<Anchor> anchorsOf(const MeasureShape& shape) {
  const std::vector<QPointF>& at = shape.places;
  switch (shape.kind) {
  case Measurement::Kind::ellipse:
    return {{at[1], 0.0}, {at[2], 90.0}, {at[3], 270.0}, {at[0], 180.0}};
  case Measurement::Kind::angle:
    if (at.size() == 3)
      return {{at[2], bearingOf(at[1], at[2])},
              {at[0], bearingOf(at[1], at[0])},
              {at[1], bearingOf((at[0] + at[2]) / 2.0, at[1])}};
    [[fallthrough]];
  case Measurement::Kind::distance:
    if (at.size() >= 2)
      return {{at[1], bearingOf(at[0], at[1])}, {at[0], bearingOf(at[1], at[0])}};
    [[fallthrough]];
  case Measurement::Kind::mark:
    break;
  }
  return {{at[0], 45.0}};
}

// A plate of a size whose nearest point lies so far from an anchor.
QRectF plateFrom(const Anchor& anchor, double degrees, double length, const QSizeF& size) {
  const double radians = degrees * std::numbers::pi / 180.0;
  const QPointF way(std::cos(radians), -std::sin(radians));
  const QPointF centre =
      anchor.at + length * way + QPointF(way.x() * size.width() / 2.0, way.y() * size.height() / 2.0);
  return {centre - QPointF(size.width(), size.height()) / 2.0, size};
}

QRectF movedInto(QRectF plate, const QRectF& view) {
  plate.moveLeft(std::clamp(plate.left(), view.left(), std::max(view.left(), view.right() - plate.width())));
  plate.moveTop(std::clamp(plate.top(), view.top(), std::max(view.top(), view.bottom() - plate.height())));
  return plate;
}

// How bad a place is: 0 where it covers nothing. What others measured may rather be covered than their texts.
double coveredBy(const QRectF& plate, const QPainterPath& area, const std::vector<QRectF>& plates,
                 const std::vector<QRectF>& others) {
  const QRectF kept = plate.adjusted(-gapAround, -gapAround, gapAround, gapAround);
  double area2 = area.intersects(kept) ? 1e6 : 0.0;
  for (const QRectF& other : plates) {
    const QRectF both = kept.intersected(other);
    area2 += both.isEmpty() ? 0.0 : both.width() * both.height();
  }
  for (const QRectF& other : others) {
    const QRectF both = kept.intersected(other);
    area2 += both.isEmpty() ? 0.0 : 0.25 * both.width() * both.height();
  }
  return area2;
}

struct TextPlace {
  QRectF plate;
  QPointF anchor;
};

QPointF nearestOf(const QRectF& plate, const QPointF& point) {
  return {std::clamp(point.x(), plate.left(), plate.right()),
          std::clamp(point.y(), plate.top(), plate.bottom())};
}

double awayFrom(const QRectF& plate, const QPointF& point) {
  return QLineF(nearestOf(plate, point), point).length();
}

// By these a text would be taken for what was measured there: its places, and the middles between them.
std::vector<QPointF> landmarksOf(const MeasureShape& shape) {
  std::vector<QPointF> points = shape.places;
  for (std::size_t n = 1; n < shape.places.size(); ++n)
    points.push_back((shape.places[n - 1] + shape.places[n]) / 2.0);
  return points;
}

// What another measurement is around it, and by which points a text may be mistaken for it.
struct OtherMeasures {
  std::vector<QRectF> boxes;
  std::vector<QPointF> landmarks;
};

// A text nearer to another measurement than to its own: less bad than one that covers anything.
double mistaken(const QRectF& plate, const QPointF& anchor, const std::vector<QPointF>& landmarks) {
  const double own = awayFrom(plate, anchor);
  return std::ranges::any_of(landmarks, [&](const QPointF& one) { return awayFrom(plate, one) <= own; })
             ? 1.0
             : 0.0;
}

TextPlace placeFor(const MeasureShape& shape, const QSizeF& size, const QRectF& view,
                   const std::vector<QRectF>& plates, const OtherMeasures& others) {
  const QPainterPath area = measuredArea(shape);
  TextPlace best;
  double least = std::numeric_limits<double>::max();
  const std::vector<Anchor> anchors = anchorsOf(shape);
  for (const double length : leaderLengths)
    for (const Anchor& anchor : anchors)
      for (const double turn : {0.0, 30.0, -30.0, 60.0, -60.0, 90.0, -90.0}) {
        const QRectF plate = movedInto(plateFrom(anchor, anchor.degrees + turn, length, size), view);
        const double cost =
            coveredBy(plate, area, plates, others.boxes) + mistaken(plate, anchor.at, others.landmarks);
        if (cost < least) {
          least = cost;
          best = {plate, anchor.at};
        }
        if (least == 0.0)
          return best;
      }
  return best;
}

// Of a crowd nothing, where no text finds a place beside all anyway.
OtherMeasures othersOf(const std::vector<MeasureShape>& shapes, std::size_t self) {
  OtherMeasures others;
  for (std::size_t n = 0; n < shapes.size() && shapes.size() <= mostKeptClear; ++n)
    if (n != self) {
      others.boxes.push_back(measuredArea(shapes[n]).boundingRect());
      std::ranges::copy(landmarksOf(shapes[n]), std::back_inserter(others.landmarks));
    }
  return others;
}

QPainterPath linesOf(const MeasureShape& shape) {
  const std::vector<QPointF>& at = shape.places;
  QPainterPath path;
  if (shape.kind == Measurement::Kind::ellipse) {
    path.addEllipse(QRectF(QPointF(at[0].x(), at[2].y()), QPointF(at[1].x(), at[3].y())));
  } else if (shape.kind == Measurement::Kind::mark) {
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
      path.moveTo(at[0] + handleRadius * way);
      path.lineTo(at[0] + 2.0 * handleRadius * way);
    }
  } else {
    path.moveTo(at[0]);
    for (std::size_t n = 1; n < at.size(); ++n)
      path.lineTo(at[n]);
  }
  if (shape.kind == Measurement::Kind::angle && at.size() == 3 && at[0] != at[1] && at[2] != at[1]) {
    const double radius = std::min({arcRadius, QLineF(at[1], at[0]).length(), QLineF(at[1], at[2]).length()});
    const QRectF circle(at[1] - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
    const double first = bearingOf(at[1], at[0]);
    const double sweep = std::remainder(bearingOf(at[1], at[2]) - first, 360.0);
    path.arcMoveTo(circle, first);
    path.arcTo(circle, first, sweep);
  }
  return path;
}

// Dark below light: seen on any tissue.
void strokeTwice(QPainter& painter, const QPainterPath& path, const QColor& color, double width) {
  painter.setBrush(Qt::NoBrush);
  for (const auto& [ink, inkWidth] : {std::pair(measureHalo, width + 2.0), std::pair(color, width)}) {
    painter.setPen(QPen(ink, inkWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
  }
}

// Of something small they would hide what was measured.
double radiusOfHandles(const MeasureShape& shape) {
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t n = 0; n < shape.places.size(); ++n)
    for (std::size_t other = 0; other < n; ++other)
      nearest = std::min(nearest, QLineF(shape.places[n], shape.places[other]).length());
  return std::clamp(nearest / 4.0, leastHandleRadius, handleRadius);
}

void paintShape(QPainter& painter, const MeasureShape& shape) {
  const QColor& color = shape.isInHand ? measureInHand : measureColor;
  strokeTwice(painter, linesOf(shape), color, shape.isInHand ? 1.75 : 1.25);
  painter.setPen(QPen(measureHalo, 1.0));
  painter.setBrush(color);
  // Of an ellipse the handles show while it is in hand: they lie on what is looked at.
  if (shape.kind != Measurement::Kind::ellipse || shape.isInHand)
    for (const QPointF& place : shape.places)
      painter.drawEllipse(place, radiusOfHandles(shape), radiusOfHandles(shape));
}

} // namespace

QPainterPath measuredArea(const MeasureShape& shape) {
  const std::vector<QPointF>& at = shape.places;
  QPainterPath area;
  if (shape.kind == Measurement::Kind::ellipse) {
    area.addEllipse(QRectF(QPointF(at[0].x(), at[2].y()), QPointF(at[1].x(), at[3].y())));
  } else if (shape.kind == Measurement::Kind::angle && at.size() == 3) {
    area.addPolygon(QPolygonF({at[0], at[1], at[2]}));
    area.closeSubpath();
  } else if (at.size() == 2) {
    const double half = QLineF(at[0], at[1]).length() / 2.0;
    const double across = std::min(half, widestAcross);
    QTransform toLine;
    toLine.translate((at[0].x() + at[1].x()) / 2.0, (at[0].y() + at[1].y()) / 2.0);
    toLine.rotate(-bearingOf(at[0], at[1]));
    area.addEllipse(QPointF(0.0, 0.0), half, across);
    area = toLine.map(area);
  } else {
    area.addEllipse(at[0], aroundMark, aroundMark);
  }
  return area;
}

std::vector<MeasureMark> placedMeasures(const std::vector<MeasureShape>& shapes, const QFont& font,
                                        const QRectF& view, std::vector<QRectF> plates) {
  std::vector<MeasureMark> marks;
  for (const MeasureShape& shape : shapes) {
    MeasureMark mark{shape, std::nullopt, {}};
    if (!shape.text.isEmpty()) {
      Note note = noteAt(font, shape.text, {0.0, 0.0}, Qt::AlignLeft,
                         std::clamp(0.45 * view.width(), 0.0, roomForText));
      const TextPlace placed =
          placeFor(shape, note.plate.size(), view, plates, othersOf(shapes, marks.size()));
      note.plate = placed.plate;
      plates.push_back(note.plate);
      mark.anchor = placed.anchor;
      mark.note = note;
    }
    marks.push_back(mark);
  }
  return marks;
}

std::optional<MeasureHandle> measureHandleAt(const std::vector<MeasureShape>& shapes, const QPointF& point) {
  std::optional<MeasureHandle> found;
  double nearest = measureHandleReach;
  for (const MeasureShape& shape : shapes)
    for (std::size_t place = 0; place < shape.places.size() && !shape.isOpen; ++place)
      if (const double away = QLineF(shape.places[place], point).length(); away <= nearest) {
        nearest = away;
        found = {shape.number, place};
      }
  return found;
}

void paintMeasures(QPainter& painter, const std::vector<MeasureMark>& marks) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const MeasureMark& mark : marks) {
    painter.setOpacity(mark.shape.isHidden ? hiddenOpacity : 1.0);
    if (mark.note) {
      QPainterPath leader(mark.anchor);
      leader.lineTo(nearestOf(mark.note->plate, mark.anchor));
      strokeTwice(painter, leader, mark.shape.isInHand ? measureInHand : measureColor, 0.75);
    }
    paintShape(painter, mark.shape);
  }
  painter.restore();
  // Texts over every line, and never faint: what stands there is read.
  for (const MeasureMark& mark : marks)
    if (mark.note) {
      paintPlate(painter, mark.note->plate); // and its own: numbers are read on white bone, too
      paintNote(painter, *mark.note);
    }
}

} // namespace limn
