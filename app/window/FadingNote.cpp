// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/FadingNote.h"

#include <QEvent>
#include <QFontMetrics>
#include <QPainter>

namespace limn {
namespace {

constexpr int beside = 16; // of the words, pixels
constexpr int above = 8;

} // namespace

FadingNote::FadingNote(QWidget& below) : QWidget(&below) {
  setObjectName(QStringLiteral("fadingNote"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  below.installEventFilter(this);
  connect(&m_fade, &LabelFade::changed, this, [this] {
    setVisible(m_fade.opacity() > 0.0);
    update();
  });
  hide();
}

void FadingNote::say(const QString& text) {
  m_text = text;
  setAccessibleName(text);
  place();
  show();
  raise();
  m_fade.wake();
}

// In the middle, below what stands at the upper edge of a picture.
void FadingNote::place() {
  const QSize words = fontMetrics().size(Qt::TextSingleLine, m_text);
  const QSize size = words + QSize(2 * beside, 2 * above);
  setGeometry((parentWidget()->width() - size.width()) / 2, 48, size.width(), size.height());
}

bool FadingNote::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize)
    place();
  return QWidget::eventFilter(watched, event);
}

// Dark in every theme, as all that lies over pictures.
void FadingNote::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(m_fade.opacity());
  painter.setPen(QPen(QColor(134, 142, 155), 1.0));
  painter.setBrush(QColor(24, 27, 34));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6.0, 6.0);
  painter.setPen(Qt::white);
  painter.drawText(rect(), Qt::AlignCenter, m_text);
}

} // namespace limn
