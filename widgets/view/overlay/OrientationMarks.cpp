// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/OrientationMarks.h"

#include "widgets/view/overlay/OverlayParts.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QString>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr double letterGap = 4.0;   // between a letter and a plate, logical pixels
constexpr double letterEdge = 4.0;  // between a letter and the upper or lower edge
constexpr double depthOfLane = 0.2; // of the picture, from its edge inwards

// Places that touch a plate's edge, and the wished one: a nearest free place is one of them.
std::vector<double> candidates(double wished, double size,
                               const std::vector<std::pair<double, double>>& taken) {
  std::vector<double> places{wished};
  for (const auto& [first, last] : taken)
    places.insert(places.end(), {first - letterGap - size, last + letterGap});
  return places;
}

bool isFree(const QRectF& place, const std::vector<QRectF>& plates) {
  return std::ranges::none_of(plates, [&](const QRectF& plate) {
    return plate.adjusted(-letterGap, -letterGap, letterGap, letterGap).intersects(place);
  });
}

// How far a place lies from the wished one: across the lane first, then along it.
std::pair<double, double> detour(const QRectF& wished, const QRectF& place, Qt::Orientation along) {
  const QPointF moved = place.topLeft() - wished.topLeft();
  const double x = std::abs(moved.x());
  const double y = std::abs(moved.y());
  return along == Qt::Horizontal ? std::pair(y, x) : std::pair(x, y);
}

// The strip at one edge of the picture in which a letter may stand: all of it, because a letter at the end of
// its edge tells more than none.
QRectF laneOf(const QRectF& wished, const LetterWish& wish, Qt::Orientation along) {
  const QRectF& picture = wish.picture;
  const QRectF inner = picture.adjusted(letterEdge, letterEdge, -letterEdge, -letterEdge);
  QRectF lane = inner;
  lane.setTop(inner.top() + wish.titles);
  if (along == Qt::Horizontal) {
    const double depth = std::max(depthOfLane * picture.height(), wished.height() + overlayMargin);
    wished.center().y() < picture.center().y() ? lane.setBottom(picture.top() + wish.titles + depth)
                                               : lane.setTop(picture.bottom() - depth);
  } else {
    const double depth = std::max(depthOfLane * picture.width(), wished.width() + overlayMargin);
    wished.center().x() < picture.center().x() ? lane.setRight(picture.left() + depth)
                                               : lane.setLeft(picture.right() - depth);
  }
  return lane;
}

// Nearer to the eye a scale would shrink to nothing, and behind it a turn would lead away what is seen.
constexpr double nearestShare = 0.01; // of the target's distance

double depthOf(const Camera& camera, const glm::dvec3& placeMm) {
  return glm::dot(placeMm - camera.position, basisOf(camera).forward);
}

} // namespace

std::optional<glm::dvec3> centreBeforeEye(const Camera& camera, const std::optional<glm::dvec3>& placeMm) {
  const bool isBefore =
      placeMm && depthOf(camera, *placeMm) > nearestShare * glm::length(camera.target - camera.position);
  return isBefore ? placeMm : std::nullopt;
}

Camera withTargetAsDeepAs(Camera camera, const std::optional<glm::dvec3>& placeMm) {
  if (const std::optional<glm::dvec3> centre = centreBeforeEye(camera, placeMm))
    camera.target = camera.position + depthOf(camera, *centre) * basisOf(camera).forward;
  return camera;
}

double mmPerPixel(const Camera& camera, double heightPixels, const std::optional<glm::dvec3>& placeMm) {
  if (camera.projection == Camera::Projection::orthographic)
    return camera.heightMm / heightPixels;
  const std::optional<glm::dvec3> centre = centreBeforeEye(camera, placeMm);
  const double depth = centre ? depthOf(camera, *centre) : glm::length(camera.target - camera.position);
  return 2.0 * halfHeight(camera) * depth / heightPixels;
}

ScaleBar scaleBar(double mmPerPixel, double mostPixels) {
  const double most = mmPerPixel * mostPixels;
  if (!(most > 0.0) || !std::isfinite(most))
    return {};
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  double length = power;
  for (double factor : {2.0, 5.0})
    if (factor * power <= most)
      length = factor * power;
  return {length, length / mmPerPixel};
}

std::string lettersOf(const glm::dvec3& direction) {
  constexpr double leastCosine = 0.2588; // cos 75°
  // LPS: +x is the patient's left, +y posterior, +z superior.
  constexpr std::array<const char*, 3> letters{"RL", "AP", "IS"};
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
  std::string text;
  for (int axis : order)
    if (std::abs(direction[axis]) > leastCosine)
      text += letters[axis][direction[axis] > 0.0 ? 1 : 0];
  return text;
}

OrientationLetters orientationLetters(const Camera& camera) {
  const CameraBasis basis = basisOf(camera);
  return {lettersOf(-basis.right), lettersOf(basis.right), lettersOf(basis.up), lettersOf(-basis.up)};
}

QSizeF letterSize(const QFont& font) {
  const QFontMetricsF metrics(titleFont(font));
  return {metrics.horizontalAdvance(QStringLiteral("WWW")), metrics.height()};
}

double letterInset(const QFont& font) {
  return overlayMargin + letterSize(font).height() / 2;
}

std::optional<QRectF> clearPlace(const QRectF& wished, const QRectF& lane, Qt::Orientation along,
                                 const std::vector<QRectF>& plates) {
  std::vector<std::pair<double, double>> columns;
  std::vector<std::pair<double, double>> rows;
  for (const QRectF& plate : plates) {
    columns.emplace_back(plate.left(), plate.right());
    rows.emplace_back(plate.top(), plate.bottom());
  }
  std::optional<QRectF> best;
  for (const double x : candidates(wished.left(), wished.width(), columns))
    for (const double y : candidates(wished.top(), wished.height(), rows)) {
      const QRectF place(QPointF(x, y), wished.size());
      const bool isWished = place == wished;
      if ((isWished || lane.contains(place)) && isFree(place, plates) &&
          (!best || detour(wished, place, along) < detour(wished, *best, along)))
        best = place;
    }
  return best;
}

LetterMarks letterMarks(const OrientationLetters& letters, const LetterWish& wish, const QFont& font,
                        const std::vector<QRectF>& plates) {
  const QSizeF size = letterSize(font);
  const double inset = letterInset(font);
  const QRectF& picture = wish.picture;
  const double edge = letterEdge + size.height() / 2;
  // With room for three, so that turning moves none; where that is not free, with room for what is written.
  const auto placeAt = [&](const std::string& text, double x, double y, Qt::Orientation along) {
    const QFontMetricsF metrics(titleFont(font));
    std::optional<QRectF> place;
    for (const double width : {size.width(), metrics.horizontalAdvance(QString::fromStdString(text))}) {
      const QRectF wished(x - width / 2, y - size.height() / 2, width, size.height());
      if (!place)
        place = clearPlace(wished, laneOf(wished, wish, along), along, plates);
    }
    return place;
  };
  const double top = picture.top() + std::max(edge, wish.titles + letterGap + size.height() / 2);
  std::optional<QRectF> upper = placeAt(letters.top, wish.across, top, Qt::Horizontal);
  if (upper && upper->bottom() > picture.center().y())
    upper.reset();
  return {letters,
          {placeAt(letters.left, picture.left() + inset, wish.down, Qt::Vertical),
           placeAt(letters.right, picture.right() - inset, wish.down, Qt::Vertical), upper,
           placeAt(letters.bottom, wish.across, picture.bottom() - edge, Qt::Horizontal)}};
}

void paintLetters(QPainter& painter, const LetterMarks& marks) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(titleFont(painter.font()));
  const auto& [left, right, top, bottom] = marks.letters;
  const std::array<const std::string*, 4> letters{&left, &right, &top, &bottom};
  for (std::size_t i = 0; i < letters.size(); ++i) {
    if (!marks.places[i])
      continue;
    const QString text = QString::fromStdString(*letters[i]);
    QRectF plate(0, 0, painter.fontMetrics().horizontalAdvance(text) + 2 * letterGap,
                 marks.places[i]->height());
    plate.moveCenter(marks.places[i]->center());
    paintPlate(painter, plate);
    paintOutlined(painter, *marks.places[i], text);
  }
  painter.restore();
}

} // namespace limn
