// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/FigureMeasures.h"

#include "planes/EllipseVoxels.h"
#include "widgets/MeasureText.h"
#include "widgets/figure/FigureText.h"
#include "widgets/planes/PlaneMeasures.h"
#include "widgets/view/overlay/ViewGeometry.h"

#include <QPainter>
#include <QTransform>

#include <algorithm>

namespace limn {
namespace {

constexpr int screenText = 12;    // the height of the text on screen for which marks are laid out, pixels
constexpr double inkBeside = 8.0; // handles and dark edges reach as far from the lines, of the same layout

// In the plane as the figure shows it, `scale` of its pixels one of the layout.
std::vector<MeasureShape> shapesInPlane(const FigurePanel& panel, const std::vector<Measured>& measured,
                                        const QSize& pixels, double scale) {
  PlaneContent content = planeContentOf(panel);
  content.measured = measured;
  PlaneFrame frame = planeFrameOf(panel, pixels);
  frame.pixelRatio = scale;
  return measureShapes(content, *panel.plane, frame);
}

std::vector<MeasureShape> shapesInScene(const FigurePanel& panel, const std::vector<Measured>& measured,
                                        const QSizeF& size) {
  const ViewProjection projection = viewProjection(panel.scene.camera, {{0.0, 0.0}, size});
  std::vector<MeasureShape> shapes;
  for (std::size_t number = 0; number < measured.size(); ++number) {
    const Measurement& one = measured[number].measurement;
    if (!isSeenInPicture(one))
      continue;
    MeasureShape shape{number, one.kind, {}, measureNoteText(measured[number], *panel.scene.volume)};
    for (const glm::dvec3& place : one.placesMm)
      if (const std::optional<QPointF> at = pixelOf(projection, place))
        shape.places.push_back(*at);
    if (shape.places.size() == one.placesMm.size())
      shapes.push_back(std::move(shape));
  }
  return shapes;
}

QTransform toFigure(const FigureMeasures& measures) {
  return QTransform::fromTranslate(measures.picture.left(), measures.picture.top())
      .scale(measures.scale, measures.scale);
}

} // namespace

FigureMeasures figureMeasures(const FigurePanel& panel, const FigureLayout& layout, const QRectF& picture,
                              const std::vector<QRectF>& plates) {
  FigureMeasures measures{picture, layout.textPixels / screenText, figureFont(layout), {}};
  measures.font.setPixelSize(screenText);
  const std::vector<Measured> measured = measuredIn(panel.scene.volume.get(), panel.measurements);
  const QSizeF size = picture.size() / measures.scale;
  const std::vector<MeasureShape> shapes =
      panel.plane ? shapesInPlane(panel, measured, picture.size().toSize(), measures.scale)
                  : shapesInScene(panel, measured, size);
  const QTransform fromFigure = toFigure(measures).inverted();
  std::vector<QRectF> kept;
  std::transform(plates.begin(), plates.end(), std::back_inserter(kept),
                 [&](const QRectF& plate) { return fromFigure.mapRect(plate); });
  measures.marks = placedMeasures(shapes, measures.font, {{0.0, 0.0}, size}, kept);
  return measures;
}

std::vector<QRectF> coveredBy(const FigureMeasures& measures) {
  std::vector<QRectF> covered;
  const auto add = [&](const QRectF& part) {
    const QRectF reached = part.adjusted(-inkBeside, -inkBeside, inkBeside, inkBeside);
    covered.push_back(toFigure(measures).mapRect(reached).intersected(measures.picture));
  };
  for (const MeasureMark& mark : measures.marks) {
    add(QPolygonF(QList<QPointF>(mark.shape.places.begin(), mark.shape.places.end())).boundingRect());
    if (mark.note)
      add(mark.note->plate.united(QRectF(mark.anchor, QSizeF(1.0, 1.0))));
  }
  return covered;
}

void paintFigureMeasures(QPainter& painter, const FigureMeasures& measures) {
  if (measures.marks.empty())
    return;
  painter.save();
  painter.setClipRect(measures.picture);
  painter.setTransform(toFigure(measures), true);
  painter.setFont(measures.font);
  paintMeasures(painter, measures.marks);
  painter.restore();
}

} // namespace limn
