// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetDelegate.h"

#include "widgets/Theme.h"
#include "widgets/presets/PresetModel.h"

#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

#include <algorithm>

namespace limn {
namespace {

constexpr int groupHeight = 24;
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

QFont noteFont(const QFont& font) {
  QFont small = font;
  small.setPointSizeF(small.pointSizeF() * 0.9);
  return small;
}

// As many lines of `text` as fit, the last one cut off with an ellipsis where it goes on.
void paintLines(QPainter& painter, const QRect& place, const QString& text) {
  const QFontMetrics metrics(painter.font());
  const int most = std::max(1, place.height() / metrics.height());
  QTextLayout layout(text, painter.font());
  layout.beginLayout();
  for (int number = 1; number <= most; ++number) {
    QTextLine line = layout.createLine();
    if (!line.isValid())
      break;
    line.setLineWidth(place.width());
    const QString rest = text.mid(line.textStart());
    const QString shown = number < most ? text.mid(line.textStart(), line.textLength()).trimmed()
                                        : metrics.elidedText(rest, Qt::ElideRight, place.width());
    painter.drawText(
        QRect(place.left(), place.top() + (number - 1) * metrics.height(), place.width(), metrics.height()),
        Qt::AlignLeft | Qt::AlignVCenter, shown);
  }
  layout.endLayout();
}

void paintTexts(QPainter& painter, const QStyleOptionViewItem& option, const QRect& place,
                const QModelIndex& index, PresetUse use) {
  const ThemeColors colors = themeColors(option.palette);
  const QFontMetrics metrics(option.font);
  const QFont small = noteFont(option.font);
  const QFontMetrics smallMetrics(small);
  const QString modified = use == PresetUse::modified ? QObject::tr("modified") : QString();
  const int beside = modified.isEmpty() ? 0 : smallMetrics.horizontalAdvance(modified) + 6;
  const QString noteText = index.data(presetRole::note).toString();
  const int noteLines = smallMetrics.horizontalAdvance(noteText) > place.width() ? 2
                        : noteText.isEmpty()                                     ? 0
                                                                                 : 1;
  const int height = metrics.height() + noteLines * smallMetrics.height();
  const QRect line(place.left(), place.center().y() - height / 2, place.width(), metrics.height());
  painter.setFont(option.font);
  painter.setPen(colors.text);
  painter.drawText(
      line, Qt::AlignLeft | Qt::AlignVCenter,
      metrics.elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideRight, line.width() - beside));
  painter.setFont(small);
  painter.setPen(colors.secondaryText);
  painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, modified);
  paintLines(painter, {line.left(), line.bottom() + 1, line.width(), noteLines * smallMetrics.height()},
             noteText);
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
  const auto use = static_cast<PresetUse>(index.data(presetRole::use).toInt());
  const bool hovered = option.state & QStyle::State_MouseOver;
  const bool hasKeyboard = option.state & QStyle::State_HasFocus;
  const QRectF card = QRectF(option.rect).adjusted(4.0, 1.0, -4.0, -1.0);
  if (use != PresetUse::none || hovered || hasKeyboard) {
    painter->setPen(use != PresetUse::none ? QPen(colors.accent, 1.5)
                    : hasKeyboard          ? QPen(colors.secondaryText, 1.0, Qt::DashLine)
                                           : QPen(Qt::NoPen));
    painter->setBrush(use != PresetUse::none || hovered ? QBrush(colors.hover) : QBrush(Qt::NoBrush));
    painter->drawRoundedRect(card.adjusted(0.75, 0.75, -0.75, -0.75), 6.0, 6.0);
  }
  const QRect picture(option.rect.left() + margin + 4, option.rect.center().y() - thumbnailHeight / 2 + 1,
                      thumbnailWidth, thumbnailHeight);
  paintPicture(*painter, picture, index.data(presetRole::thumbnail).value<QImage>());
  const QRect texts(picture.right() + 12, option.rect.top(), option.rect.right() - picture.right() - 20,
                    option.rect.height());
  paintTexts(*painter, option, texts, index, use);
  painter->restore();
}

// Room for a name and two lines of its note.
QSize PresetDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  if (index.data(presetRole::isGroup).toBool())
    return {180, groupHeight};
  const int texts = QFontMetrics(option.font).height() + 2 * QFontMetrics(noteFont(option.font)).height();
  return {180, std::max(texts, thumbnailHeight) + 9};
}

} // namespace limn
