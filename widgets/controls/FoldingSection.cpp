// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/FoldingSection.h"

#include "widgets/controls/FoldingHeader.h"

#include <QVBoxLayout>

#include <algorithm>

namespace limn {

FoldingSection::FoldingSection(const QString& title, QWidget* parent)
    : QWidget(parent), m_header(new FoldingHeader(title)), m_body(new QWidget),
      m_contents(new QVBoxLayout(m_body)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_header);
  layout->addWidget(m_body);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum); // room left over stays below all sections
  m_contents->setContentsMargins(12, 4, 12, 12);
  m_contents->setSpacing(8);
  connect(m_header, &QAbstractButton::clicked, this, [this](bool open) {
    setFolded(!open);
    emit foldedByUser(!open);
  });
}

void FoldingSection::setFolded(bool folded) {
  m_header->setChecked(!folded);
  m_body->setVisible(!folded);
}

bool FoldingSection::isFolded() const {
  return !m_header->isChecked();
}

QSize FoldingSection::minimumSizeHint() const {
  const QSize size = QWidget::minimumSizeHint();
  return {std::max(size.width(), m_body->minimumSizeHint().width()), size.height()};
}

void FoldingSection::setSummary(const QString& summary) {
  m_header->setSummary(summary);
}

} // namespace limn
