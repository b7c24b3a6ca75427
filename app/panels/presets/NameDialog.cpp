// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/NameDialog.h"

#include "widgets/controls/NumberField.h"

#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>

#include <utility>

namespace limn {

NameDialog::NameDialog(const QString& title, const QString& label, const QString& text, Refusal refusal,
                       QWidget* parent)
    : QInputDialog(parent), m_refusal(std::move(refusal)) {
  setWindowTitle(title);
  setLabelText(label);
  setTextValue(text);
  setOkButtonText(tr("Save"));
  m_field = findChild<QLineEdit*>(); // made by what was set
  const auto* buttons = findChild<QDialogButtonBox*>();
  connect(this, &QInputDialog::textValueChanged, buttons, [this, buttons](const QString& entered) {
    buttons->button(QDialogButtonBox::Ok)->setEnabled(!entered.trimmed().isEmpty());
    showRefusal({});
  });
}

QString NameDialog::said() const {
  return m_field->accessibleDescription();
}

void NameDialog::done(int result) {
  const QString sentence = result == Accepted && m_refusal ? m_refusal(textValue().trimmed()) : QString();
  if (sentence.isEmpty())
    return QInputDialog::done(result);
  showRefusal(sentence);
  m_field->setFocus();
  m_field->selectAll();
  sayRefusal(*m_field, sentence);
}

void NameDialog::showRefusal(const QString& sentence) {
  m_field->setAccessibleDescription(sentence);
  m_field->setToolTip(sentence);
  m_field->setProperty("isRefused", !sentence.isEmpty()); // theme.qss
  m_field->style()->unpolish(m_field);
  m_field->style()->polish(m_field);
}

} // namespace limn
