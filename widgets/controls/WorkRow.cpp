// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/WorkRow.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace limn {

WorkRow::WorkRow(const QString& name, QWidget* parent)
    : QWidget(parent), m_bar(new QProgressBar), m_doing(new QLabel) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  m_bar->setRange(0, 1000);
  m_bar->setTextVisible(false);
  m_bar->setFixedHeight(4);
  m_bar->setAccessibleName(name);
  column->addWidget(m_bar);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  m_doing->setWordWrap(true);
  m_doing->setForegroundRole(QPalette::PlaceholderText);
  row->addWidget(m_doing, 1);
  auto* cancel = new QPushButton(tr("Cancel"));
  row->addWidget(cancel, 0, Qt::AlignTop);
  column->addLayout(row);
  cancel->setAccessibleName(tr("Cancel: %1").arg(name));
  connect(cancel, &QPushButton::clicked, this, &WorkRow::cancelled);
  setVisible(false);
}

void WorkRow::showProgress(std::optional<double> fraction, const QString& doing) {
  if (fraction && isHidden())
    m_left.begin();
  setVisible(fraction.has_value());
  m_bar->setValue(qRound(1000.0 * fraction.value_or(0.0)));
  m_doing->setText(doing + m_left.text(fraction.value_or(0.0)));
}

} // namespace limn
