// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/HintBar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>

#include <algorithm>

namespace limn {
namespace {

constexpr int aboveEdge = 44; // logical pixels, over scale and notes
constexpr int gapAbove = 8;   // what else lies there
constexpr int besideEdge = 4; // in their row, which messages leave free
constexpr int gapAtSides = 8;

} // namespace

HintBar::HintBar(const QString& name, QWidget* parent)
    : PicturePanel(parent), m_rows(new QBoxLayout(QBoxLayout::LeftToRight, this)),
      m_others(new QBoxLayout(QBoxLayout::LeftToRight)), m_text(new QLabel(this)) {
  auto* close = panelButton(tr("Done"), QStringLiteral("choice"), this);
  close->setToolTip(tr("Lays the tool aside (Esc)."));
  m_rows->setSpacing(6);
  m_others->setSpacing(6);
  for (QHBoxLayout*& group : m_groups) {
    group = new QHBoxLayout;
    group->setSpacing(6);
    (&group == &m_groups.front() ? m_rows : m_others)->addLayout(group);
  }
  m_rows->addLayout(m_others);
  m_groups.front()->addWidget(m_text);
  m_text->setContentsMargins(0, 0, 6, 0);
  m_groups.back()->addWidget(close);
  connect(close, &QPushButton::clicked, this, &HintBar::closeRequested);
  m_soon.setSingleShot(true);
  connect(&m_soon, &QTimer::timeout, this, &HintBar::follow);
  parent->installEventFilter(this);
  setCursor(Qt::SizeAllCursor);
  setAccessibleName(name);
  hide();
}

void HintBar::showHint(const QString& text, const QString& tip, bool stays) {
  m_text->setText(text);
  m_text->setToolTip(tip);
  m_stays = stays;
  m_isOut = true;
  place();
  follow();
}

QString HintBar::hint() const {
  return m_text->text();
}

void HintBar::putAway() {
  m_isOut = m_isAside = false;
  m_grip.reset();
  m_movedTo.reset();
  hide();
}

void HintBar::follow() {
  if (!m_isOut || m_isAside || m_isDrawing())
    return hide();
  if ((m_placedOver != m_coveredBelow() || m_placedBeside != m_written()) && !isUnderPointer())
    place();
  setVisible(m_hasRoom);
}

// A button that goes as it is clicked leaves the click to the picture.
bool HintBar::isUnderPointer() const {
  const std::vector<QRect> covers = m_coveredBelow();
  return isVisible() && underMouse() &&
         std::ranges::none_of(covers, [this](const QRect& cover) { return cover.intersects(geometry()); });
}

void HintBar::leaveEvent(QEvent* event) {
  PicturePanel::leaveEvent(event);
  if (m_isOut && !m_soon.isActive())
    m_soon.start(0);
}

void HintBar::followCover(QWidget& cover) {
  cover.installEventFilter(this);
}

bool HintBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched != parent()) {
    const QEvent::Type type = event->type();
    const bool isElsewhere =
        type == QEvent::Move || type == QEvent::Resize || type == QEvent::Show || type == QEvent::Hide;
    if (isElsewhere && m_isOut && !m_soon.isActive())
      m_soon.start(0);
    return PicturePanel::eventFilter(watched, event);
  }
  if (event->type() == QEvent::Resize && m_isOut)
    place();
  // While something is drawn the picture is seen whole; the view has to know first what an event is to it.
  // Once for all events that wait: what is written is laid out each time.
  if (m_isOut && !m_soon.isActive())
    m_soon.start(0);
  const auto* mouse = dynamic_cast<const QMouseEvent*>(event);
  if (event->type() == QEvent::MouseMove && isVisible() && mouse->buttons().testFlag(Qt::LeftButton)) {
    m_isAside = true;
    hide();
  } else if (event->type() == QEvent::MouseButtonRelease) {
    m_isAside = false;
  }
  return PicturePanel::eventFilter(watched, event);
}

void HintBar::showEvent(QShowEvent* event) {
  PicturePanel::showEvent(event);
  place();
}

// By all of it that is no button: what it lies on may be what the tool is for.
void HintBar::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton)
    m_grip = event->position().toPoint();
}

void HintBar::mouseMoveEvent(QMouseEvent* event) {
  if (!m_grip || !event->buttons().testFlag(Qt::LeftButton))
    return;
  m_movedTo = pos() + event->position().toPoint() - *m_grip;
  place();
}

void HintBar::mouseReleaseEvent(QMouseEvent*) {
  m_grip.reset();
}

// In the row of scale and notes it lies on least of what is looked at.
bool HintBar::placeBeside() {
  const QSizeF size = sizeHint();
  const QRectF view = parentWidget()->rect();
  const QRectF lane(view.left() + gapAtSides, view.bottom() - besideEdge - size.height(),
                    view.width() - 2 * gapAtSides, size.height());
  const QRectF wished(QPointF(view.center().x() - size.width() / 2, lane.top()), size);
  const std::optional<QRectF> place = m_clear(wished, lane, m_placedBeside);
  if (place)
    setGeometry(place->toRect());
  return place.has_value();
}

// How much of the lower edge is covered where it is to stand.
int HintBar::coveredBelow(int left, int width) const {
  int covered = 0;
  for (const QRect& cover : m_placedOver)
    if (cover.left() < left + width && left <= cover.right())
      covered = std::max(covered, parentWidget()->height() - cover.top());
  return covered;
}

// In a narrow view words that the tool's tip says, too, give way; the others take a row first. Beside slices
// the view may have no room for all buttons either: then they stand in three rows.
void HintBar::place() {
  const QWidget* view = parentWidget();
  constexpr auto inOne = QBoxLayout::LeftToRight, inRows = QBoxLayout::TopToBottom;
  const auto fits = [&](bool hasText, QBoxLayout::Direction all, QBoxLayout::Direction others) {
    m_text->setVisible(hasText);
    m_rows->setContentsMargins(hasText ? 12 : 6, 6, 6, 6);
    m_rows->setDirection(all);
    m_others->setDirection(others);
    layout()->activate();
    return sizeHint().width() <= view->width() - 2 * gapAtSides;
  };
  const auto fitsInRows = [&] { return fits(true, inRows, inOne) || fits(true, inRows, inRows); };
  const auto fitsWithoutText = [&] { return fits(false, inOne, inOne); };
  m_placedOver = m_coveredBelow();
  m_placedBeside = m_written();
  raise();
  const bool fitsInOne = fits(true, inOne, inOne);
  const bool isBeside = fitsInOne && !m_movedTo && placeBeside();
  m_hasRoom = isBeside || m_movedTo || view->height() >= m_leastHeight;
  if (isBeside || !m_hasRoom)
    return;
  if (!fitsInOne && !(m_stays ? fitsInRows() : fitsWithoutText()) &&
      !(m_stays ? fitsWithoutText() : fitsInRows()))
    fits(false, inRows, inRows);
  const QSize size = sizeHint().boundedTo(view->size());
  const int left = (view->width() - size.width()) / 2;
  const int covered = coveredBelow(left, size.width());
  const int below = covered > 0 ? std::max(aboveEdge, covered + gapAbove) : aboveEdge;
  const QPoint corner = m_movedTo.value_or(QPoint(left, view->height() - below - size.height()));
  setGeometry(std::clamp(corner.x(), 0, view->width() - size.width()),
              std::clamp(corner.y(), 0, view->height() - size.height()), size.width(), size.height());
}

} // namespace limn
