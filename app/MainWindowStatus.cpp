// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/MessageBar.h"
#include "widgets/view/pictures/PictureState.h"
#include "widgets/view/status/PictureStatus.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

// What the status bar says, and whether the picture refines at rest.

namespace limn {

void MainWindow::makeStatusBar() {
  m_volumeLabel = new QLabel(this);
  m_probeLabel = new QLabel(this);
  m_pictureStatus = new PictureStatus(this);
  statusBar()->addWidget(m_volumeLabel);
  statusBar()->addWidget(m_probeLabel, 1);
  makeWaitingRow();
  statusBar()->addPermanentWidget(m_pictureStatus);
  m_probeLabel->setAlignment(Qt::AlignCenter);
}

// In the status bar, where it takes nothing from the picture: that would begin anew in another size.
void MainWindow::makeWaitingRow() {
  m_waiting = new QLabel(this);
  m_stopWaiting = new QToolButton(this);
  m_stopWaiting->setObjectName(QStringLiteral("stopWaiting"));
  m_stopWaiting->setText(tr("Cancel"));
  m_stopWaiting->setAccessibleName(tr("Cancel: saving the picture"));
  m_stopWaiting->setMaximumHeight(m_waiting->sizeHint().height());
  m_stopWaiting->setStyleSheet(QStringLiteral("padding: 0px 4px; margin: 0px; text-decoration: underline;"));
  connect(m_stopWaiting, &QToolButton::clicked, this, &MainWindow::forgetAwaitedPicture);
  for (QWidget* widget : {static_cast<QWidget*>(m_waiting), static_cast<QWidget*>(m_stopWaiting)}) {
    statusBar()->addPermanentWidget(widget);
    widget->hide();
  }
}

void MainWindow::showPictureState(const PictureState& state) {
  m_pictureStatus->setText(pictureStatusText(state, m_session.scene()));
  if (!state.limitation.isEmpty() && m_messages->sentence() != state.limitation)
    m_messages->show(MessageBar::Kind::warning, state.limitation);
  // Not here: the view may be in the middle of drawing.
  if (m_awaitedPicture)
    QTimer::singleShot(0, this, &MainWindow::writeAwaitedPicture);
}

void MainWindow::prepareForDriverFailure() {
  connect(m_view, &CompareView::graphicsRestored, this,
          [this](const QString& sentence) { m_messages->show(MessageBar::Kind::warning, sentence); });
}

void MainWindow::addRefineAction(QMenu& menu) {
  QAction* action = menu.addAction(tr("Refine at &rest"));
  action->setCheckable(true);
  action->setToolTip(
      tr("While nothing moves, draws the picture again with smaller and smaller steps until it "
         "lies within half a level of the exact one."));
  action->setChecked(m_settings.refinesAtRest());
  m_view->setRefinesAtRest(action->isChecked());
  connect(action, &QAction::toggled, this, [this](bool refines) {
    m_settings.setRefinesAtRest(refines);
    m_view->setRefinesAtRest(refines);
  });
}

} // namespace limn
