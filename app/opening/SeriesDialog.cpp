// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/opening/SeriesDialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace limn {
namespace {

QString rowOf(const SeriesSummary& series) {
  QString row = SeriesDialog::tr("%1   %2   %3 images of %4×%5")
                    .arg(series.number)
                    .arg(QString::fromStdString(series.modality))
                    .arg(series.dims.z)
                    .arg(series.dims.x)
                    .arg(series.dims.y);
  for (const std::string& part : {series.description, series.folder})
    if (!part.empty())
      row += QStringLiteral("   ") + QString::fromStdString(part);
  return row;
}

} // namespace

SeriesDialog::SeriesDialog(const std::vector<SeriesSummary>& series, QWidget* parent)
    : QDialog(parent), m_series(series), m_list(new QListWidget(this)) {
  setWindowTitle(tr("Choose a series"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(new QLabel(tr("This folder holds %1 series, the largest first.").arg(series.size())));
  for (const SeriesSummary& one : series)
    m_list->addItem(rowOf(one));
  m_list->setCurrentRow(0);
  m_list->setAccessibleName(tr("Series"));
  column->addWidget(m_list);
  auto* buttons = new QDialogButtonBox(this);
  QPushButton* open = buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole);
  buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  open->setDefault(true);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &SeriesDialog::choose);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_list, &QListWidget::itemActivated, this, &SeriesDialog::choose);
  resize(qBound(420, m_list->sizeHintForColumn(0) + 64, 900), 360);
}

void SeriesDialog::choose() {
  const int row = m_list->currentRow();
  if (row < 0)
    return;
  emit seriesChosen(m_series[static_cast<std::size_t>(row)].number);
  accept();
}

} // namespace limn
