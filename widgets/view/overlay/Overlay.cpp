// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/Overlay.h"

#include "widgets/ValueText.h"
#include "widgets/view/overlay/LabelReading.h"
#include "widgets/view/overlay/OverlayParts.h"
#include "widgets/view/overlay/ViewGeometry.h"

#include <QObject>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QRegion>

#include <algorithm>
#include <cmath>

namespace limn {

QString warningText() {
  return QObject::tr("Not for diagnosis");
}

QString unknownOrientationText() {
  return QObject::tr("Orientation unknown");
}

QString readingText(double value, const Volume& volume) {
  return valueText(value, QString::fromStdString(volume.info().unit),
                   decimalsOfSpan(volume.range().highest - volume.range().lowest));
}

std::optional<ScaleMark> scaleMarkOf(const OverlaySource& source) {
  if (!source.volume().info().spacingKnown)
    return std::nullopt;
  const Camera& camera = source.comparison.scene.camera;
  const QRectF side = pictureRect(source.geometry, 0);
  const ScaleBar bar = scaleBar(mmPerPixel(camera, side.height(), source.comparison.turnsAboutMm),
                                std::min(160.0, side.width() / 4));
  if (bar.pixels < 8.0)
    return std::nullopt;
  const QString length = QObject::tr("%1 mm").arg(bar.lengthMm);
  // In perspective a length holds at one distance only: one that moving the picture leaves as it is.
  const bool perspective = camera.projection == Camera::Projection::perspective;
  const QString text = perspective ? QObject::tr("%1 at the pivot").arg(length) : length;
  return ScaleMark{bar, text, scaleBarPlate(source.font, bar, text, source.written(0))};
}

namespace {

// In the middle, clear of other plates and of the letters: it comes and goes, they stay.
Note passingNote(const QString& text, const OverlaySource& source, const Overlay& overlay,
                 std::vector<QRectF> plates) {
  for (const LetterMarks& marks : overlay.letters)
    for (const std::optional<QRectF>& place : marks.places)
      if (place)
        plates.push_back(*place);
  const double middle = source.view().center().x();
  Note note =
      noteAt(source.font, text, {middle, 0.0}, Qt::AlignHCenter, source.view().width() - 2 * overlayMargin);
  note.plate.moveTop(clearRowBelow(overlayMargin, note.plate.size(), {middle}, plates));
  return note;
}

// Of a line that is set corner by corner: whoever looks there sees how it ends. Else that what is seen is not
// what is edited.
QString passingText(const OverlaySource& source) {
  if (source.cutLine && source.cutLine->isByClicks)
    return QObject::tr("Enter or a double click closes the line. Esc takes it back.");
  const std::string& preview = source.comparison.preview;
  return preview.empty() ? QString() : QObject::tr("Preview: %1").arg(QString::fromStdString(preview));
}

// What the pictures are, at the upper edge; tells the plates.
std::vector<QRectF> addTitles(Overlay& overlay, const OverlaySource& source) {
  std::vector<QRectF> plates;
  overlay.labels = labelsOf(source);
  for (const PlacedLabel& label : overlay.labels)
    plates.push_back(label.steadyPlate);
  for (int position = 0; position < standingCount(source.geometry); ++position)
    for (const HiddenNote& hidden : hiddenNotesOf(source, position)) {
      overlay.notes.push_back(hidden.note);
      plates.push_back(hidden.note.plate);
    }
  overlay.difference = differenceTitleOf(source);
  overlay.explanationOpacity = source.labelOpacity;
  if (overlay.difference)
    plates.insert(plates.end(), {overlay.difference->label.plate, overlay.difference->note.plate});
  return plates;
}

// The bar of a difference, with its lower right corner there.
DifferenceBar differenceBarOf(const OverlaySource& source, const QPointF& corner) {
  const int most = static_cast<int>(std::lround(255.0 / differenceGain));
  DifferenceBar bar;
  bar.lowest = QStringLiteral("−%1").arg(most);
  bar.middle = QStringLiteral("0");
  bar.highest = QObject::tr("+%1 of 255").arg(most);
  bar.leftBrighter = QObject::tr("%1 brighter").arg(sideTitle(source.comparison, 0));
  bar.rightBrighter = QObject::tr("%1 brighter").arg(sideTitle(source.comparison, 1));
  bar.plate = differenceBarPlate(source.font, bar, corner);
  return bar;
}

// Scale, cube and notes at the lower edge; tells the plates. The notes never give way, the scale does.
std::vector<QRectF> addNotes(Overlay& overlay, const OverlaySource& source) {
  const double width = source.geometry.size.width();
  const double height = source.lowest();
  const double room = width - 2 * overlayMargin;
  const Note warning = noteAt(source.font, warningText(), {width - overlayMargin, height - overlayMargin},
                              Qt::AlignRight, room);
  overlay.notes.push_back(warning);
  std::vector<QRectF> plates{warning.plate};
  const std::optional<ScaleMark> scale = scaleMarkOf(source);
  if (scale && !scale->plate.adjusted(0.0, 0.0, overlayMargin, 0.0).intersects(warning.plate)) {
    overlay.scale = scale;
    plates.push_back(scale->plate);
  }
  overlay.cube = orientationCubeOf(source);
  if (overlay.cube)
    plates.push_back(overlay.cube->plate);
  if (source.geometry.layout == CompareLayout::difference) {
    overlay.differenceBar =
        differenceBarOf(source, warning.plate.topRight() - QPointF(0.0, overlayMargin / 3));
    plates.push_back(overlay.differenceBar->plate);
  }
  if (!source.state.limitation.isEmpty()) {
    Note note = noteAt(source.font, source.state.limitation, {width / 2.0, height - 3 * overlayMargin},
                       Qt::AlignHCenter, room);
    note.plate.moveBottom(
        clearRowAbove(note.plate.bottom(), note.plate.size(), {note.plate.center().x()}, plates));
    overlay.notes.push_back(note);
    plates.push_back(note.plate);
  }
  return plates;
}

// Where the letters above and below each picture stand.
std::vector<double> letterColumns(const ViewGeometry& geometry) {
  std::vector<double> columns;
  for (int position = 0; position < standingCount(geometry); ++position) {
    double column = pictureRect(geometry, position).center().x();
    if (geometry.layout == CompareLayout::wipe && std::abs(wipeX(geometry) - column) < 2 * overlayMargin)
      column = wipeX(geometry) + 2 * overlayMargin; // beside the border, not under it
    columns.push_back(column);
  }
  return columns;
}

// Letters keep clear of the handles of the crop box, too.
std::vector<QRectF> handlePlates(const std::vector<CropBoxOverlay>& boxes) {
  std::vector<QRectF> plates;
  for (const CropBoxOverlay& box : boxes)
    for (const CropHandle& handle : box.shape.handles) {
      const QPointF reach(cropHandleHitRadius, cropHandleHitRadius);
      plates.emplace_back(handle.centre - reach, handle.centre + reach);
    }
  return plates;
}

void addOrientation(Overlay& overlay, const OverlaySource& source, std::vector<QRectF> plates) {
  const double lowest = source.lowest() - overlayMargin;
  const std::vector<double> columns = letterColumns(source.geometry);
  if (!source.volume().info().orientationKnown) {
    Note note = noteAt(source.font, unknownOrientationText(), {0.0, 0.0}, Qt::AlignHCenter,
                       pictureRect(source.geometry, 0).width());
    note.plate.moveBottom(clearRowAbove(lowest, note.plate.size(), columns, plates));
    for (const double column : columns) {
      note.plate.moveLeft(column - note.plate.width() / 2);
      overlay.notes.push_back(note);
    }
    return;
  }
  const std::vector<QRectF> handles = handlePlates(overlay.cropBoxes);
  plates.insert(plates.end(), handles.begin(), handles.end());
  for (std::size_t position = 0; position < columns.size(); ++position) {
    const QRectF picture = source.written(static_cast<int>(position));
    const double titles = leavesMiddleFree(source, static_cast<int>(position))
                              ? 0.0
                              : overlay.labels[position].plate.bottom() - picture.top();
    overlay.letters.push_back(letterMarks(orientationLetters(source.comparison.scene.camera),
                                          {picture, columns[position], picture.center().y(), titles},
                                          source.font, plates));
  }
}

std::vector<double> progressOf(const PictureState& state) {
  std::vector<double> progress;
  if (state.refines)
    progress.push_back(state.refinementFraction);
  if (!state.resting && !state.sides.empty()) {
    double fraction = 0.0;
    for (const SideState& side : state.sides)
      fraction += side.fraction / static_cast<double>(state.sides.size());
    progress.push_back(fraction);
  }
  return progress;
}

// A marked place in every picture that has it in view, in front of or behind what is drawn.
std::vector<QPointF> marksOf(const OverlaySource& source, const std::optional<glm::dvec3>& worldMm) {
  std::vector<QPointF> marks;
  if (!worldMm)
    return marks;
  for (int position = 0; position < standingCount(source.geometry); ++position) {
    const QRectF picture = pictureRect(source.geometry, position);
    const auto at = pixelOf(viewProjection(source.comparison.scene.camera, picture), *worldMm);
    if (at && picture.contains(*at))
      marks.push_back(*at);
  }
  return marks;
}

// Beside all that is written, in each picture.
std::vector<Overlay::Measures> measuresOf(const OverlaySource& source, const Overlay& overlay,
                                          std::vector<QRectF> plates) {
  for (const LetterMarks& marks : overlay.letters)
    for (const std::optional<QRectF>& place : marks.places)
      if (place)
        plates.push_back(*place);
  std::vector<Overlay::Measures> measures;
  if (!source.comparison.measures.empty())
    for (int position = 0; position < standingCount(source.geometry); ++position)
      measures.push_back(
          {pictureRect(source.geometry, position),
           placedMeasures(measureShapesOf(source, position), source.font, source.written(position), plates)});
  return measures;
}

void addMarks(Overlay& overlay, const OverlaySource& source) {
  for (const QPointF& at : marksOf(source, source.comparison.markMm)) {
    const int side = sideAt(source, at);
    const bool isHidden = source.comparison.markIsHidden[static_cast<std::size_t>(side)];
    (isHidden ? overlay.hiddenMarks : overlay.marks).push_back(at);
  }
}

// Lines of the box would strike through what is written there.
QRegion besideTexts(const Overlay& overlay, const QRectF& picture) {
  QRegion region(picture.toAlignedRect());
  for (const PlacedLabel& label : overlay.labels)
    region -= label.plate.toAlignedRect();
  for (const Note& note : overlay.notes)
    region -= note.plate.toAlignedRect();
  if (overlay.scale)
    region -= overlay.scale->plate.toAlignedRect();
  if (overlay.cube)
    region -= overlay.cube->plate.toAlignedRect();
  return region;
}

void paintCropBoxes(QPainter& painter, const Overlay& overlay) {
  for (const CropBoxOverlay& box : overlay.cropBoxes) {
    painter.save();
    painter.setClipRegion(besideTexts(overlay, box.picture));
    paintCropBox(painter, box.shape, box.lively);
    if (box.note)
      paintNote(painter, *box.note);
    painter.restore();
  }
}

void paintTitles(QPainter& painter, const Overlay& overlay) {
  for (const PlacedLabel& label : overlay.labels)
    paintLabel(painter, label.label, label.plate);
  if (!overlay.difference)
    return;
  paintLabel(painter, overlay.difference->label.label, overlay.difference->label.plate);
  painter.setOpacity(overlay.explanationOpacity);
  paintNote(painter, overlay.difference->note);
  painter.setOpacity(1.0);
}

// Where two pictures lie one on the other, what either of them shows is seen.
bool isHiddenAt(const OverlaySource& source, const SeenMeasure& measure, int position) {
  if (standingCount(source.geometry) < pictureCount(source.geometry.layout))
    return measure.isHidden[0] && measure.isHidden[1];
  return measure.isHidden[static_cast<std::size_t>(sideShownAt(source.comparison, position))];
}

} // namespace

std::vector<MeasureShape> measureShapesOf(const OverlaySource& source, int position) {
  const ViewProjection projection =
      viewProjection(source.comparison.scene.camera, pictureRect(source.geometry, position));
  std::vector<MeasureShape> shapes;
  for (const SeenMeasure& measure : source.comparison.measures) {
    MeasureShape shape{measure.number,
                       measure.kind,
                       {},
                       measure.text,
                       measure.isInHand,
                       measure.isOpen,
                       isHiddenAt(source, measure, position)};
    for (const glm::dvec3& place : measure.placesMm)
      if (const std::optional<QPointF> at = pixelOf(projection, place))
        shape.places.push_back(*at);
    if (shape.places.size() == measure.placesMm.size() && !shape.places.empty())
      shapes.push_back(std::move(shape));
  }
  return shapes;
}

Overlay overlayOf(const OverlaySource& source) {
  Overlay overlay;
  overlay.view = source.view();
  overlay.font = source.font;
  if (source.geometry.layout == CompareLayout::sideBySide)
    overlay.gap =
        QRectF(pictureRect(source.geometry, 0).topRight(), pictureRect(source.geometry, 1).bottomLeft());
  overlay.cropBoxes = cropBoxesOf(source);
  if (source.geometry.layout == CompareLayout::wipe)
    overlay.border = Overlay::Border{wipeX(source.geometry), source.hovered.wipe};
  std::vector<QRectF> plates = addTitles(overlay, source);
  const std::vector<QRectF> notes = addNotes(overlay, source);
  plates.insert(plates.end(), notes.begin(), notes.end());
  addOrientation(overlay, source, plates);
  if (const QString text = passingText(source); !text.isEmpty())
    overlay.notes.push_back(passingNote(text, source, overlay, plates));
  addMarks(overlay, source);
  overlay.halves = marksOf(source, source.comparison.halfMm);
  if (source.isTurning)
    overlay.centres =
        marksOf(source, centreBeforeEye(source.comparison.scene.camera, source.comparison.turnsAboutMm));
  if (source.read)
    overlay.reading = Overlay::Reading{
        withLabelReading(readingText(source.read->value, source.volume()), source.read->label),
        source.read->at};
  overlay.measures = measuresOf(source, overlay, plates);
  overlay.cutLine = source.cutLine;
  overlay.progress = progressOf(source.state);
  return overlay;
}

std::vector<QRectF> writtenPlaces(const Overlay& overlay) {
  std::vector<QRectF> places;
  for (const PlacedLabel& label : overlay.labels)
    places.push_back(label.steadyPlate);
  for (const Note& note : overlay.notes)
    places.push_back(note.plate);
  if (overlay.differenceBar)
    places.push_back(overlay.differenceBar->plate);
  if (overlay.scale)
    places.push_back(overlay.scale->plate);
  if (overlay.cube)
    places.push_back(overlay.cube->plate);
  for (const LetterMarks& marks : overlay.letters)
    for (const std::optional<QRectF>& place : marks.places)
      if (place)
        places.push_back(*place);
  return places;
}

void paintOverlay(QPainter& painter, const Overlay& overlay) {
  painter.setFont(overlay.font);
  painter.setRenderHint(QPainter::TextAntialiasing);
  if (overlay.gap)
    painter.fillRect(*overlay.gap, QColor(70, 76, 88));
  paintCropBoxes(painter, overlay);
  if (overlay.cutLine)
    paintCutLine(painter, *overlay.cutLine);
  for (const Overlay::Measures& measures : overlay.measures) {
    painter.save();
    painter.setClipRect(measures.picture);
    paintMeasures(painter, measures.marks);
    painter.restore();
  }
  for (const QPointF& mark : overlay.marks)
    paintMark(painter, mark);
  for (const QPointF& mark : overlay.hiddenMarks)
    paintHiddenMark(painter, mark);
  for (const QPointF& half : overlay.halves)
    paintHalfMark(painter, half);
  for (const QPointF& centre : overlay.centres)
    paintTurnMark(painter, centre);
  if (overlay.border)
    paintWipeBorder(painter, overlay.border->x, overlay.view,
                    {overlay.border->isHovered, overlay.border->hasKnob});
  paintTitles(painter, overlay);
  for (const Note& note : overlay.notes)
    paintNote(painter, note);
  if (overlay.differenceBar)
    paintDifferenceBar(painter, *overlay.differenceBar);
  if (overlay.scale)
    paintScaleBar(painter, *overlay.scale);
  if (overlay.cube)
    paintOrientationCube(painter, *overlay.cube);
  for (const LetterMarks& letters : overlay.letters)
    paintLetters(painter, letters);
  if (overlay.reading)
    paintProbe(painter, overlay.reading->at, overlay.reading->text, overlay.view);
  for (const double fraction : overlay.progress)
    paintProgress(painter, fraction, overlay.view);
}

// Not on the widget itself: while a window is grabbed, Qt would lead its painters elsewhere.
void paintOverlayInContext(const Overlay& overlay, const ViewGeometry& geometry) {
  const glm::ivec2 size = deviceSize(geometry);
  QOpenGLPaintDevice device(size.x, size.y);
  device.setDevicePixelRatio(geometry.pixelRatio);
  QPainter painter(&device);
  paintOverlay(painter, overlay);
}

} // namespace limn
