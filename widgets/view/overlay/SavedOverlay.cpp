// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/SavedOverlay.h"

#include "widgets/view/overlay/OverlayParts.h"

#include <QPainter>

#include <algorithm>
#include <iterator>
#include <utility>

namespace limn {
namespace {

// As the picture lies when nobody has a hand on it.
OverlaySource leftAlone(OverlaySource source) {
  source.hovered = {};
  source.heldFace.reset();
  source.hasCropBox = false;
  source.hasCube = false;
  source.isTurning = false;
  source.read.reset();
  source.cutLine.reset();
  source.coveredBelow = 0.0;
  source.labelOpacity = 0.0; // numbers beside the titles are about the work
  source.comparison.markMm.reset();
  source.comparison.halfMm.reset();
  source.comparison.preview.clear();
  for (SeenMeasure& measure : source.comparison.measures)
    measure.isInHand = false;
  source.state.limitation.clear();
  source.state.refines = false;
  source.state.resting = true;
  return source;
}

} // namespace

Overlay savedOverlay(const OverlaySource& source, const SavedMarks& marks) {
  OverlaySource still = leftAlone(source);
  if (!marks.measurements)
    still.comparison.measures.clear();
  Overlay overlay = overlayOf(still);
  QStringList hidden;
  for (int position = 0; position < standingCount(still.geometry); ++position)
    for (const HiddenNote& note : hiddenNotesOf(still, position))
      hidden << note.note.text;
  const auto isWanted = [&](const Note& note) {
    return (marks.names && hidden.contains(note.text)) || (marks.warning && note.text == warningText()) ||
           (marks.letters && note.text == unknownOrientationText());
  };
  std::vector<Note> notes;
  std::ranges::copy_if(overlay.notes, std::back_inserter(notes), isWanted);
  for (Note& note : notes) // no pointer will make them say more
    if (hidden.contains(note.text))
      note.plate.setWidth(
          noteAt(source.font, note.text, note.plate.topLeft(), Qt::AlignLeft, note.plate.width())
              .plate.width());
  overlay.notes = std::move(notes);
  overlay.gap.reset(); // pictures stand without one in a file
  if (overlay.border)
    overlay.border->hasKnob = false; // nobody drags it there
  // No menu opens in a file.
  for (PlacedLabel& label : overlay.labels) {
    label.label.leadsToMenu = false;
    const double width = labelPlate(source.font, label.label, source.view(), Qt::AlignLeft).width();
    const bool isAtTheRight = label.plate.center().x() > source.view().center().x() &&
                              overlay.labels.size() == 2 &&
                              source.geometry.layout != CompareLayout::sideBySide;
    isAtTheRight ? label.plate.setLeft(label.plate.right() - width) : label.plate.setWidth(width);
  }
  if (!marks.names) {
    overlay.labels.clear();
    overlay.difference.reset();
    overlay.differenceBar.reset();
  }
  if (!marks.letters)
    overlay.letters.clear();
  if (!marks.scale)
    overlay.scale.reset();
  return overlay;
}

OverlaySource inFile(OverlaySource source, const QSize& size) {
  ViewGeometry& geometry = source.geometry;
  const double scale = std::max(static_cast<double>(size.width()) / geometry.size.width(),
                                static_cast<double>(size.height()) / geometry.size.height());
  const int height = std::max(1, qRound(size.height() / scale));
  const double aspect = static_cast<double>(size.width()) / size.height();
  geometry.size = QSize(std::max(1, qRound(height * aspect)), height);
  geometry.hasGap = false;
  return source;
}

QImage savedMarksImage(const OverlaySource& source, const SavedMarks& marks, const QSize& size) {
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  if (image.isNull() || source.geometry.size.isEmpty())
    return image;
  const OverlaySource shown = inFile(source, size);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const double factor = static_cast<double>(size.height()) / shown.geometry.size.height();
  painter.scale(factor, factor);
  paintOverlay(painter, savedOverlay(shown, marks));
  return image;
}

} // namespace limn
