// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/CropBoxOverlay.h"

#include <QPainter>

#include <cmath>
#include <numbers>

namespace limn {
namespace {

// Opaque inks: Qt blends a translucent line over the whole rectangle around it, which costs a software driver
// as much as a coarse picture. Everything light has something dark around it, so that it stands out from
// bright bone and from black alike.
const QColor lightColor(255, 255, 255);
const QColor darkColor(12, 14, 18);
const QColor hiddenColor(122, 128, 138); // of handles behind the box
const QColor accentColor(77, 163, 255);

// Dashes of 4 pixels, whatever their width: Qt counts in widths.
QPen linePen(const QColor& color, double width, bool isDashed) {
  QPen pen(color, width, Qt::SolidLine, Qt::FlatCap);
  if (isDashed)
    pen.setDashPattern({4.0 / width, 4.0 / width});
  return pen;
}

void paintEdges(QPainter& painter, const CropBoxShape& shape, bool hidden) {
  for (const auto& [color, width] : {std::pair(darkColor, 3.5), std::pair(lightColor, 1.5)}) {
    painter.setPen(linePen(color, width, hidden));
    for (const CropEdge& edge : shape.edges)
      if (edge.isHidden == hidden)
        painter.drawLine(edge.line);
  }
}

// A dark ring, a light one in it, and what tells its state in the middle.
void paintHandle(QPainter& painter, const CropHandle& handle, bool lively) {
  const double radius = lively ? cropHandleRadius + 1.5 : cropHandleRadius;
  painter.setPen(Qt::NoPen);
  const QColor middle = lively ? accentColor : handle.isHidden ? hiddenColor : lightColor;
  for (const auto& [color, inset] :
       {std::pair(darkColor, 0.0), std::pair(lightColor, 1.5), std::pair(middle, 3.0)}) {
    painter.setBrush(color);
    painter.drawEllipse(handle.centre, radius + 1.5 - inset, radius + 1.5 - inset);
  }
}

void paintHandles(QPainter& painter, const CropBoxShape& shape, const std::optional<CropFace>& lively,
                  bool hidden) {
  for (const CropHandle& handle : shape.handles)
    if (handle.isHidden == hidden)
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
