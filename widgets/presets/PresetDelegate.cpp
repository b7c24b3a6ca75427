// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetDelegate.h"

#include "widgets/Theme.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/presets/PresetPainting.h"
#include "widgets/presets/PresetWords.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QTextLayout>

#include <algorithm>
#include <optional>

namespace limn {
namespace {

constexpr int groupHeight = 24;
constexpr int rowMargin = 8;
constexpr int rowSpace = 9; // of a row, around its texts

const QAbstractItemView* viewOf(const QStyleOptionViewItem& option) {
  return qobject_cast<const QAbstractItemView*>(option.widget);
}

QFont titleFontOf(const QStyleOptionViewItem& option) {
  QFont bold = option.font;
  bold.setWeight(QFont::DemiBold);
  return bold;
}

QFont noteFont(const QFont& font) {
  QFont small = font;
  small.setPointSizeF(small.pointSizeF() * 0.9);
  return small;
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
  return std::clamp(room / QFontMetrics(noteFont(option.font)).height(), 2, 4);
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
  const QFont font = noteFont(option.font);
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

void paintName(QPainter& painter, const QStyleOptionViewItem& option, const QRect& line,
               const QString& name) {
  painter.setFont(option.font);
  const ThemeColors colors = themeColors(option.palette);
  painter.setPen(option.state & QStyle::State_Enabled ? colors.text : colors.disabledText);
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetrics(option.font).elidedText(name, Qt::ElideRight, line.width()));
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

void paintTexts(QPainter& painter, const QStyleOptionViewItem& option, const QRect& room,
                const QModelIndex& index) {
  const QFont small = noteFont(option.font);
  const QStringList note = noteLines(option, index, room.width());
  const int height =
      QFontMetrics(option.font).height() + static_cast<int>(note.size()) * QFontMetrics(small).height();
  WholeLines lines(option, {room.left(), room.center().y() - height / 2, room.width(), height});
  if (const std::optional<QRect> line = lines.next(option.font))
    paintName(painter, option, *line, nameUnderHeading(index));
  painter.setFont(small);
  painter.setPen(themeColors(option.palette).secondaryText);
  for (const QString& text : note)
    if (const std::optional<QRect> line = lines.next(small))
      painter.drawText(*line, Qt::AlignLeft | Qt::AlignVCenter, text);
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
  const int texts = QFontMetrics(option.font).height() + lines * QFontMetrics(noteFont(option.font)).height();
  return {180, std::max(texts, thumbnailHeight) + rowSpace};
}

void PresetDelegate::layOutAgain() {
  emit sizeHintChanged({});
}

} // namespace limn
