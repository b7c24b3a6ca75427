// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/presets/PresetBrowser.h"

#include <QTreeView>

namespace limn {

/// The presets that a browser shows, from top to bottom.
inline QStringList presetNames(const PresetBrowser& browser) {
  const QAbstractItemModel* model = browser.findChild<QTreeView*>()->model();
  QStringList names;
  for (int group = 0; group < model->rowCount(); ++group) {
    const QModelIndex parent = model->index(group, 0);
    for (int row = 0; row < model->rowCount(parent); ++row)
      names << model->index(row, 0, parent).data().toString();
  }
  return names;
}

} // namespace limn
