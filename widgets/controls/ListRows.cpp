// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/ListRows.h"

#include <QHeaderView>
#include <QTreeView>

#include <algorithm>

namespace limn {

void fitToRows(QAbstractItemView& view, int rows, int mostRows) {
  view.setVisible(rows > 0);
  if (rows == 0)
    return;
  const auto* tree = qobject_cast<const QTreeView*>(&view);
  const int header = tree && !tree->isHeaderHidden() ? tree->header()->sizeHint().height() : 0;
  view.setFixedHeight(header + 2 * view.frameWidth() + std::min(rows, mostRows) * view.sizeHintForRow(0));
}

} // namespace limn
