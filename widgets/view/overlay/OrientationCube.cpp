// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/OrientationCube.h"

#include "widgets/view/overlay/OrientationMarks.h"
#include "widgets/view/overlay/OverlayParts.h"

#include <QFont>
#include <QObject>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double cubeSize = 72.0;         // logical pixels
constexpr double leastPictureFor = 300.0; // each way
constexpr double leastFacing = 0.03;      // a face that is seen on edge bears nothing
constexpr double borderReach = 2.0;       // of the line around it
constexpr double straightOn = 1e-6;       // how much less than 1 the cosine of the same direction may be

constexpr std::array cubeViews{StandardView::anterior, StandardView::posterior, StandardView::left,
                               StandardView::right,    StandardView::superior,  StandardView::inferior};

QString meaningOf(StandardView view) {
  switch (view) {
  case StandardView::anterior:
    return QObject::tr("Look from the front");
  case StandardView::posterior:
    return QObject::tr("Look from the back");
  case StandardView::left:
    return QObject::tr("Look from the left");
  case StandardView::right:
    return QObject::tr("Look from the right");
  case StandardView::superior:
    return QObject::tr("Look from above");
  case StandardView::inferior:
    return QObject::tr("Look from below");
  }
  return {};
}

QString sideOf(StandardView view) {
  switch (view) {
  case StandardView::anterior:
    return QObject::tr("Anterior");
  case StandardView::posterior:
    return QObject::tr("Posterior");
  case StandardView::left:
    return QObject::tr("Left");
  case StandardView::right:
    return QObject::tr("Right");
  case StandardView::superior:
    return QObject::tr("Superior");
  case StandardView::inferior:
    return QObject::tr("Inferior");
  }
  return {};
}

// Of a face across an axis of the grid.
QString gridMeaningOf(int axis, bool isLast) {
  switch (axis) {
  case 0:
    return isLast ? QObject::tr("Look from the last column") : QObject::tr("Look from the first column");
  case 1:
    return isLast ? QObject::tr("Look from the last row") : QObject::tr("Look from the first row");
  default:
    return isLast ? QObject::tr("Look from the last slice") : QObject::tr("Look from the first slice");
  }
}

// The same face of a cube that lies as the grid does: what is x, y, z there are columns, rows and slices.
CubeFace ofTheGrid(CubeFace face, const Grid& grid) {
  const glm::dvec3 along = face.outward;
  const int axis = std::abs(along.x) > 0.5 ? 0 : std::abs(along.y) > 0.5 ? 1 : 2;
  const bool isLast = along[axis] > 0.0;
  face.outward = grid.direction * along;
  face.up = grid.direction * face.up;
  face.view.reset();
  face.letter = (isLast ? QChar(u'+') : QChar(0x2212)) + QString(QLatin1Char("xyz"[axis]));
  face.meaning = gridMeaningOf(axis, isLast);
  face.side = face.letter;
  return face;
}

// A letter in the middle of a face, upright, of half its height.
QPainterPath letterPath(const QFont& font, const QString& letter) {
  QFont large(titleFont(font));
  large.setPixelSize(100);
  QPainterPath path;
  path.addText(0.0, 0.0, large, letter);
  const QRectF box = path.boundingRect();
  QPainterPath tall; // so that all are of one size
  tall.addText(0.0, 0.0, large, QStringLiteral("H"));
  const double scale = std::min(1.05 / tall.boundingRect().height(), 1.4 / std::max(box.width(), 1.0));
  QTransform middle;
  middle.scale(scale, scale);
  middle.translate(-box.center().x(), -box.center().y());
  return middle.map(path);
}

// Where it stands, whether there is a scale below it or not; above the bar of a difference, which may be
// wide.
QRectF cubePlate(const OverlaySource& source) {
  constexpr double gap = overlayMargin / 3;
  const QRectF picture = source.written(0);
  double below = scaleBarPlate(source.font, {}, {}, picture).height() + gap;
  if (source.geometry.layout == CompareLayout::difference)
    below = noteAt(source.font, {}, {}, Qt::AlignLeft, 0.0).plate.height() + gap +
            differenceBarPlate(source.font, {}, {}).height() + gap;
  return {picture.left() + overlayMargin, picture.bottom() - overlayMargin - below - cubeSize, cubeSize,
          cubeSize};
}

} // namespace

std::array<CubeFace, 6> cubeFaces(const Volume& volume) {
  std::array<CubeFace, 6> faces;
  Grid unturned;
  unturned.dims = glm::ivec3(1);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Camera camera = standardView({}, unturned, cubeViews[i]);
    CubeFace& face = faces[i];
    face.outward = glm::round(glm::normalize(camera.position - camera.target)); // along an axis
    face.up = camera.up;
    face.view = cubeViews[i];
    face.letter = QString::fromStdString(lettersOf(face.outward));
    face.meaning = meaningOf(cubeViews[i]);
    face.side = sideOf(cubeViews[i]);
    if (!volume.info().orientationKnown)
      face = ofTheGrid(face, volume.grid());
  }
  return faces;
}

std::vector<CubeSide> cubeSides(const std::array<CubeFace, 6>& faces, const Camera& camera,
                                const QPointF& centre, double size) {
  const CameraBasis basis = basisOf(camera);
  const double half = size / 2.0 / std::sqrt(3.0); // its corners never leave the square
  const auto seen = [&](const glm::dvec3& v) {
    return half * QPointF(glm::dot(v, basis.right), -glm::dot(v, basis.up));
  };
  std::vector<CubeSide> sides;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const CubeFace& face = faces[i];
    const double facing = -glm::dot(face.outward, basis.forward);
    if (facing < leastFacing)
      continue;
    const QPointF middle = centre + seen(face.outward);
    const QPointF right = seen(glm::cross(face.up, face.outward)); // for whoever looks at it
    const QPointF up = seen(face.up);
    sides.push_back(
        {i, face.letter,
         QPolygonF({middle - right + up, middle + right + up, middle + right - up, middle - right - up}),
         QTransform(right.x(), right.y(), -up.x(), -up.y(), middle.x(), middle.y()), facing});
  }
  return sides;
}

std::optional<OrientationCube> orientationCubeOf(const OverlaySource& source) {
  const QRectF picture = source.written(0);
  if (!source.hasCube || !source.hasOverlay || picture.width() < leastPictureFor ||
      picture.height() < leastPictureFor)
    return std::nullopt;
  OrientationCube cube;
  cube.plate = cubePlate(source);
  cube.sides = cubeSides(cubeFaces(source.volume()), source.comparison.scene.camera, cube.plate.center(),
                         cubeSize - 2 * borderReach);
  cube.lit = source.hovered.cubeFace;
  return cube;
}

std::optional<std::size_t> cubeFaceAt(const OverlaySource& source, const QPointF& point) {
  if (const std::optional<OrientationCube> cube = orientationCubeOf(source))
    for (const CubeSide& side : cube->sides)
      if (side.outline.containsPoint(point, Qt::OddEvenFill))
        return side.face;
  return std::nullopt;
}

std::size_t cubeFaceLedTo(const OverlaySource& source, std::size_t face) {
  const CubeFace shown = cubeFaces(source.volume())[face];
  const CameraBasis basis = basisOf(source.comparison.scene.camera);
  const bool isThere = -glm::dot(shown.outward, basis.forward) > 1.0 - straightOn &&
                       glm::dot(shown.up, basis.up) > 1.0 - straightOn;
  return isThere ? face ^ 1u : face;
}

// The more a face is turned to the eye the lighter it is.
QColor cubeFaceColor(double facing, bool isLit) {
  if (isLit)
    return {20, 92, 170};
  const auto between = [facing](int dark, int light) {
    return dark + static_cast<int>(std::lround(facing * (light - dark)));
  };
  return {between(34, 84), between(40, 94), between(48, 108)};
}

void paintOrientationCube(QPainter& painter, const OrientationCube& cube) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QFont font = painter.font();
  // Dark around light: one of both stands out from any picture.
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 190), 2 * borderReach, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  for (const CubeSide& side : cube.sides)
    painter.drawPolygon(side.outline);
  painter.setPen(QPen(QColor(226, 231, 238), 1.25, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  for (const CubeSide& side : cube.sides) {
    painter.setBrush(cubeFaceColor(side.facing, cube.lit == side.face));
    painter.drawPolygon(side.outline);
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(cubeLetterColor);
  for (const CubeSide& side : cube.sides)
    painter.drawPath(side.onto.map(letterPath(font, side.letter)));
  painter.restore();
}

} // namespace limn
