// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/HelpBoxes.h"

#include "app/actions/HelpRows.h"
#include "widgets/Icons.h"

#include <QDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QList>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace limn {
namespace {

// One grid for all that stands below each other, so that its columns do, too.
void addRows(QGridLayout& grid, const QList<HelpRow>& rows) {
  for (const HelpRow& row : rows) {
    const int line = grid.rowCount();
    auto* effect = new QLabel(row.effect);
    if (row.gesture.isEmpty()) {
      QFont bold = effect->font();
      bold.setWeight(QFont::DemiBold);
      effect->setFont(bold);
      effect->setContentsMargins(0, line > 1 ? 12 : 0, 0, 2);
      grid.addWidget(effect, line, 0, 1, 2);
      continue;
    }
    effect->setForegroundRole(QPalette::PlaceholderText);
    grid.addWidget(new QLabel(row.gesture), line, 0);
    grid.addWidget(effect, line, 1);
  }
}

QGridLayout* columnOf(const QList<QList<HelpRow>>& groups) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(20);
  grid->setVerticalSpacing(3);
  grid->setColumnStretch(1, 1);
  for (const QList<HelpRow>& rows : groups)
    addRows(*grid, rows);
  grid->setRowStretch(grid->rowCount(), 1);
  return grid;
}

} // namespace

// Side by side, because one below the other they are higher than a small screen.
void showShortcuts(const Actions& actions, QWidget* parent) {
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Mouse and keys"));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(40);
  const HelpRows rows = helpRows(actions);
  columns->addLayout(columnOf({rows.picture, rows.curve}), 1);
  columns->addLayout(columnOf({rows.slices, rows.menus}), 1);
  auto* close = new QPushButton(QObject::tr("Close"), dialog);
  QObject::connect(close, &QPushButton::clicked, dialog, &QDialog::close);
  auto* all = new QVBoxLayout(dialog);
  all->setContentsMargins(16, 12, 16, 12);
  all->setSpacing(12);
  all->addLayout(columns);
  all->addWidget(close, 0, Qt::AlignRight);
  dialog->show();
}

void showAbout(QWidget* parent) {
  const QString text =
      QObject::tr("<h3>Limn %1</h3><p>Shows CT and MR volumes in three dimensions: you shape which tissue is "
                  "seen, in which colour and how solid, and compare ways of lighting it side by "
                  "side.</p><p><b>Not for diagnosis.</b></p><p>Free software under the GNU General Public "
                  "License, version 3 or later.</p>")
          .arg(QStringLiteral(LIMN_VERSION));
  auto* box =
      new QMessageBox(QMessageBox::NoIcon, QObject::tr("About Limn"), text, QMessageBox::Close, parent);
  box->setIconPixmap(programIcon().pixmap(QSize(64, 64), parent->devicePixelRatioF()));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowModality(Qt::NonModal);
  box->show();
}

} // namespace limn
