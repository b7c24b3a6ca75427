// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/TourController.h"

#include "app/window/WindowContext.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/view/CompareView.h"

#include <QDockWidget>
#include <QEvent>
#include <QStatusBar>
#include <QToolBar>

namespace limn {

TourController::TourController(WindowContext& context) : QObject(&context.window), m_context(context) {
  const QAction* tour = context.actions.add(QStringLiteral("tour"),
                                            {.text = tr("&Tour of the window"), .place = {Menu::help, 1, 2}});
  connect(tour, &QAction::triggered, this, &TourController::start);
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene&) {
    if (m_step != 0)
      return;
    const bool offered = m_offersSample;
    go(0);
    if (offered && !m_offersSample)
      m_callout->takeFocus(); // which the window gives to what was opened
  });
}

void TourController::offer() {
  if (m_context.settings.tourIsKnown())
    return;
  m_context.tour.show(MessageBar::Kind::question,
                      tr("New to Limn? A tour shows the window in six short steps."), {},
                      {tr("Take the tour"), [this] { start(); }},
                      {tr("No, thank you"), [this] { m_context.settings.setTourIsKnown(true); }});
}

std::vector<TourStep> TourController::steps() const {
  const auto part = [this](const char* name) {
    return m_context.window.findChild<QWidget*>(QLatin1String(name));
  };
  return {
      {tr("Open"),
       tr("Open a DICOM folder or a file here, or drop one on the window. To look around first, take "
          "the sample head."),
       part("openButton")},
      {tr("Look"),
       tr("Drag with the left button to turn, turn the wheel to come nearer. The left side is lit the "
          "classic way, the right side enhanced; Space swaps them while held. Esc always returns to "
          "turning."),
       m_context.window.findChild<CompareView*>()},
      {tr("Shape the curve"),
       tr("The curve says how solid each value is; behind it stands how often each occurs. Drag a point, or "
          "click the curve to add one: the picture follows. Ctrl+Z takes back what you did to the picture."),
       part("curveDock")},
      {tr("Choose a preset"),
       tr("Each shows what it makes of your volume. Point at one to try it, click to use it. "
          "1 to 9 in the picture are the first of the list."),
       part("presetDock")},
      {tr("Light and accuracy"),
       tr("Properties has projection, light and crop; Effects lists what is computed and why; Accuracy "
          "measures "
          "what exactness costs in time. The line below says how exact the picture is."),
       part("shadingDock")},
      {tr("Save, and find help"),
       tr("The camera saves the picture with everything that made it; File has figures, sessions and more. "
          "F1 opens the guide, ? lists every key, and Help has this tour again."),
       m_context.window.findChild<QToolBar*>()->widgetForAction(
           m_context.window.findChild<QAction*>(QStringLiteral("savePicture")))},
  };
}

void TourController::start() {
  m_context.tour.hide();
  m_context.settings.setTourIsKnown(true);
  if (m_step >= 0) {
    m_callout->takeFocus();
    return;
  }
  m_before = m_context.window.focusWidget();
  m_frame = new CalloutFrame(m_context.window);
  m_callout = new Callout(m_context.window);
  connect(m_callout, &Callout::next, this, [this] { go(m_step + 1); });
  connect(m_callout, &Callout::back, this, [this] { go(m_step - 1); });
  connect(m_callout, &Callout::ended, this, &TourController::end);
  connect(m_callout, &Callout::actionRequested, &m_context.actions.find("openSample"), &QAction::trigger);
  m_context.window.installEventFilter(this);
  go(0);
  m_callout->takeFocus();
}

void TourController::go(int step) {
  const std::vector<TourStep> all = steps();
  if (step < 0 || step >= static_cast<int>(all.size()))
    return end();
  m_step = step;
  say(all[step]);
  if (m_target)
    m_target->removeEventFilter(this);
  m_target = all[step].target;
  m_target->installEventFilter(this);
  if (auto* dock = qobject_cast<QDockWidget*>(m_target)) {
    dock->show();
    dock->raise();
  }
  m_frame->show();
  m_callout->show();
  place();
}

void TourController::say(const TourStep& step) {
  const int count = static_cast<int>(steps().size());
  m_offersSample = m_step == 0 && !m_context.session.scene().volume;
  m_callout->say({step.title, step.text, tr("%1 of %2").arg(m_step + 1).arg(count),
                  m_offersSample ? tr("Open the sample head") : QString()},
                 m_step == 0, m_step == count - 1);
}

// A panel in a window of its own is spoken of from the middle of this one.
void TourController::place() {
  QWidget& window = m_context.window;
  const bool isHere = m_target->isVisible() && m_target->window() == &window;
  const QRect target = isHere ? QRect(m_target->mapTo(&window, QPoint()), m_target->size()) : window.rect();
  m_frame->setVisible(isHere);
  m_frame->setGeometry(target.adjusted(-2, -2, 2, 2).intersected(window.rect()));
  m_frame->raise();
  m_callout->adjustSize();
  m_callout->pointAt(target);
  m_callout->raise();
}

void TourController::end() {
  m_step = -1;
  m_context.window.removeEventFilter(this);
  if (m_target)
    m_target->removeEventFilter(this);
  const bool hadFocus = m_callout->isAncestorOf(m_context.window.focusWidget());
  m_callout->hide();
  m_callout->deleteLater();
  m_frame->hide();
  m_frame->deleteLater();
  if (hadFocus && m_before)
    m_before->setFocus(Qt::OtherFocusReason);
}

bool TourController::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  if (m_step >= 0 &&
      (type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show || type == QEvent::Hide))
    QMetaObject::invokeMethod(
        this,
        [this] {
          if (m_step >= 0)
            place();
        },
        Qt::QueuedConnection); // once the layout is done
  return QObject::eventFilter(watched, event);
}

} // namespace limn
