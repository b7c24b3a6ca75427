// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/CutBar.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>

#include <algorithm>
#include <utility>

namespace limn {
namespace {

constexpr int aboveEdge = 44; // logical pixels, over scale and notes

// Two buttons of which one is down.
void pair(QPushButton* first, QPushButton* second, QObject* parent) {
  auto* group = new QButtonGroup(parent);
  for (QPushButton* button : {first, second}) {
    button->setCheckable(true);
    group->addButton(button);
  }
}

} // namespace

CutBar::CutBar(QWidget* parent)
    : PicturePanel(parent), m_text(new QLabel(this)),
      m_inside(panelButton(tr("Inside"), QStringLiteral("choice"), this)),
      m_outside(panelButton(tr("Outside"), QStringLiteral("choice"), this)),
      m_through(panelButton(tr("Through all"), QStringLiteral("choice"), this)),
      m_seen(panelButton(tr("What is seen"), QStringLiteral("choice"), this)),
      m_hide(panelButton(tr("Hide"), QStringLiteral("choice"), this)),
      m_alone(panelButton(tr("Only this"), QStringLiteral("choice"), this)),
      m_look(panelButton(tr("Its own curve"), QStringLiteral("choice"), this)) {
  pair(m_inside, m_outside, this);
  pair(m_through, m_seen, this);
  m_inside->setToolTip(tr("Takes away what the line goes around."));
  m_outside->setToolTip(tr("Takes away all that the line does not go around."));
  m_through->setToolTip(tr("Cuts through the whole volume."));
  m_seen->setToolTip(
      tr("Cuts only as deep as what is seen inside the line; in a slice, as deep as its slab, at "
         "least one slice."));
  m_hide->setToolTip(tr("Hides this piece."));
  m_alone->setToolTip(tr("Hides all but this piece."));
  m_look->setToolTip(tr("Gives this piece a curve of its own, which the curve panel then shows."));
  auto* close = panelButton(tr("Done"), QStringLiteral("choice"), this);
  close->setToolTip(tr("Lays the tool aside (Esc)."));
  m_rows = new QBoxLayout(QBoxLayout::LeftToRight, this);
  m_rows->setContentsMargins(12, 6, 6, 6);
  auto* first = new QHBoxLayout;
  auto* second = new QHBoxLayout;
  auto* third = new QHBoxLayout;
  m_rows->setSpacing(6);
  for (QHBoxLayout* part : {first, second, third}) {
    part->setSpacing(6);
    m_rows->addLayout(part);
  }
  first->addWidget(m_text);
  first->addSpacing(6);
  first->addWidget(m_inside);
  first->addWidget(m_outside);
  first->addSpacing(6);
  for (QPushButton* button : {m_through, m_seen, m_hide, m_alone})
    second->addWidget(button);
  third->addWidget(m_look);
  third->addSpacing(6);
  third->addWidget(close);
  connect(m_inside, &QPushButton::toggled, this, &CutBar::insideChosen);
  connect(m_seen, &QPushButton::toggled, this, &CutBar::depthChosen);
  connect(m_hide, &QPushButton::clicked, this, &CutBar::hideRequested);
  connect(m_alone, &QPushButton::clicked, this, &CutBar::aloneRequested);
  connect(m_look, &QPushButton::clicked, this, &CutBar::lookRequested);
  connect(close, &QPushButton::clicked, this, &CutBar::closeRequested);
  parent->installEventFilter(this);
  setAccessibleName(tr("Cutting"));
  hide();
}

void CutBar::showScissors(bool removesInside, bool onlySeen) {
  m_text->setText(tr("Draw around it, or click corners"));
  m_text->setToolTip(tr("Shift draws straight on; Enter, a double click or the first corner closes a line of "
                        "corners, Backspace takes the last one back, Esc all."));
  m_tellsPiece = false;
  (removesInside ? m_inside : m_outside)->setChecked(true);
  (onlySeen ? m_seen : m_through)->setChecked(true);
  for (QPushButton* button : {m_inside, m_outside, m_through, m_seen})
    button->show();
  for (QPushButton* button : {m_hide, m_alone, m_look})
    button->hide();
  m_isOut = true;
  follow();
  place();
}

void CutBar::showPiece(const QString& text, bool isPicked) {
  m_tellsPiece = isPicked;
  m_text->setText(text);
  m_text->setToolTip(tr("The wheel widens or narrows the range of values; another click picks another piece, "
                        "Esc none."));
  for (QPushButton* button : {m_inside, m_outside, m_through, m_seen})
    button->hide();
  for (QPushButton* button : {m_hide, m_alone, m_look})
    button->setVisible(isPicked);
  m_isOut = true;
  follow();
  place();
}

void CutBar::putAway() {
  m_isOut = m_isAside = false;
  hide();
}

void CutBar::follow() {
  setVisible(m_isOut && !m_isAside && !m_isDrawing());
}

bool CutBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched != parent())
    return PicturePanel::eventFilter(watched, event);
  if (event->type() == QEvent::Resize && isVisible())
    place();
  // While a line is drawn the picture is seen whole; the view has to know first what an event is to it.
  if (m_isOut)
    QMetaObject::invokeMethod(this, &CutBar::follow, Qt::QueuedConnection);
  const auto* mouse = dynamic_cast<const QMouseEvent*>(event);
  if (event->type() == QEvent::MouseMove && isVisible() && mouse->buttons().testFlag(Qt::LeftButton)) {
    m_isAside = true;
    hide();
  } else if (event->type() == QEvent::MouseButtonRelease) {
    m_isAside = false;
  }
  return PicturePanel::eventFilter(watched, event);
}

void CutBar::showEvent(QShowEvent* event) {
  PicturePanel::showEvent(event);
  place();
}

// In a narrow view the sentence gives way: it says what the tool's tip does, but for what is found of a
// piece, which takes a row first. Beside slices the view may have no room for all buttons either: then they
// stand in three rows.
void CutBar::place() {
  const QWidget* view = parentWidget();
  const auto fits = [&](bool hasText, QBoxLayout::Direction direction) {
    m_text->setVisible(hasText);
    m_rows->setDirection(direction);
    layout()->activate();
    return sizeHint().width() <= view->width() - 16;
  };
  const auto fitsInRows = [&] { return fits(true, QBoxLayout::TopToBottom); };
  const auto fitsWithoutText = [&] { return fits(false, QBoxLayout::LeftToRight); };
  if (!fits(true, QBoxLayout::LeftToRight) && !(m_tellsPiece ? fitsInRows() : fitsWithoutText()) &&
      !(m_tellsPiece ? fitsWithoutText() : fitsInRows()))
    fits(false, QBoxLayout::TopToBottom);
  const QSize size = sizeHint().boundedTo(view->size());
  setGeometry((view->width() - size.width()) / 2, std::max(0, view->height() - aboveEdge - size.height()),
              size.width(), size.height());
  raise();
}

} // namespace limn
