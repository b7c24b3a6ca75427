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

// One line under the picture: two names that begin alike are told apart by their pictures and tool tips.
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

} // namespace

void PresetTile::paint(QPainter* painter, const QStyleOptionViewItem& option,
                       const QModelIndex& index) const {
  painter->save();
  painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  paintPresetCard(*painter, option, index, QRectF(option.rect).adjusted(1.0, 1.0, -1.0, -1.0));
  const QRect picture(option.rect.topLeft() + QPoint(tileMargin, tileMargin),
                      pictureSize(option.rect.width()));
  paintPresetPicture(*painter, option, index, picture);
  const QRect line(picture.left(), picture.bottom() + 1, picture.width(),
                   option.rect.bottom() - picture.bottom() - 2);
  const QFont font = tileFont(option.font);
  painter->setFont(font);
  painter->setPen(themeColors(option.palette).text);
  painter->drawText(line, Qt::AlignCenter,
                    QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideRight, line.width()));
  painter->restore();
}

// As many beside each other as have room, which they share.
QSize PresetTile::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
  const int room = view ? view->viewport()->width() - 1 : leastWidth;
  const int width = room / std::max(1, room / leastWidth);
  return {width, pictureSize(width).height() + 2 * tileMargin + QFontMetrics(tileFont(option.font)).height()};
}

} // namespace limn
