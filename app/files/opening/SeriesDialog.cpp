// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/opening/SeriesDialog.h"

#include "widgets/ValueText.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

enum Column { numberColumn, modality, images, size, thickness, date, description, folder, columns };

// What the file does not say is left open.
QString textOf(const SeriesSummary& series, Column column) {
  switch (column) {
  case numberColumn:
    return QString::number(series.number);
  case modality:
    return QString::fromStdString(series.modality);
  case images:
    return QString::number(series.dims.z);
  case size:
    return QStringLiteral("%1 × %2").arg(series.dims.x).arg(series.dims.y);
  case thickness:
    return series.thicknessMm ? valueText(*series.thicknessMm, SeriesDialog::tr("mm"), 2) : QString();
  case date:
    return QString::fromStdString(series.date);
  case description:
    return QString::fromStdString(series.description);
  default:
    return QString::fromStdString(series.folder);
  }
}

bool isNumber(int column) {
  return column == numberColumn || (column >= images && column <= thickness);
}

QTreeWidgetItem* rowOf(const SeriesSummary& series) {
  auto* row = new QTreeWidgetItem;
  for (int column = 0; column < columns; ++column) {
    row->setText(column, textOf(series, static_cast<Column>(column)));
    if (isNumber(column))
      row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  return row;
}

} // namespace

SeriesDialog::SeriesDialog(const std::vector<SeriesSummary>& series, QWidget* parent, int chosen)
    : QDialog(parent), m_series(series), m_list(new QTreeWidget(this)) {
  setWindowTitle(tr("Choose a series"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(new QLabel(tr("This folder holds %1 series, the largest first.").arg(series.size())));
  makeTable();
  for (std::size_t row = 0; row < series.size(); ++row)
    if (series[row].number == chosen)
      m_list->setCurrentItem(m_list->topLevelItem(static_cast<int>(row)));
  column->addWidget(m_list);
  auto* buttons = new QDialogButtonBox(this);
  QPushButton* open = buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole);
  buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  open->setDefault(true);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &SeriesDialog::choose);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_list, &QTreeWidget::itemActivated, this, &SeriesDialog::choose);
}

void SeriesDialog::makeTable() {
  m_list->setHeaderLabels({tr("Series"), tr("Modality"), tr("Images"), tr("Size"), tr("Thickness"),
                           tr("Date"), tr("Description"), tr("Folder")});
  m_list->setAccessibleName(tr("Series"));
  m_list->setRootIsDecorated(false);
  m_list->setAllColumnsShowFocus(true);
  m_list->setUniformRowHeights(true);
  for (const SeriesSummary& one : m_series)
    m_list->addTopLevelItem(rowOf(one));
  m_list->header()->setStretchLastSection(false);
  int width = 48; // frame and scroll bar
  for (int i = 0; i < columns; ++i) {
    if (isNumber(i))
      m_list->headerItem()->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
    m_list->resizeColumnToContents(i);
    width += m_list->columnWidth(i);
    const auto says = [i](const SeriesSummary& one) {
      return !textOf(one, static_cast<Column>(i)).isEmpty();
    };
    m_list->setColumnHidden(i, std::ranges::none_of(m_series, says)); // a column that says nothing
  }
  m_list->header()->setSectionResizeMode(description, QHeaderView::Stretch);
  m_list->setCurrentItem(m_list->topLevelItem(0));
  const int rows = std::clamp(static_cast<int>(m_series.size()), 4, 12);
  resize(std::clamp(width, 560, 960), 128 + rows * m_list->sizeHintForRow(0));
}

void SeriesDialog::choose() {
  const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
  if (row < 0)
    return;
  emit seriesChosen(m_series[static_cast<std::size_t>(row)].number);
  accept();
}

} // namespace limn
