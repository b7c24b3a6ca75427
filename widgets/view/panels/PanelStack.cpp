// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/PanelStack.h"

#include "widgets/view/panels/FailureBar.h"
#include "widgets/view/panels/ViewPanels.h"

#include <algorithm>

namespace limn {

PanelStack::PanelStack(QWidget* view)
    : QObject(view), m_view(view), m_empty(new EmptyPanel(view)), m_message(new MessagePanel(view)),
      m_loading(new LoadingPanel(view)), m_failure(new FailureBar(view)) {
  m_message->hide();
  m_loading->hide();
  connect(m_message, &MessagePanel::retryRequested, this, &PanelStack::retryRequested);
  connect(m_loading, &LoadingPanel::cancelled, this, &PanelStack::loadingCancelled);
  connect(m_failure, &FailureBar::retryRequested, this, &PanelStack::driverRetryRequested);
}

int PanelStack::takenBelow() const {
  return m_failure->hasReason() ? m_failure->heightForWidth(m_view->width()) : 0;
}

int PanelStack::coveredBelow() const {
  return !m_loading->isHidden() ? std::max(0, m_loading->height() - takenBelow()) : 0;
}

void PanelStack::arrange(bool hasVolume, const QString& sentence) {
  const QRect whole = m_view->rect();
  m_empty->setGeometry(whole);
  m_message->setGeometry(whole);
  const int height = m_loading->sizeHint().height();
  m_loading->setGeometry(0, whole.height() - height, whole.width(), height);
  const int below = takenBelow();
  m_failure->setGeometry(0, whole.height() - below, whole.width(), below);
  m_failure->setVisible(below > 0);
  m_message->setSentence(sentence);
  m_message->setVisible(!sentence.isEmpty());
  m_empty->setVisible(sentence.isEmpty() && !hasVolume);
  for (QWidget* panel : {static_cast<QWidget*>(m_message), static_cast<QWidget*>(m_empty),
                         static_cast<QWidget*>(m_failure), static_cast<QWidget*>(m_loading)})
    panel->raise();
}

void PanelStack::setLoading(double fraction, const QString& text) {
  m_loading->setProgress(fraction, text);
  m_loading->show();
}

void PanelStack::clearLoading() {
  m_loading->hide();
}

void PanelStack::setFailure(const QString& sentence, const QString& details) {
  m_failure->setReason(sentence, details);
}

} // namespace limn
