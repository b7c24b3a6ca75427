// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/PanelStack.h"

#include "widgets/view/panels/ReferencePanel.h"
#include "widgets/view/panels/ViewPanels.h"

namespace limn {

PanelStack::PanelStack(QWidget* view)
    : QObject(view), m_view(view), m_empty(new EmptyPanel(view)), m_message(new MessagePanel(view)),
      m_loading(new LoadingPanel(view)), m_reference(new ReferencePanel(view)) {
  m_message->hide();
  m_loading->hide();
  connect(m_empty, &EmptyPanel::openFolderRequested, this, &PanelStack::openFolderRequested);
  connect(m_empty, &EmptyPanel::openFileRequested, this, &PanelStack::openFileRequested);
  connect(m_empty, &EmptyPanel::sampleRequested, this, &PanelStack::sampleRequested);
  connect(m_message, &MessagePanel::retryRequested, this, &PanelStack::retryRequested);
  connect(m_loading, &LoadingPanel::cancelled, this, &PanelStack::loadingCancelled);
  connect(m_reference, &ReferencePanel::retryRequested, this, &PanelStack::driverRetryRequested);
}

void PanelStack::arrange(bool hasVolume, const QString& sentence, bool onProcessor) {
  const QRect whole = m_view->rect();
  m_empty->setGeometry(whole);
  m_message->setGeometry(whole);
  const int height = m_loading->sizeHint().height();
  m_loading->setGeometry(0, whole.height() - height, whole.width(), height);
  const bool showsReference = onProcessor && !m_reference->pictures().empty();
  m_reference->cover(whole);
  m_reference->showParts(showsReference);
  m_message->setSentence(sentence);
  m_message->setVisible(!sentence.isEmpty() && !showsReference);
  m_empty->setVisible(sentence.isEmpty() && !hasVolume);
  m_loading->raise();
}

void PanelStack::setLoading(double fraction, const QString& text) {
  m_loading->setProgress(fraction, text);
  m_loading->show();
}

void PanelStack::clearLoading() {
  m_loading->hide();
}

void PanelStack::setReason(const QString& sentence, const QString& details) {
  m_reference->setReason(sentence, details);
  m_reference->setPictures({});
}

void PanelStack::setPictures(const std::vector<QImage>& pictures) {
  m_reference->setPictures(pictures);
}

} // namespace limn
