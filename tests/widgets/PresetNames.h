// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/presets/PresetBrowser.h"
#include "widgets/presets/PresetModel.h"

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

/// The preset that a browser marks as shown, with "*" where it is marked as modified; empty where none is.
inline QString shownPreset(const PresetBrowser& browser) {
  const QAbstractItemModel* model = browser.findChild<QTreeView*>()->model();
  QStringList shown;
  for (int group = 0; group < model->rowCount(); ++group) {
    const QModelIndex parent = model->index(group, 0);
    for (int row = 0; row < model->rowCount(parent); ++row) {
      const QModelIndex index = model->index(row, 0, parent);
      const auto use = static_cast<PresetUse>(index.data(presetRole::use).toInt());
      if (use != PresetUse::none)
        shown << index.data().toString() + (use == PresetUse::modified ? "*" : "");
    }
  }
  return shown.join(QStringLiteral(", "));
}

/// The place of a preset in the window of its list's viewport.
inline QRect rowOf(const PresetBrowser& browser, const QString& name) {
  QTreeView& list = *browser.findChild<QTreeView*>();
  const QModelIndexList found = list.model()->match(list.model()->index(0, 0), Qt::DisplayRole, name, 1,
                                                    Qt::MatchExactly | Qt::MatchRecursive);
  if (found.empty())
    return {};
  list.scrollTo(found.front());
  return list.visualRect(found.front());
}

} // namespace limn
