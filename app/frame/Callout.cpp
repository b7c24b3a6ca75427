// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/Callout.h"

#include "widgets/theme/Theme.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace limn {

namespace {

// Moved by no more than it takes.
QRect inside(QRect box, const QRect& window) {
  box.moveLeft(std::max(window.left(), std::min(box.left(), window.right() - box.width() + 1)));
  box.moveTop(std::max(window.top(), std::min(box.top(), window.bottom() - box.height() + 1)));
  return box;
}

struct Beside {
  CalloutSide side;
  int over; ///< pixels left once the box stands there
};

} // namespace

CalloutPlace calloutPlace(const QRect& target, const QSize& size, const QRect& window, int gap) {
  const QRect seen = target.intersected(window);
  const std::array<Beside, 4> rooms{{
      {CalloutSide::right, window.right() - seen.right() - size.width() - gap},
      {CalloutSide::left, seen.left() - window.left() - size.width() - gap},
      {CalloutSide::above, seen.top() - window.top() - size.height() - gap},
      {CalloutSide::below, window.bottom() - seen.bottom() - size.height() - gap},
  }};
  // What is lower than the box stands in a row with others, which a box beside it would hide.
  const bool isLow = seen.height() < size.height() && std::max(rooms[2].over, rooms[3].over) >= 0;
  const Beside best = *std::max_element(rooms.begin() + (isLow ? 2 : 0), rooms.end(),
                                        [](const Beside& a, const Beside& b) { return a.over < b.over; });
  const CalloutSide side = best.over < 0 ? CalloutSide::within : best.side;
  QRect box({}, size);
  box.moveCenter(seen.center());
  if (side == CalloutSide::right)
    box.moveLeft(seen.right() + 1 + gap);
  else if (side == CalloutSide::left)
    box.moveRight(seen.left() - 1 - gap);
  else if (side == CalloutSide::above)
    box.moveBottom(seen.top() - 1 - gap);
  else if (side == CalloutSide::below)
    box.moveTop(seen.bottom() + 1 + gap);
  box = inside(box, window);
  QPoint tip = box.center();
  if (side == CalloutSide::right || side == CalloutSide::left)
    tip = {side == CalloutSide::right ? seen.right() : seen.left(),
           std::clamp(seen.center().y(), box.top(), box.bottom())};
  else if (side != CalloutSide::within)
    tip = {std::clamp(seen.center().x(), box.left(), box.right()),
           side == CalloutSide::above ? seen.top() : seen.bottom()};
  return {box, side, tip};
}

namespace {

constexpr int arrow = 12; // pixels from the box to its tip, and around the box on every side
constexpr int textWidth = 300;
constexpr qreal radius = 8;

QPushButton* button(const QString& text, const char* name, QWidget& parent) {
  auto* made = new QPushButton(text, &parent);
  made->setObjectName(QLatin1String(name));
  made->setAutoDefault(true); // Enter presses it
  made->installEventFilter(&parent);
  return made;
}

} // namespace

Callout::Callout(QWidget& window)
    : QFrame(&window), m_title(new QLabel(this)), m_text(new QLabel(this)), m_place(new QLabel(this)),
      m_action(button({}, "tourAction", *this)), m_end(button(tr("End tour"), "tourEnd", *this)),
      m_back(button(tr("Back"), "tourBack", *this)), m_next(button({}, "tourNext", *this)) {
  setObjectName(QStringLiteral("tourCallout"));
  QFont bold = m_title->font();
  bold.setWeight(QFont::DemiBold);
  m_title->setFont(bold);
  m_text->setWordWrap(true);
  m_text->setFixedWidth(textWidth);
  m_place->setForegroundRole(QPalette::PlaceholderText);
  m_end->setFlat(true);
  auto* head = new QHBoxLayout;
  head->addWidget(m_title, 1);
  head->addWidget(m_place);
  auto* row = new QHBoxLayout;
  row->addWidget(m_end);
  row->addStretch();
  row->addWidget(m_back);
  row->addWidget(m_next);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(arrow + 16, arrow + 12, arrow + 16, arrow + 12);
  column->setSpacing(8);
  column->setSizeConstraint(QLayout::SetFixedSize);
  column->addLayout(head);
  column->addWidget(m_text);
  column->addWidget(m_action);
  column->addLayout(row);
  setTabOrder(m_next, m_action);
  setTabOrder(m_action, m_back);
  setTabOrder(m_back, m_end);
  connect(m_next, &QPushButton::clicked, this, &Callout::next);
  connect(m_back, &QPushButton::clicked, this, &Callout::back);
  connect(m_end, &QPushButton::clicked, this, &Callout::ended);
  connect(m_action, &QPushButton::clicked, this, &Callout::actionRequested);
}

void Callout::say(const CalloutText& text, bool isFirst, bool isLast) {
  setAccessibleName(QStringLiteral("%1, %2").arg(text.title, text.place));
  setAccessibleDescription(text.text);
  m_title->setText(text.title);
  m_text->setText(text.text);
  m_text->setFixedHeight(m_text->heightForWidth(textWidth)); // a box of fixed size asks for no other
  m_place->setText(text.place);
  m_action->setText(text.action);
  m_action->setVisible(!text.action.isEmpty());
  m_back->setVisible(!isFirst);
  m_next->setText(isLast ? tr("Done") : tr("Next"));
  m_next->setDefault(true);
  m_next->setAccessibleDescription(text.text); // read when it gets the keyboard
  m_end->setVisible(!isLast);
  layout()->activate();
}

void Callout::pointAt(const QRect& target) {
  const QSize box = size() - QSize(2 * arrow, 2 * arrow);
  m_at = calloutPlace(target, box, parentWidget()->rect().adjusted(4, 4, -4, -4), arrow);
  move(m_at.box.topLeft() - QPoint(arrow, arrow));
  update();
}

void Callout::takeFocus() {
  m_next->setFocus(Qt::OtherFocusReason);
}

void Callout::paintEvent(QPaintEvent*) {
  const ThemeColors colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath shape;
  shape.addRoundedRect(QRectF(rect()).adjusted(arrow, arrow, -arrow, -arrow), radius, radius);
  if (m_at.side != CalloutSide::within) {
    const QPointF tip = m_at.tip - pos();
    const QPointF foot(std::clamp(tip.x(), arrow + 16.0, width() - arrow - 16.0),
                       std::clamp(tip.y(), arrow + 16.0, height() - arrow - 16.0));
    const bool isBeside = m_at.side == CalloutSide::right || m_at.side == CalloutSide::left;
    const QPointF across = isBeside ? QPointF(0, arrow) : QPointF(arrow, 0);
    QPainterPath point;
    point.addPolygon(QPolygonF(
        {foot - across, isBeside ? QPointF(tip.x(), foot.y()) : QPointF(foot.x(), tip.y()), foot + across}));
    point.closeSubpath();
    shape = shape.united(point);
  }
  painter.setPen(QPen(colors.accent, 2));
  painter.setBrush(colors.raised);
  painter.drawPath(shape);
}

// A button would give the keyboard to its neighbour for an arrow, and at last to the picture.
bool Callout::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress)
    return QFrame::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Right && !m_end->isHidden())
    emit next();
  else if (key == Qt::Key_Left && !m_back->isHidden())
    emit back();
  return key == Qt::Key_Right || key == Qt::Key_Left || QFrame::eventFilter(watched, event);
}

void Callout::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape)
    emit ended();
  else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    emit next();
  else
    QFrame::keyPressEvent(event);
}

CalloutFrame::CalloutFrame(QWidget& window) : QWidget(&window) {
  setObjectName(QStringLiteral("tourFrame"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
}

void CalloutFrame::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(themeColors(palette()).accent, 3));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 4, 4);
}

} // namespace limn
