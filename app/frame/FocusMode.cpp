// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/FocusMode.h"

#include "app/window/WindowContext.h"
#include "widgets/view/CompareView.h"

#include <QEvent>
#include <QFontMetrics>
#include <QPainter>
#include <QStatusBar>
#include <QToolBar>

#include <utility>

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

FocusMode::FocusMode(WindowContext& context)
    : QObject(&context.window), m_context(context),
      m_action(
          context.actions.add(QStringLiteral("pictureAndCurveOnly"), {.text = tr("Picture and cur&ve only"),
                                                                      .place = {Menu::view, 3, 20},
                                                                      .shortcut = Qt::Key_F11,
                                                                      .isCheckable = true})) {
  connect(m_action, &QAction::toggled, this, &FocusMode::set);
  connect(&context.view, &CompareView::maximiseRequested, m_action, &QAction::trigger);
}

void FocusMode::leave() {
  m_action->setChecked(false);
}

// What the user had closed before stays closed.
void FocusMode::set(bool isOn) {
  if (!isOn) {
    if (m_note)
      m_note->hide();
    for (const QPointer<QWidget>& bar : std::exchange(m_hidden, {}))
      if (bar)
        bar->show();
    return m_context.docks.showAgain();
  }
  m_context.docks.hideBeside();
  const auto hide = [this](QWidget* bar) {
    if (bar->isHidden())
      return;
    m_hidden.emplace_back(bar);
    bar->hide();
  };
  for (QToolBar* bar : m_context.window.findChildren<QToolBar*>())
    hide(bar);
  hide(m_context.window.statusBar());
  if (!m_note)
    m_note = new FadingNote(*m_context.window.centralWidget());
  m_note->say(tr("F11 or Esc shows the panels again"));
}

} // namespace limn
