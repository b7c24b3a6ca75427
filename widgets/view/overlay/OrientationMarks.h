// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

#include <QFont>
#include <QRectF>

#include <array>
#include <optional>
#include <string>
#include <vector>

class QPainter;

namespace limn {

/// A bar of a round length.
struct ScaleBar {
  double lengthMm = 0.0; ///< 1, 2 or 5 times a power of ten
  double pixels = 0.0;
};

/// A place of the world that a camera can turn about so that what is seen follows the pointer: one that lies
/// before the eye, at least a hundredth as far as the target. Otherwise nothing: it turns about its target.
std::optional<glm::dvec3> centreBeforeEye(const Camera& camera, const std::optional<glm::dvec3>& placeMm);

/// The camera that sees the same, to rounding, with its target as deep as a place of the world that it can
/// turn about (centreBeforeEye); itself without one.
Camera withTargetAsDeepAs(Camera camera, const std::optional<glm::dvec3>& placeMm);

/// Millimetres per pixel of a picture `heightPixels` high, in the plane of the camera's target, or of a place
/// of the world that it can turn about (centreBeforeEye).
double mmPerPixel(const Camera& camera, double heightPixels, const std::optional<glm::dvec3>& placeMm = {});

/// The longest bar of a round length that is at most `mostPixels` long.
ScaleBar scaleBar(double mmPerPixel, double mostPixels);

/// The anatomical directions at the four edges of a picture, as letters: R right, L left, A anterior,
/// P posterior, S superior, I inferior; several where the view is oblique, the strongest first.
struct OrientationLetters {
  std::string left, right, top, bottom;
  bool operator==(const OrientationLetters&) const = default;
};

/// The letters of a world direction (LPS): every axis within 75° of it, the nearest first.
std::string lettersOf(const glm::dvec3& direction);

/// The letters at the edges of the camera's picture.
OrientationLetters orientationLetters(const Camera& camera);

/// The letters of the patient's sides at the edges of one picture, logical pixels.
struct LetterMarks {
  OrientationLetters letters;
  /// Left, right, top, bottom; none where a letter would lie on what is shown.
  std::array<std::optional<QRectF>, 4> places;
};

/// Where in `picture` letters are wished: `across` the place of the upper and the lower one, `down` that of
/// the left and the right one. The upper one stands below the rows of titles that take the upper
/// `titles` pixels of the picture, however wide those are at the moment: numbers come and go beside a title,
/// and no letter may move for them.
struct LetterWish {
  QRectF picture;
  double across = 0.0;
  double down = 0.0;
  double titles = 0.0;
};

/// The room an orientation letter takes.
QSizeF letterSize(const QFont& font);

/// The centre of a letter at the left or right edge lies so far from it.
double letterInset(const QFont& font);

/// The place nearest to `wished` that lies within `lane` and keeps clear of the plates: first as near as
/// possible to the edge along which the lane runs, then as little along it. None where nothing is free.
std::optional<QRectF> clearPlace(const QRectF& wished, const QRectF& lane, Qt::Orientation along,
                                 const std::vector<QRectF>& plates);

/// Letters at the edges of a picture, clear of the plates: along the edge where a plate is in the way,
/// inwards by at most a fifth of the picture from the titles on, and left out rather than put upon the
/// patient.
LetterMarks letterMarks(const OrientationLetters& letters, const LetterWish& wish, const QFont& font,
                        const std::vector<QRectF>& plates);

/// Paints those letters that have a place, on plates, so that they stand out from lines and bright tissue.
void paintLetters(QPainter& painter, const LetterMarks& marks);

} // namespace limn
