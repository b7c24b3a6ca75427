// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/FlatPresets.h"

#include <algorithm>

namespace limn {

void FlatPresets::setSourceModel(QAbstractItemModel* source) {
  QAbstractProxyModel::setSourceModel(source);
  connect(source, &QAbstractItemModel::modelReset, this, &FlatPresets::look);
  connect(source, &QAbstractItemModel::rowsInserted, this, &FlatPresets::look);
  connect(source, &QAbstractItemModel::rowsRemoved, this, &FlatPresets::look);
  connect(source, &QAbstractItemModel::layoutChanged, this, &FlatPresets::look);
  connect(source, &QAbstractItemModel::dataChanged, this,
          [this](const QModelIndex& first, const QModelIndex& last, const QList<int>& roles) {
            for (int row = first.row(); first.parent().isValid() && row <= last.row(); ++row)
              if (const QModelIndex its = mapFromSource(first.siblingAtRow(row)); its.isValid())
                emit dataChanged(its, its, roles);
          });
  look();
}

void FlatPresets::look() {
  beginResetModel();
  m_presets.clear();
  const QAbstractItemModel& source = *sourceModel();
  for (int group = 0; group < source.rowCount(); ++group) {
    const QModelIndex heading = source.index(group, 0);
    for (int row = 0; row < source.rowCount(heading); ++row)
      m_presets.emplace_back(source.index(row, 0, heading));
  }
  endResetModel();
}

QModelIndex FlatPresets::mapToSource(const QModelIndex& index) const {
  return index.isValid() ? QModelIndex(m_presets[static_cast<std::size_t>(index.row())]) : QModelIndex();
}

QModelIndex FlatPresets::mapFromSource(const QModelIndex& index) const {
  const auto found = std::ranges::find(m_presets, QPersistentModelIndex(index));
  return found == m_presets.end() ? QModelIndex()
                                  : createIndex(static_cast<int>(found - m_presets.begin()), 0);
}

QModelIndex FlatPresets::index(int row, int column, const QModelIndex& parent) const {
  return parent.isValid() || row < 0 || row >= rowCount() || column != 0 ? QModelIndex()
                                                                         : createIndex(row, 0);
}

QModelIndex FlatPresets::parent(const QModelIndex&) const {
  return {};
}

int FlatPresets::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_presets.size());
}

int FlatPresets::columnCount(const QModelIndex&) const {
  return 1;
}

} // namespace limn
