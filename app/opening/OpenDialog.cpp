// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/opening/OpenDialog.h"

#include "app/FileDialogRoom.h"
#include "app/Settings.h"

#include <QFileDialog>
#include <QFileInfo>

namespace limn {

QStringList askForPaths(QWidget* parent, const OpenQuestion& question, Settings& settings) {
  QFileDialog dialog(parent, question.title, settings.dialogFolder());
  dialog.setFileMode(question.isFolder ? QFileDialog::Directory
                     : question.isMany ? QFileDialog::ExistingFiles
                                       : QFileDialog::ExistingFile);
  dialog.setOption(QFileDialog::HideNameFilterDetails); // a list of endings would be cut off
  dialog.setOption(QFileDialog::ShowDirsOnly, question.isFolder);
  if (!question.filters.isEmpty())
    dialog.setNameFilters(question.filters);
  giveRoom(dialog);
  if (dialog.exec() != QDialog::Accepted)
    return {};
  QStringList paths = dialog.selectedFiles();
  settings.setDialogFolder(QFileInfo(paths.value(0)).absolutePath());
  return paths;
}

QString askWhatToOpen(QWidget* parent, const OpenQuestion& question, Settings& settings) {
  return askForPaths(parent, question, settings).value(0);
}

} // namespace limn
