// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetDelegate.h"

#include "widgets/Theme.h"
#include "widgets/presets/PresetModel.h"

#include <QPainter>
#include <QPainterPath>

namespace limn {
namespace {

constexpr int cardHeight = 56;
constexpr int groupHeight = 32;
constexpr int margin = 8;

void paintGroup(QPainter& painter, const QStyleOptionViewItem& option, const QString& title) {
  QFont bold = option.font;
  bold.setWeight(QFont::DemiBold);
  painter.setFont(bold);
  painter.setPen(themeColors(option.palette).secondaryText);
  painter.drawText(option.rect.adjusted(margin + 4, 4, -margin, 0), Qt::AlignLeft | Qt::AlignVCenter, title);
}

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

void paintTexts(QPainter& painter, const QStyleOptionViewItem& option, const QRect& place,
                const QModelIndex& index, const QColor& name, const QColor& note) {
  const QString noteText = index.data(presetRole::note).toString();
  const QFontMetrics metrics(option.font);
  QFont small = option.font;
  small.setPointSizeF(small.pointSizeF() * 0.9);
  const QFontMetrics smallMetrics(small);
  const int height = noteText.isEmpty() ? metrics.height() : metrics.height() + smallMetrics.height();
  QRect line(place.left(), place.center().y() - height / 2, place.width(), metrics.height());
  painter.setFont(option.font);
  painter.setPen(name);
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideRight, line.width()));
  line.translate(0, metrics.height());
  painter.setFont(small);
  painter.setPen(note);
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                   smallMetrics.elidedText(noteText, Qt::ElideRight, line.width()));
}

} // namespace

void PresetDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
  painter->save();
  painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  if (index.data(presetRole::isGroup).toBool()) {
    paintGroup(*painter, option, index.data(Qt::DisplayRole).toString());
    painter->restore();
    return;
  }
  const ThemeColors colors = themeColors(option.palette);
  const bool selected = option.state & QStyle::State_Selected;
  const bool hovered = option.state & QStyle::State_MouseOver;
  const QRectF card = QRectF(option.rect).adjusted(4.0, 2.0, -4.0, -2.0);
  if (selected || hovered) {
    painter->setPen(selected ? QPen(colors.accent, 1.5) : QPen(Qt::NoPen));
    painter->setBrush(colors.hover);
    painter->drawRoundedRect(card.adjusted(0.75, 0.75, -0.75, -0.75), 6.0, 6.0);
  }
  const QRect picture(option.rect.left() + margin + 4, option.rect.center().y() - thumbnailHeight / 2 + 1,
                      thumbnailWidth, thumbnailHeight);
  paintPicture(*painter, picture, index.data(presetRole::thumbnail).value<QImage>());
  const QRect texts(picture.right() + 12, option.rect.top(), option.rect.right() - picture.right() - 20,
                    option.rect.height());
  paintTexts(*painter, option, texts, index, colors.text, colors.secondaryText);
  painter->restore();
}

QSize PresetDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const {
  return {180, index.data(presetRole::isGroup).toBool() ? groupHeight : cardHeight};
}

} // namespace limn
