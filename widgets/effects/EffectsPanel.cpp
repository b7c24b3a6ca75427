// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/effects/EffectsPanel.h"

#include "widgets/ValueText.h"
#include "widgets/effects/EffectRowWidget.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {

EffectsPanel::EffectsPanel(QWidget* parent)
    : SectionPanel(parent), m_list(new QWidget), m_heading(new QLabel), m_measure(new QPushButton),
      m_method(new QLabel) {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 8, 0, 12);
  column->setSpacing(4);
  m_heading->setWordWrap(true);
  m_heading->setContentsMargins(12, 0, 12, 4);
  column->addWidget(m_heading);
  auto* buttonRow = new QHBoxLayout;
  buttonRow->setContentsMargins(12, 0, 12, 4);
  m_measure->setObjectName(QStringLiteral("measureCost"));
  m_measure->setToolTip(tr("Draws the picture several times with and without each effect, while nothing else "
                           "is to be drawn; any change of the scene stops it."));
  buttonRow->addWidget(m_measure);
  buttonRow->addStretch(1);
  column->addLayout(buttonRow);
  connect(m_measure, &QPushButton::clicked, this, &EffectsPanel::measureRequested);
  auto* rows = new QVBoxLayout(m_list);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  column->addWidget(m_list);
  m_method->setWordWrap(true);
  m_method->setForegroundRole(QPalette::PlaceholderText);
  m_method->setContentsMargins(12, 4, 12, 0);
  column->addWidget(m_method);
  column->addStretch(1);
  setWidget(content);
  // Narrower, texts would be columns of words, and the tabs above it cut off.
  setMinimumWidth(260);
  setAccessibleName(tr("Effects"));
  setRows({}, {});
  showTimes();
}

void EffectsPanel::setRows(const std::vector<EffectRow>& rows, const QString& picture) {
  m_shown = rows;
  while (m_rows.size() < rows.size()) {
    m_rows.push_back(new EffectRowWidget);
    m_list->layout()->addWidget(m_rows.back());
  }
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    m_rows[i]->setVisible(i < rows.size());
    if (i < rows.size())
      m_rows[i]->setRow(rows[i]);
  }
  const auto on = std::count_if(rows.begin(), rows.end(), [](const EffectRow& row) { return row.isOn; });
  m_heading->setText(rows.empty()
                         ? tr("Open a volume to see which effects its picture calls for.")
                         : tr("%1: the picture calls for %2 of %3 effects; nothing else is computed.")
                               .arg(picture)
                               .arg(on)
                               .arg(rows.size()));
  m_measure->setEnabled(!rows.empty() && !m_times.isMeasuring);
}

void EffectsPanel::setTimes(const EffectTimes& times) {
  m_times = times;
  showTimes();
}

void EffectsPanel::showTimes() {
  for (std::size_t i = 0; i < m_rows.size(); ++i)
    m_rows[i]->setCost(i < m_times.costs.size() ? m_times.costs[i] : std::nullopt);
  m_measure->setText(m_times.isMeasuring ? tr("Measuring… %1 %").arg(qRound(100.0 * m_times.fraction))
                                         : tr("Measure cost"));
  m_measure->setAccessibleName(m_measure->text());
  m_measure->setEnabled(!m_shown.empty() && !m_times.isMeasuring);
  m_method->setVisible(!m_times.costs.empty());
  if (!m_times.costs.empty())
    m_method->setText(
        tr("The whole picture takes %1 ms at %2 × %3 pixels. Each cost is the median time with the "
           "effect less the median without it; costs overlap and do not add up. Method: %4.")
            .arg(fixedNumber(m_times.wholeMs, m_times.wholeMs < 10.0 ? 1 : 0))
            .arg(m_times.size.width())
            .arg(m_times.size.height())
            .arg(m_times.method));
}

} // namespace limn
