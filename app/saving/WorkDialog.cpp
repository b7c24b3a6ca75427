// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/saving/WorkDialog.h"

#include "app/BackgroundWork.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace limn {

WorkDialog::WorkDialog(const QString& name, const QString& work, QWidget* parent)
    : QDialog(parent), m_text(new QLabel(this)), m_bar(new QProgressBar(this)),
      m_close(new QPushButton(tr("Close"), this)) {
  m_text->setObjectName(name + QStringLiteral("Says"));
  m_text->setWordWrap(true);
  m_text->hide();
  m_bar->setRange(0, 1000);
  m_bar->setTextVisible(false);
  m_bar->setAccessibleName(work);
  m_bar->hide();
  m_close->setObjectName(name + QStringLiteral("Close"));
  m_close->setAutoDefault(false);
  connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
}

void WorkDialog::follow(const BackgroundWork& work) {
  connect(&work, &BackgroundWork::progressed, this, &WorkDialog::showProgress);
  connect(&work, &BackgroundWork::failed, this, &WorkDialog::endProgress);
}

void WorkDialog::addFoot(QVBoxLayout* column, QPushButton* start, QPushButton* other) {
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  if (other) {
    other->setAutoDefault(false);
    buttons->addWidget(other);
    m_starts.push_back(other);
  }
  buttons->addWidget(m_close);
  buttons->addWidget(start);
  start->setDefault(true);
  m_starts.push_back(start);
  column->addWidget(m_text);
  column->addWidget(m_bar);
  column->addLayout(buttons);
}

void WorkDialog::showProgress(double fraction) {
  const bool wasWorking = isWorking();
  m_bar->setValue(static_cast<int>(1000.0 * fraction));
  m_bar->show();
  if (!wasWorking)
    m_before = focusWidget();
  setStartable(false);
  m_close->setText(tr("Cancel"));
  say(doing(fraction));
  if (!wasWorking)
    emit workingChanged(true);
}

void WorkDialog::endProgress(const QString& text) {
  const bool wasWorking = isWorking();
  m_bar->hide();
  setStartable(true);
  m_close->setText(tr("Close"));
  say(text);
  if (!wasWorking)
    return;
  emit workingChanged(false);
  if (m_before && focusWidget() == m_close) // where the keyboard went as what had it could not be used
    m_before->setFocus(Qt::OtherFocusReason);
}

bool WorkDialog::isWorking() const {
  return !m_bar->isHidden();
}

void WorkDialog::say(const QString& text) {
  m_text->setText(text);
  m_text->setVisible(!text.isEmpty());
}

void WorkDialog::setStartable(bool isStartable) {
  for (QPushButton* start : m_starts)
    start->setEnabled(isStartable);
}

// What runs ends first; closing takes a second step.
void WorkDialog::done(int result) {
  if (isWorking())
    emit cancelled();
  else
    QDialog::done(result);
}

} // namespace limn
