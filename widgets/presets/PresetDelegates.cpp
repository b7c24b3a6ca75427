// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetDelegates.h"

#include "widgets/presets/PresetModel.h"
#include "widgets/theme/Theme.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QPainterPath>
#include <QStyleOptionViewItem>
#include <QTextLayout>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

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

const QAbstractItemView* viewOf(const QStyleOptionViewItem& option) {
  return qobject_cast<const QAbstractItemView*>(option.widget);
}

QFont smallFont(const QFont& font) {
  QFont small = font;
  small.setPointSizeF(small.pointSizeF() * 0.9);
  return small;
}

constexpr int tileMargin = 4;
constexpr int leastWidth = 84; // of a tile: so that the list has two beside each other where it is narrow
constexpr int nameLines = 2;   // under the picture of a tile

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

constexpr int groupHeight = 24;
constexpr int rowMargin = 8;
constexpr int rowSpace = 9; // of a row, around its texts

QFont titleFontOf(const QStyleOptionViewItem& option) {
  QFont bold = option.font;
  bold.setWeight(QFont::DemiBold);
  return bold;
}

// The lines of a text at this width, at most so many, the last one cut off with an ellipsis where it goes on.
QStringList wrapped(const QString& text, const QFont& font, int width, int most) {
  QStringList lines;
  QTextLayout layout(text, font);
  layout.beginLayout();
  while (lines.size() < most) {
    QTextLine line = layout.createLine();
    if (!line.isValid())
      break;
    line.setLineWidth(width);
    lines << (lines.size() + 1 < most
                  ? text.mid(line.textStart(), line.textLength()).trimmed()
                  : QFontMetrics(font).elidedText(text.mid(line.textStart()), Qt::ElideRight, width));
  }
  layout.endLayout();
  return lines;
}

// Two, and more where the list has room for six rows with more.
int mostNoteLines(const QStyleOptionViewItem& option) {
  constexpr int rowsSeen = 6;
  const QAbstractItemView* view = viewOf(option);
  const int height = view ? view->viewport()->height() / rowsSeen : 0;
  const int room = height - QFontMetrics(option.font).height() - rowSpace;
  return std::clamp(room / QFontMetrics(smallFont(option.font)).height(), 2, 4);
}

// The whole note where it has room, otherwise what stands before its semicolon, with an ellipsis unless that
// would cut a word; the tool tip has the rest.
// That the preset was changed, or shows nothing, comes first.
QStringList noteLines(const QStyleOptionViewItem& option, const QModelIndex& index, int width) {
  QString note = index.data(presetRole::note).toString();
  if (static_cast<PresetUse>(index.data(presetRole::use).toInt()) == PresetUse::modified)
    note = QObject::tr("Modified. %1", "a preset; its note follows").arg(note);
  if (index.data(presetRole::showsNothing).toBool())
    note = QObject::tr("Shows nothing of this volume. %1", "a preset; its note follows").arg(note);
  const QFont font = smallFont(option.font);
  const int most = mostNoteLines(option);
  if (wrapped(note, font, width, most + 1).size() <= most)
    return wrapped(note, font, width, most);
  QStringList lines = wrapped(note.section(QLatin1Char(';'), 0, 0), font, width, most);
  if (lines.isEmpty())
    return lines;
  const QString goesOn = lines.back() + QChar(0x2026);
  if (!lines.back().endsWith(QChar(0x2026)) && QFontMetrics(font).horizontalAdvance(goesOn) <= width)
    lines.back() = goesOn;
  return lines;
}

// Of a row that is so wide, beside its picture.
int textWidth(int rowWidth) {
  return rowWidth - thumbnailWidth - 4 * rowMargin;
}

/// Hands out the lines of a text from the top down, but for those that the edge of the list would cut.
class WholeLines {
public:
  WholeLines(const QStyleOptionViewItem& option, const QRect& place)
      : m_seen(viewOf(option) ? viewOf(option)->viewport()->rect() : option.rect), m_place(place) {}

  std::optional<QRect> next(const QFont& font) {
    const QRect line(m_place.left(), m_place.top(), m_place.width(), QFontMetrics(font).height());
    m_place.setTop(line.bottom() + 1);
    return m_seen.contains(line) ? std::optional(line) : std::nullopt;
  }

private:
  QRect m_seen;
  QRect m_place;
};

void paintGroup(QPainter& painter, const QStyleOptionViewItem& option, const QString& title) {
  const QFont bold = titleFontOf(option);
  QRect room = option.rect.adjusted(rowMargin + 4, 4, -rowMargin, 0);
  room.setTop(room.center().y() - QFontMetrics(bold).height() / 2);
  painter.setFont(bold);
  painter.setPen(themeColors(option.palette).secondaryText);
  if (const std::optional<QRect> line = WholeLines(option, room).next(bold))
    painter.drawText(*line, Qt::AlignLeft | Qt::AlignVCenter, title);
}

// "CT bone" below "CT" is "Bone".
QString nameUnderHeading(const QModelIndex& index) {
  QString name = presetWords(index.data(Qt::DisplayRole).toString());
  const QString heading = index.parent().data(Qt::DisplayRole).toString() + QLatin1Char(' ');
  if (!name.startsWith(heading))
    return name;
  name.remove(0, heading.size());
  name[0] = name[0].toUpper();
  return name;
}

// One line, or two of a name that has no room in one.
QStringList linesOfName(const QStyleOptionViewItem& option, const QModelIndex& index, int width) {
  return inTwoLines(nameUnderHeading(index), QFontMetrics(option.font), width);
}

void paintTexts(QPainter& painter, const QStyleOptionViewItem& option, const QRect& room,
                const QModelIndex& index) {
  const QFont small = smallFont(option.font);
  const QStringList name = linesOfName(option, index, room.width());
  const QStringList note = noteLines(option, index, room.width());
  const int height = static_cast<int>(name.size()) * QFontMetrics(option.font).height() +
                     static_cast<int>(note.size()) * QFontMetrics(small).height();
  WholeLines lines(option, {room.left(), room.center().y() - height / 2, room.width(), height});
  const ThemeColors colors = themeColors(option.palette);
  painter.setFont(option.font);
  painter.setPen(option.state & QStyle::State_Enabled ? colors.text : colors.disabledText);
  for (const QString& text : name)
    if (const std::optional<QRect> line = lines.next(option.font))
      painter.drawText(*line, Qt::AlignLeft | Qt::AlignVCenter, text);
  painter.setFont(small);
  painter.setPen(colors.secondaryText);
  for (const QString& text : note)
    if (const std::optional<QRect> line = lines.next(small))
      painter.drawText(*line, Qt::AlignLeft | Qt::AlignVCenter, text);
}

// Marks the card of a preset that is in use, under the pointer or has the keyboard.
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

// What a preset makes of the volume, where that is known and there is something to see, otherwise its curve;
// with a star where it is a favourite.
void paintPresetPicture(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                        const QRectF& place) {
  paintPicture(painter, place, pictureOf(index));
  if (index.data(presetRole::isFavourite).toBool())
    paintStar(painter, place.topRight() + QPointF(-8.0, 8.0), themeColors(option.palette));
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
  const QFont font = smallFont(option.font);
  painter->setFont(font);
  painter->setPen(themeColors(option.palette).text);
  painter->drawText(lines, Qt::AlignHCenter | Qt::AlignTop,
                    inTwoLines(index.data().toString(), QFontMetrics(font), lines.width()).join(u'\n'));
  painter->restore();
}

// As many beside each other as have room, which they share.
QSize PresetTile::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  const QAbstractItemView* view = viewOf(option);
  const int room = view ? view->viewport()->width() - 1 : leastWidth;
  const int width = room / std::max(1, room / leastWidth);
  return {width, pictureSize(width).height() + 2 * tileMargin +
                     nameLines * QFontMetrics(smallFont(option.font)).lineSpacing()};
}

void PresetDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
  painter->save();
  painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  if (index.data(presetRole::isGroup).toBool()) {
    paintGroup(*painter, option, index.data(Qt::DisplayRole).toString());
    painter->restore();
    return;
  }
  paintPresetCard(*painter, option, index, QRectF(option.rect).adjusted(4.0, 1.0, -4.0, -1.0));
  const QRect picture(option.rect.left() + rowMargin + 4, option.rect.center().y() - thumbnailHeight / 2 + 1,
                      thumbnailWidth, thumbnailHeight);
  painter->setOpacity(option.state & QStyle::State_Enabled ? 1.0 : 0.4); // texts keep their contrast
  paintPresetPicture(*painter, option, index, picture);
  painter->setOpacity(1.0);
  const QRect texts(picture.right() + 12, option.rect.top(), textWidth(option.rect.width()),
                    option.rect.height());
  paintTexts(*painter, option, texts, index);
  painter->restore();
}

// Room for a name and two lines of its note in any case, so that most rows are alike.
QSize PresetDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  if (index.data(presetRole::isGroup).toBool())
    return {180, groupHeight};
  const QAbstractItemView* view = viewOf(option);
  const int width = textWidth(view ? view->viewport()->width() : option.rect.width());
  const int lines = std::max(2, static_cast<int>(noteLines(option, index, width).size()));
  const int names = static_cast<int>(linesOfName(option, index, width).size());
  const int texts =
      names * QFontMetrics(option.font).height() + lines * QFontMetrics(smallFont(option.font)).height();
  return {180, std::max(texts, thumbnailHeight) + rowSpace};
}

void PresetDelegate::layOutAgain() {
  emit sizeHintChanged({});
}

} // namespace limn
