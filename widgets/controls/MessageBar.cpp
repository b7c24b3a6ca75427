// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/MessageBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

namespace limn {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), m_sentence(new QLabel(this)), m_details(new QLabel(this)),
      m_more(new QToolButton(this)), m_action(new QToolButton(this)), m_close(new QToolButton(this)) {
  setObjectName(QStringLiteral("messageBar"));
  setAutoFillBackground(true);
  m_action->setObjectName(QStringLiteral("messageAction")); // stands out (theme.qss)
  for (QLabel* label : {m_sentence, m_details}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  m_more->setText(tr("Details"));
  m_action->setAccessibleName(tr("What can be done about it")); // until a message brings its own
  m_close->setText(tr("Dismiss"));
  m_more->setCheckable(true);
  m_more->setToolTip(tr("Shows every remark about this volume."));
  auto* row = new QHBoxLayout;
  row->addWidget(m_sentence, 1);
  for (QToolButton* button : {m_action, m_more, m_close})
    row->addWidget(button, 0, Qt::AlignTop);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 8, 8);
  column->setSpacing(4);
  column->addLayout(row);
  column->addWidget(m_details);
  connect(m_more, &QToolButton::toggled, m_details, &QWidget::setVisible);
  connect(m_action, &QToolButton::clicked, this, [this] {
    if (m_run)
      m_run();
  });
  connect(m_close, &QToolButton::clicked, this, [this] {
    hide();
    if (m_dismiss)
      m_dismiss();
  });
  hide();
}

void MessageBar::show(Kind kind, const QString& sentence, const QStringList& details, const Action& action,
                      const Action& dismissal) {
  setProperty("kind", kind == Kind::error     ? QStringLiteral("error")
                      : kind == Kind::warning ? QStringLiteral("warning")
                                              : QStringLiteral("question"));
  style()->unpolish(this);
  style()->polish(this);
  m_sentence->setText(sentence);
  m_details->setText(details.join(QLatin1Char('\n')));
  m_more->setVisible(!details.isEmpty());
  m_more->setChecked(false);
  m_details->hide();
  m_run = action.run;
  m_action->setText(action.text);
  m_action->setAccessibleName(action.text);
  m_action->setVisible(!action.text.isEmpty());
  m_dismiss = dismissal.run;
  m_close->setText(dismissal.text.isEmpty() ? tr("Dismiss") : dismissal.text);
  m_close->setAccessibleName(m_close->text());
  m_close->setToolTip(dismissal.text.isEmpty() ? tr("Hides this message.") : QString());
  QFrame::show();
}

QString MessageBar::sentence() const {
  return m_sentence->text();
}

} // namespace limn
