// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/FocusRing.h"

#include "widgets/theme/Theme.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFocusEvent>
#include <QLineEdit>
#include <QPainter>

#include <utility>

namespace limn {
namespace {

constexpr int ringWidth = 2; // pixels

// A field for text, whatever it holds; of a number only one that somebody has begun to type.
bool isTypedInto(const QWidget* widget) {
  if (qobject_cast<const QLineEdit*>(widget))
    return true;
  const auto* number = qobject_cast<const QAbstractSpinBox*>(widget);
  const auto* line = number ? number->findChild<const QLineEdit*>() : nullptr;
  return line && line->isModified();
}

} // namespace

FocusRing::FocusRing(QWidget* owner) : QWidget(owner) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  owner->installEventFilter(this);
  hide();
}

bool FocusRing::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
  case QEvent::FocusIn: {
    const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
    setVisible(reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason);
    break;
  }
  case QEvent::FocusOut:
  case QEvent::MouseButtonPress:
    hide();
    break;
  case QEvent::Resize:
    break;
  default:
    return QWidget::eventFilter(watched, event);
  }
  setGeometry(parentWidget()->rect());
  raise();
  return QWidget::eventFilter(watched, event);
}

void FocusRing::paintEvent(QPaintEvent*) {
  // The dark look's accent, because pictures are dark in both.
  QPainter painter(this);
  painter.setPen(
      QPen(themeColors(Look::dark).accent, ringWidth, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

PointerFocus::PointerFocus(QWidget* owner) : QObject(owner) {
  owner->installEventFilter(this);
}

bool PointerFocus::eventFilter(QObject* watched, QEvent* event) {
  auto* owner = static_cast<QWidget*>(parent());
  if (event->type() == QEvent::Enter || event->type() == QEvent::Leave)
    m_hasEntered = event->type() == QEvent::Enter;
  else if (event->type() == QEvent::MouseMove && std::exchange(m_hasEntered, false) &&
           owner->isActiveWindow() && !isTypedInto(QApplication::focusWidget()))
    owner->setFocus(Qt::MouseFocusReason);
  return QObject::eventFilter(watched, event);
}

} // namespace limn
