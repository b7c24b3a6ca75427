// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/CropBoxOverlay.h"
#include "widgets/view/overlay/MeasureMarks.h"
#include "widgets/view/overlay/OrientationCube.h"
#include "widgets/view/overlay/OrientationMarks.h"
#include "widgets/view/overlay/Titles.h"

#include <optional>
#include <vector>

class QPainter;

namespace limn {

/// What stands above the pictures, ready to be painted; places in logical pixels.
struct Overlay {
  /// The border of the wipe.
  struct Border {
    double x = 0.0;
    bool isHovered = false;
    bool hasKnob = true; ///< by which it is dragged
  };
  /// A value beside the point at which it was read.
  struct Reading {
    QString text;
    QPointF at;
  };

  /// What was measured, over one picture.
  struct Measures {
    QRectF picture;
    std::vector<MeasureMark> marks;
  };

  QRectF view;
  QFont font;
  std::optional<QRectF> gap; ///< between pictures side by side
  std::vector<CropBoxOverlay> cropBoxes;
  std::optional<Border> border;
  std::vector<PlacedLabel> labels;
  std::optional<DifferenceTitle> difference;
  std::optional<DifferenceBar> differenceBar;
  double explanationOpacity = 1.0; ///< of the note under the title of a difference
  std::vector<Note> notes;
  std::optional<ScaleMark> scale;
  std::optional<OrientationCube> cube;
  std::vector<LetterMarks> letters;
  std::optional<Reading> reading;
  std::vector<QPointF> marks;       ///< where a marked place is seen in each picture that shows it
  std::vector<QPointF> hiddenMarks; ///< the same in pictures in which something lies before it
  std::vector<QPointF> halves;      ///< the same of where half of a ray's light is gathered
  std::vector<QPointF> centres;     ///< the same of the place about which the pictures are turned
  std::vector<Measures> measures;
  std::optional<CutLine> cutLine;
  std::vector<double> progress; ///< each 0..1
};

/// What notes over pictures say: what no picture is for, and that sides are unknown.
QString warningText();
QString unknownOrientationText();

/// A value of a volume with its unit and as many digits as the volume's range makes sensible.
QString readingText(double value, const Volume& volume);

/// The scale in the corner; in perspective it holds at the depth of the place about which turns go. None
/// where spacings are unknown.
std::optional<ScaleMark> scaleMarkOf(const OverlaySource& source);

/// What was measured, where it is seen in the picture at a position. What lies behind the eye is not.
std::vector<MeasureShape> measureShapesOf(const OverlaySource& source, int position);

/// Lays everything out; nothing is painted yet.
Overlay overlayOf(const OverlaySource& source);

/// Where something is written over the pictures that stays there: titles, notes, scales, cube and letters.
std::vector<QRectF> writtenPlaces(const Overlay& overlay);

/// Paints what stands above the pictures, in the painter's logical pixels.
void paintOverlay(QPainter& painter, const Overlay& overlay);

/// Paints it into the framebuffer bound in the current OpenGL context.
void paintOverlayInContext(const Overlay& overlay, const ViewGeometry& geometry);

} // namespace limn
