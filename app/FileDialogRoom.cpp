// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/FileDialogRoom.h"

#include <QFileDialog>
#include <QHeaderView>
#include <QScreen>
#include <QSplitter>
#include <QTreeView>

namespace limn {

void giveRoom(QFileDialog& dialog) {
  auto* files = dialog.findChild<QTreeView*>(QStringLiteral("treeView")); // as Qt calls it
  auto* splitter = dialog.findChild<QSplitter*>();
  if (!files || !splitter)
    return;
  files->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  files->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  dialog.resize(QSize(860, 520).boundedTo(dialog.screen()->availableSize()));
  splitter->setSizes({160, 680});
  const bool isSave = dialog.acceptMode() == QFileDialog::AcceptSave;
  dialog.setLabelText(QFileDialog::LookIn, isSave ? QObject::tr("Save in:") : QObject::tr("Look in:"));
  if (dialog.fileMode() != QFileDialog::Directory)
    return;
  // Folders have neither size nor kind.
  dialog.setLabelText(QFileDialog::FileName, QObject::tr("Folder:"));
  files->setColumnHidden(1, true);
  for (const char* part : {"fileTypeLabel", "fileTypeCombo"})
    if (auto* shown = dialog.findChild<QWidget*>(QLatin1String(part)))
      shown->hide();
}

} // namespace limn
