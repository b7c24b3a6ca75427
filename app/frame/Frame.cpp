// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/Frame.h"

#include "app/window/WindowContext.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"

namespace limn {
namespace {

QList<QWidget*> panelsOf(const WindowContext& context) {
  return context.docks.contentsAt(Qt::LeftDockWidgetArea) + QList<QWidget*>{&context.view, &context.planes} +
         context.docks.contentsAt(Qt::BottomDockWidgetArea) +
         context.docks.contentsAt(Qt::RightDockWidgetArea);
}

} // namespace

Frame::Frame(WindowContext& context)
    : QObject(&context.window), m_appearance(context), m_focus(context),
      m_panels(context.actions, panelsOf(context)), m_title(context), m_dialogs(context), m_tour(context) {
  const QAction* quit =
      context.actions.add(QStringLiteral("quit"),
                          {.text = tr("&Quit"), .place = {Menu::file, 3, 2}, .shortcut = QKeySequence::Quit});
  connect(quit, &QAction::triggered, &context.window, &QWidget::close);
  context.docks.arrange(context.actions);
  context.actions.arrange();
  context.docks.restore(context.settings.windowGeometry(), context.settings.windowState());
}

} // namespace limn
