// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/opening/OpenDialog.h"

#include "app/FileDialogRoom.h"
#include "app/Settings.h"

#include <QFileDialog>
#include <QFileInfo>

namespace limn {

QString askWhatToOpen(QWidget* parent, const OpenQuestion& question, Settings& settings) {
  QFileDialog dialog(parent, question.title, settings.dialogFolder());
  dialog.setFileMode(question.isFolder ? QFileDialog::Directory : QFileDialog::ExistingFile);
  dialog.setOption(QFileDialog::HideNameFilterDetails); // a list of endings would be cut off
  dialog.setOption(QFileDialog::ShowDirsOnly, question.isFolder);
  if (!question.filters.isEmpty())
    dialog.setNameFilters(question.filters);
  giveRoom(dialog);
  if (dialog.exec() != QDialog::Accepted)
    return {};
  const QString path = dialog.selectedFiles().value(0);
  settings.setDialogFolder(QFileInfo(path).absolutePath());
  return path;
}

} // namespace limn
