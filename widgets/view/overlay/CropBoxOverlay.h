// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/properties/CropFaces.h"
#include "widgets/view/overlay/OverlayParts.h"
#include "widgets/view/overlay/ViewGeometry.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <QLineF>
#include <Qt>

#include <optional>
#include <vector>

class QPainter;

namespace limn {

inline constexpr double cropHandleRadius = 6.0;     ///< logical pixels
inline constexpr double cropHandleHitRadius = 12.0; ///< so the hit area is 24 wide

/// An edge of the crop box as seen.
struct CropEdge {
  QLineF line;
  bool isHidden = false; ///< behind the box
};

/// The handle of a face as seen: in its middle, where that lies beyond the picture as near to it as the face
/// is seen (of a face that is not seen at all at the picture's edge), or, where the face lies across the line
/// of sight and would move along it, towards a corner as far as that is seen beside the texts at the edges of
/// the picture: of the face in front up to the right, of the one behind down to the left.
struct CropHandle {
  CropFace face;
  QPointF centre;
  QPointF outward;       ///< unit length: the way the face moves in the picture as the box grows
  bool isHidden = false; ///< on a face turned away from the eye
  bool isAcross = false; ///< the face lies across the line of sight
};

/// The crop box over a picture, logical pixels. What lies behind the eye is left out.
struct CropBoxShape {
  std::vector<CropEdge> edges;
  std::vector<CropHandle> handles;
};

/// The box of `crop` in a volume on `grid`.
CropBoxShape cropBoxShape(const CropBox& crop, const Grid& grid, const ViewProjection& projection);

/// The handle that a press takes hold of: the nearest within reach, one on a visible face before one behind.
std::optional<CropHandle> handleAt(const CropBoxShape& shape, const QPointF& pixel);

/// The middle of a face, world mm.
glm::dvec3 faceCentre(const CropBox& crop, const Grid& grid, CropFace face);

/// Where along its axis a face must lie, as a fraction of the volume, for its handle to be under the pointer,
/// or as near to it as its axis passes in the picture. Not limited to the volume; ±infinity beyond the point
/// where the axis vanishes. A face across the line of sight moves by as many mm as the pointer does beside
/// it, outwards as the handle's way leads. `crop` holds the place of the face before the drag.
double placeUnder(const CropBox& crop, const Grid& grid, CropFace face, const ViewProjection& projection,
                  const QPointF& pixel);

/// The crop box over one picture.
struct CropBoxOverlay {
  QRectF picture;
  CropBoxShape shape;
  std::optional<CropFace> lively; ///< the face whose handle is hovered or held
  std::optional<Note> note;       ///< what that face is called and cuts off
};

/// One for each picture that the box stands over; empty where it is not shown.
std::vector<CropBoxOverlay> cropBoxesOf(const OverlaySource& source);

/// The box that stands over the pictures: the turned one, or the crop's.
TurnedBox boxOver(const Comparison& comparison);

/// The crop box as it stands over the picture at `position`.
CropBoxShape cropShapeAt(const Comparison& comparison, const ViewGeometry& geometry, int position);

/// The handle that a press at `point` takes hold of.
std::optional<CropHandle> cropHandleAt(const OverlaySource& source, const QPointF& point);

/// Paints the crop box over a picture: light lines on dark ones, so that they show on any picture; what lies
/// behind the box is dimmer. `lively` is the face whose handle is hovered or held.
void paintCropBox(QPainter& painter, const CropBoxShape& shape, const std::optional<CropFace>& lively);

/// The pointer for a handle: two arrows along the way its face moves.
Qt::CursorShape cursorFor(const CropHandle& handle);

} // namespace limn
