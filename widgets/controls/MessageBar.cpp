// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/MessageBar.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace limn {
namespace {

constexpr int widestOver = 720;      // of what lies over a picture, pixels
constexpr int narrowestBeside = 240; // of a sentence beside buttons
constexpr int narrowestOver = 240;   // beside what is kept free
constexpr int marginOver = 12;
constexpr int marginBelow = 48; // clear of what is written at the lower edge of a picture

// So much longer a note stands that offers something: who reads it late still wants it.
constexpr int msToAct = 30000;

} // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), m_row(new QHBoxLayout), m_sentence(new QLabel(this)), m_details(new QLabel(this)),
      m_more(new QToolButton(this)), m_action(new QToolButton(this)), m_other(new QToolButton(this)),
      m_close(new QToolButton(this)), m_end(new QTimer(this)) {
  setObjectName(QStringLiteral("messageBar"));
  setAutoFillBackground(true);
  m_action->setObjectName(QStringLiteral("messageAction")); // stands out (theme.qss)
  for (QLabel* label : {m_sentence, m_details}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  m_more->setText(tr("Details"));
  for (QToolButton* action : {m_action, m_other})
    action->setAccessibleName(tr("What can be done about it")); // until a message brings its own
  m_close->setText(tr("Dismiss"));
  m_more->setCheckable(true);
  m_more->setToolTip(tr("Shows every remark about this volume."));
  auto* buttonRow = new QHBoxLayout;
  buttonRow->addStretch();
  for (QToolButton* button : buttons())
    buttonRow->addWidget(button, 0, Qt::AlignTop);
  m_row->addWidget(m_sentence, 1);
  m_row->addLayout(buttonRow);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 8, 8);
  column->setSpacing(4);
  column->addLayout(m_row);
  column->addWidget(m_details);
  connect(m_more, &QToolButton::toggled, m_details, &QWidget::setVisible);
  connect(m_action, &QToolButton::clicked, this, [this] {
    if (const std::function<void()> run = m_run) // it may have something else said, and goes then
      run();
  });
  connect(m_other, &QToolButton::clicked, this, [this] {
    if (const std::function<void()> run = m_runOther)
      run();
  });
  connect(m_close, &QToolButton::clicked, this, [this] {
    const std::function<void()> run = std::exchange(m_dismiss, nullptr); // it may have something else said
    hide();
    if (run)
      run();
  });
  m_end->setSingleShot(true);
  connect(m_end, &QTimer::timeout, this, [this] { hide(); });
  if (parent)
    parent->installEventFilter(this);
  hide();
}

int MessageBar::readingMs(const QString& sentence) {
  constexpr int shortest = 8000;
  constexpr int msPerLetter =
      120; // 250 words of six letters a minute are 40 ms a letter; slow readers, twice
  return std::max(shortest, static_cast<int>(sentence.size()) * msPerLetter);
}

void MessageBar::setHeldBack(bool isHeldBack) {
  m_isHeldBack = isHeldBack;
  m_isLate = m_isLate || (m_isHeldBack && m_isWanted);
  QFrame::setVisible(m_isWanted && !m_isHeldBack);
}

// Hidden by itself or by whoever showed it: it is not wanted any more.
void MessageBar::setVisible(bool visible) {
  const bool isNews = visible != m_isWanted;
  m_isWanted = visible;
  if (!visible)
    m_run = m_runOther = nullptr; // with all that they hold
  QFrame::setVisible(m_isWanted && !m_isHeldBack);
  if (isNews)
    emit wanted();
}

// Beside its buttons a sentence is read in lines of several words or not at all.
void MessageBar::arrangeIn(int width) {
  const int lines = m_sentence->fontMetrics().horizontalAdvance(m_sentence->text());
  const int beside = std::min(lines, narrowestBeside);
  int beyond = contentsMargins().left() + contentsMargins().right();
  for (const QToolButton* button : buttons())
    if (!button->isHidden())
      beyond += button->sizeHint().width() + m_row->spacing();
  const QBoxLayout::Direction direction =
      beside + beyond <= width ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom;
  if (direction != m_row->direction())
    m_row->setDirection(direction);
}

int MessageBar::heightAt(int width) const {
  return hasHeightForWidth() ? heightForWidth(width) : sizeHint().height();
}

// At the lower edge of a room, in its middle.
QRect MessageBar::placeIn(const QRect& room) {
  const int width = std::min(room.width(), widestOver);
  arrangeIn(width);
  const int height = std::min(room.height(), heightAt(width));
  return {room.left() + (room.width() - width) / 2, room.bottom() + 1 - height, width, height};
}

void MessageBar::layOver() {
  if (!parentWidget())
    return;
  layout()->activate(); // a sentence that has just changed is measured anew
  m_laidBeside = m_keptFree();
  const QRect all = parentWidget()->rect();
  QRect place;
  if (m_part)
    place = placeOver({m_part->mapTo(parentWidget(), QPoint()), m_part->size()});
  if (!all.contains(place) || !fits(place))
    place = placeOver(all);
  setGeometry(place);
  // Buttons were put beside and below to see how high that is: laid out now, that calls for no other look.
  layout()->activate();
  QCoreApplication::removePostedEvents(this, QEvent::LayoutRequest);
  raise();
}

bool MessageBar::fits(const QRect& place) const {
  return place.width() >= narrowestOver && place.height() >= heightAt(place.width());
}

// At the lower edge of an area, beside what is kept free or above it.
QRect MessageBar::placeOver(const QRect& area) {
  QRect room = area.adjusted(marginOver, marginOver, -marginOver, -marginBelow);
  QRect place = placeIn(room);
  if (place.intersects(m_laidBeside)) {
    const int left = m_laidBeside.right() + 1 + marginOver;
    if (room.right() + 1 - left >= narrowestOver)
      room.setLeft(left);
    else
      room.setBottom(m_laidBeside.top() - 1 - marginOver);
    place = placeIn(room);
  }
  return place;
}

void MessageBar::setPart(QWidget& part) {
  m_part = &part;
  part.installEventFilter(this);
}

void MessageBar::lookAgain() {
  if (isVisible() && m_laidBeside != m_keptFree())
    layOver();
}

// Under the pointer or with the keyboard in it, it is being read.
void MessageBar::goInTime() {
  const bool isPassing = m_kind == Kind::note || (m_isLate && m_isBriefWhenLate);
  const bool goes = isPassing && isVisible() && !underMouse() && !isAncestorOf(QApplication::focusWidget());
  if (goes)
    m_end->start((m_run ? msToAct : 0) + readingMs(sentence()));
  else
    m_end->stop();
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
  const bool isMoved = event->type() == QEvent::Resize || event->type() == QEvent::Move;
  if (isMoved && (watched == parent() || watched == m_part))
    layOver();
  return QFrame::eventFilter(watched, event);
}

bool MessageBar::event(QEvent* event) {
  const bool isRecognised = QFrame::event(event);
  switch (event->type()) {
  case QEvent::LayoutRequest:
    layOver();
    break;
  case QEvent::Show:
    layOver();
    goInTime();
    break;
  case QEvent::Enter:
    m_end->stop();
    break;
  case QEvent::Leave:
    goInTime();
    break;
  default:
    break;
  }
  return isRecognised;
}

void MessageBar::offer(QToolButton& button, const Action& action) {
  button.setText(action.text);
  if (!action.text.isEmpty()) // a hidden one is listed for assistive technology, too, and keeps a name
    button.setAccessibleName(action.text);
  button.setVisible(!action.text.isEmpty());
}

void MessageBar::show(Kind kind, const QString& sentence, const QStringList& details, const Action& action,
                      const Action& dismissal, const Action& other) {
  setProperty("kind", kind == Kind::error     ? QStringLiteral("error")
                      : kind == Kind::warning ? QStringLiteral("warning")
                                              : QStringLiteral("question"));
  style()->unpolish(this);
  style()->polish(this);
  m_sentence->setText(sentence);
  m_details->setText(details.join(QLatin1Char('\n')));
  m_more->setVisible(!details.isEmpty());
  m_more->setChecked(false);
  m_details->hide();
  m_run = action.run;
  m_runOther = other.run;
  offer(*m_action, action);
  offer(*m_other, other);
  m_dismiss = dismissal.run;
  m_close->setText(dismissal.text.isEmpty() ? tr("Dismiss") : dismissal.text);
  m_close->setAccessibleName(m_close->text());
  m_close->setToolTip(dismissal.text.isEmpty() ? tr("Hides this message.") : QString());
  m_kind = kind;
  m_isLate = m_isWanted && m_isHeldBack;
  QFrame::show();
  layOver();
  goInTime();
  emit wanted();
}

QString MessageBar::sentence() const {
  return m_sentence->text();
}

std::optional<MessageBar::Said> MessageBar::said() const {
  if (!m_isWanted)
    return std::nullopt;
  const QString details = m_details->text();
  return Said{m_kind == Kind::question ? Kind::note : m_kind, sentence(),
              details.isEmpty() ? QStringList() : details.split(QLatin1Char('\n'))};
}

MessageOrder::MessageOrder(const std::vector<MessageBar*>& bars, QObject* parent)
    : QObject(parent), m_bars(bars) {
  for (const MessageBar* bar : m_bars)
    connect(bar, &MessageBar::wanted, this, &MessageOrder::arrange);
}

void MessageOrder::arrange() {
  const auto wanted = std::ranges::find_if(m_bars, &MessageBar::isWanted);
  const auto error = std::ranges::find_if(m_bars, &MessageBar::isError);
  const bool letsErrorsPass = wanted != m_bars.end() && ((*wanted)->isNote() || (*wanted)->isAsking());
  const auto first = error != m_bars.end() && letsErrorsPass ? error : wanted;
  // First what goes, so that no two are seen.
  for (auto bar = m_bars.begin(); bar != m_bars.end(); ++bar)
    if (first != m_bars.end() && bar != first)
      (*bar)->setHeldBack(true);
  for (auto bar = m_bars.begin(); bar != m_bars.end(); ++bar)
    if (first == m_bars.end() || bar == first)
      (*bar)->setHeldBack(false);
}

} // namespace limn
