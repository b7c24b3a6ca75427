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
}

} // namespace limn
