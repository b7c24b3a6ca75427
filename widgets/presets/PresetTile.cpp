// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetTile.h"

#include "widgets/Theme.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/presets/PresetPainting.h"

#include <QAbstractItemView>
#include <QPainter>

#include <algorithm>

namespace limn {
namespace {

constexpr int tileMargin = 4;
constexpr int leastWidth = 84; // of a tile: so that the list has two beside each other where it is narrow

// Of the name under the picture.
constexpr int nameLines = 2;

QFont tileFont(const QFont& font) {
  QFont small = font;
  small.setPointSizeF(small.pointSizeF() * 0.9);
  return small;
}

// In a tile of this width.
QSize pictureSize(int width) {
  return QSize(largeThumbnailWidth, largeThumbnailHeight)
      .scaled(width - 2 * tileMargin, width, Qt::KeepAspectRatio);
}

/// A name in at most two lines: as many words in the first as have room, and the rest, cut where it is too
/// long.
QStringList inTwoLines(const QString& name, const QFontMetrics& metrics, int width) {
  if (metrics.horizontalAdvance(name) <= width)
    return {name};
  qsizetype space = name.lastIndexOf(u' ');
  while (space > 0 && metrics.horizontalAdvance(name.left(space)) > width)
    space = name.lastIndexOf(u' ', space - 1);
  const auto cut = [&](const QString& text) { return metrics.elidedText(text, Qt::ElideRight, width); };
  return space > 0 ? QStringList{name.left(space), cut(name.mid(space + 1))} : QStringList{cut(name)};
}

} // namespace

void PresetTile::paint(QPainter* painter, const QStyleOptionViewItem& option,
                       const QModelIndex& index) const {
  painter->save();
  painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  paintPresetCard(*painter, option, index, QRectF(option.rect).adjusted(1.0, 1.0, -1.0, -1.0));
  const QRect picture(option.rect.topLeft() + QPoint(tileMargin, tileMargin),
                      pictureSize(option.rect.width()));
  paintPresetPicture(*painter, option, index, picture);
  const QRect lines(picture.left(), picture.bottom() + 1, picture.width(),
                    option.rect.bottom() - picture.bottom() - 2);
  const QFont font = tileFont(option.font);
  painter->setFont(font);
  painter->setPen(themeColors(option.palette).text);
  painter->drawText(lines, Qt::AlignHCenter | Qt::AlignTop,
                    inTwoLines(index.data().toString(), QFontMetrics(font), lines.width()).join(u'\n'));
  painter->restore();
}

// As many beside each other as have room, which they share.
QSize PresetTile::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
  const int room = view ? view->viewport()->width() - 1 : leastWidth;
  const int width = room / std::max(1, room / leastWidth);
  return {width, pictureSize(width).height() + 2 * tileMargin +
                     nameLines * QFontMetrics(tileFont(option.font)).lineSpacing()};
}

} // namespace limn
