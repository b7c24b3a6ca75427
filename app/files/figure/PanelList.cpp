// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/figure/PanelList.h"

#include "widgets/controls/ChoiceRow.h"
#include "widgets/figure/FigureText.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>

namespace limn {

PanelList::PanelList(QWidget* parent) : QWidget(parent), m_count(new QuietComboBox(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(6);
  for (const int column : {1, 2})
    grid->setColumnStretch(column, 1);
  auto* label = new QLabel(tr("&Panels"), this);
  label->setBuddy(m_count);
  m_count->setObjectName(QStringLiteral("panelCount"));
  m_count->setAccessibleName(tr("Panels"));
  for (int count = 1; count <= static_cast<int>(mostPanels); ++count)
    m_count->addItem(count == 4   ? tr("4, in two rows")
                     : count == 1 ? tr("1")
                                  : tr("%1, side by side").arg(count));
  connect(m_count, &QComboBox::activated, this, [this](int index) {
    setCount(index + 1);
    emit edited();
  });
  grid->addWidget(label, 0, 0);
  grid->addWidget(m_count, 0, 1, 1, 2);
  for (std::size_t i = 0; i < m_rows.size(); ++i)
    addRow(i);
  setCount(1);
}

void PanelList::addRow(std::size_t index) {
  auto* grid = static_cast<QGridLayout*>(layout());
  Row& row = m_rows[index];
  const QString letter = panelLetter(index);
  row.letter = new QLabel(letter, this);
  row.letter->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row.source = new QuietComboBox(this);
  row.source->setObjectName(QStringLiteral("panelSource-") + letter);
  row.source->setAccessibleName(tr("What panel %1 shows").arg(letter));
  row.source->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  row.source->setMinimumContentsLength(18);
  row.name = new QLineEdit(this);
  row.name->setObjectName(QStringLiteral("panelName-") + letter);
  row.name->setAccessibleName(tr("Name above panel %1").arg(letter));
  row.name->setPlaceholderText(tr("no name"));
  row.letter->setBuddy(row.source);
  const int line = static_cast<int>(index) + 1;
  grid->addWidget(row.letter, line, 0);
  grid->addWidget(row.source, line, 1);
  grid->addWidget(row.name, line, 2);
  connect(row.source, &QComboBox::activated, this, [this, index](int chosen) {
    Row& changed = m_rows[index];
    changed.chosen = m_sources[static_cast<std::size_t>(chosen)].text;
    changed.ownName = QString();
    showRow(changed);
    emit edited();
  });
  row.name->installEventFilter(this);
  connect(row.name, &QLineEdit::textEdited, this, [this, index](const QString& text) {
    m_rows[index].ownName = text.isNull() ? QStringLiteral("") : text;
    emit edited();
  });
}

// Left, the field of a long name shows its beginning again.
bool PanelList::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut)
    static_cast<QLineEdit*>(watched)->setCursorPosition(0);
  return QWidget::eventFilter(watched, event);
}

void PanelList::setCount(int count) {
  m_count->setCurrentIndex(count - 1);
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const Row& row = m_rows[i];
    for (QWidget* part : {static_cast<QWidget*>(row.letter), static_cast<QWidget*>(row.source),
                          static_cast<QWidget*>(row.name)})
      part->setVisible(static_cast<int>(i) < count);
  }
}

const PanelSource& PanelList::sourceOf(const Row& row) const {
  const auto found = std::ranges::find(m_sources, row.chosen, &PanelSource::text);
  return found == m_sources.end() ? m_sources.front() : *found;
}

void PanelList::showRow(Row& row) {
  if (m_sources.empty())
    return;
  const PanelSource& source = sourceOf(row);
  row.source->setCurrentIndex(row.source->findText(source.text));
  row.source->setToolTip(source.text); // of a long name the list shows a part
  const QString name = row.ownName.isNull() ? source.panel.name : row.ownName;
  if (row.name->text() == name)
    return;
  row.name->setText(name);
  row.name->setCursorPosition(0); // likewise
}

void PanelList::setSources(const std::vector<PanelSource>& sources) {
  const bool isSameList = std::ranges::equal(m_sources, sources, {}, &PanelSource::text, &PanelSource::text);
  m_sources = sources;
  for (Row& row : m_rows) {
    if (!isSameList) {
      row.source->clear();
      for (const PanelSource& source : sources)
        row.source->addItem(source.text);
    }
    showRow(row);
  }
}

// Panels that are added show what no other does.
void PanelList::choose(const std::vector<std::size_t>& sources) {
  std::vector<std::size_t> order = sources;
  for (std::size_t source = 0; source < m_sources.size(); ++source)
    if (std::ranges::find(sources, source) == sources.end())
      order.push_back(source);
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    m_rows[i].chosen = m_sources[order[std::min(i, order.size() - 1)]].text;
    m_rows[i].ownName = QString();
    showRow(m_rows[i]);
  }
  setCount(static_cast<int>(std::clamp<std::size_t>(sources.size(), 1, mostPanels)));
}

std::vector<FigurePanel> PanelList::panels() const {
  std::vector<FigurePanel> panels;
  for (int i = 0; i <= m_count->currentIndex() && !m_sources.empty(); ++i) {
    const Row& row = m_rows[static_cast<std::size_t>(i)];
    panels.push_back(sourceOf(row).panel);
    if (!row.ownName.isNull())
      panels.back().name = row.ownName;
  }
  return panels;
}

} // namespace limn
