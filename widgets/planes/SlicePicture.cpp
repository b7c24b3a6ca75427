// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/SlicePicture.h"

#include "scene/basics/Error.h"
#include "widgets/planes/PlaneOverlay.h"
#include "widgets/planes/PlanePictures.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Clear of the window of grey values, which stands in the same corner.
Note warningOf(const PlaneOverlay& overlay) {
  std::vector<QRectF> plates;
  for (const Note& note : overlay.notes)
    plates.push_back(note.plate);
  if (overlay.scale)
    plates.push_back(overlay.scale->plate);
  const QPointF corner = overlay.view.bottomRight() - QPointF(overlayMargin, overlayMargin);
  Note warning =
      noteAt(overlay.font, warningText(), corner, Qt::AlignRight, overlay.view.width() - 2.0 * overlayMargin);
  warning.plate.moveBottom(
      clearRowAbove(warning.plate.bottom(), warning.plate.size(), {warning.plate.center().x()}, plates));
  return warning;
}

PlaneOverlay keptOverlay(const SeenSlice& slice, const SavedMarks& marks) {
  PlaneContent content = slice.content;
  content.inHand.reset();
  if (!marks.measurements)
    content.measured.clear();
  PlaneOverlay overlay = planeOverlay(content, slice.plane, slice.frame, slice.size, slice.font);
  overlay.hasCrosshair = false;
  std::vector<Note> notes;
  for (const Note& note : overlay.notes) {
    const bool isName = note.text == overlay.title || note.text == overlay.window;
    if ((isName && marks.names) || (note.text == unknownOrientationText() && marks.letters))
      notes.push_back(note);
  }
  overlay.notes = std::move(notes);
  if (!marks.scale)
    overlay.scale.reset();
  if (!marks.letters)
    overlay.letters.reset();
  if (marks.warning)
    overlay.notes.push_back(warningOf(overlay));
  return overlay;
}

} // namespace

QImage slicePicture(const SeenSlice& slice, const SavedMarks& marks) {
  const PlaneFrame& frame = slice.frame;
  QImage picture(frame.grid.size.x, frame.grid.size.y, QImage::Format_RGB32);
  if (picture.isNull())
    throw Error(
        Error::Kind::other,
        Message::tr("There is not enough memory for a picture of %1 × %2 pixels; choose a smaller one.")
            .arg(frame.grid.size.x, frame.grid.size.y));
  picture.fill(Qt::black);
  PlaneContent content = slice.content;
  content.inHand.reset();
  const int linePixels = std::max(1, static_cast<int>(std::lround(frame.pixelRatio)));
  QPainter painter(&picture);
  painter.drawImage(0, 0, PlanePictures().picture(content, frame.grid, linePixels));
  painter.scale(frame.pixelRatio, frame.pixelRatio);
  paintPlaneOverlay(painter, keptOverlay(slice, marks));
  return picture;
}

} // namespace limn
