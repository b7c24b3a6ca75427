// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/PanelStack.h"

#include "widgets/view/panels/ViewPanels.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace limn {
namespace {

// It lies where pictures lie, so it is dark in both themes, as the other panels are.
const QString barStyle = QStringLiteral(R"(
QFrame#graphicsFailure { background: #1d2027; border-top: 1px solid #434a57; }
QLabel { color: #f2f4f7; background: transparent; }
QPushButton { color: #f2f4f7; background: #262a33; border: 1px solid #434a57; border-radius: 4px;
              padding: 4px 12px; min-height: 20px; }
QPushButton:hover { background: #323844; }
QPushButton:focus { border-color: #4da3ff; }
)");

} // namespace

FailureBar::FailureBar(QWidget* parent) : QFrame(parent), m_text(new QLabel(this)) {
  setObjectName(QStringLiteral("graphicsFailure"));
  setStyleSheet(barStyle);
  m_text->setObjectName(QStringLiteral("failureReason"));
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* copy = panelButton(tr("Copy details"), QStringLiteral("copyFailure"), this);
  copy->setToolTip(tr("What the driver wrote, for a report; it names nobody and no file"));
  connect(copy, &QPushButton::clicked, this, &FailureBar::copyDetails);
  auto* retry = panelButton(tr("Try again"), QStringLiteral("retryGraphics"), this);
  connect(retry, &QPushButton::clicked, this, &FailureBar::retryRequested);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 8, 12, 8);
  row->setSpacing(12);
  row->addWidget(m_text, 1);
  row->addWidget(copy);
  row->addWidget(retry);
  hide();
}

void FailureBar::setReason(const QString& sentence, const QString& details) {
  m_sentence = sentence;
  m_details = details;
  m_text->setText(tr("%1 Until it works again, the processor draws the picture.").arg(sentence));
}

void FailureBar::copyDetails() const {
  QGuiApplication::clipboard()->setText(m_details.isEmpty() ? m_sentence
                                                            : m_sentence + QLatin1Char('\n') + m_details);
}

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
