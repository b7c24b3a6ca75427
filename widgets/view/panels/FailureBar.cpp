// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/FailureBar.h"

#include "widgets/view/panels/ViewPanels.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

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

} // namespace limn
