// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetPainting.h"

#include "widgets/Theme.h"
#include "widgets/presets/PresetModel.h"

#include <QPainter>
#include <QPainterPath>
#include <QStyleOptionViewItem>

#include <cmath>
#include <numbers>

namespace limn {
namespace {

void paintPicture(QPainter& painter, const QRectF& place, const QImage& picture) {
  QPainterPath frame;
  frame.addRoundedRect(place, 4.0, 4.0);
  painter.save();
  painter.setClipPath(frame);
  // Fill the frame without distorting the picture.
  const QSizeF filled = QSizeF(picture.size()).scaled(place.size(), Qt::KeepAspectRatioByExpanding);
  QRectF target(QPointF(0.0, 0.0), filled);
  target.moveCenter(place.center());
  painter.drawImage(target, picture);
  painter.restore();
}

// What it makes of the volume, where that is known and there is something to see; otherwise its curve.
QImage pictureOf(const QModelIndex& index) {
  const auto picture = index.data(presetRole::picture).value<QImage>();
  const bool hasOnlyCurve = picture.isNull() || index.data(presetRole::showsNothing).toBool();
  return hasOnlyCurve ? index.data(presetRole::curve).value<QImage>() : picture;
}

// Of a favourite, in a corner of its picture; it stands out from any.
void paintStar(QPainter& painter, const QPointF& centre, const ThemeColors& colors) {
  constexpr double outer = 6.0;
  constexpr double inner = 2.6;
  QPolygonF star;
  for (int corner = 0; corner < 10; ++corner) {
    const double angle = std::numbers::pi * (corner / 5.0 - 0.5);
    star << centre + (corner % 2 ? inner : outer) * QPointF(std::cos(angle), std::sin(angle));
  }
  painter.setPen(QPen(QColor(0, 0, 0, 200), 2.0));
  painter.setBrush(colors.accent);
  painter.drawPolygon(star);
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(star);
}

} // namespace

void paintPresetCard(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                     const QRectF& card) {
  const ThemeColors colors = themeColors(option.palette);
  const auto use = static_cast<PresetUse>(index.data(presetRole::use).toInt());
  const bool hovered = option.state & QStyle::State_MouseOver;
  // Enter uses the one that has the keyboard, and in the search the best hit.
  const bool hasKeyboard =
      (option.state & QStyle::State_HasFocus) || index.data(presetRole::isBestHit).toBool();
  if (use == PresetUse::none && !hovered && !hasKeyboard)
    return;
  painter.setPen(use != PresetUse::none ? QPen(colors.accent, 1.5)
                 : hasKeyboard          ? QPen(colors.secondaryText, 1.0, Qt::DashLine)
                                        : QPen(Qt::NoPen));
  painter.setBrush(use != PresetUse::none || hovered ? QBrush(colors.hover) : QBrush(Qt::NoBrush));
  painter.drawRoundedRect(card.adjusted(0.75, 0.75, -0.75, -0.75), 6.0, 6.0);
}

void paintPresetPicture(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                        const QRectF& place) {
  paintPicture(painter, place, pictureOf(index));
  if (index.data(presetRole::isFavourite).toBool())
    paintStar(painter, place.topRight() + QPointF(-8.0, 8.0), themeColors(option.palette));
}

} // namespace limn
