// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/properties/CropFaces.h"
#include "widgets/view/Comparison.h"
#include "widgets/view/ViewGeometry.h"
#include "widgets/view/pictures/PictureState.h"

#include <QFont>
#include <QPointF>

#include <optional>

namespace limn {

/// What may hide a part of the volume.
enum class HiddenBy { region, crop };

/// A note that tells what is hidden.
struct HiddenPlace {
  int position; ///< of its picture
  HiddenBy by;
  bool operator==(const HiddenPlace&) const = default;
};

/// What of the overlay the pointer is over, or holds.
struct Hovered {
  int label = -1; ///< the position of a picture, -1 for none
  bool wipe = false;
  std::optional<HiddenPlace> hidden;
  std::optional<CropFace> face;
  bool operator==(const Hovered&) const = default;
};

/// A value read under the pointer.
struct ReadValue {
  double value = 0.0; ///< scalar units
  QPointF at;         ///< logical pixels
};

/// Everything from which follows what stands above the pictures; there is a volume.
struct OverlaySource {
  const Comparison& comparison;
  ViewGeometry geometry;
  PictureState state;
  QFont font;
  double labelOpacity = 1.0; ///< of the numbers beside the titles
  Hovered hovered;
  bool hasCropBox = false;
  std::optional<CropFace> heldFace;
  std::optional<ReadValue> read;
  double coveredBelow = 0.0; ///< by a panel over the pictures' lower edge, logical pixels

  const Volume& volume() const { return *comparison.scene.volume; }
  QRectF view() const { return {{0.0, 0.0}, QSizeF(geometry.size)}; }
  /// Below which nothing is written.
  double lowest() const { return geometry.size.height() - coveredBelow; }
  /// The part of a picture in which something is written.
  QRectF written(int position) const {
    return pictureRect(geometry, position).adjusted(0, 0, 0, -coveredBelow);
  }
};

} // namespace limn
