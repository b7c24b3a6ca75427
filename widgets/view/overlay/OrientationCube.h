// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/ViewOrder.h"

#include <QColor>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <QTransform>

#include <array>
#include <optional>
#include <vector>

class QPainter;

namespace limn {

/// One face of the cube that shows how the picture lies: from where one looks at it, and what stands on it.
struct CubeFace {
  glm::dvec3 outward{0.0, -1.0, 0.0}; ///< world, unit length
  glm::dvec3 up{0.0, 0.0, 1.0}; ///< world, unit length: upwards on the face, and in the picture from there
  std::optional<StandardView> view; ///< which that is; none where sides are unknown
  QString letter;                   ///< "A"; of an axis of the grid "−y"
  QString meaning;                  ///< "Look from the front"
  QString side;                     ///< "Anterior"; of an axis of the grid "−y"
};

/// The six faces in the order of StandardView: those that lie opposite each other are 2n and 2n + 1. Where
/// the volume's sides are known they are the patient's; otherwise those of the voxel grid, however that lies.
std::array<CubeFace, 6> cubeFaces(const Volume& volume);

/// A face as it is seen; places in logical pixels, y down.
struct CubeSide {
  std::size_t face = 0; ///< of cubeFaces
  QString letter;
  QPolygonF outline;   ///< its four corners
  QTransform onto;     ///< from the face, which goes from -1 to 1 rightwards and downwards, to the view
  double facing = 1.0; ///< the cosine between its outward direction and the way to the eye, 0..1
};

/// The faces that a camera sees of a cube that fills a square of `size` in whatever way it is turned, around
/// `centre`. They do not overlap.
std::vector<CubeSide> cubeSides(const std::array<CubeFace, 6>& faces, const Camera& camera,
                                const QPointF& centre, double size);

/// The cube above the first picture, in its lower left corner above the scale.
struct OrientationCube {
  QRectF plate;
  std::vector<CubeSide> sides;
  std::optional<std::size_t> lit; ///< the face under the pointer
};

/// None where it is switched off, or the picture is so small that it would be in the way.
std::optional<OrientationCube> orientationCubeOf(const OverlaySource& source);

/// The face under a point of the view.
std::optional<std::size_t> cubeFaceAt(const OverlaySource& source, const QPointF& point);

/// The face from which a click on this one has one look: itself, or the opposite one where the picture is
/// looked at from there already, which shows no other.
std::size_t cubeFaceLedTo(const OverlaySource& source, std::size_t face);

/// Paints it, legible on any picture.
void paintOrientationCube(QPainter& painter, const OrientationCube& cube);

/// The colours of a face that faces the eye with this cosine, and of the letters on it.
QColor cubeFaceColor(double facing, bool isLit);
inline constexpr QColor cubeLetterColor(255, 255, 255);

} // namespace limn
