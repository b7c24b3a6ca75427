// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/CropBoxOverlay.h"

#include <QPainter>

#include <cmath>
#include <numbers>

namespace limn {
namespace {

// Opaque inks: Qt blends a translucent line over the whole rectangle around it, which costs a software driver
// as much as a coarse picture. The grey of what is hidden has a contrast of about 4:1 on white and 5:1 on
// black.
const QColor lightColor(255, 255, 255);
const QColor darkColor(12, 14, 18);
const QColor hiddenColor(122, 128, 138);
const QColor accentColor(77, 163, 255);

void paintLines(QPainter& painter, const CropBoxShape& shape, bool hidden, const QPen& pen) {
  painter.setPen(pen);
  for (const CropEdge& edge : shape.edges)
    if (edge.isHidden == hidden)
      painter.drawLine(edge.line);
}

void paintEdges(QPainter& painter, const CropBoxShape& shape, bool hidden) {
  if (hidden)
    return paintLines(painter, shape, true, QPen(hiddenColor, 1.0, Qt::DashLine, Qt::FlatCap));
  for (const auto& [color, width] : {std::pair(darkColor, 3.0), std::pair(lightColor, 1.0)})
    paintLines(painter, shape, false, QPen(color, width, Qt::SolidLine, Qt::FlatCap));
}

void paintHandle(QPainter& painter, const CropHandle& handle, bool lively) {
  const double radius = lively ? cropHandleRadius + 1.5 : cropHandleRadius;
  painter.setPen(QPen(darkColor, 1.5));
  painter.setBrush(lively ? accentColor : handle.isHidden ? hiddenColor : lightColor);
  painter.drawEllipse(handle.centre, radius, radius);
}

void paintHandles(QPainter& painter, const CropBoxShape& shape, const std::optional<CropFace>& lively,
                  bool hidden) {
  for (const CropHandle& handle : shape.handles)
    if (handle.isHidden == hidden && handle.canMove)
      paintHandle(painter, handle, lively == handle.face);
}

} // namespace

void paintCropBox(QPainter& painter, const CropBoxShape& shape, const std::optional<CropFace>& lively) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const bool hidden : {true, false}) {
    paintEdges(painter, shape, hidden);
    paintHandles(painter, shape, lively, hidden);
  }
  painter.restore();
}

Qt::CursorShape cursorFor(const CropHandle& handle) {
  // The angle of the way, y up, folded to a half turn and counted in eighths of a turn.
  const double angle = std::atan2(-handle.outward.y(), handle.outward.x()) / std::numbers::pi * 4.0;
  const Qt::CursorShape cursors[] = {Qt::SizeHorCursor, Qt::SizeBDiagCursor, Qt::SizeVerCursor,
                                     Qt::SizeFDiagCursor};
  return cursors[(std::lround(angle) + 8) % 4];
}

} // namespace limn
